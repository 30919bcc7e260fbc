#include "cave/gl/image.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>

#include "engine/base/whole_file.h"

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
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(image.size_px.x, image.size_px.y, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(image.rgb.begin(), image.rgb.end(), static_cast<std::uint8_t*>(pixels->GetScalarPointer()));

  vtkNew<vtkPNGWriter> encoder;
  encoder->SetInputData(pixels);
  encoder->SetCompressionLevel(3);
  encoder->WriteToMemoryOn();
  encoder->Write();
  vtkUnsignedCharArray* png = encoder->GetResult();
  try {
    WholeFile(path).commit({reinterpret_cast<const char*>(png->GetPointer(0)),
                            static_cast<std::size_t>(png->GetNumberOfValues())});
  } catch (const NotWritten& error) {
    throw std::runtime_error(
        fmt::format("picture \"{}\" cannot be written: {}", path.string(), error.reason()));
  }
}

}  // namespace carom
