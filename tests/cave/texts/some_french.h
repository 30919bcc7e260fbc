#pragma once
// A language of the tests' own.

#include "cave/texts/language.h"
#include "cave/texts/texts.h"

namespace carom::texts::test {

/// A language in which some texts have words.
inline Language french() {
  Language made("fr");
  made.put(message::kStroke.index(), {"Votre coup va à {3} {0} en {1:.1f} s, et revient en {2:.1f} s"});
  made.put(message::kRightOfCentre.index(), {"{:.0f} mm à droite de"});
  made.put(console::kPucksAndLight.index(), {"{} palet, {:.4g} m/s", "{} palets, {:.4g} m/s"});
  made.put(legend::kMe.index(), {"vous"});
  made.putOther("red", "rouge");
  made.putOther("left", "gauche");
  return made;
}

}  // namespace carom::texts::test
