#pragma once
// Hands without controllers, by the extension XR_EXT_hand_tracking: where they point, and whether thumb and
// index finger are pinched together.

#include <array>

#include "cave/headset/openxr.h"
#include "engine/base/pose.h"

namespace carom::openxr {

struct BareHand {
  bool isSeen = false;
  /// The palm, at the middle of the hand: -z along the hand to its fingers, which does not turn when they
  /// pinch.
  Pose roomFromPalm;
  double pinched = 0.0;  ///< 0 open, 1 the tips touch; as it was last seen
};

/// Returns how far thumb and index finger are pinched together whose tips' middles are this far apart: 0.7,
/// at which a trigger is held, at 2 cm and 0.4, at which it is released, at 3.5 cm.
double pinchedAt(double apart_m);

class BareHands {
 public:
  /// Throws std::runtime_error if the runtime does not follow hands though it says so.
  BareHands(XrInstance instance, XrSession session);
  ~BareHands();
  BareHands(const BareHands&) = delete;
  BareHands& operator=(const BareHands&) = delete;

  /// Returns a hand (0 left, 1 right) as it will be at `time`, in the coordinates of `room`.
  const BareHand& at(std::size_t hand, XrTime time, XrSpace room);

 private:
  PFN_xrLocateHandJointsEXT locate_;
  PFN_xrDestroyHandTrackerEXT destroy_;
  std::array<XrHandTrackerEXT, 2> trackers_{};
  std::array<BareHand, 2> hands_;
};

}  // namespace carom::openxr
