#pragma once
// Packing of the left and the right picture of a wall into what a display or projector expects.

#include <map>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/picture.h"
#include "cave/room/wall.h"

namespace carom {

class Projector;
struct Projection;

/// The pictures that a wall with this stereo mode needs: {mono}, {left}, {right} or {left, right}.
std::vector<Eye> eyesOf(StereoMode mode);

/// The name used for files and messages: "left", "right" or "mono".
const char* nameOf(Eye eye);

/// One wall in a visible window.
struct Pane {
  const RenderTarget* left = nullptr;   ///< left eye, or the only picture there is (mono, left, right)
  const RenderTarget* right = nullptr;  ///< right eye; null where there is only one picture
  StereoMode stereo = StereoMode::mono;
  glm::ivec2 position_px{0};  ///< of its top left corner in the window, from the window's top left
  glm::ivec2 size_px{0};
  const Projection* projection = nullptr;  ///< null where the pictures go to the window as they are
};

/// Draws panes into the window whose context is current. One per context; made and destroyed in it.
class StereoPacker {
 public:
  StereoPacker();
  ~StereoPacker();
  StereoPacker(const StereoPacker&) = delete;
  StereoPacker& operator=(const StereoPacker&) = delete;

  /// `windowSize_px` is the size of the current framebuffer. Each eye's picture is projected first, then
  /// packed: which window pixel is whose does not depend on the projection, which must outlive this.
  void draw(const Pane& pane, const glm::ivec2& windowSize_px);

 private:
  Pane projected(const Pane& pane);
  void fill(const Pane& pane, const glm::ivec2& windowSize_px, int mode) const;

  unsigned program_ = 0;
  unsigned vertexArray_ = 0;
  std::map<const Projection*, std::unique_ptr<Projector>> projectors_;  // made when first drawn
};

}  // namespace carom
