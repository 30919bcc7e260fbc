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

void StillLayers::draw(BodyDrawer& drawer, const BodyDrawer::Choice& choice, const glm::ivec2& size_px,
                       DrawTarget& target, const glm::ivec2& place) {
  Layer& layer = layerAt(place);
  const StillView view = drawer.stillView(choice, size_px);
  if (view != layer.view) {
    layer.view = view;
    layer.isDrawn = false;
    target.begin(size_px);
    drawer.draw(choice, BodyDrawer::What::still);
  } else {
    if (!layer.picture) layer.picture = std::make_unique<DrawTarget>(1);
    if (!layer.isDrawn) {
      layer.picture->forgetViewport();
      layer.picture->begin(size_px);
      drawer.draw(choice, BodyDrawer::What::still);
      layer.isDrawn = true;
    }
    target.beginWith(*layer.picture);
  }
  drawer.draw(choice, BodyDrawer::What::changing);
}

}  // namespace carom
