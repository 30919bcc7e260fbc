#include "cave/render/edge_smoother.h"

namespace carom {

void EdgeSmoother::copy(const DrawTarget& drawn, RenderTarget& picture, int left_px) {
  const glm::ivec2 size_px = drawn.size_px();
  drawn.read(pixels_.begin(size_px));
  picture.fill(pixels_.smooth(), left_px, size_px.x);
}

}  // namespace carom
