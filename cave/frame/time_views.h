#pragma once
// Which views of time are drawn, over what is seen or beside it.

#include <array>
#include <cstdint>

#include "engine/light/switches.h"

namespace carom {

struct TimeViews {
  std::uint8_t boardNow = 0;  ///< ghosts where the bodies are at the person's board time
  std::uint8_t myNow = 0;     ///< ghosts where they are at the person's own moment: simultaneous for the head
  std::uint8_t paths = 0;     ///< the ways of the pucks' centres over the cloth, past and to come
  std::uint8_t events = 0;    ///< markers where something happened, and the light of flashes on its way
  std::uint8_t clocks = 0;    ///< each puck's own clock as it is seen, and the person's
  std::uint8_t ruler = 0;     ///< a metre on the cloth, with light's way along it
  std::uint8_t angles = 0;    ///< between the ways of two pucks after they met
  std::uint8_t split = 0;     ///< the right half of every wall is drawn with `beside`
  std::uint8_t frozen = 0;    ///< the sight of one moment, to be walked round
  Switches beside = kNoSwitches;  ///< of the right half: Newton's, unless chosen otherwise

  bool operator==(const TimeViews&) const = default;
};

/// A view of time as the command line and the session file name it.
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
