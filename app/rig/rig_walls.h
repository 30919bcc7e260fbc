#pragma once
// Reads the walls of a rig file with their windows and projectors.

#include <glm/vec3.hpp>
#include <optional>

#include "app/file_keys/rig_keys.h"
#include "app/rig/rig.h"
#include "app/rig/rig_screen.h"
#include "app/toml/toml_file.h"

namespace carom {

/// A wall as given in the file, before its corners are checked.
struct WallText {
  TomlTable table;
  Wall wall;
  std::optional<glm::dvec3> upperRight_m;
  bool skewed = false;               ///< its four corners are no rectangle
  std::optional<ScreenText> screen;  ///< it is curved, and has no corners
};

/// Puts the rectangle around the screen into the place of the measured corners of a skewed wall. Call it once
/// all numbers have been read.
void straighten(WallText& text);

WallText readWall(const TomlFile& file, const TomlTable& table, const RoomAxes& axes, double unit_m,
                  bool hasOneWindow);

WindowPlacement readWindow(const TomlTable& table);

/// Returns the positions in the file of everything that is checked of a wall.
WallPlaces placesOf(const TomlTable& table);

}  // namespace carom
