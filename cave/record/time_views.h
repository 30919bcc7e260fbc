#pragma once
// The views of time, drawn over the seen picture or beside it.

#include <array>
#include <cstdint>

#include "cave/record/effects.h"
#include "cave/texts/texts.h"

namespace carom {

struct TimeViews {
  std::uint8_t boardNow = 0;  ///< ghosts of the bodies where they are at the person's board time
  std::uint8_t myNow =
      0;  ///< ghosts of the bodies where they are at the person's own time: simultaneous for the head
  std::uint8_t paths = 0;      ///< paths of the pucks' centres over the cloth, past and future
  std::uint8_t events = 0;     ///< markers where something happened, and the light of flashes on its way
  std::uint8_t clocks = 0;     ///< each puck's own clock as it is seen, and the person's
  std::uint8_t ruler = 0;      ///< a metre on the cloth, with light travelling along it
  std::uint8_t angles = 0;     ///< angles between the paths of two pucks after they met
  std::uint8_t split = 0;      ///< the right half of every wall is drawn with the switches `beside`
  std::uint8_t frozen = 0;     ///< the view stays at one observation event while the head moves
  std::uint8_t strain = 0;     ///< soft bodies show by their colours how much they are stretched or pressed
  std::uint8_t heat = 0;       ///< or how hot they are
  std::uint8_t news = 0;       ///< rings of news, at the speed of light, around each hit
  std::uint8_t spacetime = 0;  ///< the game's spacetime stands in the room, with time upwards
  std::uint8_t speeds = 0;     ///< a plate above each moving puck: the speed with which it is seen to move
  Switches beside = kNoSwitches;  ///< switches of the right half: Newton's, unless chosen otherwise

  bool operator==(const TimeViews&) const = default;
};

/// The key F11 as windows number keys (GLFW_KEY_F11); letters and signs are their own numbers.
inline constexpr int kKeyF11 = 300;

/// A view of time as a row: what every list of them is made from.
struct NamedView {
  const char* name;  ///< on the command line and in files
  std::uint8_t TimeViews::*value;
  int key;            ///< that turns it: a letter, a sign or kKeyF11
  texts::Text words;  ///< what the key does
  texts::Text tip;
  texts::Text legend;  ///< none: the legend tells of it in another way (cave/hud/hud_text.cpp)
  bool isMark;         ///< it is drawn among the bodies (cave/marks/spacetime_marks.h)
};

/// A session file stores them as one number, whose bits are in this order.
inline constexpr std::array<NamedView, 14> kNamedViews{{
    {"board-now", &TimeViews::boardNow, 'N', texts::keys::kBoardNow, texts::console::kBoardNowTip, {}, true},
    {"my-now", &TimeViews::myNow, 'M', texts::keys::kMyNow, texts::console::kMyNowTip, {}, true},
    {"paths", &TimeViews::paths, 'P', texts::keys::kPaths, texts::console::kPathsTip, texts::legend::kPaths,
     true},
    {"events", &TimeViews::events, 'E', texts::keys::kEvents, texts::console::kEventsTip,
     texts::legend::kEvents, true},
    {"clocks", &TimeViews::clocks, 'C', texts::keys::kClocks, texts::console::kClocksTip, {}, true},
    {"split", &TimeViews::split, 'V', texts::keys::kSplit, texts::console::kSplitTip, {}, false},
    {"frozen", &TimeViews::frozen, 'F', texts::keys::kFreeze, texts::console::kFrozenTip, {}, false},
    {"ruler", &TimeViews::ruler, 'U', texts::keys::kRuler, texts::console::kRulerTip, texts::legend::kRuler,
     true},
    {"angles", &TimeViews::angles, 'O', texts::keys::kAngles, texts::console::kAnglesTip,
     texts::legend::kAngles, true},
    {"strain", &TimeViews::strain, 'Z', texts::keys::kStrain, texts::console::kStrainTip,
     texts::legend::kStrain, false},
    {"heat", &TimeViews::heat, kKeyF11, texts::keys::kHeat, texts::console::kHeatTip, texts::legend::kHeat,
     false},
    {"news", &TimeViews::news, '.', texts::keys::kNews, texts::console::kNewsTip, texts::legend::kNews, true},
    {"spacetime", &TimeViews::spacetime, 'I', texts::keys::kSpacetime, texts::console::kSpacetimeTip,
     texts::legend::kSpacetime, false},
    {"speeds", &TimeViews::speeds, ',', texts::keys::kSpeeds, texts::console::kSpeedsTip,
     texts::legend::kSpeeds, true},
}};

}  // namespace carom
