#pragma once
// Which chunks of a scene's meshes a wall may show to one eye: only these are drawn.
//
// Each chunk has a sphere around it, which the eye sees within a cap of its sky (engine/light/seen_cap.h); a
// cap outside the wall's pyramid is not drawn. Shadows lie where no part of their puck is: they have one wide
// cap.
// Theory: app/doc/physics.md, Aberration and cells.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cave/mesh/mesh_chunks.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/seen_cap.h"
#include "engine/spacetime/spherical_cap.h"

namespace carom {

/// Chunks of one mesh. Parts with the same mesh share them, but each sees its own in another place: it counts
/// them from `firstPlace`.
struct ChunkRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t firstPlace = 0;
};

/// The chunks of one part of a scene, and of its coarser meshes.
struct PartChunks : ChunkRange {
  static constexpr std::size_t kMostCoarser = 4;
  struct Coarser : ChunkRange {
    double cell_m = 0.0, off_m = 0.0;  ///< CoarserMesh
  };
  std::size_t body = 0;
  std::array<Coarser, kMostCoarser> coarser{};
  std::size_t coarserCount = 0;
  double reach_m = 0.0;  ///< of the coarser meshes, from the body's centre
  const ChunkRange& rangeOf(std::size_t level) const {
    if (level == 0) return *this;
    return coarser[level - 1];
  }
  /// Of a shadow, how far it can reach from the place of its puck's centre; of all else, 0.
  double shadowReach_m = 0.0;
  bool tiled = false;  ///< each chunk is a tile
};

/// The meshes of a scene in chunks; `parts[i]` is part i of the scene.
struct SceneChunks {
  explicit SceneChunks(const Scene& scene);

  ChunkedMeshes meshes;
  std::vector<PartChunks> parts;
  std::size_t places = 0;  ///< chunks of all parts together, each part's own

 private:
  void appendCoarser(const ScenePart& part, PartChunks& chunks);
};

/// Ranges of the indices, as glMultiDrawElements takes them.
struct IndexRanges {
  std::span<const int> counts;
  std::span<const void* const> offsets;  ///< in bytes
};

/// Chunks chosen anew for each eye and wall. Allocates only when it is made.
class VisibleChunks {
 public:
  /// Keeps a reference to `scene`.
  explicit VisibleChunks(const SceneChunks& scene);

  /// Sets what an eye sees: `bodies[i]` is body i in `frame`; a body without legs is not drawn. No bodies:
  /// nothing is.
  void look(std::span<const BodyView> bodies, const ViewFrame& frame);

  /// Chooses the chunks that the wall with this projection may show; or with `everything`, all that are
  /// drawn. Of parts that have coarser meshes, those of the coarsest by which nothing is off by more than
  /// `tolerance_rad`.
  void choose(const glm::dmat4& clipFromDrawn, double tolerance_rad = 0.0, bool everything = false);

  /// Returns the chosen chunks of a part, the nearest first.
  IndexRanges of(std::size_t part) const;
  /// Returns the mesh of a part that was chosen, counted from its own towards the coarser ones.
  std::size_t levelOf(std::size_t part) const { return level_[part]; }
  /// Returns their places.
  std::span<const std::uint32_t> chosenOf(std::size_t part) const;
  /// Returns the places of all chosen chunks (ChunkRange::firstPlace), part by part.
  std::span<const std::uint32_t> chosen() const { return chosen_; }

 private:
  /// How a part is seen: the angles by which its coarser meshes are off, and the meshes whose caps are known.
  struct PartView {
    std::optional<SeenCaps> seen;
    std::array<double, PartChunks::kMostCoarser> off_rad{};
    std::uint32_t known = 0;  // a bit for each mesh
  };
  void chooseLevel(std::size_t part, double tolerance_rad);

  const SceneChunks* scene_;
  std::vector<SphericalCap> caps_;        // of each place
  std::vector<PartView> views_;           // of each part; nothing is seen of one that is not drawn
  std::vector<std::uint8_t> level_;       // of each part
  std::vector<std::uint32_t> chosen_;     // places
  std::vector<std::size_t> firstOfPart_;  // in chosen_, and its end
  std::vector<int> counts_;               // of each chosen chunk
  std::vector<const void*> offsets_;
};

}  // namespace carom
