#include "app/play/hand_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "cave/frame/bodies.h"
#include "cave/texts/saying.h"
#include "cave/texts/texts.h"
#include "devices/force_law/shown_mass.h"
#include "devices/setup/force_factory.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kFresh_s = 0.1;  // of what the device reports

}  // namespace

HandForce::HandForce(const ForceSetup& setup, const RoomAxes& axes, std::unique_ptr<ForceChannel> channel)
    : setup_(setup), axes_(axes), channel_(std::move(channel)) {}

void HandForce::play(const BilliardSetup& game) {
  game_ = &game;
  laws_.emplace(setup_, axes_, game);
  blows_ = {};
  felt_.clear();
  if (std::exchange(saidStiffness_, true)) return;
  const std::string lowered = loweredStiffness(setup_);
  if (!lowered.empty()) log::warn(lowered);
  if (!lowered.empty()) tell("force stiffness", texts::message::kForceLowered);
}

/// Returns whether the hand that aims is the one at the device. A simulated device is in whatever hand there
/// is; the stick of a gamepad may be an input device with force.
bool HandForce::isFelt(const HandInput& hand) const {
  if (setup_.kind == ForceKind::simulated) return !hand.device.empty();
  const bool isPad = setup_.kind == ForceKind::evdev && hand.device == kHandGamepad;
  return hand.device == kHandWand || isPad;
}

void HandForce::draw(HandInput& hand) {
  const std::scoped_lock hold(reporting_);
  feels_ = isFelt(hand);
  const bool draws = feels_ && hand.held;
  if (!draws) base_m_ = wish_m_;
  if (draws) wish_m_ = base_m_ + hand.pull_m;
  if (!feels_) return;
  hand.d0_m = setup_.d0_m;
  const ForceReport& report = channel_->report();
  if (draws && report.active && report.draw_m != Vec3(0.0))
    hand.pull_m = laws_->roomFromDevice(report.draw_m);
}

/// Returns the blows that are not over.
std::span<const Blow> HandForce::current(double now_s) {
  std::erase_if(felt_, [now_s](const Blow& blow) { return blow.start_s + kBlow_s < now_s; });
  return std::span<const Blow>(felt_).first(std::min(felt_.size(), ForceLaw().blows.size()));
}

void HandForce::post(const HandInput& hand, bool buttonHeld, const std::optional<Holding>& holding,
                     double now_s, ViewerState& own) {
  const std::scoped_lock hold(reporting_);
  ForceLaw law;
  law.up = laws_->deviceFromRoom(axes_.up);
  law.cue.scale = laws_->scale();
  if (feels_ && own.hand.pulling)
    law = laws_->cue(game_->pucks.at(own.hand.target - kFirstPuck).mass_kg);
  else if (holding)
    law = laws_->held(holding->mass_kg, holding->betaInRoom);
  law.held = buttonHeld || (feels_ && hand.held);
  law.posted_s = channel_->now_s(now_s);
  const std::span<const Blow> blows = current(now_s);
  std::copy(blows.begin(), blows.end(), law.blows.begin());
  law.blowCount = blows.size();
  law.wish_m = laws_->deviceFromRoom(wish_m_);
  channel_->post(law);
  const ForceReport& report = channel_->report();
  ForceView& view = own.force;
  view.shown = law.posted_s - report.time_s <= kFresh_s ? 1 : 0;
  view.scale = laws_->scale();
  if (view.shown) {
    view.place_m = setup_.roomFromDevice * report.position_m;
    view.force_n = laws_->roomFromDevice(report.force_n);
  }
  note(own.hand);
  noteHeld(holding, law.held);
}

/// Notes something that is said in the room, too.
void HandForce::tell(std::string_view what, const texts::Saying& said) {
  notes_.push_back({what, said.english(), said});
}

/// Notes draws that begin and end, falls, and news of the device.
void HandForce::note(const HandView& view) {
  const ForceReport& report = channel_->report();
  if (wasPulling_ && !view.pulling) notes_.push_back({"force draw", "released"});
  if (!wasPulling_ && view.pulling)
    notes_.push_back({"force draw", fmt::format("begun, 1 N here is {:.3g} N", 1.0 / laws_->scale())});
  wasPulling_ = view.pulling != 0;
  if (report.falls != falls_)
    tell("force off", texts::say(texts::message::kForceOff, std::string_view(toString(report.fall))));
  falls_ = report.falls;
  for (const std::string& line : channel_->takeNews()) {
    log::note(line);
    notes_.push_back({"force device", line});
  }
}

std::vector<ForceNote> HandForce::finish() {
  channel_->end();
  const std::scoped_lock hold(reporting_);
  const ForceReport& report = channel_->report();
  if (report.falls == std::exchange(falls_, report.falls)) return {};
  log::note(fmt::format("{}: no force, for {}", nameOf(setup_), toString(report.fall)));
  return {{"force off", toString(report.fall)}};
}

/// Says, once a puck that was held is let go, what mass the hand felt; no number where the device's stiffness
/// hides it.
void HandForce::noteHeld(const std::optional<Holding>& holding, bool isHeld) {
  const ForceReport& report = channel_->report();
  if (holding && isHeld) {
    if (std::isfinite(report.shown_kg)) shown_kg_ = report.shown_kg;
    return;
  }
  const double felt_kg = std::exchange(shown_kg_, 0.0);
  if (!holding || felt_kg == 0.0) return;
  const double beta = glm::length(holding->betaInRoom), gamma = 1.0 / std::sqrt(1.0 - beta * beta);
  const double across_kg = gamma * holding->mass_kg, along_kg = gamma * gamma * across_kg;
  const bool isHidden = ShownMass::isHidden(along_kg, laws_->held(holding->mass_kg, {}).puck.stiffness_n_m);
  tell("force mass", isHidden ? texts::say(texts::message::kHiddenMass, beta, along_kg, across_kg)
                              : texts::say(texts::message::kFeltMass, felt_kg, beta, along_kg, across_kg));
}

void HandForce::see(std::span<const GameEvent> events, const FrameRecord& record, std::size_t viewer) {
  for (const Vec3& change : blows_.look(events, record, viewer)) {
    felt_.push_back(laws_->blow(change, record.display_s));
    notes_.push_back({"force pulse",
                      fmt::format("{:.3g} m c, {:.3g} N s", glm::length(change), felt_.back().impulse_ns())});
  }
}

}  // namespace carom
