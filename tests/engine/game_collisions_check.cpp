// Each collision, bounce and stroke by itself: see checkCollisions.

#include "engine/game_checks.h"

namespace carom::test {

namespace {

class CollisionCheck {
 public:
  CollisionCheck(const GameRecord& record, Findings& findings) : game_(record), found_(findings) {}

  void check(std::size_t number) {
    const GameEvent& event = game_.events[number];
    for (const Turn& turn : event.turns) {
      const Part* part = game_.partOf(turn.puck, number);
      if (part->knot == 0) return;  // said of the world line
    }
    said_ = "event " + std::to_string(number) + " at " + std::to_string(event.at.t_s) + " s: ";
    found_.expect(event.heat_j >= 0.0, "heat", said_, event.heat_j, " J");
    if (event.kind == EventKind::puckPuck) checkPair(number);
    if (event.kind == EventKind::puckCushion) checkBounce(number);
    if (event.kind == EventKind::stroke) checkStroke(number);
  }

 private:
  struct Side {
    std::size_t puck;
    const Part* part;
    Four before, after;  // four-velocities at the turn
    Four turn;
    bool struck = false;  // while the signal was on its way
  };

  Side sideOf(std::size_t number, std::size_t puck) const {
    const Part* part = game_.partOf(puck, number);
    const CheckedLeg& after = game_.legs[puck][part->knot];
    Side side{puck, part, game_.legs[puck][part->knot - 1].at(after.start.t).u, after.u, after.start};
    for (const Part& other : game_.parts[puck]) {
      if (game_.events[other.event].kind == EventKind::stroke && other.event > number &&
          other.turn <= part->turn)
        side.struck = true;
    }
    return side;
  }

  // What rounding may do to a momentum that a turn changes, in kg.
  Real roundingOfMomentum(const Side& side) const {
    const CheckedLeg& leg = game_.legs[side.puck][side.part->knot];
    return game_.mass(side.puck) *
           (64 * kUlp * (side.before.t + side.after.t) + 4 * leg.brake * roundingAt(side.turn));
  }

  void expectRestitution(Real seen, Real rule, Real tolerance, bool mayJam) {
    const bool asRuled = std::abs(seen - rule) <= tolerance;
    found_.expect(asRuled || (mayJam && std::abs(seen) <= tolerance), "restitution", said_, "restitution ",
                  seen, " instead of ", rule, " (within ", tolerance, ")");
  }

  // Heat makes both rest masses grow by one and the same m'² − m² = gained, so that the sum says how much
  // each has.
  void checkPair(std::size_t number) {
    ++found_.tally["collisions"];
    const GameEvent& event = game_.events[number];
    const std::array<std::size_t, 2> who = game_.pair(event);
    const Side a = sideOf(number, who[0]), b = sideOf(number, who[1]);
    placeOfPair(number, a, b);
    if (a.struck || b.struck) return;  // the stroke's account has the difference
    const Real m1 = game_.mass(a.puck), m2 = game_.mass(b.puck);
    const Real heat = Real(event.heat_j) / (game_.c * game_.c), sum = m1 + m2 + heat;
    const Real m1After = (sum + (m1 - m2) * (m1 + m2) / sum) / 2, m2After = sum - m1After;
    const Four left = a.before * m1 + b.before * m2 - a.after * m1After - b.after * m2After;
    const Real tolerance = roundingOfMomentum(a) + roundingOfMomentum(b);
    const Real wrong = std::abs(left.t) + lengthInPlane(left);
    found_.expect(wrong <= tolerance, "momentum", said_, "momentum is wrong by ", wrong, " kg c of ",
                  tolerance);
    const Four q = a.before * m1 - a.after * m1After;
    const Real gained = (m1After - m1) * (m1After + m1), q2 = -product(q, q);
    // Each end of q is known to within the tolerance, and q2 is small where they nearly miss.
    const Real rough = tolerance * (std::abs(q.t) + lengthInPlane(q));
    if (!(q2 > 1e8L * rough)) return;
    const bool jam = game_.jammed[a.puck] || game_.jammed[b.puck];
    expectRestitution((q2 - gained) / (q2 + gained), game_.setup->rules.puckRestitution,
                      1e-12L + 64 * rough / q2, jam);
    checkDirection(number, a, b, q, rough / q2);
  }

  // The kick is along the rims' common normal, less what would change the energy in the frame of the total
  // momentum.
  void checkDirection(std::size_t number, const Side& a, const Side& b, const Four& q, Real rough) {
    const Encounter& e = game_.contacts[number].encounter;
    const Four normal =
        e.ahead * (e.gamma * e.distanceAt(game_.contacts[number].moment)) + e.aside * e.offset;
    const Four n = fromFrame(
        e.U, e.ahead * (e.gamma * (normal.x * e.ahead.x + normal.y * e.ahead.y)) + e.aside * e.offset);
    const Four P = a.before * game_.mass(a.puck) + b.before * game_.mass(b.puck);
    const Four k = n - e.U * (product(n, P) / product(e.U, P));
    const Real kq = product(k, q), kk = product(k, k), qq = product(q, q);
    // Of vectors orthogonal to P the metric is definite: the sine of their angle.
    const Real sine = std::sqrt(std::max(Real(0), 1 - kq * kq / (kk * qq)));
    const Real reach = game_.radius(a.puck) + game_.radius(b.puck);
    const Real tolerance = 1e-7L + std::sqrt(64 * rough) + 1e3L * a.part->tolerance / reach;
    found_.expect(sine <= tolerance, "direction", said_, "the kick is off the normal by ", sine, " (",
                  tolerance, ")");
  }

  void placeOfPair(std::size_t number, const Side& a, const Side& b) {
    const GameEvent& event = game_.events[number];
    const Encounter& e = game_.contacts[number].encounter;
    if (event.withoutDelay) {
      ++found_.tally["without delay"];
      if (game_.jammed[a.puck] || game_.jammed[b.puck]) return;  // kicked with all that press on them
      found_.expect(a.part->off <= a.part->tolerance, "contact", said_, "kicked without delay, ", a.part->off,
                    " m from a contact as the later leg begins (", a.part->tolerance, ")");
      for (const Side* side : {&a, &b}) checkSimultaneous(event, e, *side);
      return;
    }
    found_.expect(a.part->off <= a.part->tolerance, "contact", said_, "the rims miss each other by ",
                  a.part->off, " m (", a.part->tolerance, ")");
    for (const Side* side : {&a, &b}) {
      if (game_.atCentre())
        checkSignal(event, *side);
      else
        checkSimultaneous(event, e, *side);
    }
  }

  // On the leg on which the contact was found; elsewhere, where its signal meets the centre.
  void checkSimultaneous(const GameEvent& event, const Encounter& e, const Side& side) {
    if (side.struck || side.part->leg + 1 != side.part->knot) return;
    const Real late = product(e.U, side.turn - game_.place(event.at));
    found_.expect(std::abs(late) <= side.part->tolerance, "cause", said_,
                  "a turn is not simultaneous with the contact by ", late, " m of light");
  }

  // The turn is where the contact's future cone meets the centre; two within 1e-9 of the radius are one.
  void checkSignal(const GameEvent& event, const Side& side) {
    const Four way = side.turn - game_.place(event.at);
    const Real late = way.t - lengthInPlane(way);
    const Real gamma = std::max(side.before.t, side.after.t);
    const Real rounding = roundingAt(side.turn), same = 4e-9L * game_.radius(side.puck) * gamma;
    found_.expect(late >= -rounding - same && late <= rounding + same, "cause", said_,
                  game_.setup->pucks[side.puck].name, " turns ", late,
                  " m of light after the signal of its contact reaches it");
  }

  void checkBounce(std::size_t number) {
    ++found_.tally["bounces"];
    const GameEvent& event = game_.events[number];
    const Side side = sideOf(number, event.turns[0].puck);
    const int axis = *event.cushion == Cushion::plusX || *event.cushion == Cushion::minusX ? 0 : 1;
    const Real sign = *event.cushion == Cushion::plusX || *event.cushion == Cushion::plusY ? 1 : -1;
    placeOfBounce(event, side, axis, sign);
    const Real m = game_.mass(side.puck), after = m + Real(event.heat_j) / (game_.c * game_.c);
    const Real normal = sign * (axis == 0 ? side.before.x : side.before.y),
               along = axis == 0 ? side.before.y : side.before.x;
    const Real normalAfter = sign * (axis == 0 ? side.after.x : side.after.y);
    const Real alongAfter = axis == 0 ? side.after.y : side.after.x;
    const Real tolerance = roundingOfMomentum(side);
    const Real wrong =
        std::abs(m * side.before.t - after * side.after.t) + std::abs(m * along - after * alongAfter);
    found_.expect(wrong <= tolerance, "momentum", said_, "cushion: energy or momentum along it wrong by ",
                  wrong, " kg c of ", tolerance);
    if (side.struck && !(normal > 0)) return;
    expectRestitution(-after * normalAfter / (m * normal), game_.setup->rules.cushionRestitution,
                      1e-12L + 8 * tolerance / (m * normal), game_.jammed[side.puck]);
  }

  void placeOfBounce(const GameEvent& event, const Side& side, int axis, Real sign) {
    const Four contact = game_.place(event.at);
    const Real half = Real(axis == 0 ? game_.setup->board->length_m : game_.setup->board->width_m) / 2;
    const Real otherHalf = Real(axis == 0 ? game_.setup->board->width_m : game_.setup->board->length_m) / 2;
    const Real across = sign * (axis == 0 ? contact.x : contact.y), along = axis == 0 ? contact.y : contact.x;
    found_.expect(std::abs(across - half) <= roundingAt(contact), "cushion", said_, "contact ", across - half,
                  " m off the cushion's edge");
    found_.expect(std::abs(along) <= otherHalf + side.part->tolerance, "cushion", said_, "contact ",
                  std::abs(along) - otherHalf, " m beyond the end of ", nameOf(*event.cushion));
    const Real inside = half - sign * (axis == 0 ? side.turn.x : side.turn.y);
    if (side.part->leg + 1 == side.part->knot)
      found_.expect(inside <= game_.radius(side.puck) + side.part->tolerance, "cushion", said_, "turned by ",
                    nameOf(*event.cushion), " from ", inside, " m away");
    if (event.withoutDelay) {
      ++found_.tally["without delay"];
      return;
    }
    // Beyond its end a cushion is touched at its end, which the disc covers by then.
    const bool atEnd = std::abs(along) >= otherHalf - roundingAt(contact);
    const Real missed = atEnd ? side.part->off - game_.radius(side.puck) : side.part->off;
    found_.expect(missed <= side.part->tolerance, "cushion", said_, "the rim misses ", nameOf(*event.cushion),
                  " by ", side.part->off, " m (", side.part->tolerance, ")");
    if (game_.atCentre()) return checkSignal(event, side);
    found_.expect(std::abs(side.turn.t - contact.t) <= side.part->tolerance, "cause", said_,
                  "the turn is not at the time of the contact");
  }

  void checkStroke(std::size_t number) {
    ++found_.tally["strokes"];
    const GameEvent& event = game_.events[number];
    const Side side = sideOf(number, event.turns[0].puck);
    const Stroke& stroke = game_.setup->strokes[event.which];
    const Real m = game_.mass(side.puck);
    const Vec2& p = stroke.momentum_kg_m_s;
    const Real wrong = std::abs(m * (side.after.x - side.before.x) - p.x / game_.c) +
                       std::abs(m * (side.after.y - side.before.y) - p.y / game_.c);
    found_.expect(wrong <= roundingOfMomentum(side), "momentum", said_, "stroke: wrong by ", wrong, " kg c");
    Real late = side.turn.t - Real(stroke.at_s) * game_.c;
    if (stroke.from_m) {
      const Real dx = side.turn.x - stroke.from_m->x, dy = side.turn.y - stroke.from_m->y;
      const Real dz = stroke.from_m->z - game_.setup->pucks[side.puck].height_m / 2;
      late -= std::sqrt(dx * dx + dy * dy + dz * dz);
    }
    found_.expect(std::abs(late) <= 16 * side.before.t * side.before.t * roundingAt(side.turn), "cause",
                  said_, "the stroke acts ", late, " m of light after its light arrives");
  }

  const GameRecord& game_;
  Findings& found_;
  std::string said_;
};

}  // namespace

void checkCollisions(const GameRecord& game, Findings& found) {
  CollisionCheck check(game, found);
  for (std::size_t number = 0; number < game.events.size(); ++number) check.check(number);
}

}  // namespace carom::test
