#pragma once
// The console's column of display settings: relativistic effects, time views, light, eyes, patterns.

#include <array>
#include <string>

#include "app/console/console_parts.h"

namespace carom::console {

class EffectsPanel {
 public:
  explicit EffectsPanel(KeysOf keys);

  /// Returns how wide the column's names and keys are, but at least this.
  float width_px(float least_px) const;
  /// Draws the column. `usual_m_s` is the scenario's own light speed.
  void draw(const ConsoleFrame& frame, double usual_m_s);

 private:
  void drawSwitches(const ConsoleFrame& frame) const;
  void drawLight(const ConsoleFrame& frame, double usual_m_s);
  void drawViews(const ConsoleFrame& frame) const;
  void drawWalls(const ConsoleFrame& frame) const;

  KeysOf keys_;
  std::array<std::string, kNamedSwitches.size()> switchKeys_;  ///< of the left and right half
  std::array<std::string, kNamedViews.size()> viewKeys_;
  PatientSlider light_, eyes_;
};

}  // namespace carom::console
