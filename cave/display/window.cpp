#include "cave/display/window.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

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

  static void pointer(GLFWwindow* window, double x, double y) {
    Window& here = of(window);
    const glm::dvec2 at_px = here.toPixels(x, y);
    here.pointer_.move(at_px);
    if (here.gui_) here.gui_->hear({GuiEvent::Kind::pointer, at_px});
  }

  static void left(GLFWwindow* window, int inside) {
    Window& here = of(window);
    const bool dragging = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    if (!inside && !dragging && here.gui_) here.gui_->hear({GuiEvent::Kind::pointer, {-1e9F, -1e9F}});
  }

  static void button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
    Window& here = of(window);
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const bool down = action == GLFW_PRESS;
    glm::dvec2 place(0.0);
    glfwGetCursorPos(window, &place.x, &place.y);
    const glm::dvec2 at_px = here.toPixels(place.x, place.y);
    const bool isOver =
        here.gui_ && (down ? here.listens_ || here.gui_->isClaimed(at_px) : here.pointing_.overHeld);
    if (isOver) {
      if (!here.listens_) here.gui_->hear({GuiEvent::Kind::pointer, at_px});  // as when a finger comes down
      here.gui_->hear({GuiEvent::Kind::button, {}, static_cast<unsigned>(button), down});
      here.pointing_.overHeld = down;
      return;
    }
    if (button == GLFW_MOUSE_BUTTON_MIDDLE) return;
    const bool isLeft = button == GLFW_MOUSE_BUTTON_LEFT;
    here.pointer_.change(isLeft ? PointerQueue::Button::left : PointerQueue::Button::right, down, at_px);
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
  glfwSetCursorPosCallback(window_, Hears::pointer);
  glfwSetCursorEnterCallback(window_, Hears::left);
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
  const auto covers = [&](const Pane& pane) {
    return pane.position_px == glm::ivec2(0) && pane.size_px == size;
  };
  if (std::none_of(panes.begin(), panes.end(), covers)) {
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  for (const Pane& pane : panes) packer_->draw(pane, size);
  if (over || graphics_.overAll_) {
    if (!gui_) gui_ = std::make_unique<Gui>(kText_px);
    gui_->begin(size);
    if (over) over();
    if (graphics_.overAll_) graphics_.overAll_();
    gui_->end();
  } else if (gui_) {
    gui_->forgetClaims();
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

void Window::setVisible(bool on) { on ? glfwShowWindow(window_) : glfwHideWindow(window_); }

bool Window::isVisible() const { return glfwGetWindowAttrib(window_, GLFW_VISIBLE) == GLFW_TRUE; }

/// Returns a place in pixels of the framebuffer that GLFW gives in the desktop's units.
glm::dvec2 Window::toPixels(double x, double y) const {
  glm::ivec2 size{1};
  glfwGetWindowSize(window_, &size.x, &size.y);
  return glm::dvec2(x, y) * glm::dvec2(size_px()) / glm::dvec2(glm::max(size, 1));
}

/// Returns the pointer in this frame, which begins with the latest poll.
const PointerQueue& Window::pointer() const {
  if (std::exchange(discarded_, graphics_.discarded_) != graphics_.discarded_) pointer_.discard();
  if (std::exchange(framePoll_, graphics_.polls_) != graphics_.polls_) pointer_.beginFrame();
  return pointer_;
}

bool Window::isHeld() const { return pointer().isDown(PointerQueue::Button::left); }

bool Window::isTurning() const { return pointer().isDown(PointerQueue::Button::right); }

std::optional<glm::dvec2> Window::pointer_px() const {
  if (!isHeld() && !isTurning() && !glfwGetWindowAttrib(window_, GLFW_HOVERED)) return std::nullopt;
  return pointer().at();
}

PointerInput Window::takePointer() {
  PointerInput input;
  glm::dvec2 place_px(0.0);
  glfwGetCursorPos(window_, &place_px.x, &place_px.y);
  const bool dragging = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  if (dragging && pointing_.dragging) input.dragged_px = place_px - pointing_.at_px;
  pointing_.dragging = dragging;
  pointing_.at_px = place_px;
  if (glfwGetWindowAttrib(window_, GLFW_HOVERED)) input.wheel = graphics_.input_.wheel;
  return input;
}

}  // namespace carom
