#pragma once
// Reads the curved screens and the pictures by direction of a rig file, and the board that carries words
// where no flat wall does.

#include <optional>
#include <string>
#include <variant>

#include "app/rig/rig.h"
#include "app/toml/toml_file.h"
#include "cave/room/sky_eyes.h"
#include "cave/screen/measured_screen.h"
#include "cave/screen/screen_shape.h"
#include "cave/screen/sky_screen.h"

namespace carom {

inline constexpr double kUsualSagitta_m = 0.1;

/// A picture by direction, and whose eyes see it.
struct SkyText {
  Sky sky;
  SkyEyes eyes;
};

/// What a screen is made of: its formula, or the file with its places.
using ScreenFormula = std::variant<CylinderScreen, DomeScreen, SkyText, MeasuredScreen>;

/// A curved screen or a picture by direction as given in the file, before it is divided into flat pieces.
struct ScreenText {
  ScreenFormula shape;
  double texelsPerPixel = 1.25;
  double sagitta_m = kUsualSagitta_m;

  bool isSky() const { return std::holds_alternative<SkyText>(shape); }
};

/// Returns the least depth of flat pieces that a shape can be drawn on, and kUsualSagitta_m at least: for a
/// rig that is made of another program's file.
double sagittaFor_m(const ScreenFormula& shape);

/// Returns the direction from which a cylinder's angles count: forward at a right angle to its axis, or the
/// room's right where the axis points forward.
glm::dvec3 aheadOf(const glm::dvec3& axis, const RoomAxes& axes);

/// Reads the `screen` or `sky` of a wall, or none; `file` is the one that has it.
std::optional<ScreenText> readScreen(const TomlFile& file, const TomlTable& wallTable, const RoomAxes& axes,
                                     double unit_m);

/// Why a wall may not have a screen.
struct ScreenFault {
  bool isOfFile = false;  ///< of the file with its places; else of its facet_sagitta
  std::string what;
};

/// Sets the screen of a wall, whose corners become three of the screen's places. Call it once the wall has
/// its pixels and all numbers are sound. Returns why a rig may not have it: it takes more than kMostPieces
/// flat pieces, or its file cannot be read or drawn; then the wall stays flat.
std::optional<ScreenFault> curve(const ScreenText& text, const RoomAxes& axes, Wall& wall);

/// Records why a wall may not have its screen.
void refuseScreen(const ScreenFault& fault, const TomlTable& wallTable);

/// Returns the board that a rig's `[panel]` describes, or none.
std::optional<Wall> readPanel(const TomlTable& root, double unit_m);

/// Checks the board of a rig's `[panel]`. Without one, where no flat wall stands ahead, sets a chord of the
/// screens' front 60 degrees. Call it once all walls are set.
void settlePanel(const TomlTable& root, Rig& rig);

}  // namespace carom
