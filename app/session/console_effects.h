#pragma once
// The console's column of what is shown: effects of relativity, views of time, light, eyes, patterns.

#include <array>
#include <string>

#include "app/session/console_parts.h"

namespace carom::console {

class EffectsPanel {
 public:
  explicit EffectsPanel(KeysOf keys);

  /// `usual_m_s`: the game's own light speed.
  void draw(double usual_m_s, Controls& controls);

 private:
  void drawSwitches(Controls& controls) const;
  void drawLight(double usual_m_s, Controls& controls);
  void drawViews(TimeViews& views) const;
  void drawWalls(WallControls& walls) const;

  KeysOf keys_;
  std::array<std::string, kNamedSwitches.size()> switchKeys_;  ///< of the left half and of the right one
  std::array<KeyLine, kNamedViews.size()> views_;
  PatientSlider light_, eyes_;
};

}  // namespace carom::console
