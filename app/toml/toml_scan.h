#pragma once
// A look at a TOML file before its parser sees it, which recurses for nested values and takes memory for each
// of them.

#include <optional>
#include <string_view>

#include "app/toml/findings.h"

namespace carom {

/// The most values and keys of a file, such as 100 000 pucks with all their keys, and how deep they may be
/// nested, by brackets and by the dots of keys.
inline constexpr std::size_t kMostTomlValues = 3'000'000;
inline constexpr std::size_t kDeepestToml = 32;

/// Returns why the parser may not see the text: nested too deep, too many values, or a character beyond ASCII
/// outside quotes and comments, where TOML has none (the table of white space of toml++ 3.3 has undefined
/// behaviour there).
std::optional<Finding> faultBeforeParsing(std::string_view text);

}  // namespace carom
