#pragma once
// Text from outside on a terminal.

#include <string>
#include <string_view>

namespace carom {

/// Returns text from a file without control characters, which could hide or change the rest of a terminal's
/// lines: each byte below 0x20, each 0x7f and each of the controls U+0080 to U+009F becomes '?'. `kept` are
/// those that stay.
std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace carom
