#include "cave/display/window.h"

#include <stdexcept>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <vtk_glew.h>
#include <glm/common.hpp>

#include "cave/display/wall_window.h"
#include "cave/gl/gl_state_guard.h"

namespace carom {
namespace {

constexpr float kText_px = 18.0F;

}  // namespace

struct Window::Hears {
  static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

  static void key(GLFWwindow* window, int key, int /*scancode*/, int action, int /*modifiers*/) {
    Window& here = of(window);
    const bool pressed = action == GLFW_PRESS;
    if (action == GLFW_REPEAT || key == GLFW_KEY_UNKNOWN) return;
    if (here.listens_) here.gui_->hear({GuiEvent::Kind::key, {}, static_cast<unsigned>(key), pressed});
    // A receiver that has seen a key pressed also sees it released.
    const bool taken = here.listens_ && pressed && here.gui_->wantsKeys();
    if (!taken) here.graphics_.input_.keys.push_back({key, pressed});
  }

  static void scroll(GLFWwindow* window, double sideways, double forwards) {
    Window& here = of(window);
    if (!here.listens_) {
      here.graphics_.input_.wheel += forwards;
    } else {
      here.gui_->hear({GuiEvent::Kind::wheel, {sideways, forwards}});
    }
  }

  static void close(GLFWwindow* window) { of(window).graphics_.input_.closeRequested = true; }

  /// Takes the position from GLFW, which counts in the desktop's units.
  static void pointer(GLFWwindow* window, double x, double y) {
    glm::ivec2 size{1};
    glfwGetWindowSize(window, &size.x, &size.y);
    const glm::vec2 scale = glm::vec2(of(window).size_px()) / glm::vec2(glm::max(size, 1));
    of(window).gui_->hear({GuiEvent::Kind::pointer, glm::vec2(x, y) * scale});
  }

  static void left(GLFWwindow* window, int inside) {
    const bool dragging = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    if (!inside && !dragging) of(window).gui_->hear({GuiEvent::Kind::pointer, {-1e9F, -1e9F}});
  }

  static void button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
    Window& here = of(window);
    if (button == GLFW_MOUSE_BUTTON_LEFT && action == GLFW_PRESS) here.pressedAtPoll_ = here.graphics_.polls_;
    if (!here.listens_ || button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    here.gui_->hear({GuiEvent::Kind::button, {}, static_cast<unsigned>(button), action == GLFW_PRESS});
  }

  static void letter(GLFWwindow* window, unsigned code) {
    of(window).gui_->hear({GuiEvent::Kind::letter, {}, code});
  }
};

Window::Window(Graphics& graphics, const std::string& title, const WindowPlacement& placement,
               bool quadBuffer)
    : graphics_(graphics), border_(placement.border) {
  const std::vector<Monitor> present = monitors();
  place_ = placeOf(placement, present);
  hintContext();
  glfwWindowHint(GLFW_STEREO, quadBuffer ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DECORATED, border_ ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);  // a wall must not vanish when it loses the focus
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  window_ = glfwCreateWindow(place_.size_px.x, place_.size_px.y, title.c_str(), nullptr, graphics.context_);
  if (!window_) {
    const std::string reason = lastGlfwError();
    throw std::runtime_error(
        quadBuffer
            ? fmt::format("window \"{}\": this display offers no quad-buffer stereo ({}); choose another "
                          "stereo mode, e.g. \"side-by-side\"",
                          title, reason)
            : fmt::format("window \"{}\" cannot be opened: {}", title, reason));
  }
  glfwSetWindowPos(window_, place_.position_px.x, place_.position_px.y);
  beginBlack(window_);
  if (!border_) {
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);  // no desktop cursor on a wall
    claimWall(window_, placement.fullscreen && monitorsOf(placement, present).size() == 1);
  }
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, Hears::key);
  glfwSetScrollCallback(window_, Hears::scroll);
  glfwSetMouseButtonCallback(window_, Hears::button);
  glfwSetWindowCloseCallback(window_, Hears::close);
  glfwShowWindow(window_);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(0);
  enterRestState();
  drawable_ = currentDrawable();
  packer_ = std::make_unique<StereoPacker>();
}

Window::~Window() {
  glfwMakeContextCurrent(window_);
  shown_.reset();
  gui_.reset();
  packer_.reset();
  glfwDestroyWindow(window_);
  graphics_.makeCurrent();
}

void Window::show(std::span<const Pane> panes, const std::function<void()>& over) {
  glfwMakeContextCurrent(window_);
  if (graphics_.drawn_) glWaitSync(static_cast<GLsync>(graphics_.drawn_.get()), 0, GL_TIMEOUT_IGNORED);
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
  shown_ = placeFence();
  glFlush();
}

void Window::awaitShown() const { awaitFence(shown_); }

void Window::swap() { glfwSwapBuffers(window_); }

void Window::makeCurrent() const { glfwMakeContextCurrent(window_); }

void Window::makeNoneCurrent() { glfwMakeContextCurrent(nullptr); }

void Window::setVsync(bool on) {
  makeCurrent();
  glfwSwapInterval(on ? 1 : 0);
}

void Window::listen(float text_px, float heading_px) {
  makeCurrent();
  gui_ = std::make_unique<Gui>(text_px, heading_px);
  listens_ = true;
  glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_NORMAL);
  glfwSetCursorPosCallback(window_, Hears::pointer);
  glfwSetCursorEnterCallback(window_, Hears::left);
  glfwSetCharCallback(window_, Hears::letter);
}

ScreenPlace Window::place() const {
  ScreenPlace now;
  glfwGetWindowPos(window_, &now.position_px.x, &now.position_px.y);
  glfwGetWindowSize(window_, &now.size_px.x, &now.size_px.y);
  return now;
}

std::string Window::misplaced() const {
  if (border_) return {};
  const ScreenPlace now = place();
  const auto words = [](const ScreenPlace& place) {
    return fmt::format("{} × {} pixels from ({}, {})", place.size_px.x, place.size_px.y, place.position_px.x,
                       place.position_px.y);
  };
  return now == place_ ? "" : fmt::format("{}, expected {}", words(now), words(place_));
}

bool Window::isIconified() const { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE; }

glm::ivec2 Window::size_px() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

bool Window::isDown(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

bool Window::isHeld() const {
  return glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
         pressedAtPoll_ == graphics_.polls_;
}
bool Window::isTurning() const { return glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS; }

std::optional<glm::dvec2> Window::pointer_px() const {
  if (!isHeld() && !isTurning() && !glfwGetWindowAttrib(window_, GLFW_HOVERED)) return std::nullopt;
  glm::dvec2 place(0.0);
  glm::ivec2 size(0);
  glfwGetCursorPos(window_, &place.x, &place.y);  // in the desktop's units
  glfwGetWindowSize(window_, &size.x, &size.y);
  if (size.x <= 0 || size.y <= 0) return std::nullopt;
  return place * glm::dvec2(size_px()) / glm::dvec2(size);
}

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
