#include "cave/gl/graphics.h"

#include <malloc.h>

#include <cstdlib>
#include <stdexcept>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <vtk_glew.h>

#include "cave/gl/gl_state_guard.h"

namespace carom {
namespace {

constexpr GLuint64 kLongestDrawing_ns = 10'000'000'000;  // a graphics card that takes longer hangs

[[noreturn]] void failWithoutDisplay(const std::string& reason) {
  const char* display = std::getenv("DISPLAY");
  const std::string where = display && *display
                                ? fmt::format("no X display: cannot open \"{}\" ({})", display, reason)
                                : std::string("no X display: the environment variable DISPLAY is not set");
  throw std::runtime_error(where +
                           "; expected a screen to which this user is logged in, or one that a [[node]] of "
                           "the rig names by display");
}

/// Keeps memory that a frame gives back for the next: drawing on the processor takes some megabytes in every
/// frame, and new pages for them would cost more than the writing.
void keepFreedMemory() {
  constexpr int kMostKept = 256 << 20, kLargest = 32 << 20;  // bytes; larger pieces are pages of their own
  mallopt(M_TRIM_THRESHOLD, kMostKept);
  mallopt(M_MMAP_THRESHOLD, kLargest);
}

}  // namespace

std::string lastGlfwError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

void hintContext() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // Pictures are copied into windows, which need no depth; where one has it, llvmpipe copies six times
  // slower.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

void awaitFence(const GlFence& fence) {
  if (fence) glClientWaitSync(static_cast<GLsync>(fence.get()), 0, kLongestDrawing_ns);
}

Graphics::Graphics(const std::string& display) {
  if (!display.empty()) setenv("DISPLAY", display.c_str(), 1);
#ifdef GLFW_PLATFORM  // from GLFW 3.4 on, which would choose Wayland where there is both
  glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (!glfwInit()) failWithoutDisplay(lastGlfwError());
  hintContext();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  context_ = glfwCreateWindow(16, 16, "drawing", nullptr, nullptr);
  if (!context_) {
    const std::string reason = lastGlfwError();
    glfwTerminate();
    throw std::runtime_error("this X display offers no OpenGL 3.2: " + reason);
  }
  makeCurrent();
  glewExperimental = GL_TRUE;
  if (const GLenum status = glewInit(); status != GLEW_OK) {
    glfwTerminate();
    throw std::runtime_error(fmt::format("the OpenGL functions cannot be loaded: {}",
                                         reinterpret_cast<const char*>(glewGetErrorString(status))));
  }
  enterRestState();
  input_.keys.reserve(64);
  const std::string renderer = rendererName();
  for (const char* const known : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"})
    inSoftware_ = inSoftware_ || renderer.find(known) != std::string::npos;
  if (inSoftware_) keepFreedMemory();
}

Graphics::~Graphics() {
  makeCurrent();
  drawn_.reset();
  glfwTerminate();
}

void Graphics::makeCurrent() const {
  if (glfwGetCurrentContext() != context_) glfwMakeContextCurrent(context_);
}

void Graphics::finishDrawing() {
  makeCurrent();
  drawn_ = placeFence();
  glFlush();
}

void Graphics::awaitDrawing() const { awaitFence(drawn_); }

const WindowInput& Graphics::poll() {
  input_.keys.clear();
  input_.wheel = 0.0;
  ++polls_;
  glfwPollEvents();
  return input_;
}

void Graphics::discardInput() {
  poll();
  input_.keys.clear();
  ++discarded_;
}

std::string Graphics::rendererName() const {
  makeCurrent();
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace carom
