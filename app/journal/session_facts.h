#pragma once
// What a session file is, and what it begins with.

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// How a SQLite file tells that it is a journal ("Caro"), and the version of its tables. A file of a newer
/// one, or of one before 3, is not read.
inline constexpr int kJournalId = 0x4361726f;
inline constexpr int kJournalVersion = 4;

/// What a journal begins with.
struct SessionFacts {
  std::string program;
  std::filesystem::path rig, scenario;
  std::string rigText, scenarioText;
  double lightSpeed_m_s = 0.0;
  std::vector<std::string> pucks = {};  ///< their names, in the scenario's order; not read back
};

}  // namespace carom
