#pragma once
// Reads the curved screens and the pictures by direction of a rig file, and the board that carries words
// where no flat wall does.

#include <optional>
#include <variant>

#include "app/files/rig.h"
#include "app/files/toml_file.h"
#include "cave/room/sky_eyes.h"
#include "cave/screen/screen_shape.h"
#include "cave/screen/sky_screen.h"

namespace carom {

/// A picture by direction, and whose eyes see it.
struct SkyText {
  Sky sky;
  SkyEyes eyes;
};

/// A curved screen or a picture by direction as given in the file, before it is divided into flat pieces.
struct ScreenText {
  std::variant<CylinderScreen, DomeScreen, SkyText> shape;
  double texelsPerPixel = 1.25;
  double sagitta_m = 0.1;

  bool isSky() const { return std::holds_alternative<SkyText>(shape); }
};

/// Reads the `screen` or `sky` of a wall, or none.
std::optional<ScreenText> readScreen(const TomlTable& wallTable, const RoomAxes& axes, double unit_m);

/// Sets the screen of a wall, whose corners become three of the screen's places. Call it once all numbers
/// have been read. Records a fault if it takes too many flat pieces.
void curve(const ScreenText& text, const TomlTable& wallTable, const RoomAxes& axes, Wall& wall);

/// Returns the board that a rig's `[panel]` describes, or none.
std::optional<Wall> readPanel(const TomlTable& root, double unit_m);

/// Checks the board of a rig's `[panel]`. Without one, where no flat wall stands ahead, sets a chord of the
/// screens' front 60 degrees. Call it once all walls are set.
void settlePanel(const TomlTable& root, Rig& rig);

}  // namespace carom
