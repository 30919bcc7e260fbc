#pragma once
// Text in the pages that the program writes.

#include <string>

namespace carom {

/// Returns the text without what HTML would take for its own.
std::string htmlOf(const std::string& text);

}  // namespace carom
