#include "engine/impact/disc_contacts.h"

#include "engine/collision/braked_contact.h"
#include "engine/collision/kick.h"

namespace carom {

namespace {

std::optional<BrakedMeeting> brakedMeeting(const GameState& game, const PuckPair& who) {
  return findBrakedMeeting({game.flightOf(who[0]), game.discs[who[0]].radius},
                           {game.flightOf(who[1]), game.discs[who[1]].radius}, game.rules.convention);
}

}  // namespace

std::optional<Meeting> DiscPair::meetingOf(const GameState& game, const PuckPair& who) const {
  if (game.rules.brake == 0.0)
    return findMeeting(game.discs[who[0]], game.discs[who[1]], game.rules.convention);
  const auto found = brakedMeeting(game, who);
  if (!found) return std::nullopt;
  return found->meeting;
}

// Discs that have just collided part.
bool DiscPair::haveMet(const GameState& game, int i, int other) const {
  return (game.predictions[i].lastPartner == other && game.predictions[other].lastPartner == i) ||
         game.handled(i, other) != nullptr;
}

GameContact DiscPair::contactOf(const GameState& game, const PuckPair& who, bool withoutDelay) const {
  const GameRules& rules = game.rules;
  GameContact found;
  // Among elastic bodies with corners discs bounce without loss, also where they are pressed.
  if (rules.outlines == nullptr || rules.puckRestitution != 1.0) found.jam = JamLaw::plastic;
  if (rules.brake == 0.0) {
    found.contact = carom::contactOf(game.discs[who[0]], game.discs[who[1]], withoutDelay);
    return found;
  }
  // Of the straight flights that touch the world lines.
  found.touchAt = brakedMeeting(game, who).value().touchAt;
  const auto flight = [&](int k) {
    return flightAt({game.legOf(who[k]), game.discs[who[k]].radius}, found.touchAt[k]);
  };
  found.contact = carom::contactOf(flight(0), flight(1), withoutDelay);
  return found;
}

// Whether discs recede does not depend on their masses, and so not on what the cloth has left of their spins:
// by P = m1 u1 + m2 u2,   p1·k = m1 m2 ((n·u1) (U·u2) − (n·u2) (U·u1))/(U·P).
bool DiscPair::recede(const GameState& game, const PuckPair& who, bool, GameContact& found) const {
  std::array<Vec21, 2> u = game.lastVelocities(who);
  std::array<double, 2> mass;
  for (int k = 0; k < 2; ++k) {
    if (game.rules.brake != 0.0) u[k] = momentAt(game.lastLeg(who[k]), found.touchAt[k]).u;
    mass[k] = game.massOf(who[k], game.lastTurning(who[k]).j);
  }
  return !kickPair(found.contact.U, found.contact.n, u, mass, 1.0);
}

std::optional<SpinningPairKick> DiscPair::kick(const GameState& game, const PuckPair& who,
                                               const PairContact& contact, const std::array<Vec21, 2>& u,
                                               const std::array<double, 2>& j, double restitution) const {
  const RimRules& rims = game.rules.puckRims;
  if (rims.friction != 0.0) {
    return kickSpinningPair(contact.U, contact.n,
                            {SpinningPuck{game.spins[who[0]].body, j[0], u[0]},
                             SpinningPuck{game.spins[who[1]].body, j[1], u[1]}},
                            GameRules::withRestitution(rims, restitution));
  }
  const auto kick =
      kickPair(contact.U, contact.n, u, {game.massOf(who[0], j[0]), game.massOf(who[1], j[1])}, restitution);
  if (!kick) return std::nullopt;
  return SpinningPairKick{*kick, j};
}

std::optional<CushionContact> DiscAtCushion::touchOf(const GameState& game, int i, const Leg& leg,
                                                     const Turning&, int cushion) const {
  return findContact(leg, game.discs[i].radius, game.rules.cushions[cushion], game.rules.convention);
}

std::optional<SpinningCushionKick> DiscAtCushion::kick(const GameState& game, int i, int cushion,
                                                       const Vec21&, const LegState& turn, double j,
                                                       double restitution) const {
  const CushionPlane& plane = game.rules.cushions[cushion];
  const RimRules& rims = game.rules.cushionRims;
  if (rims.friction != 0.0) {
    return kickSpinningOffCushion(plane, {game.spins[i].body, j, turn.u},
                                  GameRules::withRestitution(rims, restitution));
  }
  const auto kick = kickOffCushion(plane, turn.u, game.massOf(i, j), restitution);
  if (!kick) return std::nullopt;
  return SpinningCushionKick{*kick, j};
}

}  // namespace carom
