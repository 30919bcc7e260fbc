#pragma once
// Files of measured screens: where in the room each place of a window is.

#include <filesystem>
#include <variant>

#include "cave/screen/measured_screen.h"
#include "cave/screen/screen_grid.h"
#include "cave/screen/screen_mesh.h"

namespace carom {

/// The places of a screen as a file gives them, in the file's unit and axes.
using MeasuredPlaces = std::variant<ScreenMesh, ScreenGrid>;

/// Points of a mesh or grid, at most: a window of 4096 × 2160 pixels has nine millions.
inline constexpr std::size_t kMostMeshPoints = 1'000'000, kMostGridPoints = 10'000'000;

/// Wavefront OBJ (InputKind::screenMesh): `v` x y z are places of the screen, `vt` places in the window, 0 to
/// 1 from its lower left; each corner of a face has both. Throws std::runtime_error, "LINE:COLUMN: …", also
/// for NaN, a place outside the window, and fewer than two triangles.
ScreenMesh parseObjScreen(std::string_view content);

/// PFM (InputKind::screenGrid): x y z of the screen at the middles of the cells of a grid over the window; a
/// number that is NaN or infinite: none. `rows`: whether the first row of the file is the window's lowest, as
/// in the MPCDI format and in pictures of this kind, or its uppermost.
ScreenGrid parsePfmScreen(std::string_view content, GridRows rows);

/// Returns the places in the file of a screen, which ends in .obj, or in .pfm or .vwf. Throws
/// std::runtime_error, "FILE:LINE:COLUMN: what is wrong, what was expected".
MeasuredPlaces readScreenFile(const MeasuredScreen& screen);

/// Returns whether a file ends in .vwf and has a blend.
bool hasBlend(const std::filesystem::path& file);

}  // namespace carom
