#pragma once
// Frames at the times at which a headset wants them.

#include <cstdint>

#include "cave/frame/pacer.h"
#include "cave/headset/headset.h"
#include "cave/record/headset_frame.h"

namespace carom {

/// The session's clock is the headset's: it advances by the difference of the display times that the runtime
/// predicts, however long a frame takes. Proper time stops while the headset is off, while its room is
/// centred anew, and in a gap longer than kLongestStep_s. Each frame that it begins must be submitted to the
/// headset before the next.
class HeadsetPacer : public FramePacer {
 public:
  static constexpr double kLongestStep_s = 0.25;
  static constexpr double kIdle_s = 1.0 / 30.0;  ///< from frame to frame for the others, while it is not worn

  /// `lived_s`: the session's clock before the first frame; `firstFrame`: its number.
  HeadsetPacer(Headset& headset, double lived_s, std::uint64_t firstFrame);

  /// Returns the next frame with the headset's data; without them while it is not worn.
  FrameTimes next() override;

 private:
  FrameTimes idle();
  double stepTo(const HeadsetFrame& next);
  void tellWhenLate(double step_s, const HeadsetFrame& next);
  void tell(const HeadsetFrame& frame);

  Headset& headset_;
  std::int64_t display_ns_ = 0;  ///< of the runtime's clock: of the headset's newest frame
  double display_s_;
  bool isRunning_ = false;  ///< the frame before was one of the headset's
  bool wasWorn_ = false;    ///< there has been one
  std::uint64_t told_ = 0;  ///< frames until it is said what the headset lacks
  bool saidLate_ = false;   ///< that frames come too late
  bool hasVelocity_ = false, hasHands_ = false, hasPosition_ = false;
};

}  // namespace carom
