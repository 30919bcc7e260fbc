#pragma once
// The console's clocks, and the playback controls of a recorded session.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/console_parts/console_parts.h"
#include "engine/base/limits.h"

namespace carom::console {

/// The clocks of the session, of the table and of everybody in the room, and the platform's motion.
class SessionClocks {
 public:
  /// `viewers`: the names of the records' viewers.
  explicit SessionClocks(std::vector<std::string> viewers) : viewers_(std::move(viewers)) {}

  /// Takes over the clocks of a frame, with the viewers' paces as means over half a second.
  void follow(const FrameRecord& record);

  /// Draws the clocks in lines of this width.
  void draw(const ConsoleFrame& frame, float width_px) const;

 private:
  /// All clocks at one moment.
  struct Moment {
    double display_s = 0.0;
    std::array<double, kMostViewers> own_s{};
  };
  std::vector<std::string> viewers_;
  Moment from_;
  std::array<double, kMostViewers> paces_{};  ///< own seconds per second of the clock on the wall; 0: unknown
};

/// The playback controls of a recorded session: direction, rate, and a slider over its duration if both ends
/// are known.
class Playing {
 public:
  void draw(const ConsoleFrame& frame);

 private:
  PatientSlider slider_;
};

}  // namespace carom::console
