#include "app/hand/cue.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cave/texts/texts.h"
#include "devices/force_law/cue_force.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

/// Returns the rotation part of the transformation, without its boost.
Lorentz turnOf(const Lorentz& boardFromRoom) {
  return Lorentz::boost(boardFromRoom.u(), boardFromRoom.lightSpeed_m_s()).inverse() * boardFromRoom;
}

}  // namespace

Vec3 wayInRoom(const Vec3& wayOnBoard, const Lorentz& boardFromRoom) {
  return (turnOf(boardFromRoom).inverse() * Displacement{0.0, wayOnBoard}).dr_m;
}

CueStroke strokeOf(const Vec3& pullInRoom_m, const Lorentz& boardFromRoom, double d0_m) {
  const Lorentz turn = turnOf(boardFromRoom);
  Vec3 way_m = (turn * Displacement{0.0, -pullInRoom_m}).dr_m;
  way_m.z = 0.0;
  const double pull_m = glm::length(way_m);
  if (!(pull_m > 0.0)) return {};
  const Vec3 way = way_m / pull_m;
  const double wanted = d0_m > 0.0 ? uOfDraw(pull_m, d0_m) : pull_m / kPullForOne_m;
  const double u = wanted < kLeastPull_m / kPullForOne_m ? 0.0 : std::min(wanted, kStrongestU);
  // + 0: avoids −0, which a session file would not restore.
  return {{u * way.x + 0.0, u * way.y + 0.0}, (turn.inverse() * Displacement{0.0, way}).dr_m};
}

double sideOf(const Vec3& asideInRoom_m, const Vec2& u, const Lorentz& boardFromRoom, double radius_m) {
  const double size = glm::length(u);
  if (size == 0.0) return 0.0;
  const Vec3 aside_m = (turnOf(boardFromRoom) * Displacement{0.0, asideInRoom_m}).dr_m;
  const double right_m = (aside_m.x * u.y - aside_m.y * u.x) / size;
  if (std::abs(right_m) < kLeastSide * radius_m) return 0.0;
  return std::clamp(right_m, -kMostSide * radius_m, kMostSide * radius_m);
}

namespace {

/// Returns the place of a device among kHandDevices.
std::size_t numberOf(std::string_view device) {
  return static_cast<std::size_t>(std::ranges::find(kHandDevices, device) - kHandDevices.begin());
}

}  // namespace

Cue::Outcome Cue::press(const HandInput& hand, const PickResult& pointed, const CueState& state) {
  if (state.frozen) return {{}, state.inLesson ? texts::message::kInLesson : texts::message::kTimeStands};
  if (pointed.behind) return {{}, texts::message::kPuckBehind};
  if (!pointed.puck) return {{}, state.isRinged ? texts::message::kNotRinged : texts::message::kNoPuck};
  target_ = pointed.puck;
  device_ = hand.device;
  pull_m_ = hand.pull_m;
  d0_m_ = hand.d0_m;
  return {};
}

Cue::Outcome Cue::step(const HandInput& hand, const PickResult& pointed, const CueState& state) {
  const bool pressed = !hand.device.empty() && hand.held, wasPressed = std::exchange(pressed_, pressed);
  if (!target_) return pressed && !wasPressed ? press(hand, pointed, state) : Outcome{};
  if (hand.device != device_) {
    target_.reset();
    return {{}, texts::message::kDeviceLost.at(numberOf(device_))};
  }
  if (state.frozen) {
    target_.reset();
    return {{}, texts::message::kStoppedStroke};
  }
  if (pressed) {
    pull_m_ = hand.pull_m;
    d0_m_ = hand.d0_m;
    return {};
  }
  return {std::exchange(target_, std::nullopt), {}};
}

}  // namespace carom
