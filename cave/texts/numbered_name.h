#pragma once
// Numbered names, "left 1" and "left 2": translators have their words once.

#include <string_view>

namespace carom::texts {

/// Returns a name without the number at its end: "left" of "left 3".
inline std::string_view nameWithoutNumber(std::string_view name) {
  std::string_view rest = name;
  while (!rest.empty() && rest.back() >= '0' && rest.back() <= '9') rest.remove_suffix(1);
  if (rest.size() == name.size()) return name;
  while (!rest.empty() && rest.back() == ' ') rest.remove_suffix(1);
  return rest;
}

}  // namespace carom::texts
