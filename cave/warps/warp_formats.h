#pragma once
// Files of calibration programs that bend a flat picture to a screen. None is trusted: each reader throws
// std::runtime_error, "LINE:COLUMN: what is wrong, what was expected" (of bytes "1:1: …, at byte N"), and
// every number must be finite and within 16 windows or pictures of their corner.

#include <string_view>

#include <glm/vec2.hpp>

#include "cave/room/warp_mesh.h"

namespace carom {

/// Wavefront OBJ as SGCT reads it (sgct/src/correction/obj.cpp, SGCT 4), the same for both eyes: `v x y` is a
/// place in the window, from -1, -1 in its lower left to 1, 1; `vt s t` with the same number is its place in
/// the picture, 0 to 1; `f` is a convex polygon of such numbers.
Warp parseObjWarp(std::string_view content);

/// PFM as SGCT reads it (sgct/src/correction/pfm.cpp, SGCT 4): a grid over the picture, row by row from its
/// top; its left half belongs to the left eye, its right half to the right eye. Point (column, row) of an
/// eye's columns × rows is at (column + 0.5) / columns, 1 - (row + 0.5) / rows in the picture; its floats are
/// the place in the window, x to the right and y upwards, 0 to 1, and one that is not used.
Warp parsePfmWarp(std::string_view content);

/// domeprojection's mesh, `x;y;u;v;column;row`: x, y in the window and u, v in the picture, 0 to 1 from the
/// upper left. Its frustum, the other kind of its files, is refused by name.
Warp parseCsvWarp(std::string_view content);

/// SimCAD's GeometryFile: the offsets of a square grid over the picture, row by row from its top, as numbers
/// of a range that stands for the window's width or height, x to the right and y downwards.
Warp parseSimcadWarp(std::string_view content);

/// SCISS .sgc: its vertices are x, y in the window from the upper left, and u, v in the picture from the
/// lower left. Version 1 has a grid, version 2 a list or a strip of triangles.
Warp parseSgcWarp(std::string_view content);

/// Paul Bourke's mesh for spherical mirrors (http://paulbourke.net/dataformats/meshwarp/): a kind, columns
/// and rows, then x y u v i: x from -aspect to aspect of the window, y from -1 to 1, u, v in the picture, 0
/// to 1 from the lower left, and the share of light, below 0 where nothing is drawn.
Warp parseBourkeWarp(std::string_view content, const glm::ivec2& window_px);

}  // namespace carom
