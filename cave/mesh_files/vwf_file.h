#pragma once
// VIOSO's .vwf: what each pixel of a window shows, a point of a screen or a place of a picture, and the light
// that it gives. Numbers are little-endian; the layout is that of VIOSOWarpBlend's headers.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/warp_mesh.h"
#include "cave/screen/screen_grid.h"

namespace carom {

struct VwfFile {
  int columns = 0, rows = 0;
  bool isScreen = false;  ///< its points are of a screen (flag 0x40); else of a picture
  /// From the window's top. Of a screen x, y, z in the file's unit; of a picture u, v from its upper left;
  /// NaN where there is none.
  std::vector<glm::vec3> points;
  /// Shares of light, RGB, 0 to 65535, from the window's bottom; empty: the file has none.
  glm::ivec2 blend_px{0};
  std::vector<std::uint16_t> blend;
};

/// Reads a file with one display, alone or in a container. Throws std::runtime_error, "1:1: …, at byte N",
/// for a file that is not as long as it says, for coordinates beyond 1e9, and for several displays.
VwfFile parseVwf(std::string_view content);

/// Returns a file's warp; throws std::runtime_error for a file with a screen, for places beyond 16 pictures,
/// and for a file without a cell.
Warp warpOf(const VwfFile& file);

/// Returns a file's screen.
ScreenGrid screenGridOf(VwfFile file);

/// Returns the bytes of a file with the places of a picture, in the order and from the corner of
/// VwfFile::points.
std::string vwfOf(const glm::ivec2& size, const std::vector<glm::vec2>& inPicture);

}  // namespace carom
