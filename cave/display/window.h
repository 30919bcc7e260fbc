#pragma once
// Visible windows, by GLFW. They share the textures of the drawing context (cave/gl/graphics.h) and only pack
// them for the display.
//
// Use from the main thread only; makeCurrent, swap and makeNoneCurrent also from another, if no other thread
// uses this window meanwhile.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "cave/cluster/frame_lock.h"
#include "cave/display/monitors.h"
#include "cave/display/pointer_queue.h"
#include "cave/gl/gl_objects.h"
#include "cave/gl/graphics.h"
#include "cave/gl/gui.h"
#include "cave/projection/stereo.h"
#include "cave/room/wall.h"

struct GLFWwindow;

namespace carom {

/// Input of the pointer over one window. Pixels are counted to the right and down.
struct PointerInput {
  glm::dvec2 dragged_px{0.0};  ///< drag with the left button down
  double wheel = 0.0;          ///< notches turned forwards
};

/// A visible window.
class Window {
 public:
  /// Throws std::runtime_error if a monitor does not exist or quad-buffer stereo is asked for but not offered
  /// by the display. A window without border is a wall's: it hides the cursor.
  Window(Graphics& graphics, const std::string& title, const WindowPlacement& placement,
         bool quadBuffer = false);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Draws the panes and, in a Gui over them, what `over` draws and what every window shows
  /// (Graphics::setOverAll); `swap` makes them visible. Leaves this window's context current.
  void show(std::span<const Pane> panes, const std::function<void()>& over = {});

  /// Waits until the shown picture is drawn. Any context may be current.
  void awaitShown() const;

  /// Makes the shown picture visible; waits for the display's refresh if `setVsync(true)`.
  void swap();
  void makeCurrent() const;
  static void makeNoneCurrent();  ///< in this thread
  void setVsync(bool on);

  /// Enables input for this window's Gui. It takes the mouse and letters, and keys while it wants them
  /// (cave/gl/gui.h); other keys go to the session, as in every window. `text_px`, `heading_px`: heights of
  /// its letters.
  void listen(float text_px, float heading_px);
  bool isPressed() const { return listens_ && gui_->isPressed(); }
  bool isIconified() const;
  void setVisible(bool on);
  bool isVisible() const;

  ScreenPlace place() const;  ///< where it lies, without its border

  /// Returns where a window without border lies, and where it should, if a window manager has moved it.
  std::string misplaced() const;

  glm::ivec2 size_px() const;  ///< size of its framebuffer
  bool isDown(int key) const;
  /// Returns where the pointer is, in pixels of the framebuffer to the right and down, or none if it is not
  /// over a visible part of the window. While a button is held that was pressed here, it may be anywhere.
  std::optional<glm::dvec2> pointer_px() const;
  /// Returns whether the left button was pressed here and is down in this frame
  /// (cave/display/pointer_queue.h).
  bool isHeld() const;
  bool isTurning() const;  ///< the same of the right button
  /// Returns the pointer's input since the last call; call it once per poll.
  PointerInput takePointer();
  SwapGroupCalls::Drawable drawable() const { return drawable_; }

 private:
  struct Hears;  // GLFW callbacks
  glm::dvec2 toPixels(double x, double y) const;
  const PointerQueue& pointer() const;

  Graphics& graphics_;
  GLFWwindow* window_ = nullptr;
  ScreenPlace place_;
  bool border_ = false;
  bool listens_ = false;  // its Gui takes input
  mutable PointerQueue pointer_;
  mutable std::uint64_t framePoll_ = 0, discarded_ = 0;  // of Graphics, when the pointer was last asked for
  // At the last takePointer.
  struct Pointing {
    glm::dvec2 at_px{0.0};
    bool dragging = false;
    bool overHeld = false;  // a button was pressed over what lies above the pictures
  };
  Pointing pointing_;
  SwapGroupCalls::Drawable drawable_ = 0;
  std::unique_ptr<StereoPacker> packer_;
  std::unique_ptr<Gui> gui_;  // from its first use on
  GlFence shown_;             // fence behind the last frame's drawing in this window
};

}  // namespace carom
