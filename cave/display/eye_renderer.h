#pragma once
// A session as one eye sees it on its walls: the bodies, and the views of time that are turned on
// (cave/record/time_views.h).

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cave/bodies/hot_bodies.h"
#include "cave/gl/graphics.h"
#include "cave/gl/picture.h"
#include "cave/marks/spacetime_marks.h"
#include "cave/record/frame_state.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/wall.h"
#include "cave/scene/scene.h"
#include "cave/sculpture/room_sculpture.h"

namespace carom {

/// Of one eye on one wall: of all of it or, while it is split, of its left half and its right.
using WallMeters = std::array<DrawingMeter, 2>;

/// A wall and the picture that is drawn for it; the wall has as many pixels as the picture.
struct PicturedWall {
  const Wall* wall = nullptr;
  RenderTarget* picture = nullptr;
  WallMeters* meters = nullptr;
  /// The column in which the right half of a split wall begins: its middle, but of a piece of a curved
  /// screen, which lies on one half, one of its ends.
  int split_px = 0;
};

/// Returns the columns of `wall` from `left_px` up to `right_px` as a wall of its own.
Wall columnsOf(const Wall& wall, int left_px, int right_px);

/// Draws the line between the halves of a split wall into its picture.
void drawSplitLine(const RenderTarget& picture);

class EyeRenderer {
 public:
  /// Width of the line between the halves of a split wall, in columns around its middle.
  static constexpr int kSplitLine_px = 3;

  /// Keeps a reference to `graphics`.
  EyeRenderer(Graphics& graphics, const Scene& scene, double lightSpeed_m_s);
  ~EyeRenderer();

  /// Draws what `eye` of `observer` sees on its walls. `world.histories[i]` is body i of the scene; people of
  /// another room follow. A view of
  /// time creates what it needs when it is first turned on; turned off, it costs nothing. A scripted body
  /// that always rests on the board has no ghost "now on the board", and one that always moves with the room
  /// has none of "my now". `viewer`: whose eye it is.
  void draw(const FrameRecord& record, const World& world, const ObserverView& observer, const EyeView& eye,
            std::span<const PicturedWall> walls, std::size_t viewer = 0);

 private:
  enum class Part { whole, left, right };
  void look(WallRenderer& renderer, const Switches& switches, const FrameRecord& record, const World& world,
            const ObserverView& observer, const EyeView& eye);
  Ghosts viewGhosts(const Switches& switches, const FrameRecord& record, const World& world,
                    const ObserverView& observer, const EyeView& eye);
  void lookAtSculpture(const FrameRecord& record, const World& world, const ObserverView& observer,
                       const EyeView& eye, std::size_t viewer);
  void drawPart(WallRenderer& renderer, Part part, const EyeView& eye, std::span<const PicturedWall> walls);

  Graphics& graphics_;
  Scene scene_;
  WallRenderer renderer_;
  std::unique_ptr<WallRenderer> beside_;  // for the right halves: each renderer keeps its shaders
  std::unique_ptr<SpacetimeMarks> marks_;
  HotBodies hot_;
  OwnLines lines_;                            // also while the sculpture is not shown
  std::unique_ptr<RoomSculpture> sculpture_;  // null while it is not shown
  std::vector<RoomSculpture::SeenTop> tops_;
  bool marked_ = false;
  std::vector<BodyView> bodies_, boardNow_, myNow_;
  std::vector<Wall> parts_;            // halves of walls
  std::vector<WallPicture> pictures_;  // of the eye that is drawn
};

}  // namespace carom
