#pragma once
// Text, bars and tables over a window, by Dear ImGui: one Gui for each window that has any.
//
// Between `begin` and `end` the functions of imgui.h draw into the window whose context is current.

#include <glm/vec2.hpp>

struct ImGuiContext;

namespace carom {

class Gui {
 public:
  /// Made, used and destroyed with the window's OpenGL context current. `text_px`: the height of a line's
  /// letters.
  explicit Gui(float text_px);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  void begin(const glm::ivec2& window_px);
  void end();  ///< draws it

 private:
  ImGuiContext* context_ = nullptr;
};

}  // namespace carom
