#include "app/live/players.h"

#include "app/operator/wall_commands.h"
#include "cave/frame/bodies.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Returns a puck that a hand holds, with its motion in the room.
HandForce::Holding holdingOf(const BilliardSetup& game, std::size_t number, const FrameRecord& record) {
  const Puck& puck = game.pucks[number];
  const Displacement onBoard{1.0, {game.lightSpeed_m_s * puck.beta, 0.0}};
  const Displacement inRoom = record.boardFromRoom.inverse() * onBoard;
  return {puck.mass_kg, inRoom.dr_m / (inRoom.dt_s * game.lightSpeed_m_s)};
}

/// Notes what a force device did, and says what people should know.
void tellOf(HandForce& force, std::size_t viewer, Announcements& announcements, Decision& decision) {
  for (const ForceNote& note : force.takeNotes()) {
    decision.notes.push_back({std::string(note.what), note.value, viewer});
    announcements.sayTo(viewer, note.said, decision);
  }
}

}  // namespace

Players::Players(const Rig& rig, const Scenario& scenario, const std::optional<FrameRecord>& before)
    : scenario_(&scenario),
      cues_(kMostViewers, CueInteraction(scenario)),
      tasks_(scenario),
      sculpture_(rig, scenario, before) {
  if (!before) return;
  match_ = Match(*before);
  for (const ViewerState& viewer : before->present())
    strokes_ += static_cast<std::uint32_t>(viewer.score.strokes);
}

void Players::showBestShot(std::span<const Command> commands, bool isInterrupted,
                           Announcements& announcements, Decision& decision) {
  const double now_s = decision.frame.record.display_s;
  const ShowBestShot* const asked = lastOf<ShowBestShot>(commands);
  const bool isAsked = asked && (!asked->isEnd || shots_.hasBest());
  const bool wasOn = replay_.look(shots_, now_s, (isAsked && !asked->isEnd) || isInterrupted);
  if (isAsked && asked->isKept && shots_.hasBest()) {
    replay_.beginAtEnd(now_s);
    decision.keepsShot = true;
    announcements.say(texts::message::kShotKept, decision);
  } else if (!wasOn) {
    if (isAsked && shots_.hasBest()) {
      replay_.begin(now_s, asked->isEnd);
      announcements.tellWhoseShot(striker_, shots_.bestCushions(), asked->isEnd, decision);
    } else if (isAsked) {
      announcements.say(texts::message::kNoCarom, decision);
    }
  }
  decision.showsShot = replay_.isOn();
}

void Players::act(const HandRules& rules, const Viewers& viewers, PlayerInputs& inputs, Game& game,
                  Announcements& announcements, Decision& decision) {
  match_.putInto(decision.frame.record);
  for (std::size_t viewer = 0; viewer < viewers.size(); ++viewer)
    act(viewer, rules, viewers, inputs, game, announcements, decision);
  match_.putInto(decision.frame.record);
}

/// Does so for one hand. A press on one of the buttons of the front wall is neither a stroke nor an answer.
void Players::act(std::size_t viewer, const HandRules& rules, const Viewers& viewers, PlayerInputs& inputs,
                  Game& game, Announcements& announcements, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  ViewerState& own = record.viewers[viewer];
  auto [hand, pointed, command] = inputs.act(viewer, viewers, own.observer, record.display_s);
  if (pointed && hand.pressed) {
    inputs.letGo(viewer, pointed->action.kind == WallAction::Kind::home);
    command = commandOf(pointed->action, rules.settings, viewer);
    decision.isHandled = true;
    hand.held = false;
  }
  const SculptureStand::Touch touch = pointed || !rules.world
                                          ? SculptureStand::Touch{}
                                          : sculpture_.touch(hand, viewer, *rules.world, record);
  announcements.sayTo(viewer, touch.said, decision);
  if (touch.takes) {
    hand.held = hand.pressed = false;
    decision.isHandled = true;
  }
  if (hand.pressed && !command && rules.asks) announcements.sayTo(viewer, texts::message::kAsks, decision);
  if (command) {
    decision.handCommands.push_back({*command, viewer});
    answeredBy_ = viewer;
    decision.isHandled = true;
  }
  const CueInteraction::Outcome outcome = cues_[viewer].step(hand, !rules.mayStrike, game, record, viewer,
                                                             rules.link ? rules.link->promises() : nullptr);
  const bool isNew = scenario_->choices && scenario_->tour.empty() && own.score.strokes == 0;
  if (isNew && rules.mayStrike) cues_[viewer].offer(0, game, record, viewer);
  if (pointed && !own.hand.pulling) {
    own.hand.to_m = pointed->onWall_m;
    own.hand.target = 0;
  }
  if (touch.takes) {
    own.hand.to_m = touch.at_m;
    own.hand.target = 0;
  }
  if (outcome.stroke) struck(viewer, rules, outcome, decision);
  HandForce* const force = inputs.force(viewer);
  if (outcome.stroke && force) force->struck(outcome.stroke->puck, outcome.arrives_s);
  const auto held = hold(viewer, hand, rules, record);
  inputs.feel(viewer, viewers, hand, outcome.stroke.has_value(), held, record);
  if (force) tellOf(*force, viewer, announcements, decision);
  if (!held) announcements.sayTo(viewer, outcome.said, decision);
}

/// In a lesson for hands with force devices, a hand holds the puck that it points at when its button goes
/// down. Returns the puck that is held, also in the frame in which it is let go.
std::optional<HandForce::Holding> Players::hold(std::size_t viewer, const HandInput& hand,
                                                const HandRules& rules, const FrameRecord& record) {
  const bool isOffered = scenario_->lesson && scenario_->lesson->plan.holds && !rules.asks;
  std::optional<std::size_t>& puck = held_[viewer];
  const std::size_t target = record.viewers[viewer].hand.target, first = kFirstPuck;
  const std::size_t pucks = scenario_->billiard.pucks.size();
  if (isOffered && hand.pressed && target >= first && target < first + pucks) puck = target - first;
  if (!puck) return {};
  const HandForce::Holding holding = holdingOf(scenario_->billiard, *puck, record);
  if (!hand.held) puck.reset();
  return holding;
}

void Players::struck(std::size_t viewer, const HandRules& rules, const CueInteraction::Outcome& outcome,
                     Decision& decision) {
  decision.strokes.push_back(rules.link ? rules.link->struck(viewer, *outcome.stroke, outcome.isPutOff)
                                        : HandStroke{*outcome.stroke, viewer, 0, strokes_++, {}});
  match_.struck(viewer, decision.frame.record.viewerCount, outcome.stroke->puck, outcome.arrives_s);
  hit_.struck(outcome.stroke->puck, outcome.arrives_s);
  striker_ = viewer;
  shots_.struck();
  tasks_.struck(viewer, *outcome.stroke, outcome.arrives_s);
}

void Players::feel(const World& world, PlayerInputs& inputs, const FrameRecord& record) {
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    if (HandForce* const force = inputs.force(viewer)) force->see(world.events, record, viewer);
  }
}

void Players::see(const World& world, const OperatorSettings& settings, Announcements& announcements,
                  Decision& decision) {
  const std::span<const GameEvent> events = world.events;
  FrameRecord& record = decision.frame.record;
  shots_.see({record.viewers[striker_].observer, record.boardFromRoom, record.display_s});
  if (const auto seen = hit_.look(events, record); seen && seen->size() > 1)
    announcements.tellWhoSawFirst(*seen, decision);
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    const Event& eye = record.viewers[viewer].observer.middle.observation;
    const auto cushions = match_.look(viewer, events, eye, scenario_->billiard.lightSpeed_m_s);
    if (!cushions) continue;
    if (viewer == striker_) shots_.carom(*cushions, record.display_s);
    announcements.tellCarom(viewer, *cushions, decision);
  }
  match_.putInto(record);
  tasks_.look(settings, world, announcements, decision);
}

}  // namespace carom
