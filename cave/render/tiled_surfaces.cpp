#include "cave/render/tiled_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/mesh/tessellation.h"

namespace carom {
namespace {

/// Returns the largest sin χ/D² within the angle of sine `sine` and cosine `cosine` around `chi` from the motion.
double mostBend(double speed_u, double cosChi, double sine, double cosine) {
  const double gamma = std::sqrt(1.0 + speed_u * speed_u);
  const double peak = (gamma - std::sqrt(gamma * gamma + 8.0 * speed_u * speed_u)) / (2.0 * speed_u);
  const double sinChi = std::sqrt(std::max(0.0, 1.0 - cosChi * cosChi));
  const double low = cosChi <= -cosine ? -1.0 : cosChi * cosine - sinChi * sine;  // cos(χ + α)
  const double high = cosChi >= cosine ? 1.0 : cosChi * cosine + sinChi * sine;   // cos(χ − α)
  const double worst = std::clamp(peak, low, high);
  const double doppler = gamma + speed_u * worst;
  return std::sqrt(std::max(0.0, 1.0 - worst * worst)) / (doppler * doppler);
}

/// Returns the coarsest level whose cells are no longer than this.
int coarsestWithin(const TileDetail& detail, double longest_m) {
  int level = 0;
  for (double cell_m = 2.0 * detail.cell_m; level < detail.coarsest && cell_m <= longest_m; cell_m *= 2.0)
    ++level;
  return level;
}

}  // namespace

double longestFlat_m(const Extent& box, const glm::dvec3& eye_m, const glm::dvec3& u) {
  const double speed_u = glm::length(u);
  if (speed_u < 1e-9) return std::numeric_limits<double>::infinity();
  const glm::dvec3 middle_m = 0.5 * (box.low_m + box.high_m) - eye_m;
  const double radius_m = 0.5 * glm::distance(box.low_m, box.high_m), distance_m = glm::length(middle_m);
  const double nearest_m =
      std::max(kNearestEye_m, glm::distance(glm::clamp(eye_m, box.low_m, box.high_m), eye_m));
  const bool within = distance_m <= radius_m;
  const double sine = within ? 0.0 : radius_m / distance_m;
  const double bend = within ? mostBend(speed_u, 0.0, 1.0, 0.0)
                             : mostBend(speed_u, glm::dot(u, middle_m) / (speed_u * distance_m), sine,
                                        std::sqrt(1.0 - sine * sine));
  return nearest_m * std::sqrt(8.0 / (speed_u * bend));
}

TiledSurfaces::TiledSurfaces(const SceneChunks& scene)
    : scene_(&scene),
      longest_m_(scene.meshes.edges.size() + scene.meshes.tiles.size()),
      levels_(longest_m_.size()),
      firstOfPart_(scene.parts.size() + 1) {
  std::size_t most = 0;
  for (const SurfaceTile& tile : scene.meshes.tiles)
    most += 6 * static_cast<std::size_t>(tile.cells[0] * tile.cells[1]);
  indices_.reserve(most);
}

void TiledSurfaces::look(const glm::dvec3& eye_m, const glm::dvec3& u) {
  auto longest_m = longest_m_.begin();
  for (const TileDetail& edge : scene_->meshes.edges) *longest_m++ = longestFlat_m(edge.extent, eye_m, u);
  for (const SurfaceTile& tile : scene_->meshes.tiles)
    *longest_m++ = longestFlat_m(tile.detail.extent, eye_m, u);
}

/// Returns the tile's level: no coarser than any of its edges.
int TiledSurfaces::levelOf(const SurfaceTile& tile, double longest_m) const {
  int level = coarsestWithin(tile.detail, longest_m);
  for (const std::uint32_t edge : tile.edges) level = std::min(level, levelOf(edge));
  return level;
}

void TiledSurfaces::choose(const VisibleChunks& visible, double tolerance_rad) {
  const ChunkedMeshes& meshes = scene_->meshes;
  const double root = std::sqrt(tolerance_rad);
  const std::size_t edges = meshes.edges.size();
  for (std::size_t i = 0; i < edges; ++i)
    levels_[i] = static_cast<std::uint8_t>(coarsestWithin(meshes.edges[i], root * longest_m_[i]));
  for (std::size_t i = 0; i < meshes.tiles.size(); ++i)
    levels_[edges + i] = static_cast<std::uint8_t>(levelOf(meshes.tiles[i], root * longest_m_[edges + i]));

  indices_.clear();
  for (std::size_t part = 0; part < scene_->parts.size(); ++part) {
    const PartChunks& chunks = scene_->parts[part];
    firstOfPart_[part] = indices_.size();
    if (!chunks.tiled) continue;
    for (const std::uint32_t place : visible.chosenOf(part)) {
      const std::size_t number = meshes.chunks[chunks.first + place - chunks.firstPlace].tile;
      const SurfaceTile& tile = meshes.tiles[number];
      const auto& e = tile.edges;
      appendTriangles(tile, levels_[edges + number],
                      {levelOf(e[0]), levelOf(e[1]), levelOf(e[2]), levelOf(e[3])}, indices_);
    }
  }
  firstOfPart_.back() = indices_.size();
}

std::size_t TiledSurfaces::digest() const {
  const std::string_view bytes(reinterpret_cast<const char*>(levels_.data()), levels_.size());
  return std::hash<std::string_view>()(bytes);
}

}  // namespace carom
