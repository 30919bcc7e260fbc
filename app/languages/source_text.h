#pragma once
// A text that can be translated.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cave/texts/language.h"

namespace carom {

struct SourceText {
  std::string context;  ///< its name: "message.kStroke", "welcome.toml caption 2 text"
  std::string english;
  std::string plural;     ///< the English for many; empty: it counts nothing
  std::string note;       ///< for translators: what fills its values, where it is seen; may be empty
  std::string reference;  ///< "angles.toml:12"; empty for the catalogue
  bool hasValues = true;  ///< braces in it are places of values
};

/// Returns whether the text of this name stands on plates among the bodies: one of their own in the
/// catalogue, or a label of a lesson.
bool standsOnPlates(std::string_view name);

/// Returns the texts of a catalogue that have words, in its order.
std::vector<SourceText> sourceTexts(std::span<const texts::Entry> catalogue);

}  // namespace carom
