#pragma once
// A screen whose places have been measured.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/pose.h"

namespace carom {

/// Where the first row of a grid in a file is in the window.
enum class GridRows : std::uint8_t { fromBottom, fromTop };

/// The file with the places, and how they stand in the room.
struct MeasuredScreen {
  std::filesystem::path file;
  std::shared_ptr<const std::string> bytes{};  ///< of a file that is not on the disk yet; null: it is
  bool isGrid = false;                         ///< else triangles
  GridRows rows = GridRows::fromBottom;
  double unit_m = 1.0;  ///< of the file's lengths
  Pose roomFromScreen{};
};

}  // namespace carom
