#include "app/files/scenario_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "app/files/toml_values.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

std::vector<ScriptedLeg> readLegs(const TomlTable& body) {
  std::vector<ScriptedLeg> legs;
  double last_s = -std::numeric_limits<double>::infinity();
  for (const TomlTable& table : body.tables("leg")) {
    ScriptedLeg leg;
    if (legs.empty()) {
      table.refuse("from_s",
                   "has no meaning on the first leg, which reaches back to the beginning; expected none");
    } else {
      leg.from_s = table.number("from_s");
      if (table.has("from_s") && !(leg.from_s > last_s)) {
        table.fault("from_s", fmt::format("from_s is {}, expected a time after the leg before it, above {}",
                                          leg.from_s, last_s));
      }
      last_s = leg.from_s;
    }
    const Vec3 beta = toVec3(table.numbers<3>("beta"));
    checkSpeed(table, beta);
    leg.u = glm::dot(beta, beta) < 1.0 ? uFromBeta(beta) : Vec3(0.0);
    legs.push_back(leg);
  }
  if (legs.empty()) body.fault("leg", "there is no leg here, expected one [[body.leg]] at least");
  return legs;
}

/// Returns the centre at board time `t_s`, on a straight leg that it passes at `event`.
Event alongLeg(const Event& event, const Vec3& u, double t_s, double c_m_s) {
  return {t_s, event.r_m + betaFromU(u) * (c_m_s * (t_s - event.t_s))};
}

/// Returns the world line of a body whose centre passes `at`, on whichever leg holds that time: the events of
/// its turns follow from there in both directions. Its angle is 0 there.
WorldLine scriptedWorldLine(const BodyText& body, double c_m_s) {
  const std::vector<ScriptedLeg>& legs = body.legs;
  const Event& at = body.at;
  std::size_t holding = 0;
  while (holding + 1 < legs.size() && legs[holding + 1].from_s <= at.t_s) ++holding;
  std::vector<Event> begins(legs.size(), at);  // for the first leg, an event on it
  for (std::size_t i = holding; i > 0; --i) {
    begins[i] = alongLeg(i == holding ? at : begins[i + 1], legs[i].u, legs[i].from_s, c_m_s);
    begins[i - 1] = begins[i];
  }
  for (std::size_t i = holding + 1; i < legs.size(); ++i) {
    begins[i] = alongLeg(i == holding + 1 ? at : begins[i - 1], legs[i - 1].u, legs[i].from_s, c_m_s);
  }

  std::vector<Knot> knots;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    Knot knot{.turn = begins[i], .u = legs[i].u, .signal = begins[i]};
    if (i > 0) knot.properTime_s = motionOnLeg(knots.back(), knot.turn.t_s, c_m_s).properTime_s;
    knots.push_back(knot);
  }
  const double at_s = motionOnLeg(knots[holding], at.t_s, c_m_s).properTime_s;
  for (Knot& knot : knots)
    knot.spin = {angleAfter({0.0, body.spin_rad_s}, knot.properTime_s - at_s), body.spin_rad_s};

  // The clock shows 0 where the body appears, or at board time 0.
  const double zero_s = body.appears_s.value_or(0.0);
  const auto holdsZero = std::find_if(knots.rbegin(), knots.rend() - 1,
                                      [&](const Knot& knot) { return knot.turn.t_s <= zero_s; });
  const double shown_s = motionOnLeg(*holdsZero, zero_s, c_m_s).properTime_s;
  for (Knot& knot : knots) knot.properTime_s -= shown_s;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WorldLine line(knots.front(), c_m_s, kInfinity, body.appears_s.value_or(-kInfinity));
  for (std::size_t i = 1; i < knots.size(); ++i) line.append(knots[i]);
  return line;
}

}  // namespace

std::optional<std::filesystem::path> readMesh(const TomlFile& file, const TomlTable& table) {
  if (!table.has("mesh")) return {};
  return file.existingFile(table, "mesh", InputKind::mesh, Reach::ownFolder);
}

BodyText readBody(const TomlFile& file, const TomlTable& table) {
  BodyText body{table, table.text("name"), readMesh(file, table), {}, {}, 0.0, {}};
  if (const auto at = table.requiredTable("at")) {
    body.at = {at->number("t_s"), toVec3(at->numbers<3>("r_m"))};
  }
  if (table.has("appears_s")) body.appears_s = table.number("appears_s");
  body.spin_rad_s = table.number("spin_rad_s");
  body.legs = readLegs(table);
  return body;
}

ScriptedBody scriptedBody(const BodyText& body, double c_m_s) {
  return {body.name, scriptedWorldLine(body, c_m_s), body.mesh};
}

}  // namespace carom
