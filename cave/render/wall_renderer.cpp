#include "cave/render/wall_renderer.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/bodies/body_drawer.h"
#include "cave/frame/bodies.h"
#include "cave/marks/spacetime_marks.h"
#include "cave/mesh/tessellation.h"
#include "cave/render/draw_target.h"
#include "cave/render/edge_smoother.h"
#include "cave/render/still_layers.h"
#include "cave/room/off_axis.h"
#include "cave/sculpture/room_sculpture.h"

namespace carom {

/// What the eye sees on a wall; null if it is not before the wall.
struct WallRenderer::Seen {
  const BodyDrawer::Choice* choice = nullptr;
};

struct WallRenderer::Drawing {
  Drawing(const Scene& scene, double lightSpeed_m_s, int samples, bool inSoftware)
      : bodyCount(scene.bodyCount),
        bodies(scene, lightSpeed_m_s),
        target(inSoftware ? 1 : samples),
        keepsStill(inSoftware) {
    if (inSoftware && samples > 1) smoother.emplace();
  }

  void drawBodies(const BodyDrawer::Choice& choice, const glm::ivec2& size_px, const glm::ivec2& place) {
    if (keepsStill) {
      still.draw(bodies, choice, size_px, target, place);
    } else {
      target.begin(size_px);
      bodies.draw(choice, BodyDrawer::What::still);
      bodies.draw(choice, BodyDrawer::What::changing);
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
                        const Switches& switches, const Ghosts& ghosts, const SoftLook& soft,
                        std::span<const HotBlows> heat) {
  for (const std::span<const BodyView> views : {bodies, ghosts.boardNow, ghosts.myNow}) {
    if (views.size() == drawing_->bodyCount || (views.empty() && views.data() != bodies.data())) continue;
    throw std::invalid_argument(
        fmt::format("the scene has {} bodies, views of {} were given", drawing_->bodyCount, views.size()));
  }
  if (bodies[kRestingBody].legs.size() != 1) {
    throw std::invalid_argument("what rests on the board has turned");
  }
  graphics_.makeCurrent();
  drawing_->bodies.look(headFromBoard, eye, bodies, switches, ghosts, soft, heat);
}

std::size_t WallRenderer::draw(std::span<const WallPicture> walls, const glm::dvec3& eyeInRoom_m) {
  graphics_.makeCurrent();
  seen_.clear();
  for (const WallPicture& shown : walls) {
    const std::optional<glm::dmat4> projection = clipFromEye(*shown.wall, eyeInRoom_m);
    if (!projection) {
      seen_.push_back({});
      continue;
    }
    const glm::dmat4 clipFromDrawn = glm::translate(*projection, shown.drawing.seenFromEye_m);
    const double pixel_rad = finestPixel_rad({shown.wall, 1}, eyeInRoom_m);
    seen_.push_back({&drawing_->bodies.choose(clipFromDrawn, pixel_rad, shown.drawing.everything)});
  }
  const auto isDrawn = [](const Seen& seen) { return seen.choice && !seen.choice->parts.empty(); };
  if (std::any_of(seen_.begin(), seen_.end(), isDrawn)) drawing_->bodies.upload();
  drawing_->target.forgetViewport();
  for (std::size_t i = 0; i < walls.size(); ++i) {
    DrawingMeter* const meter = walls[i].meter;
    if (meter) meter->timer.begin();
    drawWall(walls[i], seen_[i]);
    if (!meter) continue;
    meter->timer.end();
    meter->triangles = seen_[i].choice ? seen_[i].choice->triangles : 0;
  }
  return static_cast<std::size_t>(
      std::count_if(seen_.begin(), seen_.end(), [](const Seen& seen) { return seen.choice != nullptr; }));
}

void WallRenderer::drawWall(const WallPicture& shown, const Seen& seen) {
  const auto& [wall, picture, drawing, meter] = shown;
  const int left_px = drawing.left_px;
  if (!seen.choice || (seen.choice->parts.empty() && !drawing.marks && !drawing.sculpture)) {
    picture->clear(left_px, wall->pixels.x);
    return;
  }
  drawing_->drawBodies(*seen.choice, wall->pixels, {picture->framebuffer(), left_px});
  if (drawing.sculpture)
    drawing.sculpture->draw(glm::mat4(seen.choice->clipFromDrawn), drawing_->target.framebuffer(),
                            wall->pixels, drawing.cutAt);
  if (drawing.marks) {
    drawing.marks->draw(glm::mat4(seen.choice->clipFromDrawn), drawing_->target.framebuffer(), wall->pixels,
                        drawing.cutAt);
  }
  if (drawing_->smoother) {
    drawing_->smoother->copy(drawing_->target, *picture, left_px);
  } else {
    drawing_->target.copyTo(*picture, left_px);
  }
}

}  // namespace carom
