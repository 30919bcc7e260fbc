#pragma once
// PFM, "PF": a grid with three floats a point, row by row.

#include <cstddef>
#include <string_view>

#include <glm/vec3.hpp>

namespace carom {

/// The grid of floats in a file, which must outlive it.
struct PfmGrid {
  std::size_t columns = 0, rows = 0;
  bool isBigEndian = false;
  std::string_view bytes;
  std::size_t at = 0;  ///< of `bytes` in the file

  /// Returns a point's numbers as they are, `row` counted in the order of the file.
  glm::vec3 point(std::size_t column, std::size_t row) const;
  /// Returns where in the file a number of a point begins.
  std::size_t byteOf(std::size_t column, std::size_t row, std::size_t part) const {
    return at + 12 * (row * columns + column) + 4 * part;
  }
};

/// Reads "PF", columns and rows, and the scale, on one line each, then the grid, which must end the file. A
/// negative scale means that floats are little-endian. There are two columns and two rows at least; with
/// `twoEyes` there are as many columns for each eye. At most `mostPoints` points. Throws std::runtime_error,
/// "LINE:COLUMN: …".
PfmGrid parsePfm(std::string_view content, bool twoEyes, std::size_t mostPoints);

}  // namespace carom
