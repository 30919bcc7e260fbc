#pragma once
// Soft pucks in games of their own, with the rows that a node keeps and with every step of their simulation,
// on which points are solved for by bisection.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "cave/bodies/seen_rows.h"
#include "cave/frame/bodies.h"
#include "cave/record/frame_state.h"
#include "engine/billiard/billiard.h"
#include "engine/game/soft_puck_mesh.h"
#include "engine/soft/soft_play.h"

namespace carom::test {

inline constexpr double kSoftC = 1.42, kSoftRadius = 0.0305, kSoftHeight = 0.02;
inline constexpr double kPixel_rad = 3.0 / 1920.0 / 1.5;  // on a wall of a CAVE, from its middle

inline Puck disc(const char* name, const Vec2& position_m, const Vec2& beta) {
  Puck puck;
  puck.name = name;
  puck.radius_m = kSoftRadius;
  puck.height_m = kSoftHeight;
  puck.mass_kg = 0.2;
  puck.position_m = position_m;
  puck.beta = beta;
  return puck;
}

inline BilliardSetup bounceAt(double speed, int cells) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kSoftC;
  setup.board = Board{1.2, 0.8};
  setup.pucks = {disc("jelly", {0.45, 0.0}, {speed, 0.2})};
  setup.pucks[0].soft = SoftMatter{0.5, cells, 0.3, {}};
  return setup;
}

/// Two soft pucks that meet beside their centres, each at `speed`.
inline BilliardSetup pairAt(double speed, int cells) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kSoftC;
  setup.board = Board{1.2, 0.8};
  setup.pucks = {disc("jelly", {0.2, 0.0}, {speed, 0.0}), disc("other", {0.42, 0.02}, {-speed, 0.0})};
  setup.pucks[0].soft = SoftMatter{0.5, cells, 0.3, {}};
  setup.pucks[1].soft = SoftMatter{0.35, cells, 0.3, {}};
  return setup;
}

/// The steps of one of the pucks: its nodes' places at all times of the simulation, from a play of its own
/// with all of them, which are soft.
struct Steps {
  std::vector<double> times;
  std::vector<std::vector<glm::dvec2>> places;

  Steps(const BilliardSetup& setup, double until, std::size_t puck = 0) {
    const double x = 0.5 * setup.board->length_m, y = 0.5 * setup.board->width_m;
    SoftPlay play({{{1.0, 0.0}, x}, {{-1.0, 0.0}, x}, {{0.0, 1.0}, y}, {{0.0, -1.0}, y}});
    for (const Puck& each : setup.pucks) play.add(entryOf(each));
    std::vector<glm::dvec2> now;
    const auto note = [&](double time) {
      if (!times.empty() && time <= times.back()) return;
      times.push_back(time);
      places.push_back(now);
    };
    play.drawnPlaces(puck, -2.0, now), note(-2.0);
    play.drawnPlaces(puck, 0.0, now), note(0.0);
    play.watch([&](std::size_t body, double time) {
      if (body == puck) play.drawnPlaces(puck, std::nullopt, now), note(time);
    });
    while (play.time() < until) play.playSlice();
  }

  static SoftEntry entryOf(const Puck& puck) {
    SoftEntry entry;
    entry.name = puck.name;
    entry.mesh = std::make_shared<const SoftMesh>(softMeshOf(puck));
    entry.material = {puck.soft->soundSpeed, puck.soft->viscosity};
    entry.mass = puck.mass_kg;
    entry.centre = puck.position_m;
    entry.u = fourVelocity(puck.beta.x / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta)),
                           puck.beta.y / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta)));
    return entry;
  }

  glm::dvec3 at(double time, const SoftModel& model, std::size_t point) const {
    const SoftModel::Point& of = model.points[point];
    const auto after = std::upper_bound(times.begin(), times.end() - 1, time) - times.begin();
    const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1));
    const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
    const glm::dvec2 place = places[k - 1][of.node] + share * (places[k][of.node] - places[k - 1][of.node]);
    return {place, 0.5 * kSoftHeight + of.z_m};
  }

  /// The event of a point on the past cone of an eye, from the eye.
  Displacement seen(const Event& eye, const SoftModel& model, std::size_t point) const {
    double least = eye.t_s * kSoftC - 3.0, most = eye.t_s * kSoftC;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (least + most);
      const bool isBefore = eye.t_s * kSoftC - middle > glm::length(at(middle, model, point) - eye.r_m);
      (isBefore ? least : most) = middle;
    }
    return {least / kSoftC - eye.t_s, at(least, model, point) - eye.r_m};
  }
};

/// A game with its rows, as a node keeps them.
struct Played {
  World world;
  SoftModel model;
  std::vector<WorldLine> lines;

  Played(const BilliardSetup& setup, double until_s, std::size_t puck = 0)
      : model(
            softModel(softMeshOf(setup.pucks[puck]), true, kSoftHeight, kFirstPuck + puck, glm::vec3(1.0F))) {
    Billiard billiard(setup);
    billiard.advanceTo(until_s);
    lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
    world.histories = {restingWorldLine(kSoftC)};
    world.histories.insert(world.histories.end(), lines.begin(), lines.end());
    SoftRows rows;
    billiard.takeSoftRows(rows);
    FrameState frame;
    frame.rows = rows.rows;
    frame.rowNodes = rows.nodes;
    for (SoftRow& row : frame.rows) row.body += kFirstPuck;
    applyFrame(frame, world);
  }

  std::vector<SeenVertex> seen(const SeenHow& how) {
    std::vector<SeenVertex> vertices(model.vertices.size());
    SeenRows rows;
    rows.see(model, world.soft[model.body], how, Told::nothing, vertices);
    return vertices;
  }
};

}  // namespace carom::test
