#pragma once
// The end of a session that somebody asks for: Ctrl-C, SIGTERM, and what mpirun sends to the other nodes when
// one of them has died.

#include <functional>

namespace carom {

/// From now on SIGINT and SIGTERM ask this process to end instead of ending it: loops that draw look at
/// terminationAsked after each frame. A second Ctrl-C ends it at once. Whoever still runs 1.5 s after being
/// asked (0.8 s after mpirun's SIGTERM, which comes late) is in the middle of something long: starting,
/// dividing bodies, a frame of a million collisions. It is not waited for: from another thread all that is
/// ClosedOnLeaving is closed, and the process ends with status 0, or 1 where something could not be closed.
void noticeTermination();

/// Whether they have.
bool terminationAsked();

/// Something that is to be whole when the process leaves in the middle of something else: a file.
class ClosedOnLeaving {
 public:
  /// `close`: called at most once, from another thread, while the rest goes on; may throw. The latest made is
  /// closed first.
  explicit ClosedOnLeaving(std::function<void()> close);
  ~ClosedOnLeaving();  ///< never returns once closing has begun
  ClosedOnLeaving(const ClosedOnLeaving&) = delete;
  ClosedOnLeaving& operator=(const ClosedOnLeaving&) = delete;

 private:
  std::function<void()> close_;
};

/// Closes all that is ClosedOnLeaving, for a process that then ends at once: whoever makes or destroys such a thing
/// after this waits for ever. Returns whether all could be closed; what could not is said on standard error.
bool closeAll();

/// Ends the process, with status 0, after a session whose files are closed, once `last` has returned; whoever
/// is asked to end waits for that no longer than for anything else. Nothing is taken down: the system frees
/// all at once what VTK would search a list for, vertex buffer by vertex buffer: minutes, for thousands of
/// pucks.
[[noreturn]] void leave(const std::function<void()>& last);

}  // namespace carom
