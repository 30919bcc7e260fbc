#pragma once
// A made language for who writes the program (Language::pseudo).

#include <string>
#include <string_view>

namespace carom::texts {

/// Returns a text with accents on its letters, 40 % longer and in brackets. Places for values, keys and
/// blanks at its ends stay as they are; what has no letters stays whole.
std::string pseudoOf(std::string_view english);

}  // namespace carom::texts
