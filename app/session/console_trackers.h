#pragma once
// The console's trackers: how each fares, and how the head is known.

#include <vector>

#include "app/session/console_parts.h"

namespace carom::console {

class TrackersPanel {
 public:
  /// Asks the source some times a second.
  void follow(const ConsoleFrame& frame);
  /// Green, yellow or red: the worst of them.
  const ImVec4& light() const;
  void draw(const ConsoleFrame& frame) const;

 private:
  std::vector<TrackerReport> reports_;
  double asked_s_ = -1.0;  ///< session clock
};

}  // namespace carom::console
