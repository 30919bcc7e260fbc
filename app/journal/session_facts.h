#pragma once
// The identity of a session file and its initial data.

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// The SQLite application id of a journal ("Caro") and the version of its tables. Files of newer versions, or
/// of versions before 3, are not read.
inline constexpr int kJournalId = 0x4361726f;
inline constexpr int kJournalVersion = 7;

/// The initial data of a journal.
struct SessionFacts {
  std::string program;
  std::filesystem::path rig, scenario;
  std::string rigText, scenarioText;
  double lightSpeed_m_s = 0.0;
  std::vector<std::string> pucks = {};  ///< names in the scenario's order; not read back
  bool isAnotherGame = false;           ///< a file that goes on, goes on with another game; not read back
};

}  // namespace carom
