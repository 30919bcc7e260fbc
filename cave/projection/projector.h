#pragma once
// What stands between a wall's picture and its screen: the projector's mesh, its share of the light where
// projectors overlap, its black and its mirroring.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/picture.h"
#include "cave/room/wall.h"
#include "cave/room/warp_mesh.h"

namespace carom {

/// The share of the light that passes at each place of the window: RGB from 0 to 65535, rows from the bottom
/// up, stretched over the whole window. The numbers count light, not its sRGB code: half of the highest lets
/// half of the light through.
struct BlendPicture {
  glm::ivec2 size_px{1};
  std::vector<std::uint16_t> rgb{0xffff, 0xffff, 0xffff};
};

/// A PNG, JPEG or TIFF (by its ending) of 8 or 16 bits, grey or RGB; what covers it (alpha) is not used.
/// Throws std::runtime_error, "FILE:1:1: what is wrong, what was expected".
BlendPicture readBlend(const std::filesystem::path& file);

/// The light leaving a projector is black + (1 - black) × blend × picture, each a share of the brightest
/// (decoded from sRGB, IEC 61966-2-1, and encoded again); outside the mesh and the picture, the picture is 0.
/// Mesh and blend are given as the person sees them: mirroring comes last.
struct Projection {
  Warp warp;
  BlendPicture blend;
  double blackLevel = 0.0;
  Flip flip = Flip::none;
};

/// None where the wall's picture goes to its window as it is. Throws as readWarp and readBlend.
std::optional<Projection> projectionOf(const Wall& wall);

/// Draws projected pictures in the context in which it was made, and is destroyed in it.
class Projector {
 public:
  explicit Projector(const Projection& projection);
  ~Projector();
  Projector(const Projector&) = delete;
  Projector& operator=(const Projector&) = delete;

  /// What leaves the projector, `size_px` large, for a picture of this eye. Valid until the next call for the
  /// eye.
  const RenderTarget& project(const RenderTarget& picture, Eye eye, const glm::ivec2& size_px);

 private:
  struct DrawnMesh {
    unsigned vertexArray = 0;
    unsigned points = 0;     // buffer
    unsigned triangles = 0;  // buffer
    int corners = 0;
  };
  DrawnMesh upload(const WarpMesh& mesh) const;
  void uploadBlend(const BlendPicture& blend);

  unsigned program_ = 0;
  unsigned blend_ = 0;  // texture
  float black_ = 0.0F;
  std::array<DrawnMesh, 2> meshes_;                         // left, right
  std::array<std::unique_ptr<RenderTarget>, 2> projected_;  // left, right
};

}  // namespace carom
