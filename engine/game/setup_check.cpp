#include "engine/game/setup_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "engine/collision/spinning_body.h"
#include "engine/polygons/moving_shape.h"
#include "engine/soft/soft_body.h"
#include "engine/soft/soft_mesh.h"
#include "engine/text/joined_text.h"

namespace carom {

namespace {

// Overlap by less than this part of the radius is rounding of a setup in which things touch.
constexpr double kTouching = 1e-12;

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  constexpr int kDigits = 17;
  throw std::invalid_argument(joinedText(kDigits, parts...));
}

bool isPositive(double x) { return x > 0.0 && std::isfinite(x); }
bool isFinite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

void checkRules(const BilliardSetup& setup) {
  if (!isPositive(setup.lightSpeed_m_s)) {
    refuse("light speed ", setup.lightSpeed_m_s, " m/s: expected a positive number");
  }
  if (setup.board && !(isPositive(setup.board->length_m) && isPositive(setup.board->width_m))) {
    refuse("board of ", setup.board->length_m, " m by ", setup.board->width_m,
           " m: expected positive numbers");
  }
  const PhysicsRules& rules = setup.rules;
  for (const double e : {rules.puckRestitution, rules.cushionRestitution}) {
    if (!(e >= 0.0 && e <= 1.0)) refuse("restitution ", e, ": expected a number from 0 to 1");
  }
  if (!(rules.friction_m_s2 >= 0.0 && std::isfinite(rules.friction_m_s2))) {
    refuse("friction ", rules.friction_m_s2, " m/s²: expected 0 or a positive number");
  }
  for (const double mu : {rules.puckFriction, rules.cushionFriction}) {
    if (!(mu >= 0.0)) refuse("coefficient of friction ", mu, ": expected 0, a positive number or infinity");
  }
  if (!(rules.tangentialRestitution >= 0.0 && rules.tangentialRestitution <= 1.0))
    refuse("tangential restitution ", rules.tangentialRestitution, ": expected a number from 0 to 1");
  if (!(rules.spinDeceleration_m_s2 >= 0.0 && std::isfinite(rules.spinDeceleration_m_s2)))
    refuse("spin deceleration ", rules.spinDeceleration_m_s2, " m/s²: expected 0 or a positive number");
}

void checkSpin(const Puck& puck, double c_m_s) {
  if (!(puck.inertia >= kLeastInertia && puck.inertia <= 1.0))
    refuse("puck \"", puck.name, "\": inertia ", puck.inertia, ": expected a number from ", kLeastInertia,
           " to 1");
  const double u = rimUOf(puck, puck.spin_kg_m2_s, c_m_s);
  if (!(std::abs(u / std::hypot(1.0, u)) < 1.0))
    refuse("puck \"", puck.name, "\": spin ", puck.spin_kg_m2_s,
           " kg m²/s: expected one with which the rim is slower than light");
}

/// A puck as it is at board time 0, c = 1.
struct Start {
  std::optional<Outline> outline;
  MovingShape flight;

  Start(const Puck& puck, double c_m_s) {
    if (!puck.outline_m.empty()) outline.emplace(puck.outline_m);
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    const SpinningBody body{puck.mass_kg, puck.inertia * puck.mass_kg};
    flight = {{0.0, puck.position_m.x, puck.position_m.y},
              {gamma, gamma * puck.beta.x, gamma * puck.beta.y},
              puck.radius_m,
              outline ? &*outline : nullptr,
              0.0,
              rimBeta(body, puck.spin_kg_m2_s / (puck.radius_m * c_m_s)) / puck.radius_m};
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;
};

void checkOutline(const PhysicsRules& rules, const Puck& puck) {
  if (puck.outline_m.empty()) return;
  if (const auto fault = faultOf(puck.outline_m)) refuse("puck \"", puck.name, "\": outline: ", fault->what);
  const double radius_m = radiusOf_m(puck.outline_m);
  if (!(std::abs(puck.radius_m - radius_m) <= kTouching * radius_m))
    refuse("puck \"", puck.name, "\": radius ", puck.radius_m, " m: expected that of its farthest corner, ",
           radius_m, " m");
  if (rules.friction_m_s2 != 0.0 || rules.spinDeceleration_m_s2 != 0.0)
    refuse("puck \"", puck.name,
           "\" has corners, and the cloth slows pucks: expected no friction and no spin "
           "deceleration in a game with corners");
}

/// Soft pucks touch without friction, and only they may have corners or turn beside them.
void checkSoft(const BilliardSetup& setup) {
  if (std::none_of(setup.pucks.begin(), setup.pucks.end(), [](const Puck& puck) { return puck.soft; }))
    return;
  const PhysicsRules& rules = setup.rules;
  if (rules.friction_m_s2 != 0.0 || rules.puckFriction != 0.0 || rules.cushionFriction != 0.0 ||
      rules.spinDeceleration_m_s2 != 0.0)
    refuse("friction in a game with soft pucks: expected none");
  if (!(rules.stiffSoundSpeed > 0.0 && rules.stiffSoundSpeed <= kStiffestSound))
    refuse("stiff sound speed ", rules.stiffSoundSpeed, ": expected a number above 0 up to ", kStiffestSound);
  for (std::size_t i = 0; i < setup.strokes.size(); ++i) {
    if (setup.strokes[i].offset_m != 0.0)
      refuse("stroke ", i, " beside a centre, in a game with soft pucks: expected no offset");
  }
  for (const Puck& puck : setup.pucks) {
    if (puck.spin_kg_m2_s != 0.0)
      refuse("puck \"", puck.name, "\" spins beside soft pucks: expected no spin");
    if (!puck.soft) {
      if (!puck.outline_m.empty())
        refuse("puck \"", puck.name, "\" has corners beside soft pucks: expected a disc");
      continue;
    }
    const SoftMatter& matter = *puck.soft;
    if (!(matter.soundSpeed > 0.0 && matter.soundSpeed <= kStiffestSound))
      refuse("puck \"", puck.name, "\": sound speed ", matter.soundSpeed,
             ": expected a number above 0 up to ", kStiffestSound);
    if (matter.cells < kFewestSoftCells || matter.cells > kMostSoftCells)
      refuse("puck \"", puck.name, "\": ", matter.cells, " cells: expected ", kFewestSoftCells, " to ",
             kMostSoftCells);
    if (!(matter.viscosity > 0.0 && matter.viscosity <= 1.0))
      refuse("puck \"", puck.name, "\": viscosity ", matter.viscosity, ": expected a number above 0 up to 1");
  }
}

void checkPuck(const BilliardSetup& setup, const Puck& puck) {
  if (!isPositive(puck.radius_m))
    refuse("puck \"", puck.name, "\": radius ", puck.radius_m, " m: expected a positive number");
  if (!isPositive(puck.height_m))
    refuse("puck \"", puck.name, "\": height ", puck.height_m, " m: expected a positive number");
  if (!isPositive(puck.mass_kg))
    refuse("puck \"", puck.name, "\": mass ", puck.mass_kg, " kg: expected a positive number");
  if (!isFinite(puck.position_m)) {
    refuse("puck \"", puck.name, "\": position (", puck.position_m.x, ", ", puck.position_m.y,
           ") m: expected numbers");
  }
  const double beta = glm::length(puck.beta);
  // 1 − β² must not vanish either.
  if (!(beta < 1.0 && glm::dot(puck.beta, puck.beta) < 1.0)) {
    refuse("puck \"", puck.name, "\": beta (", puck.beta.x, ", ", puck.beta.y, "), a speed of ", beta,
           " c: expected less than 1");
  }
  const double c = setup.lightSpeed_m_s;
  checkOutline(setup.rules, puck);
  checkSpin(puck, c);
  if (!(puck.radius_m * setup.rules.friction_m_s2 < 0.5 * c * c)) {
    refuse("puck \"", puck.name, "\": friction × radius is ", puck.radius_m * setup.rules.friction_m_s2,
           " m²/s²: expected less than c²/2 = ", 0.5 * c * c, ", or its rim would outrun light");
  }
}

void checkInsideBoard(const Board& board, const Puck& puck, double c_m_s) {
  const double halves_m[2] = {0.5 * board.length_m, 0.5 * board.width_m};
  for (int axis = 0; axis < 2; ++axis) {
    // Of a disc the nearer cushion tells.
    for (const double sign :
         {puck.position_m[axis] > 0 ? 1.0 : -1.0, puck.position_m[axis] > 0 ? -1.0 : 1.0}) {
      const double clear_m = halves_m[axis] - sign * puck.position_m[axis];
      const double needed_m = extentOnBoard_m(puck, axis, sign, c_m_s);
      if (clear_m >= needed_m * (1.0 - kTouching)) continue;
      refuse("puck \"", puck.name, "\": at t = 0 its centre is ", clear_m, " m inside the ",
             axis == 0 ? (sign > 0 ? "+x" : "-x") : (sign > 0 ? "+y" : "-y"), " cushion and its ",
             puck.outline_m.empty() ? "disc reaches " : "corners reach ", needed_m,
             " m: expected it to be clear of the cushion");
    }
  }
}

// Calls f(a, b) for every two pucks whose uncontracted discs overlap.
template <class Function>
void forEachClosePair(const std::vector<Puck>& pucks, Function f) {
  double cell_m = 0.0;
  for (const Puck& puck : pucks) cell_m = std::max(cell_m, 2.0 * puck.radius_m);
  const auto key = [](double column, double row) { return column * 67108859.0 + row; };
  std::unordered_map<double, std::vector<std::size_t>> cells;
  for (std::size_t b = 0; b < pucks.size(); ++b) {
    const double column = std::floor(pucks[b].position_m.x / cell_m),
                 row = std::floor(pucks[b].position_m.y / cell_m);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto near = cells.find(key(column + dx, row + dy));
        if (near == cells.end()) continue;
        for (const std::size_t a : near->second) f(pucks[a], pucks[b]);
      }
    }
    cells[key(column, row)].push_back(b);
  }
}

}  // namespace

double extentOnBoard_m(const Puck& puck, int axis, double sign, double c_m_s) {
  if (puck.outline_m.empty()) return puck.radius_m * std::sqrt(1.0 - puck.beta[axis] * puck.beta[axis]);
  const Start start(puck, c_m_s);
  double farthest_m = 0.0;
  for (const Vec2& corner_m : cornersOnBoard(start.flight, 0.0))
    farthest_m = std::max(farthest_m, sign * (corner_m[axis] - puck.position_m[axis]));
  return farthest_m;
}

// Perram and Wertheim's contact function of two ellipses with shape matrices A, B and distance r:
// F = max over 0 < λ < 1 of λ(1−λ) rᵀ [(1−λ) A + λ B]⁻¹ r; they overlap iff F < 1. The maximised function is
// concave. For a disc, A = R² (1 − ββᵀ).
bool overlapOnBoard(const Puck& a, const Puck& b, double c_m_s) {
  if (!a.outline_m.empty() || !b.outline_m.empty())
    return overlapOnBoard(Start(a, c_m_s).flight, Start(b, c_m_s).flight, 0.0);
  const Vec2 r = b.position_m - a.position_m;
  const double reach_m = a.radius_m + b.radius_m;
  if (glm::dot(r, r) >= reach_m * reach_m) return false;
  const double a2 = a.radius_m * a.radius_m, b2 = b.radius_m * b.radius_m;
  const auto contact = [&](double lambda) {
    const double wa = (1.0 - lambda) * a2, wb = lambda * b2;
    const double xx = wa * (1.0 - a.beta.x * a.beta.x) + wb * (1.0 - b.beta.x * b.beta.x);
    const double yy = wa * (1.0 - a.beta.y * a.beta.y) + wb * (1.0 - b.beta.y * b.beta.y);
    const double xy = -wa * a.beta.x * a.beta.y - wb * b.beta.x * b.beta.y;
    return lambda * (1.0 - lambda) * (yy * r.x * r.x - 2.0 * xy * r.x * r.y + xx * r.y * r.y) /
           (xx * yy - xy * xy);
  };
  double low = 0.0, high = 1.0;
  for (int step = 0; step < 120; ++step) {
    const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
    if (contact(left) < contact(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return contact(0.5 * (low + high)) < 1.0 - kTouching;
}

void checkStroke(const BilliardSetup& setup, const Stroke& stroke, std::size_t number) {
  if (stroke.puck >= setup.pucks.size()) {
    refuse("stroke ", number, ": there is no puck ", stroke.puck, " among ", setup.pucks.size());
  }
  const std::string& name = setup.pucks[stroke.puck].name;
  const bool handThere =
      !stroke.from_m ||
      (std::isfinite(stroke.from_m->x) && std::isfinite(stroke.from_m->y) && std::isfinite(stroke.from_m->z));
  if (!std::isfinite(stroke.at_s) || !isFinite(stroke.momentum_kg_m_s) || !handThere) {
    refuse("stroke ", number, " on puck \"", name, "\": expected numbers");
  }
  if (stroke.at_s < 0.0) {
    refuse("stroke ", number, " on puck \"", name, "\": at ", stroke.at_s, " s: expected 0 or later");
  }
  const double radius_m = setup.pucks[stroke.puck].radius_m;
  if (!(std::abs(stroke.offset_m) <= radius_m)) {
    refuse("stroke ", number, " on puck \"", name, "\": ", stroke.offset_m,
           " m beside its centre: expected at most its radius, ", radius_m, " m");
  }
}

void checkFlash(const Flash& flash) {
  const Vec3& r = flash.at.r_m;
  if (!std::isfinite(flash.at.t_s) || !std::isfinite(r.x) || !std::isfinite(r.y) || !std::isfinite(r.z))
    refuse("flash \"", flash.name, "\": expected numbers");
}

void checkSetup(const BilliardSetup& setup) {
  checkRules(setup);
  checkSoft(setup);
  std::unordered_set<std::string> names;
  for (const Puck& puck : setup.pucks) {
    checkPuck(setup, puck);
    if (setup.board) checkInsideBoard(*setup.board, puck, setup.lightSpeed_m_s);
    if (!names.insert(puck.name).second)
      refuse("two pucks are named \"", puck.name, "\": expected different names");
  }
  forEachClosePair(setup.pucks, [&](const Puck& a, const Puck& b) {
    if (!overlapOnBoard(a, b, setup.lightSpeed_m_s)) return;
    refuse("pucks \"", a.name, "\" at (", a.position_m.x, ", ", a.position_m.y, ") m and \"", b.name,
           "\" at (", b.position_m.x, ", ", b.position_m.y,
           ") m overlap at t = 0: expected them to be apart");
  });
  for (std::size_t i = 0; i < setup.strokes.size(); ++i) checkStroke(setup, setup.strokes[i], i);
  for (const Flash& flash : setup.flashes) checkFlash(flash);
}

}  // namespace carom
