#pragma once
// The pictures of one wall and eye: where slower projectors stand beside this wall's, its pictures wait, so
// that the light of a frame leaves all walls together.

#include <cstddef>
#include <memory>
#include <vector>

#include "cave/gl/picture.h"

namespace carom {

/// Made and destroyed with the drawing context current, as the pictures are.
class FrameDelay {
 public:
  /// A picture is shown `held` frames after it was drawn; black before there is one.
  FrameDelay(const glm::ivec2& size_px, std::size_t held) {
    for (std::size_t i = 0; i <= held; ++i) pictures_.push_back(std::make_unique<RenderTarget>(size_px));
  }

  /// The next frame begins: the picture to draw it into, the one that was shown longest ago.
  RenderTarget& next() {
    newest_ = (newest_ + 1) % pictures_.size();
    return *pictures_[newest_];
  }
  /// The frame at hand, as drawn.
  const RenderTarget& drawn() const { return *pictures_[newest_]; }
  /// What belongs into the window with it.
  const RenderTarget& shown() const { return *pictures_[(newest_ + 1) % pictures_.size()]; }

 private:
  std::vector<std::unique_ptr<RenderTarget>> pictures_;
  std::size_t newest_ = 0;
};

}  // namespace carom
