#pragma once
// A picture for each wall of a node and each eye that sees it: the session, a pattern, or black.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cave/capture/capture.h"
#include "cave/capture/frame_delay.h"
#include "cave/capture/movie.h"
#include "cave/display/alignment_pattern.h"
#include "cave/display/eye_renderer.h"
#include "cave/overlay/latency_overlay.h"
#include "cave/room/wall.h"
#include "cave/room/wall_eyes.h"

namespace carom {

/// Returns the eye that sees what `eye` should when an operator has swapped the eyes.
Eye otherOf(Eye eye);

class WallPictures {
 public:
  /// An eye of a wall, with its pictures.
  struct WallEye {
    std::size_t wall = 0;
    ViewerEye eye;
    FrameDelay pictures;
    WallMeters meters;
  };

  WallPictures(Graphics& graphics, const Scene& scene, double lightSpeed_m_s, std::vector<Wall> walls);

  /// Shows another game.
  void setScene(const Scene& scene, double lightSpeed_m_s);

  std::span<const Wall> walls() const { return walls_; }
  /// Returns the eyes of all walls: of each wall one or two, in the order of its channels.
  std::span<const WallEye> eyes() const { return eyes_; }
  std::span<const WallEye> eyesOf(std::size_t wall) const {
    return std::span(eyes_).subspan(firstEyeOf_[wall], firstEyeOf_[wall + 1] - firstEyeOf_[wall]);
  }

  /// Hangs the walls of a headset before its wearer's eyes.
  void hangOnHead(const HeadsetState& headset);

  /// Draws the walls of one viewer.
  void drawSession(const SeenFrame& seen, const World& world);
  /// The calibration patterns stand still: they are drawn once and kept until something else is drawn.
  void drawCalibrationPatterns(bool eyesSwapped);
  void drawSeams(double display_s);
  void drawBlack();

  /// Returns the newest picture of a wall (the left eye's, if it has one for each eye), or null.
  const RenderTarget* pictureOf(const std::string& wall) const;

  void capture(Capture& capture, std::uint64_t frame) const;
  void film(Movie& movie, double display_s) const;
  std::span<const WallTime> drawingTimes() const;

 private:
  Graphics& graphics_;
  std::vector<Wall> walls_;
  std::vector<WallEye> eyes_;
  std::vector<std::size_t> firstEyeOf_;  ///< index in eyes_, of each wall; then the end of the last
  std::unique_ptr<EyeRenderer> session_;
  AlignmentPattern seams_;
  std::optional<bool> calibrationPatterns_;  ///< the pictures are these; true: with the eyes swapped
  bool split_ = false;                       ///< the newest pictures are
  std::vector<PicturedWall> pictured_;       ///< of one eye
  mutable std::vector<Capture::Taken> taken_;
  mutable std::vector<const RenderTarget*> filmed_;
  mutable std::vector<WallTime> times_;
};

}  // namespace carom
