#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"

namespace carom {
namespace {

constexpr std::string_view kColumns = "a mesh of domeprojection, which begins with x;y;u;v;column;row";

/// Reads the first line, with the names of the columns.
void readNames(MeshLines& lines) {
  if (!lines.nextWithWords()) meshFault(1, 1, fmt::format("there is no line, expected {}", kColumns));
  for (const std::string_view name : {"x", "y", "u", "v", "column", "row"}) {
    const std::string_view word = lines.word();
    if (word == name) continue;
    if (name == "u" && word == "z")
      meshFault(lines.lineNumber(), 1,
                fmt::format("this is the frustum of a projector, expected {}: the file beside it", kColumns));
    lines.wrong(word, std::string(kColumns));
  }
  lines.endLine();
}

/// Reads a column or row that must follow the last point's.
std::size_t indexOf(MeshLines& lines) {
  const std::string_view text = lines.word();
  const auto index = countIn(text);
  if (!index) lines.wrong(text, "a whole number from 0");
  return *index;
}

}  // namespace

Warp parseCsvWarp(std::string_view content) {
  MeshLines lines(content, " \t\r;");
  readNames(lines);
  WarpMesh mesh;
  std::size_t columns = 0;  // 0: not all of the first row has been read
  while (lines.nextWithWords()) {
    std::array<double, 4> values{};
    for (double& value : values) value = lines.number(kFarthestInWindow);
    const std::size_t column = indexOf(lines), row = indexOf(lines), at = mesh.points.size();
    if (columns == 0 && row == 1) columns = at;
    const std::size_t expectedColumn = columns == 0 ? at : at % columns,
                      expectedRow = columns == 0 ? 0 : at / columns;
    if (column != expectedColumn || row != expectedRow)
      meshFault(lines.lineNumber(), 1,
                fmt::format("the point is of column {}, row {}, expected column {}, row {}: row by row",
                            column, row, expectedColumn, expectedRow));
    lines.endLine();
    mesh.points.push_back({.inWindow = glm::vec2(values[0], 1.0 - values[1]),
                           .inPicture = glm::vec2(values[2], 1.0 - values[3])});
  }
  const std::size_t rows = columns == 0 ? 1 : mesh.points.size() / columns;
  if (columns < 2 || rows < 2 || mesh.points.size() != columns * rows)
    meshFault(lines.lineNumber() + 1, 1,
              fmt::format("there are {} points in rows of {}, expected two whole rows of two points at least",
                          mesh.points.size(), columns == 0 ? mesh.points.size() : columns));
  addGridTriangles(columns, rows, mesh);
  return {mesh, mesh};
}

}  // namespace carom
