#include "cave/render/wall_renderer.h"

#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/frame/bodies.h"
#include "cave/mesh/tessellation.h"
#include "cave/render/body_drawer.h"
#include "cave/render/draw_target.h"
#include "cave/render/edge_smoother.h"
#include "cave/render/spacetime_marks.h"
#include "cave/render/still_layers.h"
#include "cave/room/off_axis.h"

namespace carom {

struct WallRenderer::Drawing {
  Drawing(const Scene& scene, double lightSpeed_m_s, int samples, bool inSoftware)
      : bodyCount(scene.bodyCount),
        bodies(scene, lightSpeed_m_s),
        target(inSoftware ? 1 : samples),
        keepsStill(inSoftware) {
    if (inSoftware && samples > 1) smoother.emplace();
  }

  void drawBodies(const glm::dmat4& clipFromDrawn, const glm::ivec2& size_px, const glm::ivec2& place) {
    if (keepsStill) {
      still.draw(bodies, clipFromDrawn, size_px, target, place);
    } else {
      target.begin(size_px);
      bodies.draw(clipFromDrawn, BodyDrawer::What::still);
      bodies.draw(clipFromDrawn, BodyDrawer::What::changing);
    }
  }

  std::size_t bodyCount;
  BodyDrawer bodies;
  DrawTarget target;
  bool keepsStill;
  StillLayers still;
  std::optional<EdgeSmoother> smoother;  // instead of several samples a pixel
};

WallRenderer::WallRenderer(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, int samples)
    : graphics_(graphics) {
  graphics.makeCurrent();
  drawing_ = std::make_unique<Drawing>(scene, lightSpeed_m_s, samples, graphics.inSoftware());
}

WallRenderer::~WallRenderer() { graphics_.makeCurrent(); }

void WallRenderer::look(const Lorentz& headFromBoard, const EyeView& eye, std::span<const BodyView> bodies,
                        const Switches& switches, const Ghosts& ghosts) {
  for (const std::span<const BodyView> views : {bodies, ghosts.boardNow, ghosts.myNow}) {
    if (views.size() == drawing_->bodyCount || (views.empty() && views.data() != bodies.data())) continue;
    throw std::invalid_argument(
        fmt::format("the scene has {} bodies, views of {} were given", drawing_->bodyCount, views.size()));
  }
  if (bodies[kRestingBody].legs.size() != 1) {
    throw std::invalid_argument("what rests on the board has turned");
  }
  graphics_.makeCurrent();
  drawing_->bodies.look(headFromBoard, eye, bodies, switches, ghosts);
}

bool WallRenderer::draw(const Wall& wall, const glm::dvec3& eyeInRoom_m, RenderTarget& picture,
                        const WallDrawing& drawing) {
  graphics_.makeCurrent();
  const std::optional<glm::dmat4> projection = clipFromEye(wall, eyeInRoom_m);
  if (!projection) {
    picture.clear(drawing.left_px, wall.pixels.x);
    return false;
  }
  const glm::dmat4 clipFromDrawn = glm::translate(*projection, drawing.seenFromEye_m);
  const double pixel_rad = finestPixel_rad({&wall, 1}, eyeInRoom_m);
  if (!drawing_->bodies.choose(clipFromDrawn, pixel_rad, drawing.everything) && !drawing.marks) {
    picture.clear(drawing.left_px, wall.pixels.x);
    return true;
  }
  drawing_->drawBodies(clipFromDrawn, wall.pixels, {picture.framebuffer(), drawing.left_px});
  if (drawing.marks) {
    drawing.marks->draw(glm::mat4(clipFromDrawn), drawing_->target.framebuffer(), wall.pixels, drawing.cutAt);
  }
  drawing_->target.copyTo(picture, drawing.left_px);
  if (drawing_->smoother)
    drawing_->smoother->smooth(drawing_->target.texture(), wall.pixels, picture, drawing.left_px);
  return true;
}

}  // namespace carom
