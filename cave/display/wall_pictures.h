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
#include "cave/display/eye_renderer.h"
#include "cave/overlay/latency_overlay.h"
#include "cave/patterns/alignment_pattern.h"
#include "cave/pictures/image.h"
#include "cave/projection/screen_picture.h"
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
    std::vector<WallMeters> meters;  ///< of each flat wall that is drawn
    /// Of a curved screen: the pictures of its pieces, and what makes the wall's picture of them.
    std::vector<std::unique_ptr<RenderTarget>> pieces;
    std::unique_ptr<ScreenPicture> screen;
    glm::dvec3 eyeInRoom_m{0.0};  ///< for which they were drawn
  };
  /// A flat wall for one eye, as it is drawn: a wall, or a piece of a curved one.
  struct FlatEye {
    const Wall* wall = nullptr;
    ViewerEye eye;
    const RenderTarget* picture = nullptr;  ///< the newest
    glm::dvec3 eyeInRoom_m{0.0};            ///< for which it was drawn
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

  /// Returns the flat walls of all eyes, with their newest pictures. Valid until the next call of a function
  /// that draws.
  std::span<const FlatEye> flatEyes() const { return flatEyes_; }

  /// Hangs the walls of a headset before its wearer's eyes.
  void hangOnHead(const HeadsetState& headset);

  /// Draws the flat walls of one viewer.
  void drawSession(const SeenFrame& seen, const World& world);
  /// Makes the pictures of the curved screens of one viewer from those of their pieces, with all that was
  /// drawn over these.
  void drawScreens(const SeenFrame& seen);
  /// The calibration patterns stand still: they are drawn once and kept until something else is drawn.
  void drawCalibrationPatterns(bool eyesSwapped);
  void drawSeams(double display_s);
  void drawBlack();

  /// Returns the newest picture of a wall, or of a piece of one (the left eye's, if it has one for each eye),
  /// or null.
  const RenderTarget* pictureOf(const std::string& wall, int piece) const;

  void capture(Capture& capture, std::uint64_t frame) const;
  void film(Movie& movie, double display_s) const;
  std::span<const WallTime> drawingTimes() const;

 private:
  void addPieces(WallEye& wallEye);
  void drawFrom(const SeenFrame& seen, const World& world, const ObserverView& observer, Eye eye,
                const Wall* sky);
  void addPictured(WallEye& wallEye, bool measured);
  Image crossesOf(WallEye& wallEye);

  Graphics& graphics_;
  std::vector<Wall> walls_;
  std::vector<std::vector<Wall>> flatWalls_;  ///< of each curved wall; empty: it is flat
  std::vector<WallEye> eyes_;
  std::vector<std::size_t> firstEyeOf_;  ///< index in eyes_, of each wall; then the end of the last
  std::unique_ptr<EyeRenderer> session_;
  AlignmentPattern seams_;
  std::optional<bool> calibrationPatterns_;  ///< the pictures are these; true: with the eyes swapped
  bool split_ = false;                       ///< the newest pictures are
  std::vector<PicturedWall> pictured_;       ///< of one eye
  std::vector<FlatEye> flatEyes_;
  mutable std::vector<Capture::Taken> taken_;
  mutable std::vector<const RenderTarget*> filmed_;
  mutable std::vector<WallTime> times_;
};

}  // namespace carom
