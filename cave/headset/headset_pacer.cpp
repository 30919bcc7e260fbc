#include "cave/headset/headset_pacer.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesUntilTold = 90;  // controllers wake up in the first second

}  // namespace

HeadsetPacer::HeadsetPacer(Headset& headset, double lived_s, std::uint64_t firstFrame)
    : headset_(headset), display_s_(lived_s) {
  number_ = firstFrame;
}

/// Returns a frame in which no time passes for the wearer: the headset is off, or its session has ended.
FrameTimes HeadsetPacer::idle() {
  const bool isLast = headset_.state() == Headset::State::ended;
  if (isLast) {
    log::warn(fmt::format("{}: the session ends.", headset_.whyEnded()));
  } else if (isRunning_) {
    log::note("The headset is taken off: time stands still.");
  }
  isRunning_ = false;
  std::this_thread::sleep_for(std::chrono::duration<double>(kIdle_s));
  display_s_ += kIdle_s;
  return {number_++, display_s_, display_s_, 0.0, isLast};
}

/// Advances the session's clock to the next frame, and returns how long its wearer has lived since the one
/// before.
double HeadsetPacer::stepTo(const HeadsetFrame& next) {
  const std::int64_t step_ns = isRunning_ ? next.display_ns - display_ns_ : next.untilNext_ns;
  const double step_s = 1e-9 * static_cast<double>(step_ns);
  if (!(step_s > 0.0)) return 0.0;
  display_s_ += step_s;
  tellWhenLate(step_s, next);
  return isRunning_ && !next.isRecentred && step_s <= kLongestStep_s ? step_s : 0.0;
}

/// Says, the first time, that a frame comes much later than its display wants it. Loading at the beginning
/// delays frames, which tells nothing.
void HeadsetPacer::tellWhenLate(double step_s, const HeadsetFrame& next) {
  constexpr double kPeriods = 5.0;
  const double wanted_s = 1e-9 * static_cast<double>(next.untilNext_ns);
  if (!isRunning_ || told_ < kFramesUntilTold || saidLate_ || !(step_s > kPeriods * wanted_s)) return;
  saidLate_ = true;
  log::warn(fmt::format(
      "a frame came {:.0f} ms after the one before, expected one every {:.0f} ms: this computer is too slow "
      "for "
      "the headset, or was held up.{}",
      1e3 * step_s, 1e3 * wanted_s, step_s > kLongestStep_s ? " Time stood still meanwhile." : ""));
}

/// Says once, when everything has had time to come, what the headset lacks.
void HeadsetPacer::tell(const HeadsetFrame& frame) {
  hasVelocity_ = hasVelocity_ || frame.runtimeVelocity_m_s;
  hasHands_ = hasHands_ || frame.hands[0].isTracked || frame.hands[1].isTracked;
  hasPosition_ = hasPosition_ || frame.hasPosition;
  if (told_ > kFramesUntilTold || ++told_ != kFramesUntilTold) return;
  if (!hasPosition_)
    log::warn(
        "the headset knows directions and no places: its wearer turns the head and stands still otherwise.");
  if (!hasHands_) log::note("No hand is followed: mouse, keys and gamepad play as on a desk.");
  if (!hasVelocity_) log::note("The headset gives no velocity; the head's own filter needs none.");
}

FrameTimes HeadsetPacer::next() {
  headset_.poll();
  const std::optional<HeadsetFrame> next = headset_.nextFrame();
  if (!next) return idle();
  if (!isRunning_ && wasWorn_) log::note("The headset is worn again: time goes on.");
  const double step_s = stepTo(*next);
  display_ns_ = next->display_ns;
  isRunning_ = wasWorn_ = true;
  tell(*next);
  return {number_++, display_s_, display_s_, step_s, false, next};
}

}  // namespace carom
