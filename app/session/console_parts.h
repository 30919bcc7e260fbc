#pragma once
// What the console's panels have in common: colours, words, small things to look at.

#include <span>
#include <string_view>

#include <imgui.h>

#include "app/input/keys.h"
#include "app/operator/controls.h"
#include "app/session/frame_source.h"
#include "app/stage/recording.h"
#include "cave/display/display_walls.h"
#include "cave/frame/frame_state.h"
#include "cave/overlay/latency_overlay.h"

namespace carom {

/// The frame that is on the walls, and what there is to say about it.
struct ConsoleFrame {
  const FrameRecord& record;
  const World& world;
  const DisplayWalls& walls;
  const LatencyView& latency;
  const FrameSource& source;
  const Recording& recording;
  KeysOf keys;
};

namespace console {

inline const ImVec4 kBright{0.92F, 0.93F, 0.95F, 1.0F}, kDim{0.60F, 0.64F, 0.70F, 1.0F};
inline const ImVec4 kAccent{0.33F, 0.62F, 0.82F, 1.0F};
inline const ImVec4 kGood{0.36F, 0.76F, 0.47F, 1.0F}, kFair{0.93F, 0.76F, 0.33F, 1.0F},
    kBad{0.93F, 0.38F, 0.31F, 1.0F};

/// The style of the window whose Gui is current.
void dress();

/// A heading over what follows.
void heading(const char* words);
/// What belongs to words, dimmer.
void dim(std::string_view words);
void words(std::string_view words);
/// Said when the pointer rests on the last thing.
void tip(std::string_view words);
/// A round light, as high as a line.
void light(const ImVec4& colour);
/// A key's label at the right edge of what is left of the line.
void keyAtRight(std::string_view key);
/// "12.3 s", so that numbers stand under each other.
void seconds(double value_s);

/// A box to tick for one byte.
void tick(const char* label, std::uint8_t& value);

/// A slider that takes effect when it is let go, so that nothing is changed and noted on the way there.
class PatientSlider {
 public:
  /// True, and `value` changed, when it is let go.
  bool draw(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = 0);

 private:
  float held_ = 0.0F;
  bool isHeld_ = false;
};

/// What the keys do, in two columns.
void keyTable(std::span<const KeyLine> map);
/// The same over a wall's window, in its upper left corner.
void keysOver(std::span<const KeyLine> map);

}  // namespace console
}  // namespace carom
