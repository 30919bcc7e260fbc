#include "app/check.h"

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <string_view>

#include "app/rig.h"
#include "app/scenario.h"
#include "app/toml_file.h"
#include "engine/lorentz.h"

namespace carom {

namespace {

enum class FileKind { scenario, rig };

/// Told by what is in it.
FileKind kindOf(const std::filesystem::path& path) {
  const auto refuse = [&](const char* what) { throw InputErrors({InputError(path.string(), 1, 1, what)}); };
  if (path.extension() == ".pvx")
    refuse("ParaView files are not supported yet, expected a scenario or a rig");
  if (path.extension() == ".json") refuse("SGCT files are not supported yet, expected a scenario or a rig");
  const TomlFile file(path);
  for (const char* key : {"light_speed_m_s", "puck", "body", "board", "physics", "observer", "stroke"}) {
    if (file.root().has(key)) return FileKind::scenario;
  }
  for (const char* key : {"wall", "unit", "axes", "head", "tracker", "one_window", "display_hz"}) {
    if (file.root().has(key)) return FileKind::rig;
  }
  refuse("this is neither a scenario nor a rig, expected light_speed_m_s of a scenario or [[wall]] of a rig");
  return FileKind::scenario;
}

constexpr double kMetresPerFoot = 0.3048;

void tell(const Wall& wall) {
  constexpr std::array<std::string_view, 9> kStereo{
      "mono, one picture",      "the left eye's picture alone", "the right eye's picture alone",
      "stereo by quad-buffer",  "stereo side by side",          "stereo top and bottom",
      "stereo in red and cyan", "stereo in alternate lines",    "stereo in a checkerboard"};
  const double width_m = glm::distance(wall.lowerLeft_m, wall.lowerRight_m);
  const double height_m = glm::distance(wall.lowerLeft_m, wall.upperLeft_m);
  fmt::print(
      "wall {}: {:.0f} × {:.0f} mm ({:.2f} × {:.2f} ft), {} × {} pixels an eye, {:.1f} px/m across, {:.1f} "
      "px/m up, "
      "{}, drawn by rank {}\n",
      wall.name, width_m * 1e3, height_m * 1e3, width_m / kMetresPerFoot, height_m / kMetresPerFoot,
      wall.pixels.x, wall.pixels.y, wall.pixels.x / width_m, wall.pixels.y / height_m,
      kStereo[static_cast<std::size_t>(wall.stereo)], wall.node);
}

void tellRig(const std::filesystem::path& path) {
  const Rig rig = readRig(path);
  fmt::print("{}: a rig of {} walls at {} Hz\n", rig.title, rig.walls.size(), rig.display_hz);
  for (const Wall& wall : rig.walls) tell(wall);
  if (rig.oneWindow) {
    fmt::print("all walls in one window of {} × {} pixels\n", rig.oneWindow->size_px.x,
               rig.oneWindow->size_px.y);
  }
  for (const TrackerSetup& tracker : rig.trackers) {
    if (tracker.kind == TrackerKind::recorded) {
      fmt::print("tracker {}: recorded, from {}\n", tracker.name, tracker.source.string());
    } else {
      fmt::print("tracker {}: simulated\n", tracker.name);
    }
  }
  fmt::print("head: tracker {}, sensor {}, eyes {:.1f} mm apart\n",
             rig.trackers[rig.head.sensor.tracker].name, rig.head.sensor.sensor,
             rig.head.eyeSeparation_m * 1e3);
  if (rig.hand)
    fmt::print("hand: tracker {}, sensor {}\n", rig.trackers[rig.hand->tracker].name, rig.hand->sensor);
  for (const NodeSetup& node : rig.nodes)
    fmt::print("rank {} draws on display {}\n", node.rank, node.display);
}

void tellScenario(const std::filesystem::path& path) {
  const Scenario scenario = readScenario(path);
  const BilliardSetup& setup = scenario.billiard;
  fmt::print("{}: a scenario with light at {} m/s\n", scenario.title, setup.lightSpeed_m_s);
  if (setup.board) {
    fmt::print("board: {:.0f} × {:.0f} mm between the cushions; light takes {:.3g} s along it\n",
               setup.board->length_m * 1e3, setup.board->width_m * 1e3,
               setup.board->length_m / setup.lightSpeed_m_s);
  } else {
    fmt::print("board: an open plane without cushions\n");
  }
  for (const Puck& puck : setup.pucks) {
    const double beta = glm::length(puck.beta);
    fmt::print(
        "puck {}: radius {:.1f} mm, height {:.1f} mm, {} kg, starts at ({}, {}) mm with {:.4g} c (γ = "
        "{:.4g})\n",
        puck.name, puck.radius_m * 1e3, puck.height_m * 1e3, puck.mass_kg, puck.position_m.x * 1e3,
        puck.position_m.y * 1e3, beta, gammaFromU(uFromBeta(Vec3(puck.beta, 0.0))));
  }
  for (const ToldBody& body : scenario.bodies) {
    const std::size_t turns = body.worldLine.knots().size() - 1;
    fmt::print("body {}: moves as told, turns {} times\n", body.name, turns);
  }
  fmt::print("{} scripted strokes\n", setup.strokes.size());
  const Vec3& p = scenario.observer.position_m;
  fmt::print("observer: the room's floor origin starts at ({}, {}, {}) mm with {:.4g} c\n", p.x * 1e3,
             p.y * 1e3, p.z * 1e3, glm::length(scenario.observer.beta));
}

}  // namespace

int runCheck(const std::filesystem::path& file) {
  if (kindOf(file) == FileKind::scenario) {
    tellScenario(file);
  } else {
    tellRig(file);
  }
  return 0;
}

}  // namespace carom
