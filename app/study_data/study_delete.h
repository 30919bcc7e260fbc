#pragma once
// Deleting the data of a participant who withdraws, so that no byte of the code stays.

#include <cstddef>
#include <filesystem>
#include <string>

namespace carom {

/// Counts of the data that were removed from one session file or export folder.
struct StudyDeletion {
  std::size_t rows = 0;   ///< of the study's tables, or lines of CSV files
  std::size_t games = 0;  ///< lessons, with their frames, viewers, samples and all else that was played
  std::size_t files = 0;  ///< of an export folder
  bool any() const { return rows + games + files > 0; }
};

/// Returns a random identifier of a withdrawal, which tells nothing of its code.
std::string newWithdrawal();

/// Removes all data of a code from a session file or an export folder, and counts one more who withdrew: a
/// session file keeps `withdrawal`, so that one withdrawal from several files is counted once.
/// Afterwards no byte sequence of the code is in the file, nor in FILE-wal; what others did stays as it was.
/// Throws std::runtime_error if the file is neither, if a session is writing to it, or if the code is still
/// in it.
StudyDeletion deleteParticipant(const std::string& code, const std::filesystem::path& file,
                                const std::string& withdrawal);

}  // namespace carom
