#pragma once
// Colours, text styles and small widgets shared by the console's panels.

#include <initializer_list>
#include <string_view>

#include <imgui.h>

#include "app/class_server/class_desk.h"
#include "app/input/key_table.h"
#include "app/input/keys.h"
#include "app/live/frame_source.h"
#include "app/operator/command.h"
#include "app/session/programme.h"
#include "app/stage/recording.h"
#include "cave/display/display_walls.h"
#include "cave/overlay/latency_overlay.h"
#include "cave/record/frame_state.h"

namespace carom {

class StudyDesk;

/// The frame on the walls, with everything that the console shows about it.
struct ConsoleFrame {
  const FrameRecord& record;
  const World& world;
  const DisplayWalls& walls;
  const LatencyView& latency;
  const SourceStatus& status;  ///< up to a quarter of a second old
  Recording& recording;
  KeysOf keys;
  const OperatorSettings& settings;
  std::optional<Programme::Following> following;  ///< the playlist's next game
  Commands& commands;              ///< the operator's commands, which take effect with the next frame
  ClassDesk* classroom = nullptr;  ///< null if no class takes part
  StudyDesk* study = nullptr;      ///< null if there is no study
};

namespace console {

inline const ImVec4 kBright{0.92F, 0.93F, 0.95F, 1.0F}, kDim{0.60F, 0.64F, 0.70F, 1.0F};
inline const ImVec4 kGood{0.36F, 0.76F, 0.47F, 1.0F}, kFair{0.93F, 0.76F, 0.33F, 1.0F},
    kBad{0.93F, 0.38F, 0.31F, 1.0F};

/// Sets the ImGui style of the current Gui's window.
void setStyle();

/// Draws a heading.
void heading(const char* words);
/// Draws secondary text, dimmed.
void dim(std::string_view words);
void words(std::string_view words);
/// Shows a tooltip for the previous item.
void tip(std::string_view words);
/// Draws a round status light with the height of a line.
void light(const ImVec4& colour);
/// Draws a key's label at the right edge of the line.
void keyAtRight(std::string_view key);
/// Returns how wide words are, but at least this.
float widthOf(std::initializer_list<const char*> words, float least_px);
/// Goes on in this line, or in the next one where there is no room for an item so wide.
void sameLineFor(float width_px);

/// Draws a time as "12.3 s", aligned so that times in a column line up.
void seconds(double value_s);

/// Draws a checkbox. Returns true if it was clicked.
bool tick(const char* label, bool on);

/// A slider that takes effect only when released, so that intermediate values are neither applied nor
/// recorded.
class PatientSlider {
 public:
  /// Draws the slider. Returns true when it is released, with the new `value`.
  bool draw(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = 0);

 private:
  float held_ = 0.0F;
  bool isHeld_ = false;
};

}  // namespace console
}  // namespace carom
