#pragma once
// The identity of a session file and its initial data.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// The SQLite application id of a journal ("Caro") and the version of its tables: another one whenever a
/// column or a table is added. Files of other versions are refused.
inline constexpr int kJournalId = 0x4361726f;
inline constexpr int kJournalVersion = 12;

/// Returns the key of the table session under which the name of a viewer stands: viewer, viewer_2, …
inline std::string keyOfViewer(std::size_t viewer) {
  return viewer == 0 ? "viewer" : "viewer_" + std::to_string(viewer + 1);
}

inline constexpr const char* kKeyOfTextSize = "text_size";
inline constexpr std::array<const char*, 2> kKeysOfEyePixels{"headset_width", "headset_height"};

/// The initial data of a journal.
struct SessionFacts {
  std::string program;
  std::filesystem::path rig, scenario;
  std::string rigText, scenarioText;
  double lightSpeed_m_s = 0.0;
  std::vector<std::string> pucks = {};            ///< names in the scenario's order; not read back
  std::vector<std::string> viewers = {"viewer"};  ///< names in the rig's order
  std::vector<std::string> trackers = {};         ///< the same of its trackers; not read back
  std::array<int, 2> eyePixels{};                 ///< of each eye's picture in a headset; 0: there was none
  double textSize = 1.0;                          ///< of the walls' words, a factor
  bool hasClass = false;                          ///< a class takes part, whose votes are kept; not read back
  bool isLinked = false;                          ///< with another room, which is kept
  bool isAnotherGame = false;  ///< of a file that goes on: a game after those in it; not read back
};

}  // namespace carom
