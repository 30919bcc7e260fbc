#include "cave/gl/glyph_bitmap.h"

#include <array>
#include <filesystem>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <glm/common.hpp>

namespace carom {
namespace {

/// Crops VTK's picture of a text, which is wider than the text, to the pixels with ink.
GlyphBitmap inked(vtkImageData& rgba) {
  const glm::ivec2 size(rgba.GetDimensions()[0], rgba.GetDimensions()[1]);
  const auto* bytes = static_cast<const std::uint8_t*>(rgba.GetScalarPointer());
  const auto alpha = [&](int x, int y) { return bytes[4 * (y * size.x + x) + 3]; };
  glm::ivec2 from = size, to(0);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      if (alpha(x, y) == 0) continue;
      from = glm::min(from, {x, y});
      to = glm::max(to, {x + 1, y + 1});
    }
  }
  GlyphBitmap made{glm::max(to - from, 0), {}, from.y};
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) made.alpha.push_back(alpha(x, y));
  }
  return made;
}

void useFont(vtkTextProperty& style) {
  static const bool isThere = std::filesystem::exists(kLettersFile);
  if (!isThere) return style.SetFontFamilyToArial();
  style.SetFontFamily(VTK_FONT_FILE);
  style.SetFontFile(kLettersFile);
}

}  // namespace

GlyphBitmap ink(const std::string& text, int height_px) {
  vtkNew<vtkTextProperty> style;
  useFont(*style);
  style->SetFontSize(height_px);
  vtkNew<vtkImageData> rgba;
  glm::ivec2 box{0};
  constexpr int kPointsArePixels_dpi = 72;
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (!renderer || !renderer->RenderString(style, vtkStdString(text), rgba, &box[0], kPointsArePixels_dpi,
                                           vtkTextRenderer::FreeType)) {
    return {};
  }
  return inked(*rgba);
}

}  // namespace carom
