#pragma once
// mpirun with the nodes that it has started, as one job that is watched and always ends.

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom {

/// The time that mpirun has to end after it was asked to; then it is killed with what it runs here.
inline constexpr double kJobEnds_s = 15.0;

struct JobEnd {
  int status = 0;           ///< exit status; 128 and more after a signal
  bool wasAsked = false;    ///< a person asked for the end
  bool wasStopped = false;  ///< `isToStop` said so
};

/// Runs mpirun in a process group of its own, so that Ctrl-C in the terminal reaches it through this process
/// alone, and waits for its end. It is asked to end once `asked` is true (set by a signal's handler) or
/// `isToStop`, which is called about five times a second, returns true.
JobEnd runJob(const std::vector<std::string>& words, const std::atomic<bool>& asked,
              const std::function<bool()>& isToStop, double ends_s = kJobEnds_s);

/// Watches a job by the status file of its node 0, which runs on this computer.
class JobWatch {
 public:
  /// `starts_s`: the time until the first frame. After node 0 has ended, the job gets `ends_s`.
  JobWatch(std::filesystem::path status, double starts_s, double ends_s = kJobEnds_s);

  /// Looks once more. `elapsed_s`: since the job began. Returns a sentence if the job hangs, otherwise
  /// nothing.
  std::string look(double elapsed_s);
  /// Returns how long there have been frames, at the latest look; 0 before the first.
  double played_s() const { return played_s_; }

 private:
  std::filesystem::path status_;
  double starts_s_, ends_s_;
  double firstFrame_s_ = -1.0, ended_s_ = -1.0, played_s_ = 0.0;
};

}  // namespace carom
