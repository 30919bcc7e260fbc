#include "cave/pictures/image.h"

#include <stdexcept>

#include <fmt/format.h>
#include <vtk_glew.h>

#include "cave/pictures/picture_library.h"
#include "engine/text/whole_file.h"

namespace carom {

Image readBack(const RenderTarget& picture) {
  Image image;
  image.size_px = picture.size_px();
  image.rgb.resize(3 * static_cast<std::size_t>(image.size_px.x) * static_cast<std::size_t>(image.size_px.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.size_px.x, image.size_px.y, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return image;
}

void writePng(const Image& image, const std::filesystem::path& path) {
  const std::string png = pictureLibrary().pngOf(image.size_px, image.rgb);
  try {
    WholeFile(path).commit(png);
  } catch (const NotWritten& error) {
    throw std::runtime_error(
        fmt::format("picture \"{}\" cannot be written: {}", path.string(), error.reason()));
  }
}

}  // namespace carom
