#pragma once
// Text from outside for a message to people.

#include <string>
#include <string_view>

namespace carom {

/// Returns a name, or the beginning of a text, for a message: printable and short.
inline std::string shownName(std::string_view name) {
  std::string result(name.substr(0, 40));
  for (char& c : result) c = c >= ' ' && c <= '~' ? c : '?';
  return result;
}

}  // namespace carom
