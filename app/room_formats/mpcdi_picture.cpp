#include "app/room_formats/mpcdi_picture.h"

#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace carom {
namespace {

constexpr std::uint32_t kWidest_px = 16384, kMost_px = 1U << 26U;

/// Throws unless the picture's header is that of a PNG of a size that can be drawn (PNG, second
/// edition, 11.2.2).
void checkSize(const std::string& png) {
  constexpr std::size_t kWidthAt = 16, kHeader = 24;
  if (png.size() < kHeader || png_sig_cmp(reinterpret_cast<png_const_bytep>(png.data()), 0, 8) != 0)
    throw std::runtime_error("the picture is no PNG, expected one");
  const auto* raw = reinterpret_cast<png_const_bytep>(png.data());
  const std::uint32_t width = png_get_uint_32(raw + kWidthAt), height = png_get_uint_32(raw + kWidthAt + 4);
  if (width < 1 || height < 1 || width > kWidest_px || height > kWidest_px || width > kMost_px / height)
    throw std::runtime_error(
        fmt::format("the picture has {} × {} pixels, expected 1 to {} each way and at most {} in "
                    "all",
                    width, height, kWidest_px, kMost_px));
}

/// What libpng's simplified interface holds.
struct Png {
  png_image image{};
  Png() { image.version = PNG_IMAGE_VERSION; }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;
  ~Png() { png_image_free(&image); }
};

}  // namespace

std::string linearPicture(const std::string& png, double gamma) {
  checkSize(png);
  Png read;
  if (png_image_begin_read_from_memory(&read.image, png.data(), png.size()) == 0)
    throw std::runtime_error("the picture is broken, expected a PNG");
  read.image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> codes(PNG_IMAGE_SIZE(read.image));
  if (png_image_finish_read(&read.image, nullptr, codes.data(), 0, nullptr) == 0)
    throw std::runtime_error("the picture is broken, expected a PNG");
  if (gamma == 1.0) return png;
  for (png_byte& code : codes) {
    constexpr double kMost = 255.0;
    code = static_cast<png_byte>(std::lround(kMost * std::pow(code / kMost, gamma)));
  }
  Png written;
  written.image.width = read.image.width;
  written.image.height = read.image.height;
  written.image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  if (png_image_write_get_memory_size(written.image, size, 0, codes.data(), 0, nullptr) == 0)
    throw std::runtime_error("the picture cannot be written");
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&written.image, bytes.data(), &size, 0, codes.data(), 0, nullptr) == 0)
    throw std::runtime_error("the picture cannot be written");
  bytes.resize(size);
  return bytes;
}

}  // namespace carom
