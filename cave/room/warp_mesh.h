#pragma once
// How a projector's picture is bent onto its screen: meshes from files, which are hostile until read. The two
// formats are read as SGCT reads its warping meshes (sgct/src/correction/obj.cpp and pfm.cpp, SGCT 4).

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// A point of the picture and where in the window it goes. Both from the lower left, 0 to 1.
struct WarpPoint {
  glm::vec2 inWindow{0.0F};
  glm::vec2 inPicture{0.0F};
};

/// Triangles of the window; in between, places in the picture are interpolated. Where triangles overlap, the
/// later one shows.
struct WarpMesh {
  std::vector<WarpPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points
};

/// A mesh for each eye. A wall with one picture has the mesh of the eye it shows; a mono wall, the left one.
struct Warp {
  WarpMesh left;
  WarpMesh right;
};

/// The picture fills the window.
Warp straightWarp();

/// Wavefront OBJ, the same for both eyes: `v x y` is a place in the window, from -1, -1 in its lower left to
/// 1, 1; `vt s t` with the same number is its place in the picture, 0 to 1; `f` a convex polygon of
/// such numbers.
/// PFM, "PF": a grid of three floats a point, row by row from the picture's top; its left half is the left
/// eye's, its right half the right eye's. Point (column, row) of an eye's columns × rows is at
/// (column + 0.5) / columns, 1 - (row + 0.5) / rows in the picture; its floats are the place in the window, x
/// to the right and y upwards, 0 to 1, and one that is not used. A negative scale in the header says that the
/// lowest byte of a float comes first.
/// Every number is finite and within 16 of the window's middle, in its own units; there is a triangle at
/// least. Throw std::runtime_error, "LINE:COLUMN: …" (bytes "1:1: …, at byte N" in a PFM's grid).
Warp parseObjWarp(std::string_view content);
Warp parsePfmWarp(std::string_view content);

/// The mesh in a file that ends in .obj or .pfm, at most 128 MiB. Throws std::runtime_error,
/// "FILE:LINE:COLUMN: what is wrong, what was expected".
Warp readWarp(const std::filesystem::path& file);

}  // namespace carom
