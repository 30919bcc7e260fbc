#pragma once
// Words as ink on pixels, by VTK's FreeType.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// How much ink a text puts on each pixel of its own box, 0 to 255; rows from the bottom.
struct GlyphBitmap {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> alpha;
  int below_px = 0;  ///< from the foot of its line, the same for all texts of that height, up to the box
};

/// DejaVu Sans, of the package fonts-dejavu-core: it has Greek letters, VTK's own fonts have none.
inline constexpr const char* kLettersFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// A line of UTF-8 in DejaVu Sans, or where that is not installed in Arial, which has no Greek; capitals are
/// about 0.72 of `height_px` high. Empty where there is no ink.
GlyphBitmap ink(const std::string& text, int height_px);

}  // namespace carom
