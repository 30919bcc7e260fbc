#pragma once
// The walls of a rig file, their windows and projectors.

#include <glm/vec3.hpp>
#include <optional>

#include "app/files/rig.h"
#include "app/files/toml_file.h"

namespace carom {

inline constexpr int kMostRanks = 4096;

/// A wall as the file gives it, before its corners are checked.
struct WallText {
  TomlTable table;
  Wall wall;
  std::optional<glm::dvec3> upperRight_m;
};

WallText readWall(const TomlFile& file, const TomlTable& table, double unit_m, bool hasOneWindow);

WindowPlacement readWindow(const TomlTable& table);

/// Where the file gives what is checked of a wall.
WallPlaces placesOf(const TomlTable& table);

}  // namespace carom
