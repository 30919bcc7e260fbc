#include "cave/hud/panel_picture.h"

#include <algorithm>
#include <cmath>

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "shaders/stereo_vert.h"
#include "shaders/words_frag.h"

namespace carom {

PanelPicture::PanelPicture() : program_(makeProgram("words", shaders::stereo_vert, shaders::words_frag)) {}

void PanelPicture::begin(const glm::ivec2& size_px, const Rgba& ground) {
  size_px_ = size_px;
  rgba_.resize(4 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
  for (std::size_t i = 0; i < rgba_.size(); ++i) rgba_[i] = ground[i % 4];
}

void PanelPicture::fill(const glm::ivec2& from_px, const glm::ivec2& size_px, const Rgba& colour) {
  const glm::ivec2 to_px = glm::min(from_px + size_px, size_px_);
  for (int y = std::max(from_px.y, 0); y < to_px.y; ++y) {
    for (int x = std::max(from_px.x, 0); x < to_px.x; ++x) {
      std::copy(colour.begin(), colour.end(),
                rgba_.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * size_px_.x + x));
    }
  }
}

void PanelPicture::write(const glm::ivec2& foot_px, const GlyphBitmap& ink, const glm::vec3& colour) {
  for (int y = 0; y < ink.size_px.y; ++y) {
    for (int x = 0; x < ink.size_px.x; ++x) {
      const glm::ivec2 at{foot_px.x + x, foot_px.y + ink.below_px + y};
      const int alpha = ink.alpha[static_cast<std::size_t>(y * ink.size_px.x + x)];
      if (at.x < 0 || at.y < 0 || at.x >= size_px_.x || at.y >= size_px_.y || alpha == 0) continue;
      std::uint8_t* pixel =
          &rgba_[4 * (static_cast<std::size_t>(at.y) * size_px_.x + static_cast<std::size_t>(at.x))];
      for (int i = 0; i < 3; ++i) {
        pixel[i] =
            static_cast<std::uint8_t>((pixel[i] * (255 - alpha) + static_cast<int>(colour[i]) * alpha) / 255);
      }
      pixel[3] = std::max(pixel[3], static_cast<std::uint8_t>(alpha));
    }
  }
}

void PanelPicture::upload() {
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_px_.x, size_px_.y, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               rgba_.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void PanelPicture::draw(const RenderTarget& picture, const glm::ivec2& from_px, double stretch) const {
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  glBindTexture(GL_TEXTURE_2D, texture_);  // of the first unit, as a sampler begins
  glViewport(from_px.x, from_px.y, static_cast<int>(std::lround(size_px_.x * stretch)), size_px_.y);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace carom
