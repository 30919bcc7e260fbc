#pragma once
// Text, bars and tables over a window, by Dear ImGui: one Gui for each window that needs one.
//
// Between `begin` and `end`, the functions of imgui.h draw into the window whose context is current. Input of
// mouse and keyboard reaches them through `hear`; a Gui that gets no input only displays.

#include <bitset>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"

struct ImGuiContext;

namespace carom {

/// One piece of input that a window received.
struct GuiEvent {
  enum class Kind { pointer, button, wheel, key, letter };
  Kind kind = Kind::pointer;
  glm::vec2 at{0.0F};  ///< pointer: pixels from the upper left; wheel: notches sideways and forwards
  unsigned code = 0;   ///< button: 0 left, 1 right, 2 middle; key: GLFW's; letter: of Unicode
  bool down = false;   ///< button, key
};

class Gui {
 public:
  /// Create, use and destroy it with the window's OpenGL context current. `text_px`: height of a line's
  /// letters. `heading_px`: height of the letters of a second, larger font, number 1 in the atlas; 0: there
  /// is none.
  explicit Gui(float text_px, float heading_px = 0.0F);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Sets the letters that windows need beyond European ones and signs of physics: those of the words of a
  /// session's languages. They are in every Gui that is made from then on, of the first font that has them
  /// (cave/gl/glyph_bitmap.h).
  static void setLetters(std::u32string_view letters);

  /// Adds input, in the order in which it came. Each frame takes one change of buttons or keys, so that even
  /// the shortest click is seen; a button that goes down waits for the frame after the pointer has come,
  /// since some widgets take no press before they have been pointed to.
  void hear(const GuiEvent& heard);
  /// Returns whether a field is being filled in or a list is open, so that keys belong to the Gui.
  bool wantsKeys() const { return wantsKeys_; }
  /// Returns whether a click or a key waits for the next frame or was taken with the last one: the person who
  /// pressed it expects an answer.
  bool isPressed() const;

  /// Returns the key, of GLFW, that was pressed for this frame.
  std::optional<unsigned> pressedKey() const { return pressedKey_; }

  /// Keeps the pointer's presses within the window of the Gui that is drawn now from what lies below it. Call
  /// it in each frame between ImGui::Begin and ImGui::End.
  static void claim();
  /// Returns whether a place was claimed in the latest frame. Pixels from the upper left.
  bool isClaimed(const glm::vec2& at_px) const;
  void forgetClaims() { claims_.clear(); }

  void begin(const glm::ivec2& window_px);
  void end();  ///< draws the frame

 private:
  void takeHeard();

  ImGuiContext* context_ = nullptr;
  GlQuery drawn_;
  std::vector<GuiEvent> events_;
  struct Claim {
    glm::vec2 from_px, to_px;
  };
  std::vector<Claim> claims_;
  std::bitset<512> keysDown_;  // by GLFW's numbers, which end at 348
  std::optional<unsigned> pressedKey_;
  bool wantsKeys_ = false, took_ = false;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Returns whether this key, of GLFW, was pressed for this frame of the Gui that is drawn now.
bool isKeyPressed(int key);

/// Draws a tile in the window's lower right corner, within a Gui. Returns whether it was pressed.
bool isTilePressed(const char* name);

/// Draws what `draw` draws, within a Gui, on an opaque sheet in the window's upper left corner, which takes
/// the presses there. Returns whether it was pressed.
bool isSheetPressed(const char* name, const std::function<void()>& draw);

/// Draws what `draw` draws, within a Gui, on a dim background in the window's upper left corner; it takes no
/// input.
void overCorner(const char* name, const std::function<void()>& draw);

}  // namespace carom
