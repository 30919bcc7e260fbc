#include <array>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

std::size_t countOf(MeshLines& lines, std::size_t least, std::size_t most, std::string_view what) {
  const std::string_view text = lines.word();
  const auto count = countIn(text);
  if (!count || *count < least || *count > most)
    lines.wrong(text, fmt::format("{}, a whole number from {} to {}", what, least, most));
  return *count;
}

}  // namespace

Warp parseBourkeWarp(std::string_view content, const glm::ivec2& window_px) {
  constexpr std::size_t kMostKind = 5;
  constexpr std::size_t kShortest = 10;  // bytes of a line with five numbers
  const std::size_t most = (limitOf(InputKind::warp).most_MiB << 20U) / kShortest;
  MeshLines lines(content);
  const auto line = [&](std::string_view expected) {
    if (!lines.nextWithWords())
      meshFault(lines.lineNumber() + 1, 1, fmt::format("the file ends early, expected {}", expected));
  };
  line("the kind of picture");
  countOf(lines, 0, kMostKind, "the kind of picture");
  lines.endLine();
  line("columns and rows");
  const std::size_t columns = countOf(lines, 2, most, "columns"), rows = countOf(lines, 2, most, "rows");
  lines.endLine();
  const double aspect = static_cast<double>(window_px.x) / window_px.y;
  WarpMesh mesh;
  for (std::size_t i = 0; i < columns * rows; ++i) {
    line(fmt::format("{} × {} points, of which there are {}", columns, rows, i));
    std::array<double, 5> values{};
    for (double& value : values) value = lines.number(kFarthestInWindow);
    lines.endLine();
    mesh.points.push_back({.inWindow = glm::vec2(0.5 * (values[0] / aspect + 1.0), 0.5 * (values[1] + 1.0)),
                           .inPicture = glm::vec2(values[2], values[3]),
                           .light = static_cast<float>(values[4])});
  }
  if (lines.nextWithWords()) lines.wrong(lines.word(), "the end of the file");
  addGridTriangles(columns, rows, mesh);
  if (mesh.triangles.empty()) meshFault(2, 1, "no cell has light, expected one at least");
  return {mesh, mesh};
}

}  // namespace carom
