#pragma once
// The file that says once a second how a session goes, for a technician who is not in the room.

#include <sys/types.h>

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <thread>

namespace carom {

/// Returns the first keys of every status: version, time of writing, state and the process that writes it.
nlohmann::ordered_json statusOf(const char* state);

/// Returns the status as the content of its file.
std::string linesOf(const nlohmann::ordered_json& status);

/// The part of a status file that `carom room` reads.
struct ReadStatus {
  std::string state;                     ///< empty if the file cannot be read
  pid_t process = 0;                     ///< of node 0
  std::optional<std::uint64_t> frame{};  ///< the latest, if there was one
};
ReadStatus readStatus(const std::filesystem::path& file);

/// Returns the last words of a process that has ended, as if they were written now. Empty while the process
/// lives, or if the file cannot be read.
std::string withNewTime(const std::filesystem::path& file);

/// Replaces the file as a whole once a second, whatever the rest of the program does: a reader never sees
/// half of it. If it cannot be written any more, this is logged once.
class StatusWriter {
 public:
  /// Writes `text()` at once and then every second, from a thread of its own; an empty text leaves the file
  /// as it is. Throws NotWritten if the file cannot be written at first.
  StatusWriter(std::filesystem::path file, std::function<std::string()> text);
  StatusWriter(const StatusWriter&) = delete;
  StatusWriter& operator=(const StatusWriter&) = delete;

  /// Lets the thread write soon.
  void writeSoon();
  /// Writes now.
  void write();
  /// Writes these last words, once, unless they are empty; nothing is written after them. Throws NotWritten.
  void end(const std::function<std::string()>& lastWords);

 private:
  void keepWriting(const std::stop_token& stop);

  std::filesystem::path file_;
  std::function<std::string()> text_;
  std::mutex writing_;  // of the file and of:
  bool hasFailed_ = false, hasEnded_ = false;
  std::mutex waking_;  // of:
  bool isDue_ = false;
  std::condition_variable_any due_;
  std::jthread thread_;  // last: it uses the rest
};

}  // namespace carom
