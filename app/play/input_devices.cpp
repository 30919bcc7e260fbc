#include "app/play/input_devices.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/texts/texts.h"

namespace carom {
namespace {

enum WandButton { kTrigger, kBrake, kHome, kOnwards };
enum SpaceMouseButton { kLeftBrakes, kRightGoesHome };

/// Returns where a ray meets the plane of the cloth, which is as high in the room as the board is for the
/// midpoint of the eyes.
std::optional<Vec3> onCloth(const Vec3& from_m, const Vec3& along, const ObserverView& observer,
                            const Vec3& up) {
  const EyeView& middle = observer.middle;
  const double above_m = glm::dot(from_m - middle.positionInRoom_m, up) + middle.observation.r_m.z;
  const double falls = -glm::dot(along, up);
  const double far_m = above_m / falls;
  if (!(far_m > 0.0 && far_m < kFarthestOnCloth_m)) return std::nullopt;
  return from_m + far_m * along;
}

}  // namespace

Vec3 InputDevices::level(const Vec3& way) const {
  const Vec3 flat = way - glm::dot(way, axes_.up) * axes_.up;
  const double length = glm::length(flat);
  return length > 1e-6 ? flat / length : axes_.forward;
}

DriveWish InputDevices::drive() const {
  DriveWish wish;
  wish.steer =
      steered_ + desk_.steer.x * axes_.right + desk_.steer.y * axes_.forward + desk_.steer.z * axes_.up;
  wish.brake =
      desk_.brake || (wandKnown_ && wandButtons_.isHeld(kBrake)) || spaceMouseButtons_.isHeld(kLeftBrakes);
  wish.turn_rad = turn_rad_;
  wish.home = desk_.home || wandButtons_.wasPressed(kHome) || spaceMouseButtons_.wasPressed(kRightGoesHome);
  return wish;
}

std::optional<Command> InputDevices::lessonCommand() const {
  return carom::lessonCommand(wandButtons_.answered() + 1, wandButtons_.wasPressed(kOnwards));
}

/// Combines the steering: the wand's stick along the wand's horizontal direction, the SpaceMouse along the
/// room's axes.
void InputDevices::steer(const HandDevices& devices) {
  wandKnown_ = devices.wandKnown;
  steered_ = Vec3(0.0);
  if (devices.wandKnown) {
    const Vec3 stick = withoutDeadZone({devices.wand.axes[0], devices.wand.axes[1], 0.0});
    const Vec3 forward = level(devices.roomFromHand.orientation * axes_.forward);
    steered_ = stick.x * glm::cross(forward, axes_.up) + stick.y * forward;
  }
  const auto& axes = devices.spaceMouse.axes;
  const Vec3 cap = withoutDeadZone({axes[0], axes[1], axes[2]});  // right, up, back
  steered_ += cap.x * axes_.right + cap.y * axes_.up - cap.z * axes_.forward;
}

InputDevices::Hand InputDevices::wandHand(const HandDevices& devices, double now_s) const {
  Hand hand;
  hand.there = devices.wandKnown;
  hand.held = wandButtons_.isHeld(kTrigger);
  hand.down = (devices.wand.down & 1U << kTrigger) != 0;
  hand.from_m = hand.at_m = devices.roomFromHand.position_m;
  hand.along = devices.roomFromHand.orientation * axes_.forward;
  hand.used_s = now_s - kPatience_s;
  return hand;
}

/// Returns the mouse's state. While it holds the cue and is over no wall, it keeps pointing to its last
/// position.
InputDevices::Hand InputDevices::mouseHand(const ObserverView& observer, double now_s) {
  if (desk_.mouse && mouse_.was && desk_.mouse->onWall_m != mouse_.was->onWall_m) mouse_.used_s = now_s;
  if (desk_.mouseHeld) mouse_.used_s = now_s;
  if (desk_.mouse) mouse_.was = desk_.mouse;
  Hand hand;
  hand.there = desk_.mouse || (mouse_.was && holder_ == mouse);
  hand.held = hand.down = desk_.mouseHeld && desk_.mouseAims;
  hand.used_s = desk_.mouseAims ? mouse_.used_s : kNever_s;
  if (!hand.there) return hand;
  hand.eye = mouse_.was->eye;
  hand.from_m = mouse_.was->from_m.value_or(observer.of(hand.eye).positionInRoom_m);
  hand.along = glm::normalize(mouse_.was->onWall_m - hand.from_m);
  mouse_.at_m = onCloth(hand.from_m, hand.along, observer, axes_.up).value_or(mouse_.at_m);
  hand.at_m = mouse_.at_m;
  return hand;
}

/// Turns the room so that what the mouse took hold of stays under it. With the room's axes turned by some
/// angle, the scene turns by the opposite one.
void InputDevices::turn(const Hand& hand) {
  turn_rad_ = 0.0;
  if (!desk_.mouseTurns || !hand.there) return grabbed_.reset();
  const Vec3 now = level(hand.along), before = grabbed_.value_or(now);
  turn_rad_ = -std::atan2(glm::dot(glm::cross(before, now), axes_.up), glm::dot(before, now));
  grabbed_ = now;
}

InputDevices::Hand InputDevices::padHand(const ObserverView& observer, const Pose& roomFromHead,
                                         double now_s) {
  if (desk_.padHeld || desk_.padPull != Vec3(0.0) || desk_.padStep != 0) padUsed_s_ = now_s;
  Hand hand;
  hand.there = desk_.hasPad;
  hand.held = hand.down = desk_.padHeld;
  hand.from_m = observer.middle.positionInRoom_m;
  hand.along = roomFromHead.orientation * axes_.forward;
  const Vec3 forward = level(hand.along);
  hand.at_m = kPadPull_m * (desk_.padPull.x * glm::cross(forward, axes_.up) - desk_.padPull.y * forward);
  hand.used_s = padUsed_s_;
  return hand;
}

std::optional<InputDevices::Device> InputDevices::aiming(const std::array<Hand, kDevices>& hands,
                                                         double now_s) const {
  if (holder_) return holder_;
  std::optional<Device> latest;
  for (const Device device : {wand, mouse, pad}) {
    const Hand& hand = hands[device];
    if (!hand.there || hand.used_s < now_s - kPatience_s) continue;
    if (!latest || hand.used_s > hands[*latest].used_s) latest = device;
  }
  return latest;
}

/// Assigns the cue to the first device pressed, unless a lesson asks. A device that is lost no longer holds
/// it.
void InputDevices::take(const std::array<Hand, kDevices>& hands, HandInput& input) {
  if (holder_ && !hands[*holder_].there) holder_.reset();
  for (const Device device : {wand, mouse, pad}) {
    const Hand& hand = hands[device];
    const bool wasHeld = std::exchange(wasHeld_[device], hand.held);
    if (!hand.held || wasHeld || !hand.there || asks_) continue;
    if (holder_) {
      input.refused = texts::message::kCueTaken[*holder_];
      continue;
    }
    holder_ = device;
    pressed_m_ = device == pad ? Vec3(0.0) : hand.at_m;  // a stick returns to its centre by itself
  }
}

HandInput InputDevices::cue(const HandDevices& devices, const ObserverView& observer,
                            const Pose& roomFromHead, double now_s) {
  wandButtons_.set(devices.wand.down, asks_);
  spaceMouseButtons_.set(devices.spaceMouse.down, false);
  steer(devices);
  const std::array<Hand, kDevices> hands{wandHand(devices, now_s), mouseHand(observer, now_s),
                                         padHand(observer, roomFromHead, now_s)};
  turn(hands[mouse]);
  HandInput input;
  std::array<bool, kDevices> pressed{};
  for (const Device device : {wand, mouse, pad})
    pressed[device] = !std::exchange(wasDown_[device], hands[device].down) && hands[device].down;
  take(hands, input);
  const std::optional<Device> device = aiming(hands, now_s);
  if (!device) return input;
  const Hand& hand = hands[*device];
  input.device = kHandDevices[*device];
  input.from_m = hand.from_m;
  input.along = hand.along;
  input.eye = hand.eye;
  input.pressed = pressed[*device];
  if (!holder_) return input;
  input.held = hand.held;
  input.pull_m = hand.at_m - pressed_m_;
  if (!hand.held) holder_.reset();
  return input;
}

}  // namespace carom
