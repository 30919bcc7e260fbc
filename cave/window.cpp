#include "cave/window.h"

#include <cstdlib>
#include <stdexcept>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <vtk_glew.h>

namespace carom {
namespace {

constexpr float kText_px = 18.0F;
constexpr GLuint64 kLongestDrawing_ns = 10'000'000'000;  // a card that takes longer hangs

void await(void* sync) {
  if (sync) glClientWaitSync(static_cast<GLsync>(sync), 0, kLongestDrawing_ns);
}

std::string lastGlfwError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

[[noreturn]] void failWithoutDisplay(const std::string& reason) {
  const char* display = std::getenv("DISPLAY");
  const std::string where = display && *display
                                ? fmt::format("no X display: cannot open \"{}\" ({})", display, reason)
                                : std::string("no X display: the environment variable DISPLAY is not set");
  throw std::runtime_error(where +
                           "; start one, e.g. with: xvfb-run -a -s \"-screen 0 1920x1200x24\" COMMAND");
}

void askForContext() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
}

WindowInput& inputOf(GLFWwindow* window) {
  return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void onKey(GLFWwindow* window, int key, int /*scancode*/, int action, int /*modifiers*/) {
  if (action != GLFW_REPEAT) inputOf(window).keys.push_back({key, action == GLFW_PRESS});
}

void onScroll(GLFWwindow* window, double /*sideways*/, double notches) { inputOf(window).wheel += notches; }

void onClose(GLFWwindow* window) { inputOf(window).closeRequested = true; }

GLFWmonitor* monitorOf(const WindowPlacement& placement) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  if (placement.monitor < 0 || placement.monitor >= count) {
    throw std::runtime_error(
        fmt::format("there is no monitor {}: this display has {}, counted from 0", placement.monitor, count));
  }
  return monitors[placement.monitor];
}

}  // namespace

Graphics::Graphics(const std::string& display) {
  if (!display.empty()) setenv("DISPLAY", display.c_str(), 1);
  if (!glfwInit()) failWithoutDisplay(lastGlfwError());
  askForContext();
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
  input_.keys.reserve(64);
}

Graphics::~Graphics() {
  makeCurrent();
  if (drawn_) glDeleteSync(static_cast<GLsync>(drawn_));
  glfwTerminate();
}

void Graphics::makeCurrent() const {
  if (glfwGetCurrentContext() != context_) glfwMakeContextCurrent(context_);
}

void Graphics::finishDrawing() {
  makeCurrent();
  if (drawn_) glDeleteSync(static_cast<GLsync>(drawn_));
  drawn_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

void Graphics::awaitDrawing() const { await(drawn_); }

const WindowInput& Graphics::poll() {
  input_.keys.clear();
  input_.wheel = 0.0;
  glfwPollEvents();
  return input_;
}

std::string Graphics::rendererName() const {
  makeCurrent();
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

Window::Window(Graphics& graphics, const std::string& title, const WindowPlacement& placement,
               bool quadBuffer)
    : graphics_(graphics) {
  GLFWmonitor* monitor = monitorOf(placement);
  askForContext();
  glfwWindowHint(GLFW_STEREO, quadBuffer ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DECORATED, GLFW_TRUE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);  // a wall must not vanish when another takes the focus
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glm::ivec2 size_px = placement.size_px;
  if (placement.fullscreen) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    size_px = {mode->width, mode->height};
    glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
  }
  window_ = glfwCreateWindow(size_px.x, size_px.y, title.c_str(), placement.fullscreen ? monitor : nullptr,
                             graphics.context_);
  if (!window_) {
    const std::string reason = lastGlfwError();
    throw std::runtime_error(
        quadBuffer
            ? fmt::format("window \"{}\": this display offers no quad-buffer stereo ({}); choose another "
                          "stereo mode, e.g. \"side-by-side\"",
                          title, reason)
            : fmt::format("window \"{}\" cannot be opened: {}", title, reason));
  }
  if (placement.fullscreen) {
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);  // nothing of the desk on a wall
  } else {
    glm::ivec2 origin_px{0};
    glfwGetMonitorPos(monitor, &origin_px.x, &origin_px.y);
    glfwSetWindowPos(window_, origin_px.x + placement.position_px.x, origin_px.y + placement.position_px.y);
  }
  glfwSetWindowUserPointer(window_, &graphics.input_);
  glfwSetKeyCallback(window_, onKey);
  glfwSetScrollCallback(window_, onScroll);
  glfwSetWindowCloseCallback(window_, onClose);
  glfwShowWindow(window_);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(0);
  drawable_ = currentDrawable();
  packer_ = std::make_unique<StereoPacker>();
}

Window::~Window() {
  glfwMakeContextCurrent(window_);
  if (shown_) glDeleteSync(static_cast<GLsync>(shown_));
  gui_.reset();
  packer_.reset();
  glfwDestroyWindow(window_);
  graphics_.makeCurrent();
}

void Window::show(std::span<const Pane> panes, const std::function<void()>& over) {
  glfwMakeContextCurrent(window_);
  if (graphics_.drawn_) glWaitSync(static_cast<GLsync>(graphics_.drawn_), 0, GL_TIMEOUT_IGNORED);
  const glm::ivec2 size = size_px();
  glViewport(0, 0, size.x, size.y);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const Pane& pane : panes) packer_->draw(pane, size);
  if (over) {
    if (!gui_) gui_ = std::make_unique<Gui>(kText_px);
    gui_->begin(size);
    over();
    gui_->end();
  }
  if (shown_) glDeleteSync(static_cast<GLsync>(shown_));
  shown_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

void Window::awaitShown() const { await(shown_); }

void Window::swap() { glfwSwapBuffers(window_); }

void Window::makeCurrent() const { glfwMakeContextCurrent(window_); }

void Window::setVsync(bool on) {
  makeCurrent();
  glfwSwapInterval(on ? 1 : 0);
}

glm::ivec2 Window::size_px() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

bool Window::isDown(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

PointerInput Window::takePointer() {
  PointerInput input;
  glm::dvec2 place_px(0.0);
  glfwGetCursorPos(window_, &place_px.x, &place_px.y);
  const bool dragging = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  if (dragging && dragging_) input.dragged_px = place_px - pointer_px_;
  dragging_ = dragging;
  pointer_px_ = place_px;
  if (glfwGetWindowAttrib(window_, GLFW_HOVERED)) input.wheel = graphics_.input_.wheel;
  return input;
}

}  // namespace carom
