#pragma once
// The pictures of one eye that belong to the runtime: acquired in turn, filled, released.

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/graphics.h"
#include "cave/headset/openxr.h"

namespace carom::openxr {

class EyeImages {
 public:
  /// Throws std::runtime_error if the runtime takes no pictures of 8 bits a colour.
  EyeImages(XrInstance instance, XrSession session, glm::ivec2 pixels);
  ~EyeImages();
  EyeImages(const EyeImages&) = delete;
  EyeImages& operator=(const EyeImages&) = delete;

  /// Copies a picture of encoded bytes (RGBA8, the same size) into the next image, byte for byte. Returns
  /// false if the runtime has none free.
  bool fill(const Graphics& graphics, unsigned picture);

  XrSwapchainSubImage subImage() const;
  /// Returns whether the bytes are known to the runtime as sRGB; else it will show them as linear ones, too
  /// bright.
  bool isEncoded() const { return isEncoded_; }

 private:
  XrInstance instance_;
  glm::ivec2 pixels_;
  bool isEncoded_ = false;
  XrSwapchain chain_ = XR_NULL_HANDLE;
  std::vector<XrSwapchainImageOpenGLKHR> images_;
  GlFramebuffer from_, to_;
};

/// Makes the drawing context current after a call into the runtime, without asking whether it is: some
/// runtimes change it behind GLFW's back. Forgets OpenGL errors that they leave, and sets what drawing
/// expects.
void takeBack(const Graphics& graphics);

}  // namespace carom::openxr
