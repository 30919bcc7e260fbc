#pragma once
// Pictures in memory and as PNG files.

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/picture.h"

namespace carom {

/// Pixels in memory, RGB, rows from the bottom up.
struct Image {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> rgb;
};

/// Reads a picture back, waiting until it is drawn. The drawing context must be current.
Image readBack(const RenderTarget& picture);

/// Writes a PNG file that appears either whole or not at all. Throws std::runtime_error naming the file.
void writePng(const Image& image, const std::filesystem::path& path);

}  // namespace carom
