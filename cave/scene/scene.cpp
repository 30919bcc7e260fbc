#include "cave/scene/scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "cave/mesh/surface_tiles.h"

namespace carom {
namespace {

/// Returns whether two notes are of the same kind and divided alike.
bool alike(const MeshNote& a, const MeshNote& b) {
  return a.kind == b.kind && a.vertices == b.vertices && a.divided == b.divided &&
         a.longestEdge_m == b.longestEdge_m;
}

/// Returns the names in one text, such as "Puck white, red"; of many, the first and how many more there are.
std::string joined(std::span<const MeshNote> notes) {
  constexpr std::size_t kMost = 20;
  std::string text = notes.front().kind;
  const std::size_t named = notes.size() > kMost ? 1 : notes.size();
  for (std::size_t i = 0; i < named; ++i) text += (i > 0 ? ", " : " ") + notes[i].name;
  return named < notes.size() ? text + fmt::format(" and {} more", notes.size() - named) : text;
}

/// Returns the note about the resting parts, which are divided for each eye.
std::string levelsOf(const MeshNote& note, const Tessellation& tessellation) {
  const double nearest_m =
      std::max(kNearestToSurface_m, kNearestEye_m * note.longestEdge_m / tessellation.edge_m());
  return fmt::format(
      "{} {}: {} vertices, their cells divided for each eye by up to {}: exact to half a pixel up to {} c "
      "from {:.2f} m "
      "on.\n",
      note.kind, note.name, note.vertices, kMostParts, kFastestHead_beta, nearest_m);
}

}  // namespace

std::vector<WorldLine> reachingTo(std::span<const WorldLine> histories, std::span<const double> reach_m) {
  std::vector<WorldLine> reaching(histories.begin(), histories.end());
  for (std::size_t body = 0; body < histories.size(); ++body) {
    const WorldLine& line = histories[body];
    if (line.radius_m() >= reach_m[body]) continue;
    WorldLine wide(line.knots().front(), line.lightSpeed_m_s(), reach_m[body], line.appears_s());
    for (const Knot& knot : line.knots().subspan(1)) wide.append(knot);
    reaching[body] = wide;
  }
  return reaching;
}

std::vector<double> rimsOf(const Scene& scene) {
  std::vector<double> rims_m(scene.bodyCount);
  for (const ScenePart& part : scene.parts) {
    if (part.paint == Paint::shadow) continue;
    rims_m[part.body] = std::max(rims_m[part.body], part.mesh->GetBounds()[1]);  // VTK's xmax
  }
  return rims_m;
}

std::string tessellationReport(const Scene& scene, const Tessellation& tessellation) {
  const double tolerance_rad = 0.5 * tessellation.pixel_rad;
  constexpr double kRounding = 1.0 + 1e-5;  // of coordinates in single precision
  std::string text;
  std::size_t total = 0;
  for (auto note = scene.notes.begin(); note != scene.notes.end();) {
    const auto unlike =
        std::find_if(note, scene.notes.end(), [&](const MeshNote& other) { return !alike(*note, other); });
    const auto count = static_cast<std::size_t>(unlike - note);
    total += count * note->divided;
    if (note->most == 0) {
      text += levelsOf(*note++, tessellation);
      continue;
    }
    text += fmt::format("{}: {} vertices{}, {} added", joined({note, unlike}), note->vertices,
                        count > 1 ? " each" : "", note->divided - std::min(note->divided, note->vertices));
    if (note->longestEdge_m > kRounding * tessellation.edge_m()) {
      // Only the ratio of length and distance counts.
      text += fmt::format(
          "; nearer than {:.1f} m exact to half a pixel only up to {:.2f} c at {} m, since {} "
          "vertices are the limit",
          kNearestEye_m * note->longestEdge_m / tessellation.edge_m(),
          fastestHead_beta(note->longestEdge_m, tolerance_rad), kNearestEye_m, note->most);
    }
    text += ".\n";
    note = unlike;
  }
  return text + fmt::format(
                    "In all {} vertices; edges up to {:.0f} mm are exact to half a pixel up to {} c "
                    "from {} m on.",
                    total, tessellation.edge_m() * 1e3, kFastestHead_beta, kNearestEye_m);
}

}  // namespace carom
