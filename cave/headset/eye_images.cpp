#include "cave/headset/eye_images.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <stdexcept>

#include "cave/gl/gl_state_guard.h"

namespace carom::openxr {
namespace {

constexpr XrDuration kPatience_ns = 500'000'000;  // for an image; a runtime in good order has one free

/// Returns the format of pictures that the runtime shows as they are, or else one of linear bytes.
std::int64_t formatOf(XrSession session) {
  const auto offered =
      listOf<std::int64_t>(0, [&](std::uint32_t capacity, std::uint32_t* count, std::int64_t* items) {
        return xrEnumerateSwapchainFormats(session, capacity, count, items);
      });
  for (const std::int64_t format : {std::int64_t{GL_SRGB8_ALPHA8}, std::int64_t{GL_RGBA8}}) {
    if (std::find(offered.begin(), offered.end(), format) != offered.end()) return format;
  }
  throw std::runtime_error("the headset's runtime takes no pictures of 8 bits a colour");
}

}  // namespace

void takeBack(const Graphics& graphics) {
  glfwMakeContextCurrent(nullptr);
  glfwMakeContextCurrent(graphics.context());
  for (int i = 0; i < 8 && glGetError() != GL_NO_ERROR; ++i) {
  }
  enterRestState();
}

EyeImages::EyeImages(XrInstance instance, XrSession session, glm::ivec2 pixels)
    : instance_(instance), pixels_(pixels) {
  XrSwapchainCreateInfo info{};
  info.type = XR_TYPE_SWAPCHAIN_CREATE_INFO;
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
  info.format = formatOf(session);
  info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
  info.width = static_cast<std::uint32_t>(pixels.x);
  info.height = static_cast<std::uint32_t>(pixels.y);
  isEncoded_ = info.format == GL_SRGB8_ALPHA8;
  check(instance, xrCreateSwapchain(session, &info, &chain_),
        "the headset's runtime gives no pictures to draw into");
  XrSwapchainImageOpenGLKHR empty{};
  empty.type = XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR;
  images_ =
      listOf(empty, [&](std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageOpenGLKHR* items) {
        return xrEnumerateSwapchainImages(chain_, capacity, count,
                                          reinterpret_cast<XrSwapchainImageBaseHeader*>(items));
      });
}

EyeImages::~EyeImages() { xrDestroySwapchain(chain_); }

bool EyeImages::fill(const Graphics& graphics, unsigned picture) {
  std::uint32_t index = 0;
  if (XR_FAILED(xrAcquireSwapchainImage(chain_, nullptr, &index))) return false;
  XrSwapchainImageWaitInfo wait{};
  wait.type = XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO;
  wait.timeout = kPatience_ns;
  const bool isFree = xrWaitSwapchainImage(chain_, &wait) == XR_SUCCESS;
  takeBack(graphics);
  if (isFree && index < images_.size()) {
    glDisable(GL_FRAMEBUFFER_SRGB);  // the bytes are encoded already
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to_);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, images_[index].image, 0);
    glBlitFramebuffer(0, 0, pixels_.x, pixels_.y, 0, 0, pixels_.x, pixels_.y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  return xrReleaseSwapchainImage(chain_, nullptr) == XR_SUCCESS && isFree;
}

XrSwapchainSubImage EyeImages::subImage() const {
  XrSwapchainSubImage image{};
  image.swapchain = chain_;
  image.imageRect.extent = {pixels_.x, pixels_.y};
  return image;
}

}  // namespace carom::openxr
