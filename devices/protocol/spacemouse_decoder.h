#pragma once
// From the input reports of a 3Dconnexion SpaceMouse to readings.
// Sources: spacenavd (dev.c, proto), VRPN's vrpn_3DConnexion.C, recorded report descriptors.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

/// Axes 0 … 2: how far the cap is pushed to the right, up and back; 3 … 5: how far it is turned about these
/// (right-handed). 1 is as far as it goes. Buttons are numbered as the device does, with holes.
class SpaceMouseDecoder {
 public:
  /// Takes one report, its number first: 1 with 3 axes (pushed) or all 6, 2 with 3 axes (turned), 3 with the
  /// buttons. Appends the axes it tells and the buttons that changed. False where it is too short to be
  /// what its number says; reports of other numbers are nothing to us and are passed over.
  bool decode(std::span<const std::uint8_t> report, std::vector<Reading>& readings);

  /// The cap came back and the device has nothing more to say: appends a zero for each axis that is not.
  void centre(std::vector<Reading>& readings);

  /// The device is gone: as centre, and every button let go.
  void release(std::vector<Reading>& readings);

 private:
  void setAxes(std::span<const std::uint8_t> raw, std::size_t first, std::vector<Reading>& readings);
  void setButtons(std::uint64_t pressed, std::vector<Reading>& readings);

  std::array<double, 6> axes_{};
  std::uint64_t pressed_ = 0;  // bit i: button i
};

}  // namespace carom
