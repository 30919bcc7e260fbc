#pragma once
// Spacetime as a thing in the room: the tubes of the bodies in glass, with what a viewer sees and calls
// present in it. It is drawn as a thing at rest in the room, hanging with the walls. New knots of the game
// add to it; all else of it is a matrix.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "cave/marks/mark_buffer.h"
#include "cave/record/frame_state.h"
#include "cave/scene/scene.h"
#include "cave/sculpture/glass_drawer.h"
#include "cave/sculpture/sculpture_marks.h"
#include "cave/sculpture/sculpture_shape.h"
#include "engine/sculpture/growing_tube.h"

namespace carom {

class RoomSculpture {
 public:
  /// Create and destroy it with the drawing context current.
  explicit RoomSculpture(const SculptedGame& game);

  /// Takes a frame, once: further calls with the same frame do nothing.
  void follow(const FrameRecord& record, const World& world);

  /// A body's number among the sculpted, and where its top is drawn, from the eye.
  struct SeenTop {
    std::size_t body = 0;
    glm::dvec3 drawn_m{0.0};
  };
  /// Sets the eye from which it is drawn next: places are counted from `viewpoint_m`, room frame. Threads
  /// lead to the `tops` that a viewer sees.
  void look(const FrameRecord& record, const World& world, const OwnLines& lines, const Vec3& viewpoint_m,
            std::size_t viewer, std::span<const SeenTop> tops);

  const SculptureShape& shape() const { return shape_; }

  /// Draws it into a picture that has the depth of the bodies; `cutAt` as in MarkDrawer::draw.
  void draw(const glm::mat4& clipFromDrawn, unsigned framebuffer, const glm::ivec2& size_px,
            float cutAt = 0.0F) const;

 private:
  struct Tube {
    GrowingTube shape;
    GlassMesh mesh;
    GlassLook look;
    double reach_m = 0.0;  ///< the farthest of its places from the board's middle, along x or y
  };
  void followTubes(const FrameRecord& record, const World& world);
  void chooseTriangles(const SculptureMap& map);
  void makeSurfaces(const FrameRecord& record);
  GlassPlace placeFrom(const SculptureMap& map, const Vec3& viewpoint_m) const;
  void bound(const SculptureMap& map, const Vec3& viewpoint_m);
  bool mayShow(const glm::mat4& clipFromDrawn) const;

  SculptureShape shape_;
  GlassDrawer glass_;
  std::vector<Tube> tubes_;
  GlassMesh cushions_, seen_, boardNow_, myNow_;
  std::vector<GlassDrawer::Piece> pieces_;
  std::vector<glm::vec3> corners_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  GlassPlace place_;
  std::array<glm::vec4, 8> boundCorners_{};  // of a box around the glass, from the eye
  double base_s_ = 0.0;
  struct Marks {
    MarkBuffer batch;
    MarkDrawer drawer;
    SculptureMemory memory;
  } marks_;
  std::optional<std::uint64_t> frame_;  // that it has taken
};

}  // namespace carom
