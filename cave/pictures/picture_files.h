#pragma once
// Pictures as files, by VTK. All of it is in the library that is loaded when one is wanted
// (cave/pictures/picture_library.h).

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <glm/vec2.hpp>

namespace carom {

/// Returns a PNG file of these pixels: RGB, rows from the bottom up.
std::string pngOf(const glm::ivec2& size_px, std::span<const std::uint8_t> rgb);

/// Returns the picture in a PNG, JPEG or TIFF as bytes: width and height, then RGB in 16 bits a colour, rows
/// from the bottom up. VTK's readers crash on some broken files: to be called in a process of its own, which
/// is silent from then on. Throws std::runtime_error, without the file's name.
std::string pixelBytes(const std::filesystem::path& file);

}  // namespace carom
