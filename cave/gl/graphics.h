#pragma once
// The OpenGL context in which every wall is drawn into textures, by GLFW: one hidden window owns it. Visible
// windows (cave/display/window.h) share its textures and only pack them for the display.
//
// Use from the main thread only.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cave/gl/gl_objects.h"

struct GLFWwindow;

namespace carom {

/// A key pressed or released in any visible window; `key` is GLFW's (GLFW_KEY_W and so on).
struct KeyInput {
  int key = 0;
  bool pressed = false;
};

/// Input of the windows since the last poll.
struct WindowInput {
  std::vector<KeyInput> keys;  ///< in order
  bool closeRequested = false;
  double wheel = 0.0;  ///< notches, over any window
};

/// Common to all windows of the process: hintContext sets the hints for a context of OpenGL 3.2,
/// lastGlfwError returns the message of GLFW's last failure, and awaitFence waits for a fence (not at all for
/// null), but only for a bounded time in case the graphics card hangs.
void hintContext();
std::string lastGlfwError();
void awaitFence(const GlFence& fence);

/// GLFW and the hidden window with the drawing context. One per process.
class Graphics {
 public:
  /// Throws std::runtime_error, with a message for the person at the machine, if there is no X display or no
  /// OpenGL 3.2 on it. `display` (e.g. ":0.1"), if given, is used instead of $DISPLAY.
  explicit Graphics(const std::string& display = {});
  ~Graphics();
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  /// Makes the drawing context current.
  void makeCurrent() const;

  /// Makes the windows wait, on the GPU, for the drawing done so far. Call it after all walls are drawn,
  /// before Window::show.
  void finishDrawing();

  /// Waits until all draws before the last finishDrawing are complete.
  void awaitDrawing() const;

  /// Processes the windows' input; call it once per drawn frame. The result is valid until the next call.
  const WindowInput& poll();
  /// Forgets all input that has come so far, as after a long load.
  void discardInput();

  /// Sets what every visible window shows over its pictures from now on, in a Gui that takes the pointer
  /// where something lies (Gui::claim); an empty function: nothing.
  void setOverAll(const std::function<void()>& overAll) { overAll_ = overAll; }

  GLFWwindow* context() const { return context_; }
  /// Returns whether the processor stands in for a graphics card: then samples cost as much as pixels.
  bool inSoftware() const { return inSoftware_; }
  std::string rendererName() const;  ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"

 private:
  friend class Window;
  GLFWwindow* context_ = nullptr;
  bool inSoftware_ = false;
  GlFence drawn_;  // fence behind the last frame's drawing
  WindowInput input_;
  std::uint64_t polls_ = 0, discarded_ = 0;  // so far
  std::function<void()> overAll_;
};

}  // namespace carom
