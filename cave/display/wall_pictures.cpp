#include "cave/display/wall_pictures.h"

#include <utility>

#include "cave/patterns/calibration_pattern.h"
#include "cave/patterns/screen_pattern.h"
#include "cave/pictures/image.h"
#include "cave/room/headset_walls.h"
#include "cave/screen/curved_screen.h"

namespace carom {

Eye otherOf(Eye eye) {
  if (eye == Eye::middle) return eye;
  return eye == Eye::left ? Eye::right : Eye::left;
}

WallPictures::WallPictures(Graphics& graphics, const Scene& scene, double lightSpeed_m_s,
                           std::vector<Wall> walls)
    : graphics_(graphics),
      walls_(std::move(walls)),
      session_(std::make_unique<EyeRenderer>(graphics, scene, lightSpeed_m_s)) {
  graphics_.makeCurrent();
  for (const Wall& wall : walls_) flatWalls_.push_back(wall.screen ? flatWallsOf(wall) : std::vector<Wall>());
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    firstEyeOf_.push_back(eyes_.size());
    for (const ViewerEye& eye : carom::eyesOf(walls_[wall])) {
      eyes_.push_back({wall, eye, FrameDelay(walls_[wall].pixels, walls_[wall].heldFrames), {}, {}, {}});
      addPieces(eyes_.back());
    }
  }
  firstEyeOf_.push_back(eyes_.size());
}

void WallPictures::addPieces(WallEye& wallEye) {
  const Wall& wall = walls_[wallEye.wall];
  wallEye.meters.resize(std::max<std::size_t>(1, flatWalls_[wallEye.wall].size()));
  if (!wall.screen) return;
  for (const Wall& flat : flatWalls_[wallEye.wall])
    wallEye.pieces.push_back(std::make_unique<RenderTarget>(flat.pixels));
  wallEye.screen = std::make_unique<ScreenPicture>(*wall.screen);
}

void WallPictures::setScene(const Scene& scene, double lightSpeed_m_s) {
  session_ = std::make_unique<EyeRenderer>(graphics_, scene, lightSpeed_m_s);
}

void WallPictures::hangOnHead(const HeadsetState& headset) {
  if (!headset.isWorn) return;
  for (Wall& wall : walls_) {
    if (wall.onHead) hang(wall, headset.eyes[wall.stereo == StereoMode::left ? 0 : 1]);
  }
}

void WallPictures::drawSession(const SeenFrame& seen, const World& world) {
  calibrationPatterns_.reset();
  split_ = seen.record.views.split != 0;
  flatEyes_.clear();
  for (const Eye eye : {Eye::left, Eye::right, Eye::middle})
    drawFrom(seen, world, seen.self.observer, eye, nullptr);
  for (const Wall& wall : walls_) {
    if (!wall.sky) continue;
    const ObserverView observer =
        viewOf(*wall.sky, seen.self.observer, seen.record.boardFromRoom, seen.record.room_s);
    for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) drawFrom(seen, world, observer, eye, &wall);
  }
}

/// Draws what one eye of an observer sees on all walls, or on that wall alone whose picture is by direction.
void WallPictures::drawFrom(const SeenFrame& seen, const World& world, const ObserverView& observer, Eye eye,
                            const Wall* sky) {
  // The viewer's own view has been swapped already, if an operator wants it so.
  const EyeView& sees = observer.of(sky && seen.record.controls.eyesSwapped ? otherOf(eye) : eye);
  pictured_.clear();
  for (WallEye& wallEye : eyes_) {
    const Wall& wall = walls_[wallEye.wall];
    if (wallEye.eye != ViewerEye{seen.viewer, eye} || (wall.sky ? &wall : nullptr) != sky) continue;
    wallEye.eyeInRoom_m = sees.positionInRoom_m;
    addPictured(wallEye, seen.record.controls.latency != 0);
  }
  for (const PicturedWall& drawn : pictured_)
    flatEyes_.push_back({drawn.wall, {seen.viewer, eye}, drawn.picture, sees.positionInRoom_m});
  session_->draw(seen.record, world, observer, sees, pictured_, seen.viewer);
}

/// Adds the flat walls of an eye of a wall to those that are drawn next.
void WallPictures::addPictured(WallEye& wallEye, bool measured) {
  const auto meters = [&](std::size_t i) { return measured ? &wallEye.meters[i] : nullptr; };
  const Wall& wall = walls_[wallEye.wall];
  if (!wall.screen) {
    pictured_.push_back({&wall, &wallEye.pictures.next(), meters(0), wall.pixels.x / 2});
    return;
  }
  for (std::size_t i = 0; i < wallEye.pieces.size(); ++i) {
    const Wall& flat = flatWalls_[wallEye.wall][i];
    const bool onLeft = i < wall.screen->leftPieces;
    pictured_.push_back({&flat, wallEye.pieces[i].get(), meters(i), onLeft ? flat.pixels.x : 0});
  }
}

void WallPictures::drawScreens(const SeenFrame& seen) {
  for (WallEye& wallEye : eyes_) {
    if (!wallEye.screen || wallEye.eye.viewer != seen.viewer) continue;
    RenderTarget& picture = wallEye.pictures.next();
    wallEye.screen->draw(wallEye.eyeInRoom_m, wallEye.pieces, picture);
    if (split_) drawSplitLine(picture);
  }
}

void WallPictures::drawCalibrationPatterns(bool eyesSwapped) {
  if (calibrationPatterns_ == eyesSwapped) return;
  graphics_.makeCurrent();
  for (WallEye& wallEye : eyes_) {
    const Wall& wall = walls_[wallEye.wall];
    const Eye eye = eyesSwapped ? otherOf(wallEye.eye.eye) : wallEye.eye.eye;
    const Image pattern =
        wall.screen ? screenPattern(wall, eye, crossesOf(wallEye)) : calibrationPattern(wall, eye);
    for (std::size_t i = 0; i <= wall.heldFrames; ++i) wallEye.pictures.next().fill(pattern.rgb);
  }
  calibrationPatterns_ = eyesSwapped;
}

/// Returns the picture of a curved wall's window with a cross at each marked point, drawn through the pieces
/// for an eye in the middle of those for which they are made.
Image WallPictures::crossesOf(WallEye& wallEye) {
  const CurvedScreen& screen = *walls_[wallEye.wall].screen;
  const std::vector<ScreenPoint> marked = markedPoints(screen);
  for (std::size_t i = 0; i < wallEye.pieces.size(); ++i)
    wallEye.pieces[i]->fill(crossesOn(screen.pieces[i], marked, screen.eyesMiddle_m).rgb);
  RenderTarget& picture = wallEye.pictures.next();
  wallEye.screen->draw(screen.eyesMiddle_m, wallEye.pieces, picture);
  return readBack(picture);
}

void WallPictures::drawSeams(double display_s) {
  calibrationPatterns_.reset();
  graphics_.makeCurrent();
  for (WallEye& wallEye : eyes_) seams_.draw(walls_[wallEye.wall], display_s, wallEye.pictures.next());
}

void WallPictures::drawBlack() {
  calibrationPatterns_.reset();
  graphics_.makeCurrent();
  for (WallEye& wallEye : eyes_) wallEye.pictures.next().clear();
}

const RenderTarget* WallPictures::pictureOf(const std::string& wall, int piece) const {
  for (const WallEye& wallEye : eyes_) {
    if (walls_[wallEye.wall].name != wall) continue;
    return piece == 0 ? &wallEye.pictures.drawn()
                      : wallEye.pieces.at(static_cast<std::size_t>(piece - 1)).get();
  }
  return nullptr;
}

void WallPictures::capture(Capture& capture, std::uint64_t frame) const {
  graphics_.makeCurrent();
  taken_.clear();
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    const WallEye& wallEye = eyes_[i];
    const Wall& wall = walls_[wallEye.wall];
    const std::string& name =
        wall.pictureNames.empty() ? wall.name : wall.pictureNames[i - firstEyeOf_[wallEye.wall]];
    taken_.push_back({&wallEye.pictures.drawn(), &name, wallEye.eye.eye});
  }
  capture.take(frame, taken_);
}

void WallPictures::film(Movie& movie, double display_s) const {
  graphics_.makeCurrent();
  filmed_.clear();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall)
    filmed_.push_back(&eyesOf(wall).front().pictures.drawn());
  movie.add(display_s, filmed_);
}

std::span<const WallTime> WallPictures::drawingTimes() const {
  times_.clear();
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    WallTime& time = times_.emplace_back(WallTime{walls_[wall].name.c_str(), 0.0F, 0});
    for (const WallEye& wallEye : eyesOf(wall)) {
      for (const WallMeters& meters : wallEye.meters) {
        for (std::size_t half = 0; half < (split_ ? 2U : 1U); ++half) {
          time.drawn_s += meters[half].timer.median_s();
          time.triangles += meters[half].triangles;
        }
      }
    }
  }
  return times_;
}

}  // namespace carom
