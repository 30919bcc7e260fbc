// The game in a page: the same physics as in the room (engine/billiard), played on by the visitor.

#include <memory>
#include <string>

#include "app/page/engine/exchange.h"
#include "engine/billiard/billiard.h"

namespace carom::page {
namespace {

struct Played {
  BilliardSetup setup;
  std::unique_ptr<Billiard> billiard;
};

Played& played() {
  static Played game;
  return game;
}

PhysicsRules rulesOf(Given& given) {
  PhysicsRules rules;
  rules.puckRestitution = given.number();
  rules.cushionRestitution = given.number();
  rules.friction_m_s2 = given.number();
  rules.collisionEvent = static_cast<CollisionEvent>(static_cast<int>(given.number()));
  rules.puckFriction = given.number();
  rules.cushionFriction = given.number();
  rules.tangentialRestitution = given.number();
  rules.spinDeceleration_m_s2 = given.number();
  return rules;
}

Puck puckOf(Given& given) {
  Puck puck;
  puck.radius_m = given.number();
  puck.height_m = given.number();
  puck.mass_kg = given.number();
  puck.position_m = {given.number(), 0.0};
  puck.position_m.y = given.number();
  puck.beta.x = given.number();
  puck.beta.y = given.number();
  puck.inertia = given.number();
  puck.spin_kg_m2_s = given.number();
  puck.outline_m.resize(static_cast<std::size_t>(given.number()));
  for (Vec2& corner : puck.outline_m) {
    corner.x = given.number();
    corner.y = given.number();
  }
  for (auto letters = static_cast<int>(given.number()); letters > 0; --letters)
    puck.name += static_cast<char>(given.number());
  return puck;
}

Stroke strokeOf(Given& given) {
  Stroke stroke;
  stroke.puck = static_cast<std::size_t>(given.number());
  stroke.at_s = given.number();
  if (given.number() != 0.0) {
    stroke.from_m = given.vector();
  } else {
    given.vector();
  }
  stroke.momentum_kg_m_s.x = given.number();
  stroke.momentum_kg_m_s.y = given.number();
  stroke.offset_m = given.number();
  return stroke;
}

void answerEvent(Answer& answer, const GameEvent& event) {
  answer.number(static_cast<double>(event.number));
  answer.number(static_cast<double>(event.kind));
  answer.number(event.cushion ? 1.0 + static_cast<double>(*event.cushion) : 0.0);
  answer.event(event.at);
  answer.number(static_cast<double>(event.turns.size()));
  for (const Turn& turn : event.turns) {
    answer.number(static_cast<double>(turn.puck));
    answer.event(turn.event);
    answer.number(turn.betaAfter.x);
    answer.number(turn.betaAfter.y);
    answer.number(turn.properTime_s);
  }
}

}  // namespace

extern "C" {

/// Begins the given game: the board (0 or 1, length, width), the rules, the number of pucks and each of them
/// with the bytes of its name, the number of strokes and each of them, with or without the hand's place, the
/// number of flashes and each of their events. It must be one that can be played.
CAROM_EXPORTED(beginGame) void beginGame() {
  Given given;
  BilliardSetup setup;
  setup.lightSpeed_m_s = bodies().lightSpeed_m_s;
  const bool hasBoard = given.number() != 0.0;
  const double length_m = given.number(), width_m = given.number();
  if (hasBoard) setup.board = Board{length_m, width_m};
  setup.rules = rulesOf(given);
  for (auto pucks = static_cast<int>(given.number()); pucks > 0; --pucks)
    setup.pucks.push_back(puckOf(given));
  for (auto strokes = static_cast<int>(given.number()); strokes > 0; --strokes)
    setup.strokes.push_back(strokeOf(given));
  for (auto flashes = static_cast<int>(given.number()); flashes > 0; --flashes)
    setup.flashes.push_back({"", given.event()});
  played() = {setup, std::make_unique<Billiard>(setup)};
}

/// Plays on to a board time.
CAROM_EXPORTED(playTo) void playTo(double t_s) { played().billiard->advanceTo(t_s); }

/// Strikes a puck by the given stroke. Returns when it arrives, by the board's time.
CAROM_EXPORTED(strikePuck) double strikePuck() {
  Given given;
  return played().billiard->strike(strokeOf(given));
}

/// Gives the pucks of the visit, bodies 1 …, what has changed in the game since the last call, and answers
/// with it: the board time from which on it is another (or no number), the number of knots, and each with its
/// body.
CAROM_EXPORTED(takeChanges) void takeChanges() {
  const Changes changes = played().billiard->takeChanges();
  Answer answer;
  std::vector<WorldLine>& lines = bodies().lines;
  answer.number(changes.truncatedFrom_s.value_or(1e300));
  for (std::size_t puck = 0; changes.truncatedFrom_s && puck < played().setup.pucks.size(); ++puck)
    lines[1 + puck].truncateFrom(*changes.truncatedFrom_s);
  answer.number(static_cast<double>(changes.knots.size()));
  for (const Changes::NewKnot& added : changes.knots) {
    lines[1 + added.puck].append(added.knot);
    answer.number(1.0 + static_cast<double>(added.puck));
    answer.knot(added.knot);
  }
}

/// Answers with the game's events: their number, and of each its number, kind, cushion (from 1), event and
/// turns.
CAROM_EXPORTED(gameEvents) void gameEvents() {
  Answer answer;
  answer.number(static_cast<double>(played().billiard->events().size()));
  for (const GameEvent& event : played().billiard->events()) answerEvent(answer, event);
}

}  // extern "C"

}  // namespace carom::page
