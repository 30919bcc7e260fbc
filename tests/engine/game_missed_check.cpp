// Contacts that are not in the list: see checkNoneMissed. Every pair of legs is looked at, in the frame in
// which both move with equal and opposite speeds; of what is found there, that is left out which billiard.h
// says is no collision.

#include "engine/game_checks.h"

namespace carom::test {

namespace {

struct Candidate {
  std::array<std::size_t, 2> puck{}, leg{};  // in the order of names
  Encounter encounter;
  Real moment = 0;
  std::array<Real, 2> own{}, turn{};
  bool withoutDelay = false;
  Real due() const { return std::max(own[0], own[1]); }
};

class MissedCheck {
 public:
  MissedCheck(const GameRecord& record, Findings& findings)
      : game_(record), followed_(record.followed), found_(findings) {}

  void check(std::size_t first, std::size_t second) {
    const auto& a = game_.legs[first];
    const auto& b = game_.legs[second];
    std::size_t from = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      // In their frame simultaneous with one leg can be what the board shows before or after.
      const Real slack = 4 * (game_.radius(first) + game_.radius(second)) * a[k].u.t;
      while (from + 1 < b.size() && b[from].end + slack * b[from].u.t < a[k].start.t) ++from;
      for (std::size_t l = from; l < b.size() && b[l].start.t < a[k].end + slack * b[l].u.t; ++l)
        checkLegs({first, second}, {k, l});
    }
  }

  // Reports what is missed. A puck also waits at contacts of which nothing came: by its own moments it has
  // each before its next turn, which begins the leg after only when the contact's other puck has come as far.
  void report() {
    for (const Candidate& c : dropped_) {
      for (int i = 0; i < 2; ++i) {
        const auto& legs = game_.legs[c.puck[i]];
        for (std::size_t k = c.leg[i] + 1; k < legs.size(); ++k) {
          Real& from = followed_[c.puck[i]][k][0];
          if (c.own[i] < legs[k].start.t) from = std::max(from, c.due());
        }
      }
    }
    for (const Candidate& c : missed_) {
      if (areFollowedTogether(c) && !isExcused(c)) report(c);
    }
  }

 private:
  const CheckedLeg& leg(const Candidate& c, int i) const { return game_.legs[c.puck[i]][c.leg[i]]; }

  void checkLegs(std::array<std::size_t, 2> puck, std::array<std::size_t, 2> which) {
    ++found_.tally["pairs of legs"];
    Candidate c;
    c.puck = puck, c.leg = which;
    const CheckedLeg &a = leg(c, 0), &b = leg(c, 1);
    if (!areFollowedTogether(c)) return;
    const Real reach = game_.radius(puck[0]) + game_.radius(puck[1]);
    if (std::max(a.start.t, b.start.t) > game_.until || pass(a, b, reach)) return;
    const bool meets =
        a.brake > 0 ? findBraked(c, a, b, reach) : findStraight(c, a.start.t, b.start.t, reach);
    if (!meets || isListed(c)) return;
    const bool found = c.own[0] < a.end && c.own[1] < b.end;
    if (!isExcused(c))
      missed_.push_back(c);
    else if (found)
      dropped_.push_back(c);
  }

  bool areFollowedTogether(const Candidate& c) const {
    const auto& one = followed_[c.puck[0]][c.leg[0]];
    const auto& other = followed_[c.puck[1]][c.leg[1]];
    return one[0] < other[1] && other[0] < one[1];
  }

  void report(const Candidate& c) {
    const Real reach = game_.radius(c.puck[0]) + game_.radius(c.puck[1]);
    const Four contact = c.encounter.contactAt(c.moment, game_.radius(c.puck[0]) / reach);
    found_.expect(false, c.withoutDelay ? "approach" : "missed", game_.setup->pucks[c.puck[0]].name, " and ",
                  game_.setup->pucks[c.puck[1]].name, c.withoutDelay ? " overlap and approach" : " touch",
                  " at ", contact.t / game_.c, " s, (", contact.x, ", ", contact.y, ") m, on legs ", c.leg[0],
                  " and ", c.leg[1], "; own moments ", c.own[0] / game_.c, " and ", c.own[1] / game_.c,
                  " s, turns ", c.turn[0] / game_.c, " and ", c.turn[1] / game_.c, " s");
  }

  // A quick no: their ways on the board stay apart by more than the radii, which contraction can only lessen.
  bool pass(const CheckedLeg& a, const CheckedLeg& b, Real reach) const {
    if (a.brake > 0) return a.u.t == 1 && b.u.t == 1;
    const Encounter e = encounterOf(a, b, std::max(a.start.t, b.start.t));
    return !(std::abs(e.offset) < reach) || !(e.speed > 1e-9L);
  }

  // Fills in the moments of a contact at a moment of the frame.
  void place(Candidate& c, Real moment, Real reach) const {
    const Encounter& e = c.encounter;
    c.moment = moment;
    const Four contact = e.contactAt(moment, game_.radius(c.puck[0]) / reach);
    for (int i = 0; i < 2; ++i) {
      const Real simultaneous = (moment - e.moment[i]) / e.gamma, rest = product(e.u[i], contact - e.x[i]);
      const Real own = game_.atCentre() ? rest : simultaneous;
      const Real turn = game_.atCentre() ? rest + game_.radius(c.puck[i]) : simultaneous;
      c.own[i] = e.x[i].t + e.u[i].t * own;
      c.turn[i] = e.x[i].t + e.u[i].t * turn;
    }
  }

  // What the rules of billiard.h make of two straight flights that hold from board times `start1` and
  // `start2`. Where rounding decides, none.
  bool findStraight(Candidate& c, Real start1, Real start2, Real reach) const {
    c.withoutDelay = false;
    c.encounter = encounterOf(leg(c, 0), leg(c, 1), std::max(start1, start2));
    return decide(c, {start1, start2}, reach);
  }

  bool decide(Candidate& c, std::array<Real, 2> start, Real reach) const {
    const Encounter& e = c.encounter;
    const Real rounding = roundingOf(e);
    if (!(std::abs(e.offset) < reach - rounding)) return false;
    const std::optional<Real> touch = e.touch(reach);
    if (!touch) return false;
    Real later = -kEndless;  // of the starts, as a moment of the frame
    for (int i = 0; i < 2; ++i) later = std::max(later, e.momentOf(i, {start[i], 0, 0}));
    const Real ahead = e.distanceAt(later);
    place(c, *touch, reach);
    const bool approaching = ahead > rounding, both = start[0] == 0 && start[1] == 0;
    if (!game_.atCentre()) {
      if (!approaching) return false;
      if (*touch > later) return true;
    } else {
      bool heard = true, early = false;
      for (int i = 0; i < 2; ++i) {
        const Real since = c.turn[i] - start[i];
        if (std::abs(since) < rounding + leg(c, i).brake * since * since) return false;
        heard = heard && c.turn[i] > start[i];
        early = early || (c.own[i] < start[i] && start[i] > 0);
      }
      if (both) return heard && e.contactAt(*touch, game_.radius(c.puck[0]) / reach).t > rounding;
      if (heard) return approaching || (ahead < -rounding && !early);
      if (!approaching || !(*touch < later)) return false;
    }
    c.withoutDelay = true;
    place(c, later, reach);
    for (int i = 0; i < 2; ++i) {
      c.turn[i] = e.x[i].t + e.u[i].t * ((later - e.moment[i]) / e.gamma);
      c.own[i] = c.turn[i] - (game_.atCentre() ? e.u[i].t * game_.radius(c.puck[i]) : 0);
    }
    return true;
  }

  // With friction: the first board time at which the gap of the flights that touch the legs closes, the later
  // leg continued backwards. The discs are apart wherever the centres are on the board.
  bool findBraked(Candidate& c, const CheckedLeg& a, const CheckedLeg& b, Real reach) const {
    const Real start = std::max(a.start.t, b.start.t), slack = 2 * reach * (a.u.t + b.u.t);
    const Real end =
        std::min({std::max(a.restsAt(), b.restsAt()), std::min(a.end, b.end) + slack, game_.until + slack});
    const auto gapAt = [&](Real t) { return encounterOf(a, b, t).gapAt(0, reach); };
    Real before = start - slack;
    for (Real t = before; t < end;) {
      const CheckedLeg::LegState ma = a.at(t), mb = b.at(t);
      const Real apart = lengthInPlane(ma.x - mb.x);
      const Real speed = lengthInPlane(ma.u) / ma.u.t + lengthInPlane(mb.u) / mb.u.t;
      if (!(speed > 0)) return false;
      if (apart <= 1.1L * reach && gapAt(t) < 0) {
        if (t > before && touchesBetween(c, before, t, reach, gapAt) && !c.withoutDelay) return true;
        if (!(gapAt(start) < 0)) return false;
        c.withoutDelay = false;
        c.encounter = encounterAtLaterStart(a, b);
        return decide(c, {a.start.t, b.start.t}, reach);
      }
      before = t;
      t += std::max(apart - reach, Real(0.01) * reach) / speed;
    }
    return false;
  }

  template <class Function>
  bool touchesBetween(Candidate& c, Real low, Real high, Real reach, const Function& gapAt) const {
    for (int halving = 0; halving < 200; ++halving) {
      const Real middle = (low + high) / 2;
      if (!(middle > low && middle < high)) break;
      (gapAt(middle) < 0 ? high : low) = middle;
    }
    c.encounter = encounterOf(leg(c, 0), leg(c, 1), high);
    if (!(c.encounter.speed > 1e-9L && c.encounter.distance > roundingOf(c.encounter))) return false;
    return decide(c, {leg(c, 0).start.t, leg(c, 1).start.t}, reach);
  }

  bool isListed(const Candidate& c) const {
    for (const Part& part : game_.parts[c.puck[0]]) {
      if (part.partner != static_cast<int>(c.puck[1])) continue;
      const Part* other = game_.partOf(c.puck[1], part.event);
      const Real near = 1e-6L * (game_.radius(c.puck[0]) + game_.radius(c.puck[1])) * c.encounter.gamma;
      if ((part.leg == c.leg[0] && other->leg == c.leg[1]) ||
          (std::abs(part.own - c.own[0]) < near && std::abs(other->own - c.own[1]) < near))
        return true;
    }
    return false;
  }

  bool isExcused(const Candidate& c) const {
    for (int i = 0; i < 2; ++i) {
      const Real rounding = 1e-6L * game_.radius(c.puck[i]) * c.encounter.u[i].t;
      if (c.due() > game_.until - rounding) return true;
      // Found on the leg after, or begun too late.
      if (c.own[i] > leg(c, i).end - rounding) return true;
      if (isLateSignal(c, i, rounding)) return true;
    }
    return recede(c) || collidedLast(c) || isJammed(c);
  }

  // Had this part of puck i been decided when the contact came to be known, or due? A puck meets its contacts
  // in the order of its own moments.
  bool isDecided(const Part& part, const Candidate& c, int which) const {
    if (part.own < c.own[which]) return true;
    for (int i = 0; i < 2; ++i) {
      const int maker = game_.partOfKnot[c.puck[i]][c.leg[i]];
      if (maker >= 0 && part.event <= game_.parts[c.puck[i]][static_cast<std::size_t>(maker)].event)
        return true;
    }
    const Real known = std::max(followed_[c.puck[0]][c.leg[0]][0], followed_[c.puck[1]][c.leg[1]][0]);
    return part.decidedFrom < std::max(known, c.due()) + 1e-6L * game_.radius(c.puck[0]) * c.encounter.u[0].t;
  }

  // What came after the contact is decided already, or a turn that its signal, on the world line as it then
  // stands, would precede.
  bool isLateSignal(const Candidate& c, int i, Real rounding) const {
    const Real known = std::max(leg(c, 0).start.t, leg(c, 1).start.t);
    const Real reach = game_.radius(c.puck[0]) + game_.radius(c.puck[1]);
    const Four contact = c.encounter.contactAt(c.moment, game_.radius(c.puck[0]) / reach);
    for (const Part& part : game_.parts[c.puck[i]]) {
      if (part.knot <= c.leg[i]) continue;
      if (part.leg == c.leg[i] && part.own > c.own[i] - rounding && part.decidedFrom < known + rounding)
        return true;
      if (!isDecided(part, c, i)) continue;
      const CheckedLeg& after = game_.legs[c.puck[i]][part.knot];
      if (part.turn > c.turn[i] - rounding) return true;
      if (game_.atCentre() && !c.withoutDelay && after.whenHeard(contact) < after.start.t + rounding)
        return true;
    }
    return false;
  }

  // By the momenta that were decided by then.
  bool recede(const Candidate& c) const {
    std::array<std::size_t, 2> last = c.leg;
    for (int i = 0; i < 2; ++i) {
      for (const Part& part : game_.parts[c.puck[i]]) {
        if (part.knot > last[i] && isDecided(part, c, i)) last[i] = part.knot;
      }
    }
    const Encounter& e = c.encounter;
    const Four n =
        fromFrame(e.U, e.ahead * (e.gamma * e.gamma * e.distanceAt(c.moment)) + e.aside * e.offset);
    for (std::size_t k = c.leg[0]; k <= last[0]; ++k) {
      for (std::size_t l = c.leg[1]; l <= last[1]; ++l) {
        const Four p1 = momentum(c, 0, k), p2 = momentum(c, 1, l), P = p1 + p2;
        const Real towards = product(p1, n - e.U * (product(n, P) / product(e.U, P)));
        const Real size = lengthInPlane(p1) + lengthInPlane(p2);
        if (!(towards < -1e-9L * size * lengthInPlane(n))) return true;
      }
    }
    return false;
  }
  Four momentum(const Candidate& c, int i, std::size_t k) const {
    const Four& u = k == c.leg[i] ? c.encounter.u[i] : game_.legs[c.puck[i]][k].u;
    return u * game_.mass(c.puck[i]);
  }

  // With each other, and nothing has happened to either since.
  bool collidedLast(const Candidate& c) const {
    const auto lastOf = [&](int i) {
      const Part* last = nullptr;
      for (const Part& part : game_.parts[c.puck[i]]) {
        if (part.knot > 0 && isDecided(part, c, i)) last = &part;
      }
      return last;
    };
    const Part *a = lastOf(0), *b = lastOf(1);
    return a && b && a->event == b->event;
  }

  // Pucks that press on one another are left alone where they close slowly.
  bool isJammed(const Candidate& c) const {
    const Encounter& e = c.encounter;
    const Real ahead = e.gamma * e.distanceAt(c.moment);
    const Real closing = 2 * e.speed * e.gamma * ahead / std::hypot(ahead, e.offset);
    return (game_.jammed[c.puck[0]] || game_.jammed[c.puck[1]]) && closing < 1e-5L;
  }

  const GameRecord& game_;
  std::vector<std::vector<std::array<Real, 2>>> followed_;
  std::vector<Candidate> missed_, dropped_;  // contacts that are not in the list; the second by the rules
  Findings& found_;
};

}  // namespace

void checkNoneMissed(const GameRecord& game, Findings& found) {
  MissedCheck check(game, found);
  for (std::size_t a = 0; a < game.legs.size(); ++a) {
    for (std::size_t b = 0; b < game.legs.size(); ++b) {
      if (game.setup->pucks[a].name < game.setup->pucks[b].name) check.check(a, b);
    }
  }
  check.report();
}

}  // namespace carom::test
