#pragma once
// The effects of relativity that can be switched, as rows: what every list of them is made from.

#include <array>
#include <cstdint>

#include "cave/texts/texts.h"
#include "engine/light/switches.h"

namespace carom {

struct NamedSwitch {
  const char* name;  ///< on the command line and in the log
  std::uint8_t Switches::*value;
  char key, rightKey;             ///< that turn it, for the right half of a split wall too
  texts::Text words, rightWords;  ///< what the keys do
  texts::Text tip;
};

/// A session file stores them as one number, whose bits are in this order.
inline constexpr std::array<NamedSwitch, 5> kNamedSwitches{{
    {"retardation", &Switches::retardation, '1', '6', texts::keys::kRetardation,
     texts::keys::kRightRetardation, texts::console::kRetardationTip},
    {"contraction", &Switches::contraction, '2', '7', texts::keys::kContraction,
     texts::keys::kRightContraction, texts::console::kContractionTip},
    {"aberration", &Switches::aberration, '3', '8', texts::keys::kAberration, texts::keys::kRightAberration,
     texts::console::kAberrationTip},
    {"colour", &Switches::colour, '4', '9', texts::keys::kColour, texts::keys::kRightColour,
     texts::console::kColourTip},
    {"searchlight", &Switches::searchlight, '5', '0', texts::keys::kSearchlight,
     texts::keys::kRightSearchlight, texts::console::kSearchlightTip},
}};

/// Returns the number of the row of an effect, from 0.
constexpr std::uint8_t numberOf(std::uint8_t Switches::*effect) {
  std::uint8_t row = 0;
  while (kNamedSwitches[row].value != effect) ++row;
  return row;
}

}  // namespace carom
