#pragma once
// Text in the pages that the program writes.

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace carom {

/// Returns the text without what HTML would take for its own.
std::string htmlOf(const std::string& text);

/// What stands in the places of names.
using PageWords = std::map<std::string, std::string, std::less<>>;

/// Returns the text with the words of each name in the place of {{name}}.
std::string filled(std::string_view text, const PageWords& words);

}  // namespace carom
