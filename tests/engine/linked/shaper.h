#pragma once
// A line between two rooms in simulated time: late, uneven, lossy, and the same for the same seed.

#include <algorithm>
#include <map>
#include <utility>

#include "engine/random_world.h"

namespace carom::test {

/// What a line does to messages, one way.
struct LineFaults {
  double late_s = 0.0;
  double jitter_s = 0.0;  ///< up to so much later or earlier
  double lost = 0.0;      ///< the share that is lost
  /// A lost message comes again later and holds up all behind it, as in a stream. Otherwise messages overtake
  /// each other, a lost present stays lost, and a lost stroke comes again later.
  bool isStream = true;
  double repeated = 0.0;  ///< the share that comes twice
};

template <typename Message>
class Shaper {
 public:
  Shaper(const LineFaults& faults, std::uint64_t seed) : faults_(faults), random_(seed) {}

  void send(double now_s, const Message& message, bool mustArrive) {
    double at_s = now_s + std::max(0.0, faults_.late_s + random_.in(-faults_.jitter_s, faults_.jitter_s));
    double again_s = 0.2 + 2.0 * faults_.late_s;
    while (random_.in(0.0, 1.0) < faults_.lost) {
      if (!faults_.isStream && !mustArrive) return;
      at_s += again_s;
    }
    if (faults_.isStream) free_s_ = at_s = std::max(at_s, free_s_);
    mail_.emplace(at_s, message);
    if (random_.in(0.0, 1.0) < faults_.repeated) mail_.emplace(at_s + random_.in(0.0, 1.0), message);
  }

  /// Hands over all that has arrived by then.
  template <typename Take>
  void take(double now_s, Take&& take) {
    while (!mail_.empty() && mail_.begin()->first <= now_s) {
      const Message message = std::move(mail_.extract(mail_.begin()).mapped());
      take(message);
    }
  }

 private:
  LineFaults faults_;
  Random random_;
  double free_s_ = 0.0;  ///< when the stream has delivered what it holds
  std::multimap<double, Message> mail_;
};

}  // namespace carom::test
