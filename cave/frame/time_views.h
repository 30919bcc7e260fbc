#pragma once
// The views of time, drawn over the seen picture or beside it.

#include <array>
#include <cstdint>

#include "engine/light/switches.h"

namespace carom {

struct TimeViews {
  std::uint8_t boardNow = 0;  ///< ghosts of the bodies where they are at the person's board time
  std::uint8_t myNow =
      0;  ///< ghosts of the bodies where they are at the person's own time: simultaneous for the head
  std::uint8_t paths = 0;         ///< paths of the pucks' centres over the cloth, past and future
  std::uint8_t events = 0;        ///< markers where something happened, and the light of flashes on its way
  std::uint8_t clocks = 0;        ///< each puck's own clock as it is seen, and the person's
  std::uint8_t ruler = 0;         ///< a metre on the cloth, with light travelling along it
  std::uint8_t angles = 0;        ///< angles between the paths of two pucks after they met
  std::uint8_t split = 0;         ///< the right half of every wall is drawn with the switches `beside`
  std::uint8_t frozen = 0;        ///< the view stays at one observation event while the head moves
  Switches beside = kNoSwitches;  ///< switches of the right half: Newton's, unless chosen otherwise

  bool operator==(const TimeViews&) const = default;
};

/// A view of time with its name on the command line and in the session file.
struct NamedView {
  const char* name;
  std::uint8_t TimeViews::*value;
};
inline constexpr std::array<NamedView, 9> kNamedViews{{{"board-now", &TimeViews::boardNow},
                                                       {"my-now", &TimeViews::myNow},
                                                       {"paths", &TimeViews::paths},
                                                       {"events", &TimeViews::events},
                                                       {"clocks", &TimeViews::clocks},
                                                       {"split", &TimeViews::split},
                                                       {"frozen", &TimeViews::frozen},
                                                       {"ruler", &TimeViews::ruler},
                                                       {"angles", &TimeViews::angles}}};

}  // namespace carom
