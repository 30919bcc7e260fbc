#include "app/live/player_inputs.h"

#include <algorithm>

#include "cave/texts/texts.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

constexpr double kOnset_s = 0.5;

/// Returns the rumble strength in [0, 1]: stroke energy relative to the strongest stroke. 0 unless a gamepad
/// draws the cue.
double rumbleStrength(const HandInput& hand, const HandView& view) {
  return view.pulling && hand.device == kHandGamepad ? costOf(view.u) / costOf(kStrongestU) : 0.0;
}

}  // namespace

PlayerInputs::PlayerInputs(const Rig& rig, std::chrono::steady_clock::time_point sessionStart)
    : people_(rig.byMouse ? std::make_unique<MousePeople>(rig) : nullptr),
      hands_(rig.viewers.size(), InputDevices(rig.axes)) {
  for (std::size_t viewer = 0; viewer < hands_.size(); ++viewer)
    presses_.emplace_back(seenBy(roomGeometryOf(rig), viewer));
  for (const ViewerSetup& viewer : rig.viewers) {
    const bool isThere = viewer.force && (!people_ || viewer.force->kind == ForceKind::simulated);
    forces_.push_back(isThere
                          ? std::make_unique<HandForce>(*viewer.force, rig.axes,
                                                        createForce(*viewer.force, rig.axes, sessionStart))
                          : nullptr);
  }
}

PlayerInputs::~PlayerInputs() = default;

SharedTrackers PlayerInputs::trackers(const Rig& rig,
                                      std::chrono::steady_clock::time_point sessionStart) const {
  SharedTrackers trackers(rig, sessionStart);
  if (people_) trackers.take(rig.viewers.front().head.sensor.tracker, people_->tracker());
  return trackers;
}

void PlayerInputs::play(const Scenario& scenario) {
  for (InputDevices& hand : hands_) hand.letGo();
  for (WallPresses& presses : presses_) presses.play(scenario);
  for (const auto& force : forces_) {
    if (force) force->play(scenario.billiard);
  }
}

void PlayerInputs::follow(const FrameRecord& shown) {
  for (std::size_t viewer = 0; viewer < presses_.size(); ++viewer) presses_[viewer].follow({shown, viewer});
}

DriveWish PlayerInputs::take(const DeskInput& desk, bool asks, const FrameTimes& times) {
  padStep_ = desk.padStep;
  if (desk.mouse) atDesk_ = std::min(desk.mouse->viewer, hands_.size() - 1);
  DeskInput own = desk;
  own.mouseAims = !people_;
  for (std::size_t viewer = 0; viewer < hands_.size(); ++viewer)
    hands_[viewer].begin(viewer == atDesk_ ? own : DeskInput{}, asks);
  const auto steers = std::find_if(hands_.begin(), hands_.end(),
                                   [](const InputDevices& hand) { return asksForAnything(hand.drive()); });
  if (steers != hands_.end()) steering_ = static_cast<std::size_t>(steers - hands_.begin());
  if (people_) people_->move(desk, atDesk_, times.begin_s);
  DriveWish wish = hands_[steering_].drive();
  onset_ = wish.steer == Vec3(0.0) ? 0.0 : std::min(1.0, onset_ + times.step_s / kOnset_s);
  wish.steer *= onset_;
  return wish;
}

PlayerInputs::Act PlayerInputs::act(std::size_t viewer, const Viewers& viewers, const ObserverView& observer,
                                    double now_s) {
  Act act;
  act.hand = hands_[viewer].cue(viewers.hand(viewer), observer, viewers.head(viewer).pose, now_s);
  if (forces_[viewer]) forces_[viewer]->draw(act.hand);
  if (viewer == atDesk_) presses_[viewer].aimPad(padStep_, act.hand);
  act.pointed = presses_[viewer].at(act.hand);
  act.command = hands_[viewer].lessonCommand();
  return act;
}

std::vector<Note> PlayerInputs::endForces() {
  std::vector<Note> notes;
  for (std::size_t viewer = 0; viewer < forces_.size(); ++viewer) {
    if (!forces_[viewer]) continue;
    for (const ForceNote& note : forces_[viewer]->finish())
      notes.push_back({std::string(note.what), note.value, viewer});
  }
  return notes;
}

void PlayerInputs::letGo(std::size_t viewer, bool home) {
  hands_[viewer].letGo();
  if (home) hands_[viewer].goHome();
}

void PlayerInputs::feel(std::size_t viewer, const Viewers& viewers, const HandInput& hand, bool struck,
                        const std::optional<HandForce::Holding>& holding, FrameRecord& record) {
  ViewerState& own = record.viewers[viewer];
  if (forces_[viewer])
    forces_[viewer]->post(hand, viewers.hand(viewer).wand.down != 0, holding, record.display_s, own);
  if (viewer != atDesk_) return;
  rumble_.set(rumbleStrength(hand, own.hand));
  if (struck && hand.device == kHandGamepad) rumble_.pulse();
}

}  // namespace carom
