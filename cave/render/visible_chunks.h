#pragma once
// Which chunks of a scene's meshes a wall may show to one eye: only these are drawn.
//
// Each chunk has a sphere around it, which the eye sees within a cap of its sky (engine/light/seen_cap.h); a
// cap outside the wall's pyramid is not drawn. Shadows lie where no part of their puck is: they have one wide
// cap.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cave/mesh/mesh_chunks.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/spacetime/spherical_cap.h"

namespace carom {

/// The chunks of one part of a scene. Parts with the same mesh share them, but each sees its own in another
/// place:
/// it counts them from `firstPlace`.
struct PartChunks {
  std::size_t body = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t firstPlace = 0;
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
  /// drawn.
  void choose(const glm::dmat4& clipFromDrawn, bool everything = false);

  /// Returns the chosen chunks of a part, the nearest first.
  IndexRanges of(std::size_t part) const;
  /// Returns their places.
  std::span<const std::uint32_t> chosenOf(std::size_t part) const;
  /// Returns the places of all chosen chunks (PartChunks::firstPlace), part by part.
  std::span<const std::uint32_t> chosen() const { return chosen_; }

 private:
  void lookAtPart(const PartChunks& part, const BodyView& body, const ViewFrame& frame);

  const SceneChunks* scene_;
  std::vector<SphericalCap> caps_;        // of each place
  std::vector<std::uint8_t> drawn_;       // of each part
  std::vector<std::uint32_t> chosen_;     // places
  std::vector<std::size_t> firstOfPart_;  // in chosen_, and its end
  std::vector<int> counts_;               // of each chosen chunk
  std::vector<const void*> offsets_;
};

}  // namespace carom
