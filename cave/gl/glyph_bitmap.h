#pragma once
// Text as a bitmap, by VTK's FreeType.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// The coverage of each pixel of a text's bounding box, 0 to 255; rows from the bottom.
struct GlyphBitmap {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> alpha;
  int below_px = 0;  ///< from the foot of the line (the same for all texts of that height) up to the box
};

/// DejaVu Sans, of the package fonts-dejavu-core: it has Greek letters, and VTK's own fonts have none.
inline constexpr const char* kLettersFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Returns a line of UTF-8 text in DejaVu Sans, or in Arial, which has no Greek, if DejaVu is not installed.
/// Capitals are about 0.72 of `height_px` high. Returns an empty bitmap if the text covers no pixel.
GlyphBitmap ink(const std::string& text, int height_px);

}  // namespace carom
