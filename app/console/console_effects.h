#pragma once
// The console's column of what is shown: effects of relativity, views of time, light, eyes, patterns.

#include <array>
#include <string>

#include "app/console/console_parts.h"

namespace carom::console {

class EffectsPanel {
 public:
  explicit EffectsPanel(KeysOf keys);

  /// `usual_m_s`: the game's own light speed.
  void draw(const ConsoleFrame& frame, double usual_m_s);

 private:
  void drawSwitches(const ConsoleFrame& frame) const;
  void drawLight(const ConsoleFrame& frame, double usual_m_s);
  void drawViews(const ConsoleFrame& frame) const;
  void drawWalls(const ConsoleFrame& frame) const;

  KeysOf keys_;
  std::array<std::string, kNamedSwitches.size()> switchKeys_;  ///< of the left half and of the right one
  std::array<KeyLine, kNamedViews.size()> views_;
  PatientSlider light_, eyes_;
};

}  // namespace carom::console
