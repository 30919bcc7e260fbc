#include "cave/wall_set.h"

#include <algorithm>
#include <utility>

#include "cave/capture.h"
#include "cave/stereo.h"
#include "cave/test_pattern.h"

namespace carom {

WallSet::WallSet(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, std::vector<Wall> walls,
                 const std::optional<WindowPlacement>& oneWindow, bool visible)
    : graphics_(graphics),
      renderer_(graphics, scene, lightSpeed_m_s),
      walls_(std::move(walls)),
      oneWindow_(oneWindow.has_value()),
      bodies_(scene.bodyCount) {
  graphics_.makeCurrent();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    for (const Eye eye : eyesOf(walls_[wall].stereo)) {
      wallEyes_.push_back({wall, eye, std::make_unique<WallPicture>(walls_[wall].pixels)});
    }
  }
  if (!visible || walls_.empty()) return;
  for (const Wall& wall : walls_) projections_.push_back(projectionOf(wall));
  if (oneWindow) {
    const bool quadBuffer = std::any_of(
        walls_.begin(), walls_.end(), [](const Wall& wall) { return wall.stereo == StereoMode::quadBuffer; });
    windows_.push_back(std::make_unique<Window>(graphics_, "Carom", *oneWindow, quadBuffer));
  } else {
    for (const Wall& wall : walls_) {
      windows_.push_back(std::make_unique<Window>(graphics_, "Carom: " + wall.name, wall.window,
                                                  wall.stereo == StereoMode::quadBuffer));
    }
  }
  windows_.front()->setVsync(true);  // one wait a frame is enough for all windows of a node
}

void WallSet::drawSession(const ObserverView& observer, std::span<const WorldLine> histories,
                          const Switches& switches) {
  for (const Eye eye : {Eye::left, Eye::right, Eye::mono}) {
    const EyeView& eyeView = observer.eyes[static_cast<std::size_t>(eye)];
    bool looked = false;
    for (const WallEye& wallEye : wallEyes_) {
      if (wallEye.eye != eye) continue;
      if (!looked) {
        for (std::size_t body = 0; body < bodies_.size(); ++body) {
          viewBody(histories[body], eyeView.observation, observer.headFromBoard, bodies_[body], switches);
        }
        renderer_.look(observer.headFromBoard, eyeView, bodies_, switches);
        looked = true;
      }
      renderer_.draw(walls_[wallEye.wall], eyeView.positionInRoom_m, *wallEye.picture);
    }
  }
}

void WallSet::draw(const FrameRecord& record, std::span<const WorldLine> histories) {
  const WallControls& controls = record.controls;
  blank_ = controls.blank != 0;
  if (controls.shown == Shown::testPattern && !blank_) return drawTestPatterns(controls.eyesSwapped != 0);
  testPatterns_.reset();
  if (controls.shown == Shown::session && !blank_) {
    ObserverView observer = record.observer;
    if (controls.eyesSwapped) std::swap(observer.eyes[0], observer.eyes[1]);
    return drawSession(observer, histories, record.switches);
  }
  graphics_.makeCurrent();
  for (const WallEye& wallEye : wallEyes_) {
    if (blank_) {
      wallEye.picture->clear();
    } else {
      seams_.draw(walls_[wallEye.wall], record.display_s, *wallEye.picture);
    }
  }
}

/// They stand still: made once, kept until something else is shown.
void WallSet::drawTestPatterns(bool eyesSwapped) {
  if (testPatterns_ == eyesSwapped) return;
  graphics_.makeCurrent();
  for (const WallEye& wallEye : wallEyes_) {
    Eye eye = wallEye.eye;
    if (eyesSwapped && eye != Eye::mono) eye = eye == Eye::left ? Eye::right : Eye::left;
    wallEye.picture->fill(testPattern(walls_[wallEye.wall], eye).rgb);
  }
  testPatterns_ = eyesSwapped;
}

void WallSet::capture(const std::filesystem::path& directory, std::uint64_t frame) {
  graphics_.makeCurrent();
  for (const WallEye& wallEye : wallEyes_) {
    writePng(readBack(*wallEye.picture),
             capturePath(directory, walls_[wallEye.wall].name, wallEye.eye, frame));
  }
}

void WallSet::show() {
  if (windows_.empty()) return;
  graphics_.finishDrawing();
  panes_.clear();
  if (blank_) {  // black as the screens are, without the level that black is lifted to
    for (const auto& window : windows_) window->show({});
    return;
  }
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    const WindowPlacement& place = walls_[wall].window;
    if (oneWindow_) {
      panes_.push_back(paneOf(wall, place.position_px, place.size_px));
    } else {
      const Pane whole = paneOf(wall, {0, 0}, windows_[wall]->size_px());
      windows_[wall]->show({&whole, 1});
    }
  }
  if (oneWindow_) windows_.front()->show(panes_);
}

void WallSet::swap() {
  for (const auto& window : windows_) window->swap();
}

const WallPicture* WallSet::pictureOf(std::size_t wall, Eye eye) const {
  for (const WallEye& wallEye : wallEyes_) {
    if (wallEye.wall == wall && wallEye.eye == eye) return wallEye.picture.get();
  }
  return nullptr;
}

Pane WallSet::paneOf(std::size_t wall, const glm::ivec2& position_px, const glm::ivec2& size_px) const {
  const std::vector<Eye> eyes = eyesOf(walls_[wall].stereo);
  return {pictureOf(wall, eyes.front()),
          eyes.size() > 1 ? pictureOf(wall, eyes[1]) : nullptr,
          walls_[wall].stereo,
          position_px,
          size_px,
          projections_[wall] ? &*projections_[wall] : nullptr};
}

}  // namespace carom
