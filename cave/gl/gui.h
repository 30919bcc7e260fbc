#pragma once
// Text, bars and tables over a window, by Dear ImGui: one Gui for each window that has any.
//
// Between `begin` and `end` the functions of imgui.h draw into the window whose context is current. What
// mouse and keyboard do reaches them through `hear`; a Gui that is told nothing only shows.

#include <chrono>
#include <vector>

#include <functional>

#include <glm/vec2.hpp>

struct ImGuiContext;

namespace carom {

/// One thing that a window received.
struct HeardByGui {
  enum class Kind { pointer, button, wheel, key, letter };
  Kind kind = Kind::pointer;
  glm::vec2 at{0.0F};  ///< pointer: pixels from the upper left; wheel: notches sideways and forwards
  unsigned code = 0;   ///< button: 0 left, 1 right, 2 middle; key: GLFW's; letter: of Unicode
  bool down = false;   ///< button, key
};

class Gui {
 public:
  /// Made, used and destroyed with the window's OpenGL context current. `text_px`: the height of a line's
  /// letters; `heading_px`: of a second, larger font, the atlas's number 1; 0: none.
  explicit Gui(float text_px, float heading_px = 0.0F);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// In the order in which it came. Of buttons and keys one change a frame is taken, so that a click is seen
  /// however short it was.
  void hear(const HeardByGui& heard);
  /// A field is being filled in or a list is open: keys are for them.
  bool wantsKeys() const { return wantsKeys_; }
  /// A click or a key waits for the next frame, or was taken with the last one: who pressed it waits for an
  /// answer.
  bool isPressed() const;

  void begin(const glm::ivec2& window_px);
  void end();  ///< draws it

 private:
  void takeHeard();

  ImGuiContext* context_ = nullptr;
  std::vector<HeardByGui> heard_;
  bool wantsKeys_ = false, took_ = false;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Within a Gui: what `draw` draws, on a dim ground in the window's upper left corner; it takes no input.
void overCorner(const char* name, const std::function<void()>& draw);

}  // namespace carom
