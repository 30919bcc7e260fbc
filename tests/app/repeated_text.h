#pragma once
// A piece of text again and again, for files that hold too much or nest too deep.

#include <cstddef>
#include <string>

namespace carom::test {

inline std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace carom::test
