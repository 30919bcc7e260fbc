#pragma once
// The end of a session on request: by Ctrl-C, by SIGTERM, or by mpirun's signal to the other nodes when one
// of them has died.

#include <functional>

namespace carom {

/// From now on, SIGINT and SIGTERM request the end of this process instead of killing it; drawing loops check
/// terminationAsked after each frame. A second Ctrl-C kills it at once. A process that still runs 1.5 s after
/// the request (0.8 s after mpirun's SIGTERM, which comes late) is in the middle of something long, such as
/// starting, dividing bodies or a frame of a million collisions. It gets no more time: another thread closes
/// everything that is ClosedOnLeaving and ends the process with status 0, or 1 if something could not be
/// closed.
void noticeTermination();

/// Returns whether the end was requested.
bool terminationAsked();

/// Something, such as a file, that must be complete even if the process ends in the middle of other work.
class ClosedOnLeaving {
 public:
  /// `close`: called at most once, from another thread, while other threads continue; may throw. The newest
  /// object is closed first.
  explicit ClosedOnLeaving(std::function<void()> close);
  ~ClosedOnLeaving();  ///< never returns once closing has begun
  ClosedOnLeaving(const ClosedOnLeaving&) = delete;
  ClosedOnLeaving& operator=(const ClosedOnLeaving&) = delete;

 private:
  std::function<void()> close_;
};

/// Closes every ClosedOnLeaving object, for a process that then ends at once: a thread that creates or
/// destroys such an object afterwards waits for ever. Returns whether all could be closed; failures are
/// reported on standard error.
bool closeAll();

/// Ends the process with status 0, after a session whose files are closed, once `last` has returned. If the
/// end is requested meanwhile, `last` gets no more time than anything else. No objects are destroyed: the
/// system frees at once what VTK would look up in a list, vertex buffer by vertex buffer, which takes minutes
/// for thousands of pucks.
[[noreturn]] void leave(const std::function<void()>& last);

}  // namespace carom
