#pragma once
// Decodes the input reports of a 3Dconnexion SpaceMouse into readings.
// Sources: spacenavd (dev.c, proto), VRPN's vrpn_3DConnexion.C, recorded report descriptors.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

/// Axes 0 … 2 are how far the cap is pushed right, up and back; axes 3 … 5 how far it is turned about these
/// (right-handed). 1 is the farthest. Buttons have the device's own numbers, with gaps.
class SpaceMouseDecoder {
 public:
  /// Takes one report, which begins with its number: 1 with 3 axes (pushed) or all 6, 2 with 3 axes (turned),
  /// 3 with the buttons. Appends the axes that it holds and the buttons that changed. Returns false if it is
  /// too short for its number; ignores reports with other numbers.
  bool decode(std::span<const std::uint8_t> report, std::vector<Reading>& readings);

  /// Appends a zero for each axis that is not zero: the cap is back at its centre, and the device sends no
  /// more.
  void centre(std::vector<Reading>& readings);

  /// Does what `centre` does and releases every button: the device is gone.
  void release(std::vector<Reading>& readings);

 private:
  void setAxes(std::span<const std::uint8_t> raw, std::size_t first, std::vector<Reading>& readings);
  void setButtons(std::uint64_t pressed, std::vector<Reading>& readings);

  std::array<double, 6> axes_{};
  std::uint64_t pressed_ = 0;  // bit i: button i
};

}  // namespace carom
