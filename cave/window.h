#pragma once
// OpenGL contexts and visible windows, by GLFW. One hidden window owns the context in which every wall is
// drawn into textures; visible windows share those textures and only pack them.
//
// Use from the main thread only.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/frame_lock.h"
#include "cave/gui.h"
#include "cave/stereo.h"
#include "cave/wall.h"

struct GLFWwindow;

namespace carom {

/// A key pressed or released in any visible window; `key` is GLFW's (GLFW_KEY_W and so on).
struct KeyInput {
  int key = 0;
  bool pressed = false;
};

/// What happened in the windows since the last poll.
struct WindowInput {
  std::vector<KeyInput> keys;  ///< in order
  bool closeRequested = false;
  double wheel = 0.0;  ///< notches, over any window
};

/// What the pointer did over one window. Pixels count right and down.
struct PointerInput {
  glm::dvec2 dragged_px{0.0};  ///< with the left button down
  double wheel = 0.0;          ///< notches, forwards
};

/// GLFW and the hidden window with the drawing context. One per process.
class Graphics {
 public:
  /// Throws std::runtime_error, in words for the person at the machine, if there is no X display or no
  /// OpenGL 3.2 on it. `display` (e.g. ":0.1") is used instead of $DISPLAY where given.
  explicit Graphics(const std::string& display = {});
  ~Graphics();
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  /// Makes the drawing context current.
  void makeCurrent() const;

  /// Hands the drawing done so far to the windows: they wait (on the GPU) for it. Call after all walls
  /// are drawn, before Window::show.
  void finishDrawing();

  /// Waits until what was drawn before the last finishDrawing is drawn.
  void awaitDrawing() const;

  /// Processes what the windows received; call once a drawn frame. The span of keys is valid until the next.
  const WindowInput& poll();

  GLFWwindow* context() const { return context_; }
  std::string rendererName() const;  ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"

 private:
  friend class Window;
  GLFWwindow* context_ = nullptr;
  void* drawn_ = nullptr;  // GLsync: the last frame's drawing
  WindowInput input_;
};

/// A visible window.
class Window {
 public:
  /// Throws std::runtime_error if the monitor does not exist or quad-buffer stereo is asked for but not
  /// offered by the display.
  Window(Graphics& graphics, const std::string& title, const WindowPlacement& placement,
         bool quadBuffer = false);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Draws the panes and, in a Gui over them, what `over` draws (not yet visible: see swap). Leaves this
  /// window's context current.
  void show(std::span<const Pane> panes, const std::function<void()>& over = {});

  /// Waits until what was shown is drawn. Any context may be current.
  void awaitShown() const;

  /// Makes what was shown visible; waits for the display's refresh if `setVsync(true)`.
  void swap();
  void makeCurrent() const;
  void setVsync(bool on);

  /// What is drawn over it takes mouse and letters from now on, and keys while it wants them (cave/gui.h); other
  /// keys are the session's, as in every window. `text_px`, `heading_px`: of its letters.
  void listen(float text_px, float heading_px);
  bool isPressed() const { return listens_ && gui_->isPressed(); }
  bool isIconified() const;

  glm::ivec2 size_px() const;  ///< of its framebuffer
  bool isDown(int key) const;
  /// Where the pointer is, in pixels of the framebuffer, right and down; none while it is over no part of the window
  /// that can be seen. While a button is held that was pressed here, it may be anywhere.
  std::optional<glm::dvec2> pointer_px() const;
  bool isHeld() const;  ///< the left button was pressed here and is down
  /// Since the last call; call once a poll.
  PointerInput takePointer();
  SwapGroupCalls::Drawable drawable() const { return drawable_; }

 private:
  struct Hears;  // what GLFW calls

  Graphics& graphics_;
  GLFWwindow* window_ = nullptr;
  bool listens_ = false;  // to what its Gui should know of
  glm::dvec2 pointer_px_{0.0};  // when it was last asked for
  bool dragging_ = false;       // then
  SwapGroupCalls::Drawable drawable_ = 0;
  std::unique_ptr<StereoPacker> packer_;
  std::unique_ptr<Gui> gui_;  // from its first use on
  void* shown_ = nullptr;     // GLsync: the last frame's drawing in this window
};

}  // namespace carom
