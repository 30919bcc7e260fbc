#include "app/cave_session.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <memory>
#include <stdexcept>

#include "app/frame_loop.h"
#include "app/rig.h"
#include "app/scenario.h"
#include "app/toml_file.h"
#include "cave/scene.h"

namespace carom {
namespace {

/// Raised on every rank once one has failed: that one has said why.
struct RankFailed {};

/// What to tell the person; names the node where it is not the one they sit at.
std::string messageOf(const Cluster& cluster, const std::exception& error) {
  const std::string node = cluster.rank() == 0 ? "" : " (node " + std::to_string(cluster.rank()) + ")";
  const auto* input = dynamic_cast<const InputErrors*>(&error);
  if (!input) return std::string("error: ") + error.what() + node;
  std::string lines;
  for (const InputError& fault : input->faults()) {
    lines += (lines.empty() ? "error: " : "\nerror: ") + std::string(fault.what()) + node;
  }
  return lines;
}

/// Runs `step` on every rank; if it fails on any, the lowest such rank says why and the session ends
/// everywhere.
void together(const Cluster& cluster, const std::function<void()>& step) {
  std::string message;
  try {
    step();
  } catch (const std::exception& error) {
    message = messageOf(cluster, error);
  }
  const int failed = cluster.firstFailed(!message.empty());
  if (failed < 0) return;
  if (failed == cluster.rank()) std::fprintf(stderr, "%s\n", message.c_str());
  throw RankFailed{};
}

/// The room's attitude and motion: its floor's right, forward and up on the board, boosted by the platform's
/// β.
Lorentz boardFromRoom(const ObserverStart& start, const RoomAxes& axes, double c_m_s) {
  const glm::dvec3 forward(std::cos(start.facing_rad), std::sin(start.facing_rad), 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dmat3 board(glm::cross(forward, up), forward, up);
  const glm::dmat3 room(axes.right, axes.forward, axes.up);
  const glm::dquat turn = glm::normalize(glm::quat_cast(board * glm::transpose(room)));
  return Lorentz::boost(uFromBeta(start.beta), c_m_s) * Lorentz::rotation(turn, c_m_s);
}

Scene sceneOf(const Scenario& scenario) {
  const auto pathOf = [](const auto& mesh) { return mesh ? mesh->string() : std::string(); };
  std::vector<BodyLooks> pucks;
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    const Puck& puck = scenario.billiard.pucks[i];
    pucks.push_back({puck.name, pathOf(scenario.puckMeshes[i]), puck.radius_m, puck.height_m});
  }
  std::vector<BodyLooks> told;
  for (const ToldBody& body : scenario.bodies) told.push_back({body.name, pathOf(body.mesh), 0.0, 0.0});
  Hall hall;
  hall.floor_m = scenario.observer.position_m.z;
  return buildScene(scenario.billiard, pucks, told, hall);
}

std::vector<Wall> wallsOf(const Rig& rig, const Cluster& cluster) {
  std::vector<Wall> walls;
  for (const Wall& wall : rig.walls) {
    if (cluster.draws(wall)) walls.push_back(wall);
  }
  return walls;
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (node.rank == rank) return node.display;
  }
  return {};
}

/// The person and the game at the start of the session.
std::unique_ptr<Play> startPlay(const Rig& rig, const Scenario& scenario, Clock& clock,
                                const CaveOptions& options) {
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  HeadTracking tracking(rig);
  const HeadEstimate first = tracking.at({0, 0.0, 1.0 / rig.display_hz + rig.displayLatency_s, 0.0});
  const Observer observer(boardFromRoom(scenario.observer, rig.axes, c_m_s),
                          {0.0, scenario.observer.position_m}, {first.pose, first.celerity_m_s});
  return std::make_unique<Play>(Play{Pacer(clock, rig.display_hz, rig.displayLatency_s), std::move(tracking),
                                     observer, Game(scenario), rig.head.eyeSeparation_m, options.frames});
}

void makeFolder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw std::runtime_error(fmt::format("--capture {}: {}, expected a folder or a name for one",
                                         folder.string(), failed.message()));
  }
}

/// What is about to be seen, for the person at rank 0.
void announce(const Rig& rig, const Scenario& scenario, const Cluster& cluster, const CaveOptions& options) {
  fmt::print(stderr, "{} (light at {} m/s) in {}: {} walls, {} node{}.\n", scenario.title,
             scenario.billiard.lightSpeed_m_s, rig.title, rig.walls.size(), cluster.size(),
             cluster.size() == 1 ? "" : "s");
  for (const Wall& wall : rig.walls) {
    if (wall.node < cluster.size()) continue;
    fmt::print(stderr, "Wall {} asks for node {}; node {} draws it.\n", wall.name, wall.node,
               wall.node % cluster.size());
  }
  if (!options.frames) fmt::print(stderr, "Escape, Q or the window's button ends the session.\n");
}

void runSession(Cluster& cluster, const CaveOptions& options) {
  Rig rig;
  std::optional<Scenario> scenario;
  together(cluster, [&] {
    rig = readRig(options.rig);
    scenario = readScenario(options.scenario);
  });

  std::unique_ptr<Graphics> graphics;
  std::unique_ptr<WallSet> walls;
  std::unique_ptr<Clock> clock;
  std::unique_ptr<Play> play;
  together(cluster, [&] {
    graphics = std::make_unique<Graphics>(displayOf(rig, cluster.rank()));
    walls = std::make_unique<WallSet>(*graphics, sceneOf(*scenario), scenario->billiard.lightSpeed_m_s,
                                      wallsOf(rig, cluster), rig.oneWindow, !options.noWindow);
    if (cluster.rank() > 0) return;
    if (options.frames) {
      clock = std::make_unique<SimulatedClock>();
    } else {
      clock = std::make_unique<SteadyClock>();
    }
    play = startPlay(rig, *scenario, *clock, options);
  });
  together(cluster, [&] {
    if (options.capture) makeFolder(*options.capture);
  });

  if (play) announce(rig, *scenario, cluster, options);
  Node node{cluster, *graphics, *walls, startingHistories(*scenario), options.capture};
  runFrames(node, play.get());
  if (play && options.capture) fmt::print(stderr, "The pictures are in {}.\n", options.capture->string());
}

}  // namespace

int runCave(const CaveOptions& options) {
  Cluster cluster;
  try {
    runSession(cluster, options);
    return 0;
  } catch (const RankFailed&) {
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", messageOf(cluster, error).c_str());
    if (cluster.size() > 1) cluster.abort();
    return 1;
  }
}

}  // namespace carom
