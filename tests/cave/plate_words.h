#pragma once
// What a plate among the marks says, read from its corners.

#include <string>

#include "cave/marks/mark_buffer.h"

namespace carom::test {

/// Returns a plate's words; letters beyond ASCII as '#'. Of other marks nothing.
inline std::string plateWords(const MarkCorner& corner) {
  constexpr int kPlaces = 16;
  std::string words;
  for (int i = 0; corner.style > 0.5F && i < static_cast<int>(corner.style) % kPlaces; ++i) {
    const int letter = (static_cast<int>(corner.text[i / 3]) >> (8 * (2 - i % 3))) & 255;
    words += letter < 95 ? static_cast<char>(' ' + letter) : '#';
  }
  return words;
}

inline std::string plateWords(const PlateText& text) {
  std::string words;
  for (int i = 0; i < text.places; ++i) {
    const int letter = text.letters[static_cast<std::size_t>(i)];
    words += letter < 95 ? static_cast<char>(' ' + letter) : '#';
  }
  return words;
}

}  // namespace carom::test
