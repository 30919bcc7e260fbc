#pragma once
// The picture of a curved screen's window for one eye, from the pictures of the flat walls on which the
// screen is drawn (cave/screen/flat_pieces.h). The place in a flat wall's picture of a point P of the screen
// is clipFromRoom · P, which is linear in P before it is divided; P is linear in the window within each
// triangle; so this is interpolated, and divided for each pixel. Between texels light is mixed, not its sRGB
// codes, by the cubic of Catmull and Rom (1974), which keeps fine stripes.

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/screen/curved_screen.h"

namespace carom {

class ScreenPicture {
 public:
  /// Create, use and destroy it with the drawing context current. Keeps a reference to the screen.
  explicit ScreenPicture(const CurvedScreen& screen);

  /// Draws the window's picture for an eye in the room. `pieces`: the pictures of the screen's pieces, in
  /// their order; a piece on or behind whose wall the eye lies is black, as is the window where it shows no
  /// screen.
  void draw(const glm::dvec3& eyeInRoom_m, std::span<const std::unique_ptr<RenderTarget>> pieces,
            RenderTarget& picture) const;

 private:
  /// A corner of a triangle.
  struct Corner {
    glm::vec2 inWindow;
    glm::vec3 inRoom_m;
    glm::vec3 across_m, upwards_m;  ///< change of the place in the room over the window, in its triangle
  };
  /// The triangles of one piece on the graphics card.
  struct DrawnPiece {
    DrawnPiece(const GlProgram& program, const ScreenMesh& mesh);
    VertexStream<Corner> corners;
    int count;
  };

  const CurvedScreen& screen_;
  GlProgram program_;
  std::vector<DrawnPiece> pieces_;
};

}  // namespace carom
