#include "cave/bodies/visible_chunks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/bodies/flat_cells.h"
#include "cave/frame/bodies.h"
#include "cave/mesh/mesh_builder.h"
#include "cave/mesh/mesh_tiles.h"
#include "cave/room/wall_pyramid.h"

namespace carom {
namespace {

/// Returns how far a shadow's vertices are from the puck's centre, and how far they are moved at most,
/// `longest` heights of the puck. The third number for painting is the puck's height.
double shadowReachOf(const ChunkedMeshes& meshes, const PartChunks& part, double longest) {
  double reach_m = 0.0, height_m = 0.0;
  for (const MeshChunk& chunk : std::span(meshes.chunks).subspan(part.first, part.count)) {
    for (const std::uint32_t i : std::span(meshes.indices).subspan(chunk.firstIndex, chunk.indexCount)) {
      reach_m = std::max(reach_m, static_cast<double>(glm::length(meshes.vertices[i].place_m)));
      height_m = std::max(height_m, static_cast<double>(meshes.vertices[i].surface.z));
    }
  }
  return reach_m + longest * height_m;
}

/// Highlights of surfaces that are less rough than this, and do not mirror pixel by pixel, are computed at
/// vertices, and need cells of this size.
constexpr float kGlossy = 0.25F;
constexpr double kGlossyCell_m = 0.15;
bool isGlossy(const ScenePart& part) {
  return part.roughness > 0.0F && part.roughness < kGlossy && !isPolished(part.paint);
}

/// Returns the light that falls on a vertex of what rests for an eye at rest, as shaders/body_vert.glsl
/// computes it.
double lightAtRest(const Scene& scene, const MeshVertex& vertex) {
  const auto lit = [&](std::size_t i) { return vertex.lit[i] / 255.0; };
  double light = lit(3) * glm::mix(0.32, 0.66, 0.5 + 0.5 * static_cast<double>(vertex.normal.z));
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 way_m = scene.lamps_m[i] - glm::dvec3(vertex.place_m);
    const double distance2_m2 = glm::dot(way_m, way_m);
    const double facing = std::max(0.0, glm::dot(glm::dvec3(vertex.normal), way_m) / std::sqrt(distance2_m2));
    light += lit(i) * facing * 1.1 / (distance2_m2 + 0.3);
  }
  return light;
}

}  // namespace

SceneChunks::SceneChunks(const Scene& scene) {
  MeshTiles tiles(meshes, [&](const MeshVertex& vertex) { return lightAtRest(scene, vertex); });
  std::map<const vtkPolyData*, PartChunks> made;
  for (const ScenePart& part : scene.parts) {
    const auto [found, isNew] = made.try_emplace(part.mesh);
    PartChunks& chunks = found->second;
    if (isNew) {
      chunks.first = static_cast<std::uint32_t>(meshes.chunks.size());
      chunks.tiled = part.body == kRestingBody && hasPatches(*part.mesh);
      if (chunks.tiled) {
        tiles.append(*part.mesh, isGlossy(part) ? kGlossyCell_m : kAnyCell_m);
      } else {
        appendChunks(*part.mesh, meshes);
      }
      chunks.count = static_cast<std::uint32_t>(meshes.chunks.size()) - chunks.first;
      if (part.paint == Paint::shadow)
        chunks.shadowReach_m = shadowReachOf(meshes, chunks, scene.longestShadow);
      appendCoarser(part, chunks);
    }
    chunks.body = part.body;
    const auto place = [this](ChunkRange& range) {
      range.firstPlace = static_cast<std::uint32_t>(places);
      places += range.count;
    };
    place(chunks);
    for (std::size_t k = 0; k < chunks.coarserCount; ++k) place(chunks.coarser[k]);
    parts.push_back(chunks);
  }
}

/// Appends the coarser meshes of a part.
void SceneChunks::appendCoarser(const ScenePart& part, PartChunks& chunks) {
  chunks.coarserCount = std::min(part.coarser.size(), PartChunks::kMostCoarser);
  for (std::size_t k = 0; k < chunks.coarserCount; ++k) {
    PartChunks::Coarser& coarser = chunks.coarser[k];
    coarser.cell_m = part.coarser[k].cell_m;
    coarser.off_m = part.coarser[k].off_m;
    coarser.first = static_cast<std::uint32_t>(meshes.chunks.size());
    appendChunks(*part.coarser[k].mesh, meshes);
    coarser.count = static_cast<std::uint32_t>(meshes.chunks.size()) - coarser.first;
    for (std::uint32_t i = coarser.first; i < coarser.first + coarser.count; ++i)
      chunks.reach_m = std::max({chunks.reach_m, chunks.shadowReach_m,
                                 glm::length(meshes.chunks[i].middle_m) + meshes.chunks[i].radius_m});
  }
}

VisibleChunks::VisibleChunks(const SceneChunks& scene)
    : scene_(&scene),
      caps_(scene.places),
      views_(scene.parts.size()),
      level_(scene.parts.size()),
      firstOfPart_(scene.parts.size() + 1) {
  chosen_.reserve(caps_.size());
  counts_.reserve(caps_.size());
  offsets_.reserve(caps_.size());
}

void VisibleChunks::look(std::span<const BodyView> bodies, const ViewFrame& frame) {
  for (std::size_t i = 0; i < scene_->parts.size(); ++i) {
    const PartChunks& part = scene_->parts[i];
    PartView& view = views_[i];
    view.seen.reset();
    if (bodies.empty() || bodies[part.body].legs.empty()) continue;
    view.seen.emplace(bodies[part.body], frame);
    view.known = 0;
    for (std::size_t k = 0; k < part.coarserCount; ++k)
      view.off_rad[k] = worstOff_rad(*view.seen, part.reach_m, part.coarser[k].cell_m, part.coarser[k].off_m);
  }
}

/// Chooses the mesh of a part that is drawn, and sees to it that the caps of its chunks are known.
void VisibleChunks::chooseLevel(std::size_t number, double tolerance_rad) {
  const PartChunks& part = scene_->parts[number];
  PartView& view = views_[number];
  std::size_t level = 0;
  while (level < part.coarserCount && view.off_rad[level] <= tolerance_rad) ++level;
  // A turn bends a shadow by less than the width over which its edge is soft.
  if (level == 0 && part.shadowReach_m > 0.0 && part.coarserCount > 0) level = 1;
  level_[number] = static_cast<std::uint8_t>(level);
  if ((view.known >> level & 1U) != 0) return;
  view.known |= 1U << level;
  const ChunkRange& range = part.rangeOf(level);
  for (std::uint32_t i = 0; i < range.count; ++i) {
    const MeshChunk& chunk = scene_->meshes.chunks[range.first + i];
    caps_[range.firstPlace + i] = part.shadowReach_m > 0.0 ? view.seen->around(part.shadowReach_m)
                                                           : view.seen->of(chunk.middle_m, chunk.radius_m);
  }
}

void VisibleChunks::choose(const glm::dmat4& clipFromDrawn, double tolerance_rad, bool everything) {
  const WallPyramid pyramid(clipFromDrawn);
  chosen_.clear();
  for (std::size_t part = 0; part < scene_->parts.size(); ++part) {
    firstOfPart_[part] = chosen_.size();
    if (!views_[part].seen) continue;
    chooseLevel(part, tolerance_rad);
    const ChunkRange& range = scene_->parts[part].rangeOf(level_[part]);
    for (std::uint32_t i = range.firstPlace; i < range.firstPlace + range.count; ++i) {
      if (everything || pyramid.mayShow(caps_[i])) chosen_.push_back(i);
    }
    std::sort(chosen_.begin() + static_cast<std::ptrdiff_t>(firstOfPart_[part]), chosen_.end(),
              [this](std::uint32_t a, std::uint32_t b) {
                if (caps_[a].nearest_m != caps_[b].nearest_m) return caps_[a].nearest_m < caps_[b].nearest_m;
                return a < b;
              });
  }
  firstOfPart_.back() = chosen_.size();
  counts_.clear();
  offsets_.clear();
  for (std::size_t part = 0; part < scene_->parts.size(); ++part) {
    const ChunkRange& range = scene_->parts[part].rangeOf(level_[part]);
    for (std::size_t i = firstOfPart_[part]; i < firstOfPart_[part + 1]; ++i) {
      const MeshChunk& chunk = scene_->meshes.chunks[range.first + chosen_[i] - range.firstPlace];
      counts_.push_back(static_cast<int>(chunk.indexCount));
      offsets_.push_back(reinterpret_cast<const void*>(chunk.firstIndex * sizeof(std::uint32_t)));
    }
  }
}

std::span<const std::uint32_t> VisibleChunks::chosenOf(std::size_t part) const {
  return std::span(chosen_).subspan(firstOfPart_[part], firstOfPart_[part + 1] - firstOfPart_[part]);
}

IndexRanges VisibleChunks::of(std::size_t part) const {
  const std::size_t first = firstOfPart_[part], count = firstOfPart_[part + 1] - first;
  return {std::span(counts_).subspan(first, count), std::span(offsets_).subspan(first, count)};
}

}  // namespace carom
