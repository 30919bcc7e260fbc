#include "cave/display/display_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cave/display/calibration_pattern.h"
#include "cave/display/wall_window.h"
#include "cave/projection/stereo.h"
#include "cave/room/headset_walls.h"
#include "cave/room/wall_eyes.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Returns the eye that sees what `eye` should when an operator has swapped the eyes.
Eye otherOf(Eye eye) {
  if (eye == Eye::middle) return eye;
  return eye == Eye::left ? Eye::right : Eye::left;
}

}  // namespace

DisplayWalls::DisplayWalls(Graphics& graphics, const Scene& scene, double lightSpeed_m_s,
                           std::vector<Wall> walls, const std::optional<WindowPlacement>& oneWindow,
                           bool visible)
    : graphics_(graphics),
      session_(std::make_unique<EyeRenderer>(graphics, scene, lightSpeed_m_s)),
      walls_(std::move(walls)) {
  hands_.setRims(rimsOf(scene));
  graphics_.makeCurrent();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    firstEyeOf_.push_back(wallEyes_.size());
    for (const ViewerEye& eye : eyesOf(walls_[wall])) {
      wallEyes_.push_back({wall, eye, FrameDelay(walls_[wall].pixels, walls_[wall].heldFrames), {}});
    }
  }
  firstEyeOf_.push_back(wallEyes_.size());
  if (!visible || walls_.empty()) return;
  for (const Wall& wall : walls_) projections_.push_back(projectionOf(wall));
  openWindows(oneWindow);
}

void DisplayWalls::openWindows(const std::optional<WindowPlacement>& oneWindow) {
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    const Wall& shown = walls_[wall];
    if (oneWindow) {  // the wall's own placement is its part of that window
      walls_[wall].viewport = Viewport{shown.window.position_px, shown.window.size_px};
      walls_[wall].window = *oneWindow;
    }
    const bool shared = shown.viewport.has_value();
    const auto found = std::find_if(windows_.begin(), windows_.end(), [&](const WallWindow& window) {
      return shared && window.shared && window.node == shown.node && window.placement == shown.window;
    });
    if (found != windows_.end()) {
      found->walls.push_back(wall);
    } else {
      windows_.push_back({shown.window, shown.node, shared, {wall}, nullptr});
    }
  }
  keepDisplayAwake();
  for (WallWindow& window : windows_) {
    std::string title;
    bool quadBuffer = false;
    for (const std::size_t wall : window.walls) {
      title += (title.empty() ? "" : ", ") + walls_[wall].name;
      quadBuffer = quadBuffer || walls_[wall].stereo == StereoMode::quadBuffer;
    }
    window.window = std::make_unique<Window>(graphics_, fmt::format(texts::title::kWalls, title),
                                             window.placement, quadBuffer);
  }
  // Who wears a headset does not wait for a mirror's display.
  const bool waits = !walls_.front().onHead;
  for (const WallWindow& window : windows_) window.window->setVsync(waits);
  if (windows_.size() > 1) swapTogether();
}

/// Gives each window's swap a thread, in which its context is current for that time only: a swap may block
/// until the display's next refresh, and one after the other would take as many refreshes as there are windows.
void DisplayWalls::swapTogether() {
  std::vector<std::function<void()>> swaps;
  for (const WallWindow& window : windows_) {
    swaps.emplace_back([shown = window.window.get()] {
      shown->makeCurrent();
      shown->swap();
      Window::makeNoneCurrent();
    });
  }
  swaps_ = std::make_unique<ParallelCalls>(std::move(swaps));
}

/// Draws the walls of one viewer, who is the first in `record`.
void DisplayWalls::drawSession(const FrameRecord& record, const World& world, std::size_t viewer) {
  for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
    pictured_.clear();
    for (WallEye& wallEye : wallEyes_) {
      if (wallEye.eye == ViewerEye{viewer, eye})
        pictured_.push_back({&walls_[wallEye.wall], &wallEye.pictures.next(),
                             record.controls.latency ? &wallEye.meters : nullptr});
    }
    session_->draw(record, world, record.observer, record.observer.of(eye), pictured_);
  }
}

void DisplayWalls::hangOnHead(const HeadsetState& headset) {
  if (!headset.isWorn) return;
  for (Wall& wall : walls_) {
    if (wall.onHead) hang(wall, headset.eyes[wall.stereo == StereoMode::left ? 0 : 1]);
  }
}

void DisplayWalls::draw(const FrameRecord& record, const World& world) {
  hangOnHead(record.headset);
  const WallControls& controls = drawn_ = record.controls;
  blank_ = controls.blank != 0;
  split_ = record.views.split != 0;
  if (controls.shown == Shown::calibrationPattern && !blank_)
    return drawCalibrationPatterns(controls.eyesSwapped != 0);
  calibrationPatterns_.reset();
  if (controls.shown == Shown::session && !blank_) {
    for (std::size_t viewer = 0; viewer < record.viewers; ++viewer) {
      FrameRecord seen = seenBy(record, viewer);
      if (controls.eyesSwapped) std::swap(seen.observer.left, seen.observer.right);
      drawSession(seen, world, viewer);
      drawAids(seen, viewer);
    }
    return;
  }
  graphics_.makeCurrent();
  for (WallEye& wallEye : wallEyes_) {
    RenderTarget& picture = wallEye.pictures.next();
    if (blank_) {
      picture.clear();
    } else {
      seams_.draw(walls_[wallEye.wall], record.display_s, picture);
    }
  }
}

void DisplayWalls::setScene(const Scene& scene, double lightSpeed_m_s) {
  session_ = std::make_unique<EyeRenderer>(graphics_, scene, lightSpeed_m_s);
  hands_.setRims(rimsOf(scene));
}

void DisplayWalls::setRoom(const RoomGeometry& room) {
  front_ = frontWall(room);
  graphics_.makeCurrent();
  if (room.isHeadset) board_.emplace(room.walls.front());
  for (std::size_t viewer = 0; viewer < room.viewers.size(); ++viewer) {
    rooms_.at(viewer) = seenBy(room, viewer);
    if (front_) words_[viewer].setWall(*front_, rooms_[viewer].viewers);
  }
}

void DisplayWalls::drawAids(const FrameRecord& record, std::size_t viewer) {
  graphics_.makeCurrent();
  const RoomGeometry& room = rooms_[viewer];
  words_[viewer].follow(record);
  if (board_)
    drawOnFront(record, viewer, board_->place(), record.observer.middle.positionInRoom_m, board_->wiped());
  for (WallEye& wallEye : wallEyes_) {
    if (wallEye.eye.viewer != viewer) continue;
    const Wall& wall = walls_[wallEye.wall];
    const RenderTarget& picture = wallEye.pictures.drawn();
    const glm::dvec3& eye_m = record.observer.of(wallEye.eye.eye).positionInRoom_m;
    const bool isFront = front_ && standSame(*front_, wall);
    comfort_.draw(room, wall, eye_m, record, picture);
    motion_.draw(room, wall, eye_m, record, picture);
    aids_.draw(room, wall, isFront, eye_m, record, picture);
    if (isFront) drawOnFront(record, viewer, wall, eye_m, picture);
    if (board_) board_->draw(wall, eye_m, picture);
    hands_.draw(room, wall, eye_m, record, picture);
    comfort_.fade(wall, record, picture);
  }
}

/// Draws words and choices over the picture of the front wall.
void DisplayWalls::drawOnFront(const FrameRecord& record, std::size_t viewer, const Wall& front,
                               const glm::dvec3& eye_m, const RenderTarget& picture) {
  const RoomGeometry& room = rooms_[viewer];
  words_[viewer].draw(front, record, picture);
  choices_.draw(front, record, offeredIn(room, record, offersChoices_, hasTable_), picture);
  if (hasTable_) home_.draw(room, front, eye_m, record, picture);
}

std::optional<PointedWall> DisplayWalls::pointedAt() const {
  if (drawn_.blank || drawn_.shown != Shown::session) return std::nullopt;
  for (const WallWindow& window : windows_) {
    const bool held = window.window->isHeld() || window.window->isTurning();
    const auto pointer_px = (isHeld() || isTurning()) && !held ? std::nullopt : window.window->pointer_px();
    if (!pointer_px) continue;
    const auto paneOf = [&](std::size_t wall) {
      return walls_[wall].viewport.value_or(Viewport{{0, 0}, window.window->size_px()});
    };
    const std::size_t nearest =
        *std::min_element(window.walls.begin(), window.walls.end(), [&](std::size_t a, std::size_t b) {
          return outside_px(paneOf(a), *pointer_px) < outside_px(paneOf(b), *pointer_px);
        });
    // A pointer that is held continues beyond the edge of the wall, as when a cue is drawn back.
    auto pointed = pointedIn(walls_[nearest], paneOf(nearest), *pointer_px, held);
    if (!pointed) continue;
    if (pointed->eye != Eye::middle) {
      const bool second = pointed->eye == Eye::right && firstEyeOf_[nearest + 1] - firstEyeOf_[nearest] > 1;
      const ViewerEye& eye = wallEyes_[firstEyeOf_[nearest] + (second ? 1 : 0)].eye;
      pointed->eye = eye.eye;
      pointed->viewer = eye.viewer;
    } else {
      pointed->viewer = walls_[nearest].viewer;
    }
    if (drawn_.eyesSwapped) pointed->eye = otherOf(pointed->eye);
    return pointed;
  }
  return std::nullopt;
}

bool DisplayWalls::isHeld() const {
  return std::any_of(windows_.begin(), windows_.end(),
                     [](const WallWindow& window) { return window.window->isHeld(); });
}

bool DisplayWalls::isTurning() const {
  return std::any_of(windows_.begin(), windows_.end(),
                     [](const WallWindow& window) { return window.window->isTurning(); });
}

const RenderTarget* DisplayWalls::pictureOf(const std::string& wall) const {
  if (board_ && board_->place().name == wall) return &board_->written();
  for (const WallEye& wallEye : wallEyes_) {
    if (walls_[wallEye.wall].name == wall) return &wallEye.pictures.drawn();
  }
  return nullptr;
}

/// The patterns stand still: they are drawn once and kept until something else is shown.
void DisplayWalls::drawCalibrationPatterns(bool eyesSwapped) {
  if (calibrationPatterns_ == eyesSwapped) return;
  graphics_.makeCurrent();
  for (WallEye& wallEye : wallEyes_) {
    const Eye eye = eyesSwapped ? otherOf(wallEye.eye.eye) : wallEye.eye.eye;
    const Image pattern = calibrationPattern(walls_[wallEye.wall], eye);
    for (std::size_t i = 0; i <= walls_[wallEye.wall].heldFrames; ++i)
      wallEye.pictures.next().fill(pattern.rgb);
  }
  calibrationPatterns_ = eyesSwapped;
}

std::span<const WallTime> DisplayWalls::drawingTimes() const {
  times_.clear();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    WallTime& time = times_.emplace_back(WallTime{walls_[wall].name.c_str(), 0.0F, 0});
    for (std::size_t i = firstEyeOf_[wall]; i < firstEyeOf_[wall + 1]; ++i) {
      for (std::size_t half = 0; half < (split_ ? 2U : 1U); ++half) {
        const DrawingMeter& meter = wallEyes_[i].meters[half];
        time.drawn_s += meter.timer.median_s();
        time.triangles += meter.triangles;
      }
    }
  }
  return times_;
}

void DisplayWalls::capture(Capture& capture, std::uint64_t frame) const {
  graphics_.makeCurrent();
  taken_.clear();
  for (std::size_t i = 0; i < wallEyes_.size(); ++i) {
    const WallEye& wallEye = wallEyes_[i];
    const Wall& wall = walls_[wallEye.wall];
    const std::string& name =
        wall.pictureNames.empty() ? wall.name : wall.pictureNames[i - firstEyeOf_[wallEye.wall]];
    taken_.push_back({&wallEye.pictures.drawn(), &name, wallEye.eye.eye});
  }
  capture.take(frame, taken_);
}

void DisplayWalls::film(Movie& movie, double display_s) const {
  graphics_.makeCurrent();
  filmed_.clear();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    filmed_.push_back(&wallEyes_[firstEyeOf_[wall]].pictures.drawn());
  }
  movie.add(display_s, filmed_);
}

std::vector<std::string> DisplayWalls::misplaced() const {
  std::vector<std::string> found;
  for (const WallWindow& window : windows_) {
    const std::string words = window.window->misplaced();
    if (!words.empty())
      found.push_back(fmt::format("the window of wall {} is {}", walls_[window.walls.front()].name, words));
  }
  return found;
}

std::optional<ScreenPlace> DisplayWalls::placeOf(const std::string& wall) const {
  for (const WallWindow& window : windows_) {
    const bool isIts = !window.shared && walls_[window.walls.front()].name == wall;
    if (isIts && window.placement.border) return window.window->place();
  }
  return std::nullopt;
}

NodeLock DisplayWalls::lockSwaps(FrameLock asked) {
  if (asked == FrameLock::software) return {};
  std::vector<SwapGroupCalls::Drawable> drawables;
  for (const WallWindow& window : windows_) drawables.push_back(window.window->drawable());
  if (!windows_.empty()) windows_.front().window->makeCurrent();
  return NodeLock(swapGroupOfDriver(), std::move(drawables));
}

void DisplayWalls::show(const std::function<void()>& over) {
  graphics_.finishDrawing();
  for (const WallWindow& window : windows_) {
    panes_.clear();
    const glm::ivec2 size_px = window.window->size_px();
    // If blank, the windows are as black as the screens can be, without the level that black is lifted to.
    for (std::size_t i = 0; i < window.walls.size() && !blank_; ++i)
      panes_.push_back(paneOf(window.walls[i], size_px));
    window.window->show(panes_, over);
  }
}

void DisplayWalls::awaitShown() {
  graphics_.awaitDrawing();
  for (const WallWindow& window : windows_) window.window->awaitShown();
}

void DisplayWalls::swap() {
  if (swaps_) {
    graphics_.makeCurrent();  // so that no window's context is current here
    return swaps_->run();
  }
  for (const WallWindow& window : windows_) window.window->swap();
}

Pane DisplayWalls::paneOf(std::size_t wall, const glm::ivec2& window_px) const {
  const Viewport place = walls_[wall].viewport.value_or(Viewport{{0, 0}, window_px});
  const std::size_t first = firstEyeOf_[wall], second = first + 1;
  return {&wallEyes_[first].pictures.shown(),
          second < firstEyeOf_[wall + 1] ? &wallEyes_[second].pictures.shown() : nullptr,
          walls_[wall].stereo,
          place.position_px,
          place.size_px,
          projections_[wall] ? &*projections_[wall] : nullptr};
}

}  // namespace carom
