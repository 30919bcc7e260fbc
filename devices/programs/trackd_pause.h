#pragma once
// How long a daemon without a lock pauses in the midst of a pose, learned by watching its shared memory.
//
// A pose that is being written, half old and half new, stays for the length of the pause; a whole one stays
// for the rest of the daemon's period. A reader who takes only what stays for longer than the pause takes
// whole poses, whether the daemon writes the time first or last. A pause shows itself as two changes of one
// pose with one new time between them: the shorter of the gaps before and after a change without a new time.

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

namespace carom {

class TrackdPause {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::microseconds kLeast{200}, kMost{2000};
  static constexpr std::size_t kWatched = 16;  ///< poses after which a pause that is usual is known

  /// Notes a look at one sensor at which its bytes differed from those of the look before. `isLater`: its
  /// time is a new one.
  void changed(bool isLater, Clock::time_point now);
  bool isBegun() const { return changes_ > 0; }
  /// Returns whether enough poses have been watched; a daemon that gives no times needs none.
  bool isKnown() const { return changes_ >= 2 * kWatched || poses_ >= kWatched; }
  /// Returns for how long a pose is to stay unchanged before it is taken: half as long again as the daemon's
  /// usual pause, within kLeast and kMost. Single longer pauses do not count: a busy computer stops the
  /// daemon anywhere.
  Clock::duration settle() const;

 private:
  static constexpr std::size_t kRemembered = 64, kRare = 3;  // poses; of them may be longer
  std::array<Clock::duration, kRemembered> pauses_{};        // of the last poses; 0: none was seen
  std::size_t poses_ = 0, changes_ = 0;
  std::optional<Clock::time_point> last_;
  std::optional<Clock::duration> before_;  // the gap before a change without a new time
  Clock::duration inPose_{0};
};

}  // namespace carom
