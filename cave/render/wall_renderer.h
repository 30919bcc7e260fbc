#pragma once
// Draws the scene as one eye sees it on one wall, into a texture. The emission solve runs in the vertex
// shader (engine/light/emission_kernel.glsl), over legs that were prepared in double for that eye.
//
//   renderer.look(observer.headFromBoard, eye, bodyViews);          // once for each eye
//   renderer.draw(walls, eye.positionInRoom_m);                     // all walls of that eye

#include <memory>
#include <span>
#include <vector>

#include "cave/bodies/hot_bodies.h"
#include "cave/bodies/soft_drawer.h"
#include "cave/gl/gpu_timer.h"
#include "cave/gl/graphics.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"
#include "cave/scene/ghosts.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/switches.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"

namespace carom {

class RoomSculpture;
class SpacetimeMarks;

/// How one wall is drawn into its picture.
struct WallDrawing {
  glm::dvec3 seenFromEye_m{0.0};             ///< origin of seen places, relative to the eye; room axes
  int left_px = 0;                           ///< column of the picture in which the wall begins
  SpacetimeMarks* marks = nullptr;           ///< drawn among the bodies
  const RoomSculpture* sculpture = nullptr;  ///< stands in the room
  float cutAt = 0.0F;  ///< the wall's border beyond which another picture continues: 1 right, −1 left, 0 none
  bool everything = false;  ///< draw also what the wall cannot show: the same picture, for comparison
};

/// What drawing a wall's picture takes.
struct DrawingMeter {
  GpuTimer timer;
  std::size_t triangles = 0;  ///< that were handed over for the last picture
};

/// A wall, and the picture that is drawn for it.
struct WallPicture {
  const Wall* wall = nullptr;
  RenderTarget* picture = nullptr;
  WallDrawing drawing;
  DrawingMeter* meter = nullptr;
};

class WallRenderer {
 public:
  /// `samples`: samples of multisample antialiasing (1: none). Where the processor stands in for a graphics
  /// card, edges are smoothed in the finished picture instead (cave/render/edge_smoother.h). Keeps a
  /// reference to `graphics`, and makes its context current in every call.
  WallRenderer(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, int samples = 4);
  ~WallRenderer();
  WallRenderer(const WallRenderer&) = delete;
  WallRenderer& operator=(const WallRenderer&) = delete;

  /// Sets what one eye receives: `bodies[i]` is body i of the scene, viewed by `eye` in the frame
  /// `headFromBoard` with these switches, but for the soft bodies that have rows in `soft`.
  /// `heat` is of every body or none, and must last while the eye is drawn. The first frame
  /// after a change of switches takes longer, and so does the first frame with ghosts of a kind. Throws
  /// std::invalid_argument if the number of bodies is not that of the scene.
  void look(const Lorentz& headFromBoard, const EyeView& eye, std::span<const BodyView> bodies,
            const Switches& switches = {}, const Ghosts& ghosts = {}, const SoftLook& soft = {},
            std::span<const HotBlows> heat = {});

  /// Draws what the eye last given to `look` sees on walls from `eyeInRoom_m` (the tracked eye at the time
  /// when the photons leave the walls), each into as many columns of its picture as the wall has. The picture
  /// of a wall on or behind which the eye is stays black. Returns how many others there are.
  std::size_t draw(std::span<const WallPicture> walls, const glm::dvec3& eyeInRoom_m);
  /// Does the same for one wall; returns whether the eye is before it.
  bool draw(const Wall& wall, const glm::dvec3& eyeInRoom_m, RenderTarget& picture,
            const WallDrawing& drawing = {}) {
    const WallPicture only{&wall, &picture, drawing, nullptr};
    return draw({&only, 1}, eyeInRoom_m) == 1;
  }

 private:
  struct Seen;
  void drawWall(const WallPicture& shown, const Seen& seen);

  struct Drawing;  // what OpenGL holds
  Graphics& graphics_;
  std::unique_ptr<Drawing> drawing_;
  std::vector<Seen> seen_;  // of each wall that is being drawn
};

}  // namespace carom
