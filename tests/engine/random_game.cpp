#include "engine/random_game.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <numbers>
#include <sstream>

#include <glm/geometric.hpp>

#include "engine/random_world.h"

namespace carom::test {

namespace {

class Dice : public Random {
 public:
  using Random::Random;
  bool chance(double probability) { return in(0.0, 1.0) < probability; }
  int whole(int low, int high) { return low + static_cast<int>(in(0.0, high - low + 1.0)); }
  double decades(double low, double high) { return std::pow(10.0, in(std::log10(low), std::log10(high))); }
  Vec2 way() {
    const double angle = in(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  /// At rest, anything, or as near to 0.999 c as chance brings it.
  double speed() {
    if (chance(0.25)) return 0.0;
    return chance(0.6) ? in(0.0, 0.999) : 0.999 * (1.0 - decades(1e-3, 1.0));
  }
  double restitution() {
    if (chance(0.3)) return 1.0;
    if (chance(0.15)) return 0.0;
    return chance(0.3) ? in(0.0, 0.3) : in(0.0, 1.0);
  }
};

// Names in another order than the file's.
std::string nameOfPuck(Dice& dice, std::size_t number) {
  return std::string(1, static_cast<char>('a' + dice.whole(0, 25))) + std::to_string(number);
}

bool isClear(const BilliardSetup& setup, const Puck& puck) {
  if (setup.board) {
    if (std::abs(puck.position_m.x) + puck.radius_m > 0.5 * setup.board->length_m) return false;
    if (std::abs(puck.position_m.y) + puck.radius_m > 0.5 * setup.board->width_m) return false;
  }
  return std::none_of(setup.pucks.begin(), setup.pucks.end(), [&](const Puck& other) {
    return glm::distance(other.position_m, puck.position_m) < other.radius_m + puck.radius_m;
  });
}

Puck puckAt(Dice& dice, const BilliardSetup& setup, const Vec2& position_m, double radius_m, const Vec2& beta,
            double mass_kg) {
  return {nameOfPuck(dice, setup.pucks.size()), radius_m, 0.02, mass_kg, position_m, beta};
}

void drawRules(Dice& dice, BilliardSetup& setup) {
  setup.lightSpeed_m_s = dice.chance(0.5) ? 1.42 : dice.decades(0.3, 5.0);
  if (dice.chance(0.8)) setup.board = Board{dice.in(1.5, 3.5), dice.in(1.0, 2.0)};
  PhysicsRules& rules = setup.rules;
  rules.puckRestitution = dice.restitution();
  rules.cushionRestitution = dice.restitution();
  if (dice.chance(0.5)) rules.friction_m_s2 = dice.decades(0.005, 0.5);
  if (dice.chance(0.5)) rules.collisionEvent = CollisionEvent::contact;
}

void scatter(Dice& dice, BilliardSetup& setup, int count) {
  const Vec2 half_m =
      setup.board ? Vec2{0.5 * setup.board->length_m, 0.5 * setup.board->width_m} : Vec2{1.0, 1.0};
  const double largest_m = std::min(0.09, 0.5 * std::sqrt(half_m.x * half_m.y / count));
  const double fastest = dice.chance(0.3) ? 1.0 : 0.0;
  for (int tries = 0; static_cast<int>(setup.pucks.size()) < count && tries < 200 * count; ++tries) {
    const double speed = fastest > 0.0 ? 0.999 * (1.0 - dice.decades(1e-3, 0.3)) : dice.speed();
    const Puck puck = puckAt(dice, setup, {dice.in(-half_m.x, half_m.x), dice.in(-half_m.y, half_m.y)},
                             dice.in(0.1, 1.0) * largest_m, speed * dice.way(), dice.decades(0.03, 30.0));
    if (isClear(setup, puck)) setup.pucks.push_back(puck);
  }
}

double gap(Dice& dice) {
  switch (dice.whole(0, 3)) {
    case 0:
      return 1e-12;
    case 1:
      return 1e-9;
    case 2:
      return 1e-3;
    default:
      return dice.decades(1e-10, 0.5);
  }
}

// Equal pucks at rest that touch or nearly do, and one or two that are shot at them.
void pack(Dice& dice, BilliardSetup& setup, int count, bool row) {
  const double radius_m = row ? 0.03 : std::min(0.03, 0.3 / std::sqrt(count)),
               apart = 2.0 * radius_m * (1.0 + gap(dice));
  const double mass_kg = 0.2;
  const int columns = row ? count : std::max(2, static_cast<int>(std::sqrt(count)));
  const double tilt = dice.chance(0.5) ? 0.0 : dice.in(0.0, 6.3);
  const Vec2 along{std::cos(tilt), std::sin(tilt)}, across{-along.y, along.x};
  for (int i = 0; i < count; ++i) {
    const double shift = (i / columns) % 2 == 0 ? 0.0 : 0.5;
    const double a = (i % columns - 0.5 * (columns - 1) + shift) * apart,
                 b = (i / columns) * apart * std::sqrt(0.75);
    const Puck puck = puckAt(dice, setup, a * along + b * across, radius_m, Vec2{0.0}, mass_kg);
    if (isClear(setup, puck)) setup.pucks.push_back(puck);
  }
  const double farthest_m = 0.5 * count * apart + 0.1;
  for (int shots = dice.whole(1, 2), tries = 0; shots > 0 && tries < 100; ++tries) {
    const Vec2 from = row && dice.chance(0.5) ? along : dice.way();
    const Vec2 askew = dice.chance(0.3) ? Vec2{0.0} : dice.in(-0.03, 0.03) * Vec2{-from.y, from.x};
    const Puck puck =
        puckAt(dice, setup, -std::min(farthest_m, 0.55) * from + askew, radius_m, dice.in(0.05, 0.95) * from,
               dice.chance(0.5) ? mass_kg : dice.decades(0.03, 30.0));
    if (isClear(setup, puck)) setup.pucks.push_back(puck), --shots;
  }
}

void aimAtCorners(Dice& dice, BilliardSetup& setup, int count) {
  if (!setup.board) setup.board = Board{2.84, 1.42};
  const Vec2 half_m{0.5 * setup.board->length_m, 0.5 * setup.board->width_m};
  for (int tries = 0; static_cast<int>(setup.pucks.size()) < count && tries < 100; ++tries) {
    const double radius_m = dice.in(0.02, 0.06);
    const Vec2 corner{dice.chance(0.5) ? half_m.x : -half_m.x, dice.chance(0.5) ? half_m.y : -half_m.y};
    const Vec2 from{dice.in(-0.8, 0.8) * half_m.x, dice.in(-0.8, 0.8) * half_m.y};
    const Vec2 aim = corner - from + dice.in(-0.12, 0.12) * dice.way();
    const Puck puck =
        puckAt(dice, setup, from, radius_m, 0.999 * (1.0 - dice.decades(1e-3, 0.3)) * glm::normalize(aim),
               dice.decades(0.03, 30.0));
    if (isClear(setup, puck)) setup.pucks.push_back(puck);
  }
}

Stroke strokeAt(Dice& dice, const BilliardSetup& setup, std::size_t puck, const Event& target) {
  const double c = setup.lightSpeed_m_s;
  Stroke stroke;
  stroke.puck = puck;
  stroke.momentum_kg_m_s = dice.in(0.05, 3.0) * setup.pucks[puck].mass_kg * c * dice.way();
  stroke.at_s = target.t_s;
  const Vec3 hand_m{dice.in(-2.0, 2.0), dice.in(-2.0, 2.0), dice.in(0.0, 0.5)};
  const double sent_s = target.t_s - glm::distance(hand_m, target.r_m) / c;
  if (dice.chance(0.5) && sent_s >= 0.0) stroke.at_s = sent_s, stroke.from_m = hand_m;
  return stroke;
}

// At pucks at rest, or that friction stopped by then, so that they run into another: the first at `first_s`,
// the others soon after.
void strikeLate(Dice& dice, BilliardSetup& setup, double first_s) {
  for (Puck& puck : setup.pucks) puck.beta *= setup.rules.friction_m_s2 > 0.0 && first_s > 100.0 ? 1.0 : 0.0;
  double at_s = first_s;
  for (int strokes = dice.whole(1, 4); strokes > 0; --strokes, at_s += dice.in(0.0, 3.0)) {
    const int count = static_cast<int>(setup.pucks.size());
    const int i = dice.whole(0, count - 1), other = (i + dice.whole(1, count - 1)) % count;
    const Puck& puck = setup.pucks[i];
    Stroke stroke =
        strokeAt(dice, setup, i, {at_s, {puck.position_m.x, puck.position_m.y, 0.5 * puck.height_m}});
    const Vec2 to = glm::normalize(setup.pucks[other].position_m - puck.position_m + 0.02 * dice.way());
    stroke.momentum_kg_m_s = dice.in(0.2, 3.0) * puck.mass_kg * setup.lightSpeed_m_s * to;
    setup.strokes.push_back(stroke);
  }
}

// Of the game as it stands: at the worst moments of the turns it has.
void strikeAtBadMoments(Dice& dice, BilliardSetup& setup, double until_s, std::size_t mostEvents) {
  for (int strokes = dice.whole(1, 4); strokes > 0; --strokes) {
    Billiard game(setup);
    try {
      playAtMost(game, setup, until_s, mostEvents);
    } catch (const std::exception&) {
      return;
    }
    if (game.events().empty()) return;
    const GameEvent& event = game.events()[dice.whole(0, static_cast<int>(game.events().size()) - 1)];
    if (event.turns.empty()) continue;
    const Turn& turn = event.turns[dice.whole(0, static_cast<int>(event.turns.size()) - 1)];
    double at_s = turn.event.t_s;
    if (dice.chance(0.7)) at_s = event.at.t_s + dice.in(-0.2, 1.2) * (turn.event.t_s - event.at.t_s);
    if (!(at_s >= 0.0)) continue;
    setup.strokes.push_back(strokeAt(dice, setup, turn.puck, game.worldLines()[turn.puck].at(at_s).event));
  }
}

}  // namespace

// In steps that grow while nothing happens, but never beyond the next stroke: so that a pile which collides
// without end is left in time, and a day of rest is soon over.
double playAtMost(Billiard& billiard, const BilliardSetup& setup, double until_s, std::size_t mostEvents) {
  double short_s = 1e9;
  for (const Puck& puck : setup.pucks)
    short_s = std::min(short_s, 0.1 * puck.radius_m / setup.lightSpeed_m_s);
  double t_s = 0.0, step_s = short_s;
  std::size_t events = 0;
  while (t_s < until_s && billiard.events().size() < mostEvents) {
    double next_s = std::min(t_s + step_s, until_s);
    for (const Stroke& stroke : setup.strokes) {
      if (stroke.at_s > t_s) next_s = std::min(next_s, stroke.at_s);
    }
    billiard.advanceTo(t_s = next_s);
    const bool quiet = billiard.events().size() == events &&
                       std::none_of(setup.strokes.begin(), setup.strokes.end(), [&](const Stroke& stroke) {
                         return stroke.at_s <= t_s && t_s < stroke.at_s + 10.0;
                       });
    events = billiard.events().size();
    step_s = quiet ? 2.0 * step_s : short_s;
  }
  return t_s;
}

RandomGame randomGame(std::uint64_t seed, const GameLimits& limits) {
  Dice dice(seed);
  RandomGame game;
  game.seed = seed;
  BilliardSetup& setup = game.setup;
  drawRules(dice, setup);
  double first_s = 0.0;
  switch (dice.whole(0, 7)) {
    case 0:
    case 1:
      game.kind = "few", scatter(dice, setup, dice.whole(2, 8));
      break;
    case 2:
      game.kind = "some", scatter(dice, setup, dice.whole(9, 30));
      break;
    case 3:
      game.kind = "many", scatter(dice, setup, dice.whole(31, 100));
      break;
    case 4:
      game.kind = "pack", pack(dice, setup, dice.whole(2, limits.packed), false);
      break;
    case 5:
      game.kind = "row", pack(dice, setup, dice.whole(2, 10), true);
      break;
    case 6:
      game.kind = "corners", aimAtCorners(dice, setup, dice.whole(1, 3));
      break;
    default:
      game.kind = "late";
      scatter(dice, setup, dice.whole(2, 8));
      first_s = dice.decades(1.0, 86400.0);
      strikeLate(dice, setup, first_s);
  }
  game.until_s = first_s + dice.decades(1.0, 20.0) / setup.lightSpeed_m_s;
  if (first_s == 0.0 && dice.chance(0.5)) {
    game.kind += ", struck";
    strikeAtBadMoments(dice, setup, game.until_s, limits.events / 2);
  }
  try {
    Billiard billiard(setup);
    game.until_s = playAtMost(billiard, setup, game.until_s, limits.events);
  } catch (const std::exception&) {
    game.kind += ", breaks off";  // as those will find who play it
  }
  return game;
}

std::string scenarioText(const BilliardSetup& setup) {
  std::ostringstream text;
  text.precision(17);
  // A number of TOML has a point or an exponent.
  const auto number = [](double x) {
    std::ostringstream digits;
    digits.precision(17);
    digits << x;
    if (std::isinf(x)) return digits.str();
    return digits.str().find_first_of(".e") == std::string::npos ? digits.str() + ".0" : digits.str();
  };
  const auto pair = [&](const Vec2& v) { return "[" + number(v.x) + ", " + number(v.y) + "]"; };
  text << "title = \"A random game\"\nlight_speed_m_s = " << number(setup.lightSpeed_m_s) << "\n";
  if (setup.board)
    text << "[board]\nlength_m = " << number(setup.board->length_m)
         << "\nwidth_m = " << number(setup.board->width_m) << "\n";
  text << "[physics]\npuck_restitution = " << number(setup.rules.puckRestitution)
       << "\ncushion_restitution = " << number(setup.rules.cushionRestitution)
       << "\nfriction_m_s2 = " << number(setup.rules.friction_m_s2)
       << "\npuck_friction = " << number(setup.rules.puckFriction)
       << "\ncushion_friction = " << number(setup.rules.cushionFriction)
       << "\ntangential_restitution = " << number(setup.rules.tangentialRestitution)
       << "\nspin_deceleration_m_s2 = " << number(setup.rules.spinDeceleration_m_s2)
       << "\ncollision_event = \""
       << (setup.rules.collisionEvent == CollisionEvent::centre ? "centre" : "contact") << "\"\n";
  for (const Puck& puck : setup.pucks) {
    text << "[[puck]]\nname = \"" << puck.name << "\"\nradius_m = " << number(puck.radius_m)
         << "\nheight_m = " << number(puck.height_m) << "\nmass_kg = " << number(puck.mass_kg)
         << "\nposition_m = " << pair(puck.position_m) << "\nbeta = " << pair(puck.beta)
         << "\ninertia = " << number(puck.inertia) << "\nspin_kg_m2_s = " << number(puck.spin_kg_m2_s)
         << "\n";
  }
  for (const Stroke& stroke : setup.strokes) {
    text << "[[stroke]]\nat_s = " << number(stroke.at_s) << "\npuck = \"" << setup.pucks[stroke.puck].name
         << "\"\n";
    if (stroke.from_m)
      text << "from_m = [" << number(stroke.from_m->x) << ", " << number(stroke.from_m->y) << ", "
           << number(stroke.from_m->z) << "]\n";
    text << "momentum_kg_m_s = " << pair(stroke.momentum_kg_m_s) << "\noffset_m = " << number(stroke.offset_m)
         << "\n";
  }
  return text.str();
}

}  // namespace carom::test
