#pragma once
// Wall pictures as PNG files.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/picture.h"
#include "cave/wall.h"

namespace carom {

/// Pixels in memory, RGB, rows from the bottom up.
struct Image {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> rgb;
};

/// Reads a picture back; waits for its drawing. The drawing context must be current.
Image readBack(const WallPicture& picture);

/// `directory`/<wall>-<eye>-<frame as six digits>.png
std::filesystem::path capturePath(const std::filesystem::path& directory, const std::string& wall, Eye eye,
                                  std::uint64_t frame);

/// Writes a PNG that appears whole or not at all. Throws std::runtime_error naming the file.
void writePng(const Image& image, const std::filesystem::path& path);

}  // namespace carom
