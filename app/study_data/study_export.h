#pragma once
// The data of a study from its session files: a folder of CSV files with a codebook, and on demand the raw
// paths as BIDS has them.

#include <filesystem>
#include <vector>

namespace carom {

struct StudyExport {
  std::vector<std::filesystem::path> sessions;
  std::filesystem::path folder;
  bool hasMotion = false;  ///< with the tracker samples of people who allowed it
};

/// Writes the folder, whole or not at all. Throws std::runtime_error if it is there already, if a session has
/// no study, or if the sessions are of different studies.
void exportStudy(const StudyExport& wanted);

}  // namespace carom
