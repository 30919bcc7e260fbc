#include "cave/display/wall_pictures.h"

#include <utility>

#include "cave/display/calibration_pattern.h"
#include "cave/room/headset_walls.h"

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
  for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
    firstEyeOf_.push_back(eyes_.size());
    for (const ViewerEye& eye : carom::eyesOf(walls_[wall]))
      eyes_.push_back({wall, eye, FrameDelay(walls_[wall].pixels, walls_[wall].heldFrames), {}});
  }
  firstEyeOf_.push_back(eyes_.size());
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
  for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
    pictured_.clear();
    for (WallEye& wallEye : eyes_) {
      if (wallEye.eye == ViewerEye{seen.viewer, eye})
        pictured_.push_back({&walls_[wallEye.wall], &wallEye.pictures.next(),
                             seen.record.controls.latency ? &wallEye.meters : nullptr});
    }
    session_->draw(seen.record, world, seen.self.observer, seen.self.observer.of(eye), pictured_);
  }
}

void WallPictures::drawCalibrationPatterns(bool eyesSwapped) {
  if (calibrationPatterns_ == eyesSwapped) return;
  graphics_.makeCurrent();
  for (WallEye& wallEye : eyes_) {
    const Wall& wall = walls_[wallEye.wall];
    const Image pattern = calibrationPattern(wall, eyesSwapped ? otherOf(wallEye.eye.eye) : wallEye.eye.eye);
    for (std::size_t i = 0; i <= wall.heldFrames; ++i) wallEye.pictures.next().fill(pattern.rgb);
  }
  calibrationPatterns_ = eyesSwapped;
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

const RenderTarget* WallPictures::pictureOf(const std::string& wall) const {
  for (const WallEye& wallEye : eyes_) {
    if (walls_[wallEye.wall].name == wall) return &wallEye.pictures.drawn();
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
      for (std::size_t half = 0; half < (split_ ? 2U : 1U); ++half) {
        time.drawn_s += wallEye.meters[half].timer.median_s();
        time.triangles += wallEye.meters[half].triangles;
      }
    }
  }
  return times_;
}

}  // namespace carom
