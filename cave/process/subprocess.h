#pragma once
// Runs a job in a child process, for readers of files that may crash on bad input.

#include <functional>
#include <stdexcept>
#include <string>

namespace carom {

/// The job returned no answer: it crashed or took too long.
class SubprocessFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// It took too long or asked for too much memory: more than a job may use, or than is left of the process's
/// budget (cave/process/work_budget.h).
class JobTooLarge : public SubprocessFailed {
 public:
  using SubprocessFailed::SubprocessFailed;
};

/// Returns the bytes that `job` returns, run in a child process with at most a minute of time and 4 GiB of
/// memory more than this process has, and with no more than is left of a budget. A std::exception of the job
/// is thrown here as std::runtime_error with its text; SubprocessFailed says why there is no answer. The
/// child has no other threads: the job must not need any.
std::string runInSubprocess(const std::function<std::string()>& job);

}  // namespace carom
