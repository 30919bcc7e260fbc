#include "cave/render/visible_chunks.h"

#include <algorithm>

#include "cave/room/wall_pyramid.h"
#include "engine/light/seen_cap.h"

namespace carom {
namespace {

/// Light that falls as flat as it can, 0.05 in shaders/body_vert.glsl, makes a shadow 20 times as long as the puck
/// is high; its motion may double that.
constexpr double kLongestShadow = 40.0;

/// Returns how far a shadow's vertices are from the puck's centre, and how far they are moved at most. The
/// third number for painting is the puck's height.
double shadowReachOf(const ChunkedMeshes& meshes, const PartChunks& part) {
  double reach_m = 0.0, height_m = 0.0;
  for (const MeshChunk& chunk : std::span(meshes.chunks).subspan(part.first, part.count)) {
    for (const std::uint32_t i : std::span(meshes.indices).subspan(chunk.firstIndex, chunk.indexCount)) {
      reach_m = std::max(reach_m, static_cast<double>(glm::length(meshes.vertices[i].place_m)));
      height_m = std::max(height_m, static_cast<double>(meshes.vertices[i].surface.z));
    }
  }
  return reach_m + kLongestShadow * height_m;
}

}  // namespace

SceneChunks::SceneChunks(const Scene& scene) {
  for (const ScenePart& part : scene.parts) {
    const std::size_t first = meshes.chunks.size();
    appendChunks(*part.mesh, meshes);
    parts.push_back({part.body, static_cast<std::uint32_t>(first),
                     static_cast<std::uint32_t>(meshes.chunks.size() - first), 0.0});
    if (part.paint == Paint::shadow) parts.back().shadowReach_m = shadowReachOf(meshes, parts.back());
  }
}

VisibleChunks::VisibleChunks(const SceneChunks& scene)
    : scene_(&scene),
      caps_(scene.meshes.chunks.size()),
      drawn_(scene.parts.size()),
      firstOfPart_(scene.parts.size() + 1) {
  chosen_.reserve(caps_.size());
  counts_.reserve(caps_.size());
  offsets_.reserve(caps_.size());
}

void VisibleChunks::lookAtPart(const PartChunks& part, const BodyView& body, const ViewFrame& frame) {
  const SeenCaps seen(body, frame);
  for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
    const MeshChunk& chunk = scene_->meshes.chunks[i];
    caps_[i] =
        part.shadowReach_m > 0.0 ? seen.around(part.shadowReach_m) : seen.of(chunk.middle_m, chunk.radius_m);
  }
}

void VisibleChunks::look(std::span<const BodyView> bodies, const ViewFrame& frame) {
  for (std::size_t i = 0; i < scene_->parts.size(); ++i) {
    const PartChunks& part = scene_->parts[i];
    drawn_[i] = !bodies.empty() && !bodies[part.body].legs.empty();
    if (drawn_[i]) lookAtPart(part, bodies[part.body], frame);
  }
}

void VisibleChunks::choose(const glm::dmat4& clipFromDrawn, bool everything) {
  const WallPyramid pyramid(clipFromDrawn);
  chosen_.clear();
  for (std::size_t part = 0; part < scene_->parts.size(); ++part) {
    firstOfPart_[part] = chosen_.size();
    if (!drawn_[part]) continue;
    const PartChunks& chunks = scene_->parts[part];
    for (std::uint32_t i = chunks.first; i < chunks.first + chunks.count; ++i) {
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
  for (const std::uint32_t i : chosen_) {
    const MeshChunk& chunk = scene_->meshes.chunks[i];
    counts_.push_back(static_cast<int>(chunk.indexCount));
    offsets_.push_back(reinterpret_cast<const void*>(chunk.firstIndex * sizeof(std::uint32_t)));
  }
}

IndexRanges VisibleChunks::of(std::size_t part) const {
  const std::size_t first = firstOfPart_[part], count = firstOfPart_[part + 1] - first;
  return {std::span(counts_).subspan(first, count), std::span(offsets_).subspan(first, count)};
}

}  // namespace carom
