#pragma once
// Draws the glass of the sculpture of spacetime: tubes, panes and surfaces. Its corners are events of the
// board; one matrix takes them to where they stand in the room, whatever frame the sculpture is shown in. It
// is blended without an order: first all glass takes its share of the light behind it, by products, then all
// of it adds the light of its own, by sums.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/gl/gl_objects.h"
#include "engine/sculpture/solid.h"

namespace carom {

/// How a piece of glass looks.
struct GlassLook {
  glm::vec3 colour{1.0F};  ///< sRGB
  float taken = 0.1F;      ///< share of the light behind that it takes, of the other colours
  float shine = 0.1F;      ///< share of its colour that it adds, seen straight on
  float edge = 0.6F;       ///< and seen along its surface
  float ahead = 0.3F;      ///< factor of all that for what lies above the present
  bool closed = false;     ///< it goes round: its far side is drawn with the near one, as bright as that
};

/// Returns the look of a thin sheet, which takes nothing and adds the same from all sides.
inline GlassLook sheetLook(const glm::vec3& colour, float shine) {
  return {colour, 0.0F, shine, shine, 1.0F};
}

/// Where the glass stands for one eye.
struct GlassPlace {
  glm::mat4 drawnFromEvent{1.0F};   ///< from (x, y, c t, 1) to places from the eye
  glm::mat4 shadowFromEvent{1.0F};  ///< the same for shadows on the floor
  glm::vec4 heightOfEvent{0.0F};    ///< row that gives the height over the foot, metres of the board
  float present_m = 0.0F, top_m = 1.0F;
};

/// A surface of glass on the graphics card. Corners: (x, y, c t) metres.
class GlassMesh {
 public:
  explicit GlassMesh(const GlProgram& program);
  void upload(std::span<const glm::vec3> corners, std::span<const std::array<std::uint32_t, 3>> triangles);
  /// Draws some of the triangles, at most those that there are.
  void draw(const TriangleRange& triangles) const;

 private:
  VertexStream<glm::vec3> corners_;
  GlBuffer triangles_;
  std::size_t count_ = 0;
};

class GlassDrawer {
 public:
  /// Create and destroy it with the drawing context current.
  GlassDrawer();

  GlassMesh mesh() const { return GlassMesh(program_); }

  struct Piece {
    const GlassMesh* mesh = nullptr;
    GlassLook look;
    /// The triangles that are drawn of it.
    TriangleRange triangles{0, std::numeric_limits<std::size_t>::max()};
  };
  /// Draws all pieces, and shadows of those that are closed. Call it within a GlStateGuard, with the depth
  /// test on.
  void draw(std::span<const Piece> pieces, const GlassPlace& place, const glm::mat4& clipFromDrawn) const;

 private:
  GlProgram program_, sheets_, shadows_;
};

}  // namespace carom
