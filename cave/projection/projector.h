#pragma once
// The steps between a wall's picture and its screen: the projector's mesh, its share of the light where
// projectors overlap, its black level and its mirroring.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"
#include "cave/room/warp_mesh.h"

namespace carom {

/// The fraction of the light that passes at each place of the window: RGB from 0 to 65535, rows from the
/// bottom up, stretched over the whole window. The numbers are linear in light, not sRGB: half of the highest
/// lets half of the light through.
struct BlendPicture {
  glm::ivec2 size_px{1};
  std::vector<std::uint16_t> rgb{0xffff, 0xffff, 0xffff};
};

/// Reads a PNG, JPEG or TIFF (by its ending) of 8 or 16 bits, grey or RGB, or the blend in a .vwf; alpha is
/// ignored. Throws
/// std::runtime_error, "FILE:1:1: what is wrong, what was expected".
BlendPicture readBlend(const std::filesystem::path& file);

/// The light leaving a projector is black + (gain - black) × blend × picture for each colour, each as a
/// fraction of the brightest; outside the mesh and the picture, the picture is 0. Pictures are sRGB encoded
/// (IEC 61966-2-1). What leaves is encoded for the projector: for light = code^gamma if it has a gamma,
/// otherwise as sRGB. Meshes and blend are given as the person sees them: mirroring is the last step.
struct Projection {
  Warp warp;
  BlendPicture blend{};
  double blackLevel = 0.0;
  Flip flip = Flip::none;
  glm::dvec3 gain{1.0};               ///< above the black level
  std::optional<glm::dvec3> gamma{};  ///< above 0
  /// Red, green and blue, in place of `warp`.
  std::optional<std::array<Warp, 3>> colourWarps{};
};

/// Returns none if the wall's picture goes to its window unchanged. Throws as readWarp and readBlend do.
std::optional<Projection> projectionOf(const Wall& wall);

/// Draws projected pictures. Create, use and destroy it in the same context.
class Projector {
 public:
  explicit Projector(const Projection& projection);

  /// Returns what leaves the projector for this eye's picture, of size `size_px`. It is valid until the next
  /// call for that eye.
  const RenderTarget& project(const RenderTarget& picture, Eye eye, const glm::ivec2& size_px);

 private:
  /// A mesh on the graphics card.
  struct DrawnMesh {
    DrawnMesh(const GlProgram& program, const WarpMesh& mesh);
    VertexStream<WarpPoint> points;
    GlBuffer triangles;
    int corners;
  };
  /// The meshes of the colours that are drawn together.
  struct ColourMeshes {
    std::array<bool, 3> colours;
    std::array<DrawnMesh, 2> meshes;  ///< left, right
  };
  void addMeshes(const std::array<bool, 3>& colours, const Warp& warp);
  void uploadBlend(const BlendPicture& blend);

  GlProgram program_;
  GlTexture blend_;
  std::array<float, 3> dark_{};  // the code of the black level
  std::vector<ColourMeshes> meshes_;
  std::array<std::unique_ptr<RenderTarget>, 2> projected_;  // left, right
};

}  // namespace carom
