#pragma once
// The signs of a text in UTF-8 (RFC 3629, section 3).

#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// Takes the first sign from a text that is not empty and returns its code point; of what is no UTF-8 one
/// byte is taken, and there is none.
std::optional<char32_t> takeCodePoint(std::string_view& text);

/// Returns the code points of a text; each byte that is no UTF-8 is U+FFFD.
std::u32string codePointsOf(std::string_view text);

}  // namespace carom
