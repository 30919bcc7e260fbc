#pragma once
// How the visitor saw their shots: the views of the shot under way, and those of the best carom so far, to be
// shown again from where it was seen.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// A frame of a shot.
struct ShotView {
  ObserverView observer;
  Lorentz boardFromRoom{1.0};
  double shown_s = 0.0;  ///< session clock
};

class ShotMemory {
 public:
  static constexpr std::size_t kMostViews = 1800;  ///< half a minute at 60 Hz; a longer shot is not kept
  static constexpr double kAfter_s = 1.5;          ///< shown after the second touch was seen
  static constexpr double kKept_s = 600.0;         ///< after which the game may forget what the shot showed

  ShotMemory() {
    current_.reserve(kMostViews);
    best_.reserve(kMostViews);
  }

  /// Begins a shot.
  void struck() {
    current_.clear();
    caromAt_s_.reset();
    isOn_ = true;
  }
  /// Keeps a frame of the shot under way, if there is one.
  void see(const ShotView& view);
  /// Says that the shot was just seen to be a carom, off `cushions` cushions. It is the best if none had
  /// more.
  void carom(std::size_t cushions, double now_s) {
    cushions_ = cushions;
    caromAt_s_ = now_s;
  }

  bool hasBest() const { return !best_.empty(); }
  std::size_t bestCushions() const { return bestCushions_; }
  /// Returns the view of the best shot so long after its beginning, or null after its end.
  const ShotView* at(double since_s) const;

  /// Returns the last view of the best shot, which there must be.
  const ShotView& last() const { return best_.back(); }

  /// Returns the earliest view that may be shown again, or `now`; the best shot is dropped when it is too
  /// old.
  const ObserverView& earliest(const ObserverView& now, double now_s);

 private:
  std::vector<ShotView> current_, best_;
  bool isOn_ = false;
  std::optional<double> caromAt_s_;
  std::size_t cushions_ = 0, bestCushions_ = 0;
};

/// Shows the best shot again. Where it ends a game, its view stays while the walls go dark over it, so that
/// the game is not seen behind it.
class ShotReplay {
 public:
  static constexpr double kHeld_s = 1.0;   ///< the walls are dark before
  static constexpr double kStill_s = 1.5;  ///< its last view alone is shown so long

  void begin(double now_s, bool endsGame) {
    from_s_ = now_s;
    over_s_.reset();
    endsGame_ = endsGame;
    isStill_ = false;
  }
  /// Shows its last view alone, for a moment.
  void beginAtEnd(double now_s) {
    begin(now_s, false);
    isStill_ = true;
  }
  /// Ends it if the shot is over or the person interrupts it. Returns whether it was shown until now.
  bool look(const ShotMemory& shots, double now_s, bool interrupted);
  /// Returns whether the shot is under way: the next game waits for it.
  bool isOn() const { return from_s_ && !over_s_; }
  /// Returns the view to show now, or null.
  const ShotView* view(const ShotMemory& shots, double now_s) const;

 private:
  std::optional<double> from_s_;  ///< display time
  std::optional<double> over_s_;  ///< since when its last views stay
  bool endsGame_ = false;
  bool isStill_ = false;  ///< its last view alone
};

}  // namespace carom
