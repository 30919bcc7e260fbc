#include "engine/game_record.h"

#include <glm/geometric.hpp>

namespace carom::test {

namespace {

bool isSameTurn(const Turn& turn, const Knot& knot) {
  const Vec3 beta = betaFromU(knot.u);
  return turn.event.t_s == knot.turn.t_s && turn.event.r_m == knot.turn.r_m &&
         glm::distance(Vec2(beta), turn.betaAfter) <= 4e-16;
}

}  // namespace

Encounter encounterOf(const CheckedLeg& first, const CheckedLeg& second, Real t) {
  return encounterOf(first.at(t), second.at(t));
}

Encounter encounterOf(const CheckedLeg::LegState& a, const CheckedLeg::LegState& b) {
  Encounter e;
  e.x = {a.x, b.x}, e.u = {a.u, b.u};
  const Four sum = a.u + b.u;
  e.U = sum * (1 / std::sqrt(product(sum, sum)));
  const Four motion = inFrame(e.U, a.u);
  const Real u = lengthInPlane(motion);
  e.gamma = std::sqrt(1 + u * u), e.speed = u / e.gamma;
  e.ahead = u > 0 ? Four{0, motion.x / u, motion.y / u} : Four{0, 1, 0};
  e.aside = {0, -e.ahead.y, e.ahead.x};
  const Four D = inFrame(e.U, b.x - a.x);
  e.moment = {0, D.t};
  // The second comes along −ahead: at the first's moment it was this much farther on.
  e.distance = D.x * e.ahead.x + D.y * e.ahead.y + e.speed * D.t;
  e.offset = D.x * e.aside.x + D.y * e.aside.y;
  return e;
}

Encounter encounterAtLaterStart(const CheckedLeg& first, const CheckedLeg& second) {
  const CheckedLeg* const legs[2] = {&first, &second};
  std::array<CheckedLeg::LegState, 2> at{first.at(first.start.t), second.at(second.start.t)};
  const Real lead = product(at[0].u + at[1].u, at[1].x - at[0].x);
  const int earlier = lead > 0 ? 0 : 1;
  const CheckedLeg::LegState& later = at[1 - earlier];
  const Real t = first.brake == 0 ? legs[earlier]->whenSimultaneous(at[0].u + at[1].u, later.x)
                                  : legs[earlier]->whenRises(at[earlier].x.t, [&](const auto& m) {
                                      return product(m.u + later.u, m.x - later.x);
                                    });
  at[earlier] = legs[earlier]->at(t);
  return encounterOf(at[0], at[1]);
}

Four Encounter::contactAt(Real moment_m, Real share) const {
  const Four apart = ahead * distanceAt(moment_m) + aside * offset;
  return at(0, moment_m) + fromFrame(U, apart) * share;
}

Real roundingOf(const Encounter& e) {
  return 8 * e.gamma * (e.u[0].t + e.u[1].t) * (roundingAt(e.x[0]) + roundingAt(e.x[1]));
}

Real roundingOfWay(const Encounter& e, Real brake) {
  const Real sum = e.u[0].t + e.u[1].t;
  const Real wrong = 8 * kUlp * sum * sum + brake * (roundingAt(e.x[0]) + roundingAt(e.x[1]));
  return wrong < e.gamma * e.speed ? wrong / (e.gamma * e.speed) : 1;
}

namespace {

// A contact, as the flights of two legs have it.
struct Reading {
  Contact contact;
  Real off = kEndless;
  std::array<Real, 2> own{};
};

Reading readContactAt(const GameRecord& game, std::array<std::size_t, 2> who, const Encounter& e,
                      const Four& contact, bool touching) {
  const Real reach = game.radius(who[0]) + game.radius(who[1]);
  const Real moment = product(e.U, contact - e.x[0]);
  const Four miss = contact - e.contactAt(moment, game.radius(who[0]) / reach);
  Reading reading;
  reading.contact = {e, moment};
  reading.off = (touching ? std::abs(e.gapAt(moment, reach)) : 0) + std::abs(miss.t) + lengthInPlane(miss);
  for (int i = 0; i < 2; ++i) {
    const Real s = game.atCentre() ? product(e.u[i], contact - e.x[i]) : (moment - e.moment[i]) / e.gamma;
    reading.own[i] = e.x[i].t + e.u[i].t * s;
  }
  return reading;
}

// With friction the flights are those that touch the legs at the first's moment of the contact, or where the
// later leg begins, on the board or in their frame.
Reading readContact(const GameRecord& game, std::array<std::size_t, 2> who, const CheckedLeg& first,
                    const CheckedLeg& second, const Four& contact) {
  Encounter e = encounterOf(first, second, std::max(first.start.t, second.start.t));
  const Reading atStart = readContactAt(game, who, e, contact, true);
  if (first.brake == 0) return atStart;
  const Reading inContact = readContactAt(game, who, encounterAtLaterStart(first, second), contact, true);
  Real t = kEndless;
  for (int step = 0; step < 60; ++step) {
    const Real better = first.whenSimultaneous(e.U, contact);
    if (better == t) break;
    e = encounterOf(first, second, t = better);
  }
  const Reading there = readContactAt(game, who, e, contact, true);
  const Reading& begun = inContact.off < atStart.off ? inContact : atStart;
  return there.off < begun.off ? there : begun;
}

}  // namespace

// A signal can chase a fast centre for long, which can turn often meanwhile. The leg of a contact is the
// latest before the turn that fits.
void GameRecord::findLegsOfCollision(const GameEvent& event, Part& first, Part& second) {
  const std::array<std::size_t, 2> who = pair(event);
  const auto& a = legs[who[0]];
  const auto& b = legs[who[1]];
  Real& best = first.off = kEndless;
  bool fits = false;
  const auto consider = [&](std::size_t k, std::size_t l) {
    const Reading reading = readContact(*this, who, a[k], b[l], place(event.at));
    const Real reach = radius(who[0]) + radius(who[1]);
    const Real tolerance =
        roundingOf(reading.contact.encounter) + reach * roundingOfWay(reading.contact.encounter, a[k].brake);
    const bool last = k + 1 == first.knot && l + 1 == second.knot;
    const bool inTime = reading.own[0] <= a[k].end + tolerance && reading.own[1] <= b[l].end + tolerance;
    if (!(reading.off < best) || !(inTime || last)) return;
    contacts[first.event] = reading.contact;
    fits = reading.off <= roundingOf(reading.contact.encounter);
    first.leg = k, second.leg = l;
    first.own = reading.own[0], second.own = reading.own[1];
    first.off = second.off = reading.off;
    first.tolerance = second.tolerance = tolerance;
  };
  for (std::size_t k = first.knot; k-- > 0;) {
    for (std::size_t l = second.knot; l-- > 0 && !fits;) consider(k, l);
  }
}

// Kicked as the later of the two legs begins, as their frame has it.
void GameRecord::placeWithoutDelay(const GameEvent& event, Part& first, Part& second) {
  const std::array<std::size_t, 2> who = pair(event);
  Real& best = first.off = kEndless;
  bool fits = false;
  const auto consider = [&](std::size_t k, std::size_t l) {
    const CheckedLeg &a = legs[who[0]][k], &b = legs[who[1]][l];
    const Encounter e = encounterAtLaterStart(a, b);
    const Reading reading = readContactAt(*this, who, e, place(event.at), false);
    const Real moment = reading.contact.moment;
    const Real early = moment - std::max(e.momentOf(0, e.x[0]), e.momentOf(1, e.x[1]));
    const Real reach = radius(who[0]) + radius(who[1]);
    const Real wrong = std::max(Real(0), e.gapAt(moment, reach)) + std::max(Real(0), -e.distanceAt(moment));
    const Real off = reading.off + std::abs(early) + wrong;
    if (!(off < best)) return;
    contacts[first.event] = reading.contact;
    fits = off <= roundingOf(reading.contact.encounter);
    first.leg = k, second.leg = l;
    first.off = second.off = off;
    first.tolerance = second.tolerance = roundingOf(e) + reach * roundingOfWay(e, a.brake);
    for (int i = 0; i < 2; ++i)
      (i == 0 ? first : second).own = e.at(i, moment).t - (atCentre() ? e.u[i].t * radius(who[i]) : 0);
  };
  for (std::size_t k = first.knot; k-- > 0;) {
    for (std::size_t l = second.knot; l-- > 0 && !fits;) consider(k, l);
  }
}

void GameRecord::findLegOfBounce(const GameEvent& event, Part& part) const {
  const std::size_t puck = event.turns[0].puck;
  const Four contact = place(event.at);
  const bool alongX = *event.cushion == Cushion::plusX || *event.cushion == Cushion::minusX;
  Real best = kEndless;
  for (std::size_t k = part.knot; k-- > 0 && !(best <= part.tolerance);) {
    const CheckedLeg& leg = legs[puck][k];
    CheckedLeg::LegState own = leg.at(contact.t);
    Real off = 0;
    if (atCentre()) {
      own = leg.at(leg.whenRises(contact.t, [&](const auto& m) { return product(m.u, m.x - contact); }));
      const Four apart = contact - own.x;
      off = std::abs(std::sqrt(std::max(Real(0), -product(apart, apart))) - radius(puck));
    } else {
      const Real betaN = (alongX ? own.u.x : own.u.y) / own.u.t;
      const Real away = alongX ? contact.x - own.x.x : contact.y - own.x.y;
      off = std::abs(std::abs(away) - radius(puck) * std::sqrt((1 - betaN) * (1 + betaN)));
    }
    if (!(off < best) || (k + 1 < part.knot && own.x.t > leg.end + roundingAt(contact))) continue;
    best = off;
    part.leg = k, part.own = own.x.t, part.off = off;
    part.tolerance = 8 * leg.u.t * leg.u.t * roundingAt(contact);
  }
}

std::array<std::size_t, 2> GameRecord::pair(const GameEvent& event) const {
  const std::size_t a = event.turns[0].puck, b = event.turns[1].puck;
  if (setup->pucks[a].name < setup->pucks[b].name) return {a, b};
  return {b, a};
}

const Part* GameRecord::partOf(std::size_t puck, std::size_t event) const {
  for (const Part& part : parts[puck]) {
    if (part.event == event) return &part;
  }
  return nullptr;
}

// A turn and its knot have the same bits, but for the velocity, which the one gives as β and the other as γβ.
void GameRecord::findKnots(const Billiard& billiard) {
  for (std::size_t e = 0; e < events.size(); ++e) {
    for (const Turn& turn : events[e].turns) {
      Part part;
      part.event = e;
      part.own = part.turn = part.due = Real(turn.event.t_s) * c;
      if (events[e].turns.size() == 2)
        part.partner = static_cast<int>(events[e].turns[&turn == events[e].turns.begin() ? 1 : 0].puck);
      part.idle = events[e].cushion && events[e].heat_j == 0.0 && turn.betaBefore == turn.betaAfter;
      const Knots knots = billiard.worldLines()[turn.puck].knots();
      for (std::size_t k = 1; k < knots.size() && part.knot == 0 && !part.idle; ++k) {
        if (partOfKnot[turn.puck][k] >= 0 || !isSameTurn(turn, knots[k])) continue;
        part.knot = k, part.leg = k - 1;
        partOfKnot[turn.puck][k] = static_cast<int>(parts[turn.puck].size());
      }
      parts[turn.puck].push_back(part);
    }
  }
}

void GameRecord::findLegs(std::size_t e) {
  const GameEvent& event = events[e];
  std::array<Part*, 2> part{};
  for (std::size_t i = 0; i < event.turns.size(); ++i) {
    const std::size_t puck = event.turns.size() == 2 ? pair(event)[i] : event.turns[i].puck;
    part[i] = const_cast<Part*>(partOf(puck, e));
    if (part[i]->knot == 0) return;
  }
  const bool withoutDelay = event.withoutDelay;
  if (event.kind == EventKind::puckPuck) {
    if (withoutDelay)
      placeWithoutDelay(event, *part[0], *part[1]);
    else
      findLegsOfCollision(event, *part[0], *part[1]);
  } else if (event.kind == EventKind::puckCushion) {
    if (!withoutDelay)
      findLegOfBounce(event, *part[0]);
    else if (atCentre())
      part[0]->own -= legs[event.turns[0].puck][part[0]->leg].u.t * radius(event.turns[0].puck);
  }
  for (Part* p : part) {
    if (p) p->due = std::max(part[0]->own, part[1] ? part[1]->own : part[0]->own);
  }
}

// A leg is followed once its turn has come and everything has been decided that the puck had before, by its
// own moments.
void GameRecord::findFollowed() {
  std::vector<Real> decidedBy(events.size(), 0);
  Real latest = 0;
  for (std::size_t e = 0; e < events.size(); ++e) {
    for (const Turn& turn : events[e].turns) latest = std::max(latest, partOf(turn.puck, e)->due);
    decidedBy[e] = latest;
  }
  for (std::size_t puck = 0; puck < legs.size(); ++puck) {
    auto& own = followed.emplace_back(legs[puck].size(), std::array<Real, 2>{0, kEndless});
    for (std::size_t k = 1; k < own.size(); ++k) {
      if (partOfKnot[puck][k] < 0) continue;
      const Part& part = parts[puck][static_cast<std::size_t>(partOfKnot[puck][k])];
      own[k][0] = std::max(part.turn, decidedBy[part.event]);
      for (const Part& before : parts[puck]) {
        if (before.own < part.turn) own[k][0] = std::max(own[k][0], decidedBy[before.event]);
      }
      own[k - 1][1] = std::max(part.turn, part.decidedFrom);
    }
  }
}

GameRecord::GameRecord(const BilliardSetup& played, const Billiard& billiard, double playedUntil_s)
    : setup(&played), c(played.lightSpeed_m_s), until(Real(playedUntil_s) * c) {
  events.assign(billiard.events().begin(), billiard.events().end());
  jammed.assign(played.pucks.size(), false);
  for (const JamNote& note : billiard.jams()) jammed[note.puck] = true;
  for (const GameEvent& event : events) {
    const bool jam = event.kind == EventKind::jam;
    if (jam) jammed[event.turns[0].puck] = true;
  }
  for (const WorldLine& line : billiard.worldLines()) {
    std::vector<CheckedLeg>& own = legs.emplace_back();
    for (std::size_t k = 0; k < line.knots().size(); ++k)
      own.push_back(legFrom(line.knots(), k, played.lightSpeed_m_s));
    partOfKnot.emplace_back(line.knots().size(), -1);
  }
  parts.resize(legs.size());
  contacts.resize(events.size());
  findKnots(billiard);
  Real later = kEndless;
  for (std::size_t e = events.size(); e-- > 0;) {
    findLegs(e);
    for (const Turn& turn : events[e].turns) {
      Part* part = const_cast<Part*>(partOf(turn.puck, e));
      part->decidedFrom = later = std::min(later, part->due);
    }
  }
  // All of a jam is decided at once.
  for (std::size_t e = 1; e < events.size(); ++e) {
    const GameEvent &before = events[e - 1], &event = events[e];
    if (event.kind != EventKind::jam || before.kind != EventKind::jam || event.at.t_s != before.at.t_s)
      continue;
    Part* part = const_cast<Part*>(partOf(event.turns[0].puck, e));
    part->decidedFrom = std::min(part->decidedFrom, partOf(before.turns[0].puck, e - 1)->decidedFrom);
  }
  findFollowed();
}

}  // namespace carom::test
