#pragma once
// The console's column of display settings: relativistic effects, time views, light, eyes, patterns.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/console_parts/console_parts.h"

namespace carom::console {

class EffectsPanel {
 public:
  /// `viewers` are the names of those whose languages can be chosen.
  EffectsPanel(KeysOf keys, std::vector<std::string> viewers);

  /// Returns how wide the column's names and keys are, but at least this.
  float width_px(float least_px) const;
  /// Draws the column. `usual_m_s` is the scenario's own light speed.
  void draw(const ConsoleFrame& frame, double usual_m_s);

 private:
  void drawSwitches(const ConsoleFrame& frame) const;
  void drawLight(const ConsoleFrame& frame, double usual_m_s);
  void drawViews(const ConsoleFrame& frame) const;
  void drawWalls(const ConsoleFrame& frame) const;
  void drawLanguages(const ConsoleFrame& frame) const;
  void nameKeys();

  KeysOf keys_;
  std::vector<std::string> viewers_;
  std::uint64_t keysNamed_ = 0;                                ///< KeyNames::changes
  std::array<std::string, kNamedSwitches.size()> switchKeys_;  ///< of the left and right half
  std::array<std::string, kNamedViews.size()> viewKeys_;
  PatientSlider light_, eyes_;
};

}  // namespace carom::console
