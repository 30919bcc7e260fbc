#pragma once
// The pictures of one wall and eye. If other walls have slower projectors, this wall's pictures are held
// back, so that the light of a frame leaves all walls together.

#include <cstddef>
#include <memory>
#include <vector>

#include "cave/gl/picture.h"

namespace carom {

/// Create and destroy it with the drawing context current, as its pictures are.
class FrameDelay {
 public:
  /// `held`: how many frames after it was drawn a picture is shown. Before the first one, black is shown.
  FrameDelay(const glm::ivec2& size_px, std::size_t held) {
    for (std::size_t i = 0; i <= held; ++i) pictures_.push_back(std::make_unique<RenderTarget>(size_px));
  }

  /// Begins the next frame: returns the picture to draw it into, which is the one shown longest ago.
  RenderTarget& next() {
    newest_ = (newest_ + 1) % pictures_.size();
    return *pictures_[newest_];
  }
  /// Returns the current frame, as drawn.
  const RenderTarget& drawn() const { return *pictures_[newest_]; }
  /// Returns the picture that belongs in the window during the current frame.
  const RenderTarget& shown() const { return *pictures_[(newest_ + 1) % pictures_.size()]; }

 private:
  std::vector<std::unique_ptr<RenderTarget>> pictures_;
  std::size_t newest_ = 0;
};

}  // namespace carom
