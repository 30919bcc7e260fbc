#include "cave/render/still_layers.h"

#include <algorithm>

namespace carom {

StillLayers::Layer& StillLayers::layerAt(const glm::ivec2& place) {
  const auto found =
      std::find_if(layers_.begin(), layers_.end(), [&](const Layer& layer) { return layer.place == place; });
  if (found != layers_.end()) return *found;
  layers_.push_back({place, {}, nullptr, false});
  return layers_.back();
}

void StillLayers::draw(BodyDrawer& drawer, const glm::dmat4& clipFromDrawn, const glm::ivec2& size_px,
                       DrawTarget& target, const glm::ivec2& place) {
  Layer& layer = layerAt(place);
  const StillView view = drawer.stillView(clipFromDrawn, size_px);
  if (view != layer.view) {
    layer.view = view;
    layer.isDrawn = false;
    target.begin(size_px);
    drawer.draw(clipFromDrawn, BodyDrawer::What::still);
  } else {
    if (!layer.picture) layer.picture = std::make_unique<DrawTarget>(1);
    if (!layer.isDrawn) {
      layer.picture->begin(size_px);
      drawer.draw(clipFromDrawn, BodyDrawer::What::still);
      layer.isDrawn = true;
    }
    target.beginWith(*layer.picture);
  }
  drawer.draw(clipFromDrawn, BodyDrawer::What::changing);
}

}  // namespace carom
