#pragma once
// Commands of other programs that get a limited time.

#include <atomic>
#include <string>
#include <vector>

namespace carom {

/// The output of a command and how it ended.
struct CommandResult {
  std::string text;  ///< of both of its outputs, without line ends at its end
  int status = -1;   ///< exit status; −1 if it was ended by a signal, by the limit or could not be started
  bool isTooLate = false;    ///< it was ended because its time was over
  bool isCancelled = false;  ///< it was ended because `cancelled` became true
};

/// Runs a command with an empty standard input and waits until it ends, at most for `limit_s` or until
/// `cancelled`; then it is killed with all processes that it has started. Its first 64 KiB of output are
/// kept. May be called from any thread.
CommandResult runTimed(const std::vector<std::string>& words, double limit_s,
                       const std::atomic<bool>& cancelled);

}  // namespace carom
