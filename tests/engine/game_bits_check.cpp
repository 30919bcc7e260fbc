// The same game told in other ways: see checkSameBits.

#include <algorithm>
#include <random>

#include "engine/game_checks.h"
#include "engine/random_game.h"

namespace carom::test {

namespace {

struct Mirror {
  double x = 1.0, y = 1.0;
  Vec2 operator()(const Vec2& v) const { return {x * v.x, y * v.y}; }
  Vec3 operator()(const Vec3& v) const { return {x * v.x, y * v.y, v.z}; }
  Event operator()(const Event& e) const { return {e.t_s, (*this)(e.r_m)}; }
  /// A spin, an angle, a distance to the right.
  double turned(double aside) const { return x * y * aside; }
  Cushion operator()(Cushion cushion) const {
    switch (cushion) {
      case Cushion::plusX:
        return x > 0.0 ? Cushion::plusX : Cushion::minusX;
      case Cushion::minusX:
        return x > 0.0 ? Cushion::minusX : Cushion::plusX;
      case Cushion::plusY:
        return y > 0.0 ? Cushion::plusY : Cushion::minusY;
      case Cushion::minusY:
        return y > 0.0 ? Cushion::minusY : Cushion::plusY;
    }
    return cushion;
  }
};

BilliardSetup mirrored(BilliardSetup setup, const Mirror& mirror) {
  for (Puck& puck : setup.pucks) {
    puck.position_m = mirror(puck.position_m), puck.beta = mirror(puck.beta);
    puck.spin_kg_m2_s = mirror.turned(puck.spin_kg_m2_s);
  }
  for (Stroke& stroke : setup.strokes) {
    stroke.momentum_kg_m_s = mirror(stroke.momentum_kg_m_s);
    stroke.offset_m = mirror.turned(stroke.offset_m);
    if (stroke.from_m) stroke.from_m = mirror(*stroke.from_m);
  }
  return setup;
}

// Place in the new order of each puck of the old.
BilliardSetup shuffled(const BilliardSetup& setup, std::vector<std::size_t>& placeOf) {
  std::vector<std::size_t> order(setup.pucks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937_64(setup.pucks.size()));
  BilliardSetup other = setup;
  placeOf.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    other.pucks[i] = setup.pucks[order[i]], placeOf[order[i]] = i;
  for (Stroke& stroke : other.strokes) stroke.puck = placeOf[stroke.puck];
  return other;
}

class SameBits {
 public:
  SameBits(const Billiard& game, double until_s, Findings& found)
      : game_(game), until_s_(until_s), found_(found) {}

  void expectSame(const Billiard& other, const char* how, const Mirror& mirror,
                  const std::vector<std::size_t>* placeOf) {
    if (expectSameLines(other.worldLines(), how, mirror, placeOf)) sameEvents(other, how, mirror, placeOf);
  }

  bool expectSameLines(std::span<const WorldLine> other, const char* how, const Mirror& mirror,
                       const std::vector<std::size_t>* placeOf) {
    ++found_.tally["games compared"];
    for (std::size_t puck = 0; puck < game_.worldLines().size(); ++puck) {
      const auto there = other[placeOf ? (*placeOf)[puck] : puck].knots();
      if (!sameKnots(game_.worldLines()[puck].knots(), there, how, mirror)) return false;
    }
    return true;
  }

 private:
  static bool same(const Knot& a, const Knot& b, const Mirror& mirror) {
    const Event turn = mirror(a.turn), signal = mirror(a.signal);
    return turn.t_s == b.turn.t_s && turn.r_m == b.turn.r_m && mirror(a.u) == b.u &&
           a.properTime_s == b.properTime_s && signal.t_s == b.signal.t_s && signal.r_m == b.signal.r_m &&
           a.deceleration_m_s2 == b.deceleration_m_s2 &&
           mirror.turned(a.spin.angle_rad) == b.spin.angle_rad &&
           mirror.turned(a.spin.omega_rad_s) == b.spin.omega_rad_s &&
           mirror.turned(a.spin.rim_u) == b.spin.rim_u && a.spin.slowing_1_s == b.spin.slowing_1_s;
  }

  // Up to the time that both have played to.
  bool sameKnots(Knots a, Knots b, const char* how, const Mirror& mirror) {
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      const bool here = k < a.size() && a[k].turn.t_s <= until_s_,
                 there = k < b.size() && b[k].turn.t_s <= until_s_;
      if (!here && !there) return true;
      const double when_s = here ? a[k].turn.t_s : b[k].turn.t_s;
      const bool holds = here && there && same(a[k], b[k], mirror);
      found_.expect(holds, "bits", how, ": another turn at ", when_s, " s");
      if (!holds) return false;
    }
    return true;
  }

  void sameEvents(const Billiard& other, const char* how, const Mirror& mirror,
                  const std::vector<std::size_t>* placeOf) {
    const auto isDue = [&](const GameEvent& e) {
      return (e.kind != EventKind::stroke && e.at.t_s <= until_s_) ||
             std::any_of(e.turns.begin(), e.turns.end(),
                         [&](const Turn& turn) { return turn.event.t_s <= until_s_; });
    };
    for (std::size_t e = 0; e < std::max(game_.events().size(), other.events().size()); ++e) {
      const GameEvent* a = e < game_.events().size() ? &game_.events()[e] : nullptr;
      const GameEvent* b = e < other.events().size() ? &other.events()[e] : nullptr;
      if (!(a && isDue(*a)) && !(b && isDue(*b))) continue;
      const bool holds = a && b && sameEvent(*a, *b, mirror, placeOf);
      found_.expect(holds, "bits", how, ": another event, ", e);
      if (!holds) return;
    }
  }

  bool sameEvent(const GameEvent& a, const GameEvent& b, const Mirror& mirror,
                 const std::vector<std::size_t>* placeOf) {
    const Event at = mirror(a.at);
    if (a.kind != b.kind || a.which != b.which || a.heat_j != b.heat_j || at.t_s != b.at.t_s ||
        at.r_m != b.at.r_m)
      return false;
    if (a.cushion.has_value() != b.cushion.has_value() || (a.cushion && mirror(*a.cushion) != *b.cushion))
      return false;
    if (a.turns.size() != b.turns.size()) return false;
    for (std::size_t i = 0; i < a.turns.size(); ++i) {
      const Turn &s = a.turns[i], &t = b.turns[i];
      const bool who = (placeOf ? (*placeOf)[s.puck] : s.puck) == t.puck;
      if (!who || s.event.t_s != t.event.t_s || mirror(s.event.r_m) != t.event.r_m ||
          s.properTime_s != t.properTime_s || mirror(s.betaBefore) != t.betaBefore ||
          mirror(s.betaAfter) != t.betaAfter || mirror.turned(s.spinBefore_kg_m2_s) != t.spinBefore_kg_m2_s ||
          mirror.turned(s.spinAfter_kg_m2_s) != t.spinAfter_kg_m2_s)
        return false;
    }
    return true;
  }

  const Billiard& game_;
  double until_s_;
  Findings& found_;
};

// Told one by one, each when the game is a little past its light's arrival, or even far past it.
void tellLate(Billiard& billiard, const BilliardSetup& setup, double until_s) {
  std::vector<Stroke> strokes = setup.strokes;
  std::mt19937_64 random(setup.pucks.size());
  for (const Stroke& stroke : strokes) {
    const double late_s = static_cast<double>(random() % 1000) * 1e-3 * (random() % 2 == 0 ? 1.0 : 0.02);
    billiard.advanceTo(std::min(until_s, stroke.at_s + late_s));
    billiard.strike(stroke);
  }
  billiard.advanceTo(until_s);
}

// The world lines that one has who follows the changes.
std::vector<WorldLine> followed(const BilliardSetup& setup, double until_s) {
  BilliardSetup told = setup;
  told.strokes.clear();
  Billiard billiard(told);
  std::vector<WorldLine> lines(billiard.worldLines().begin(), billiard.worldLines().end());
  const auto follow = [&] {
    const Changes changes = billiard.takeChanges();
    if (changes.truncatedFrom_s)
      for (WorldLine& line : lines) line.truncateFrom(*changes.truncatedFrom_s);
    for (const Changes::NewKnot& knot : changes.knots) lines[knot.puck].append(knot.knot);
  };
  for (const Stroke& stroke : setup.strokes) {
    billiard.advanceTo(stroke.at_s + 0.1);
    follow();
    billiard.strike(stroke);
  }
  billiard.advanceTo(until_s);
  follow();
  return lines;
}

}  // namespace

void checkSameBits(const BilliardSetup& setup, double until_s, Findings& found) {
  Billiard game(setup);
  game.advanceTo(until_s);
  SameBits bits(game, until_s, found);
  const std::pair<Mirror, const char*> mirrors[] = {
      {{-1.0, 1.0}, "mirrored in y"}, {{1.0, -1.0}, "mirrored in x"}, {{-1.0, -1.0}, "half a turn"}};
  for (const auto& [mirror, how] : mirrors) {
    Billiard other(mirrored(setup, mirror));
    other.advanceTo(until_s);
    bits.expectSame(other, how, mirror, nullptr);
  }
  std::vector<std::size_t> placeOf;
  Billiard other(shuffled(setup, placeOf));
  other.advanceTo(until_s);
  bits.expectSame(other, "in another order", {}, &placeOf);

  Billiard stepped(setup);
  playAtMost(stepped, setup, until_s, static_cast<std::size_t>(-1));
  bits.expectSame(stepped, "in steps", {}, nullptr);
  Billiard longer(setup);
  longer.advanceTo(until_s + 0.05);
  bits.expectSame(longer, "played on", {}, nullptr);
  if (setup.strokes.empty()) return;
  BilliardSetup told = setup;
  told.strokes.clear();
  Billiard late(told);
  tellLate(late, setup, until_s);
  bits.expectSame(late, "struck late", {}, nullptr);
  bits.expectSameLines(followed(setup, until_s), "followed by its changes", {}, nullptr);
}

}  // namespace carom::test
