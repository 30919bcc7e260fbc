#pragma once
// Packs the left and the right picture of a wall into the format that a display or projector expects.

#include <map>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"

namespace carom {

class Projector;
struct Projection;

/// One wall in a visible window.
struct Pane {
  const RenderTarget* left = nullptr;   ///< left eye, or the only picture (mono, left, right)
  const RenderTarget* right = nullptr;  ///< right eye; null if there is only one picture
  StereoMode stereo = StereoMode::mono;
  glm::ivec2 position_px{0};  ///< its top left corner, from the window's top left
  glm::ivec2 size_px{0};
  const Projection* projection = nullptr;  ///< null if the pictures go to the window unchanged
};

/// Draws panes into the window whose context is current. Create one per context, and destroy it in that
/// context.
class StereoPacker {
 public:
  /// `framebuffer`: the target of the draws, bound for them; 0 is the window.
  explicit StereoPacker(unsigned framebuffer = 0);
  ~StereoPacker();

  /// `windowSize_px` is the size of the framebuffer. Each eye's picture is first projected, then
  /// packed: which window pixel belongs to which eye does not depend on the projection. The pane's projection
  /// must outlive this object.
  void draw(const Pane& pane, const glm::ivec2& windowSize_px);

 private:
  Pane projected(const Pane& pane);
  void copy(const RenderTarget& picture, const glm::ivec2& position_px, const glm::ivec2& size_px,
            const glm::ivec2& windowSize_px) const;
  void mix(const Pane& pane, const glm::ivec2& windowSize_px, int mixture) const;

  unsigned framebuffer_;
  GlProgram copyProgram_, mixProgram_;
  int modeAt_ = -1, heightAt_ = -1;  // places of uniforms of the latter
  GlVertexArray vertexArray_;
  std::map<const Projection*, std::unique_ptr<Projector>> projectors_;  // made when first drawn
};

}  // namespace carom
