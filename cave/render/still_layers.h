#pragma once
// The pictures of what rests on the board, kept for as long as an eye sees exactly the same of it: most of a
// picture then costs a copy. Only where the processor draws, in whose memory such a copy is cheap.

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/bodies/body_drawer.h"
#include "cave/render/draw_target.h"

namespace carom {

class StillLayers {
 public:
  /// Draws what `drawer` has chosen, and uploaded, into `target`, on which `begin` was not yet called.
  /// `place` says which picture this is: of each place the last still view is kept, from the second time that
  /// it is the same. The pixels are those of drawing everything.
  void draw(BodyDrawer& drawer, const BodyDrawer::Choice& choice, const glm::ivec2& size_px,
            DrawTarget& target, const glm::ivec2& place);

 private:
  struct Layer {
    glm::ivec2 place{0};
    StillView view;
    std::unique_ptr<DrawTarget> picture;  // of `view`, once it has been seen twice
    bool isDrawn = false;
  };
  Layer& layerAt(const glm::ivec2& place);

  std::vector<Layer> layers_;
};

}  // namespace carom
