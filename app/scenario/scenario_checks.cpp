#include "app/scenario/scenario_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/toml/toml_values.h"
#include "engine/game/setup_check.h"

namespace carom {
namespace {

/// Returns the shape of the contracted puck on the board: the ellipse xᵀ S⁻¹ x = 1 with S = R²(1 − β βᵀ),
/// semi-axes R/γ along the motion and R across it.
glm::dmat2 shapeOf(const Puck& puck) {
  return puck.radius_m * puck.radius_m * (glm::dmat2(1.0) - glm::outerProduct(puck.beta, puck.beta));
}

/// Returns whether two pucks' ellipses overlap at board time 0: with d from centre to centre they do if and
/// only if λ(1−λ) dᵀ[(1−λ)A + λB]⁻¹d, concave in λ, stays below 1 on 0 < λ < 1 (Perram, Wertheim 1985, eq.
/// 3.7).
bool overlap(const Puck& a, const Puck& b) {
  const Vec2 d = b.position_m - a.position_m;
  if (glm::length(d) >= (a.radius_m + b.radius_m) * (1.0 - kTouching)) return false;
  const glm::dmat2 shapeA = shapeOf(a), shapeB = shapeOf(b);
  const auto contact = [&](double l) {
    return l * (1.0 - l) * glm::dot(d, glm::inverse((1.0 - l) * shapeA + l * shapeB) * d);
  };
  double low = 0.0, high = 1.0;
  constexpr int kSteps = 90;  // (2/3)^90 of the interval is below rounding
  for (int i = 0; i < kSteps; ++i) {
    const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
    if (contact(left) < contact(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return contact(0.5 * (low + high)) < 1.0 - kTouching;
}

/// The bounding squares of pucks in grids: a puck's grid has cells as wide as its square or up to twice as
/// wide, so that squares that overlap lie in neighbouring cells of the coarser of their grids.
class Grids {
 public:
  explicit Grids(const std::vector<Puck>& pucks) : pucks_(pucks) {}

  /// Calls `f` with the pucks added before whose squares overlap that of `puck`, until it returns true. They
  /// have been added by falling radius.
  template <class Function>
  void add(std::size_t puck, Function f) {
    const int own = levelOf(pucks_[puck].radius_m);
    if (levels_.empty() || levels_.back() != own) levels_.push_back(own);
    for (const int level : levels_)
      if (findIn(level, puck, f)) break;
    cells_[cellOf(own, pucks_[puck].position_m)].push_back(puck);
  }

 private:
  using Cell = std::array<double, 3>;  // level, column, row

  static int levelOf(double radius_m) { return std::ilogb(2.0 * radius_m) + 1; }
  static Cell cellOf(int level, const Vec2& place_m) {
    return {static_cast<double>(level), std::floor(std::ldexp(place_m.x, -level)),
            std::floor(std::ldexp(place_m.y, -level))};
  }
  template <class Function>
  bool findIn(int level, std::size_t puck, Function f) {
    const Cell middle = cellOf(level, pucks_[puck].position_m);
    for (const double column : {-1.0, 0.0, 1.0}) {
      for (const double row : {-1.0, 0.0, 1.0}) {
        const auto cell = cells_.find({middle[0], middle[1] + column, middle[2] + row});
        if (cell == cells_.end()) continue;
        for (const std::size_t other : cell->second)
          if (f(other)) return true;
      }
    }
    return false;
  }

  const std::vector<Puck>& pucks_;
  std::vector<int> levels_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

/// Returns, for each puck that overlaps others by `meet`, a pair of it and another one, the later one in the
/// file first.
template <class Meet>
std::vector<std::pair<std::size_t, std::size_t>> overlapsOf(const std::vector<Puck>& pucks, Meet meet) {
  std::vector<std::size_t> byRadius(pucks.size());
  std::iota(byRadius.begin(), byRadius.end(), std::size_t{0});
  std::stable_sort(byRadius.begin(), byRadius.end(),
                   [&](std::size_t i, std::size_t j) { return pucks[i].radius_m > pucks[j].radius_m; });
  std::vector<std::pair<std::size_t, std::size_t>> overlaps;
  Grids grids(pucks);
  for (const std::size_t i : byRadius) {
    grids.add(i, [&](std::size_t j) {
      if (!meet(std::min(i, j), std::max(i, j))) return false;
      overlaps.emplace_back(std::max(i, j), std::min(i, j));
      return true;
    });
  }
  return overlaps;
}

/// Returns the distance from the centre to the rim along the board's x and y: sqrt(nᵀSn).
Vec2 reachOf(const Puck& puck) { return puck.radius_m * glm::sqrt(1.0 - puck.beta * puck.beta); }

/// Records a fault if a corner of a puck is beyond a cushion at board time 0.
void checkCorners(const BilliardSetup& setup, const Puck& puck, const TomlTable& table) {
  const Vec2 half_m = 0.5 * Vec2(setup.board->length_m, setup.board->width_m);
  for (int axis = 0; axis < 2; ++axis) {
    const double least_m = extentOnBoard_m(puck, axis, -1.0, setup.lightSpeed_m_s) - half_m[axis];
    const double most_m = half_m[axis] - extentOnBoard_m(puck, axis, 1.0, setup.lightSpeed_m_s);
    const double touching_m = kTouching * puck.radius_m, at_m = puck.position_m[axis];
    if (at_m >= least_m - touching_m && at_m <= most_m + touching_m) continue;
    table.fault("position_m",
                fmt::format("puck '{}' reaches over the {} cushion, expected its centre's {} from "
                            "{:.6g} to {:.6g} m",
                            puck.name, "xy"[axis], "xy"[axis], least_m, most_m));
  }
}

}  // namespace

void checkNames(const std::vector<TomlTable>& pucks, const std::vector<TomlTable>& bodies,
                const std::vector<TomlTable>& flashes, const std::vector<TomlTable>& pulses) {
  std::map<std::string, FilePlace> first;
  for (const auto* tables : {&pucks, &bodies, &flashes, &pulses}) {
    for (const TomlTable& table : *tables) {
      if (tables == &flashes && !table.has("name")) continue;
      const std::string name = table.text("name");
      const auto [known, isNew] = first.emplace(name, table.place("name"));
      if (isNew) continue;
      table.fault("name", fmt::format("the name '{}' is taken in line {}, expected another", name,
                                      known->second.line));
    }
  }
}

void checkPlaces(const BilliardSetup& setup, const std::vector<TomlTable>& tables) {
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    if (setup.board && !puck.outline_m.empty()) {
      checkCorners(setup, puck, tables[i]);
    } else if (setup.board) {
      const Vec2 room = 0.5 * Vec2(setup.board->length_m, setup.board->width_m) - reachOf(puck);
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(puck.position_m[axis]) <= room[axis] + kTouching * puck.radius_m) continue;
        tables[i].fault("position_m",
                        fmt::format("puck '{}' reaches over the {} cushion, expected its centre's {} "
                                    "within ±{:.6g} m",
                                    puck.name, "xy"[axis], "xy"[axis], room[axis]));
      }
    }
  }
  const auto meet = [&](std::size_t i, std::size_t j) {
    const Puck &a = setup.pucks[i], &b = setup.pucks[j];
    const bool corners = !a.outline_m.empty() || !b.outline_m.empty();
    return corners ? overlapOnBoard(a, b, setup.lightSpeed_m_s) : overlap(a, b);
  };
  for (const auto& [i, j] : overlapsOf(setup.pucks, meet)) {
    tables[i].fault("position_m", fmt::format("puck '{}' overlaps puck '{}' at t = 0, expected pucks apart",
                                              setup.pucks[i].name, setup.pucks[j].name));
  }
}

void checkFriction(const BilliardSetup& setup, const TomlTable& physics) {
  const double most_m2_s2 = 0.5 * setup.lightSpeed_m_s * setup.lightSpeed_m_s;
  for (const Puck& puck : setup.pucks) {
    for (const char* key : {"friction_m_s2", "spin_deceleration_m_s2"}) {
      if (puck.outline_m.empty() || !physics.has(key) || physics.number(key) == 0.0) continue;
      physics.fault(
          key, fmt::format("{} slows puck '{}', which has corners, expected 0 in a game with outline_m", key,
                           puck.name));
      return;
    }
    if (puck.radius_m * setup.rules.friction_m_s2 < most_m2_s2) continue;
    physics.fault("friction_m_s2",
                  fmt::format("friction_m_s2 is {}, expected below {:.6g}: times the radius of "
                              "puck '{}' it must stay under half the square of light_speed_m_s",
                              setup.rules.friction_m_s2, most_m2_s2 / puck.radius_m, puck.name));
    return;
  }
}

void checkPlayable(const BilliardSetup& setup, const TomlTable& root) {
  try {
    checkSetup(setup);
  } catch (const std::invalid_argument& error) {
    root.fault(FilePlace{}, error.what());
  }
}

}  // namespace carom
