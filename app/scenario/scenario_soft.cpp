#include "app/scenario/scenario_soft.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>

#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr double kLongest = 4.0;  // of a rectangle's width: a longer one buckles
constexpr double kFastest = 0.9;  // of c: what closes faster may crush more than can be computed

bool hasSoft(const BilliardSetup& setup) {
  return std::any_of(setup.pucks.begin(), setup.pucks.end(), [](const Puck& puck) { return puck.soft; });
}

/// Whether the corners are those of a rectangle around the centre with sides along x and y.
bool isRectangle(const std::vector<Vec2>& outline_m) {
  if (outline_m.size() != 4) return false;
  const Vec2 half_m = glm::abs(outline_m.front());
  const double most_m = 1e-9 * glm::length(half_m);
  if (!(half_m.x > most_m && half_m.y > most_m)) return false;
  const auto isCorner = [&](const Vec2& corner) { return glm::length(glm::abs(corner) - half_m) <= most_m; };
  double turned = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 side = outline_m[(k + 1) % 4] - outline_m[k];
    turned += std::abs(side.x) > most_m && std::abs(side.y) > most_m ? 1.0 : 0.0;
  }
  return turned == 0.0 && std::all_of(outline_m.begin(), outline_m.end(), isCorner);
}

Vec2 betaOf(const ScriptedLeg& leg) { return Vec2(betaFromU(leg.u)); }

/// Returns the speed of one body in the other's rest frame, over c.
double closing(const Vec2& a, const Vec2& b) {
  const double product = 1.0 - glm::dot(a, b);
  const double gamma = product / std::sqrt((1.0 - glm::dot(a, a)) * (1.0 - glm::dot(b, b)));
  return std::sqrt(std::max(0.0, 1.0 - 1.0 / (gamma * gamma)));
}

void holdSide(const TomlTable& table, bool isPlusX, const std::string& by, std::vector<BodyText>& bodies,
              double c_m_s, Puck& puck) {
  SoftMatter::HeldSide side{isPlusX, {}};
  for (const SoftMatter::HeldSide& other : puck.soft->held) {
    if (other.isPlusX != isPlusX) continue;
    table.fault("side", fmt::format("side '{}' of puck '{}' is held twice, expected one body",
                                    isPlusX ? "+x" : "-x", puck.name));
    return;
  }
  const auto body =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodyText& one) { return one.name == by; });
  if (body == bodies.end()) {
    table.fault("by", fmt::format("there is no body '{}', expected the name of a [[body]] with legs", by));
    return;
  }
  if (body->history) {
    table.fault("by", fmt::format("body '{}' has a history, expected a [[body]] with legs", by));
    return;
  }
  if (body->legs.empty()) return;  // why has been said
  const Vec3 first = body->legs.front().u;
  const Vec2 beta = betaOf(body->legs.front());
  if (first.z != 0.0 || glm::length(beta - puck.beta) > 1e-9) {
    table.fault(
        "by", fmt::format("body '{}' moves with ({}, {}, {}) c before its first turn, expected as puck '{}' "
                          "does, with ({}, {}) c",
                          by, beta.x, beta.y, betaFromU(first).z, puck.name, puck.beta.x, puck.beta.y));
    return;
  }
  for (std::size_t k = 1; k < body->legs.size(); ++k) {
    if (body->legs[k].u.z != 0.0) {
      table.fault("by", fmt::format("body '{}' leaves the plane of the board, expected legs along it", by));
      return;
    }
    if (body->legs[k].from_s * c_m_s < 0.0) {
      table.fault("by", fmt::format("body '{}' turns at {} s, expected 0 or later where it holds a puck", by,
                                    body->legs[k].from_s));
      return;
    }
    side.turns.push_back({body->legs[k].from_s, betaOf(body->legs[k])});
  }
  puck.soft->held.push_back(side);
  body->holds = true;
}

}  // namespace

void readSoft(const TomlTable& table, Puck& puck) {
  const std::optional<TomlTable> soft = table.table("soft");
  if (!soft) return;
  for (const char* key : {"spin_rad_s", "spin_kg_m2_s", "inertia"})
    table.refuse(
        key,
        "stands beside soft, expected none: a soft puck turns by its own matter, and begins without spin");
  SoftMatter matter;
  matter.soundSpeed = soft->number("sound_speed");
  matter.cells = soft->integer("cells");
  matter.viscosity = soft->number("viscosity");
  if (!puck.outline_m.empty() && !isRectangle(puck.outline_m)) {
    table.fault(
        table.has("outline_m") ? "outline_m" : "outline",
        fmt::format(
            "puck '{}' is soft and neither a disc nor a rectangle, expected radius_m, or four corners "
            "(±a, ±b) around the centre with sides along x and y",
            puck.name));
    return;
  }
  puck.soft = matter;
}

void holdSides(BilliardSetup& setup, const std::vector<TomlTable>& tables, std::vector<BodyText>& bodies) {
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const std::optional<TomlTable> soft = tables[i].table("soft");
    if (!soft || !soft->has("held")) continue;
    Puck& puck = setup.pucks[i];
    if (puck.soft && puck.outline_m.empty()) {
      soft->fault("held", fmt::format("puck '{}' is a disc and has no sides to hold, expected a rectangle",
                                      puck.name));
    }
    for (const TomlTable& side : soft->tables("held")) {
      const bool isPlusX = side.choice("side") == 1;
      const std::string by = side.text("by");
      if (puck.soft && !puck.outline_m.empty() && !by.empty())
        holdSide(side, isPlusX, by, bodies, setup.lightSpeed_m_s, puck);
    }
  }
}

void checkSoft(const BilliardSetup& setup, const std::vector<TomlTable>& tables, const TomlTable* physics) {
  if (!hasSoft(setup)) return;
  for (const char* key : {"friction_m_s2", "puck_friction", "cushion_friction", "spin_deceleration_m_s2"}) {
    if (physics == nullptr || !physics->has(key) || physics->number(key) == 0.0) continue;
    physics->fault(
        key, fmt::format("{} is {}, expected 0 in a game with soft pucks, which touch without friction", key,
                         physics->number(key)));
  }
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    if (puck.soft) continue;
    if (!puck.outline_m.empty()) {
      tables[i].fault(tables[i].has("outline_m") ? "outline_m" : "outline",
                      fmt::format("puck '{}' has corners and is rigid beside soft pucks, expected a disc, or "
                                  "[puck.soft] of a rectangle",
                                  puck.name));
    }
    for (const char* key : {"spin_rad_s", "spin_kg_m2_s"}) {
      if (!tables[i].has(key) || puck.spin_kg_m2_s == 0.0) continue;
      tables[i].fault(key, fmt::format("puck '{}' spins beside soft pucks, expected no spin", puck.name));
    }
  }
}

std::vector<Finding> oddSoft(const BilliardSetup& setup, const std::vector<TomlTable>& tables) {
  std::vector<Finding> odd;
  if (!hasSoft(setup)) return odd;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    if (puck.soft && !puck.outline_m.empty()) {
      const Vec2 half_m = glm::abs(puck.outline_m.front());
      const double slenderness = std::max(half_m.x, half_m.y) / std::min(half_m.x, half_m.y);
      if (slenderness > kLongest * (1.0 + 1e-9)) {
        odd.push_back({.at = tables[i].place("outline_m"),
                       .text = fmt::format("puck '{}' is {:.3g} times as long as wide: it buckles when it is "
                                           "compressed, expected at most {} times",
                                           puck.name, slenderness, kLongest)});
      }
    }
    double fastest = puck.soft && setup.board ? glm::length(puck.beta) : 0.0;
    for (const Puck& other : setup.pucks) {
      if (puck.soft || other.soft) fastest = std::max(fastest, closing(puck.beta, other.beta));
    }
    if (fastest <= kFastest) continue;
    odd.push_back(
        {.at = tables[i].place("beta"),
         .text = fmt::format("puck '{}' can close at {:.4g} c: soft pucks may be crushed more than can be "
                             "computed, expected at most {} c",
                             puck.name, fastest, kFastest)});
  }
  return odd;
}

std::string crushedText(const std::string& puck, double t_s) {
  return fmt::format(
      "puck '{}' was crushed more than can be computed at t = {:.6g} s, and went on in its mean motion", puck,
      t_s);
}

}  // namespace carom
