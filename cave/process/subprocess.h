#pragma once
// Runs a job where it can do no harm: a reader of files that may crash on them.

#include <functional>
#include <stdexcept>
#include <string>

namespace carom {

/// The job did not come back: it crashed or took too long.
class SubprocessFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes that `job` returns, run in a child process with at most a minute of time and 4 GiB of memory
/// more than this process has. What the job throws as std::exception is thrown here as std::runtime_error
/// with its text; SubprocessFailed says why there is no answer. The child inherits no other threads: the job must not
/// need any.
std::string runInSubprocess(const std::function<std::string()>& job);

}  // namespace carom
