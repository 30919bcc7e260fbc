#include "cave/mesh_files/screen_file.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/obj_file.h"
#include "cave/mesh_files/pfm_file.h"
#include "cave/mesh_files/vwf_file.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr double kFarthest = 1e9;  // in the file's unit

void requireCells(const ScreenGrid& grid) {
  if (hasCell(grid)) return;
  meshFault(1, 1,
            fmt::format("no four neighbours of the {} × {} points are on a screen, expected some",
                        grid.columns, grid.rows));
}

MeasuredPlaces parsed(const std::string& ending, const std::string& content, GridRows rows) {
  if (ending == ".obj") return parseObjScreen(content);
  if (ending == ".pfm") return parsePfmScreen(content, rows);
  VwfFile file = parseVwf(content);
  if (!file.isScreen)
    meshFault(
        1, 1,
        "the file has no screen (flag 0x40), only the warp of a flat picture, expected a screen: the key "
        "warp takes it");
  ScreenGrid grid = screenGridOf(std::move(file));
  requireCells(grid);
  return grid;
}

}  // namespace

ScreenMesh parseObjScreen(std::string_view content) {
  constexpr double kBesideWindow = 1e-6;  // of rounding in the file
  const ObjFile file = parseObj(content, {.coordinates = 3,
                                          .farthest = kFarthest,
                                          .farthestInPicture = 1.0 + kBesideWindow,
                                          .isPaired = false,
                                          .mostPoints = kMostMeshPoints});
  for (std::size_t i = 0; i < file.inPicture.size(); ++i) {
    const glm::dvec2& place = file.inPicture[i];
    if (place.x < -kBesideWindow || place.y < -kBesideWindow)
      meshFault(
          1, 1,
          fmt::format("vt {} is {:g} {:g}, outside the window, expected 0 to 1", i + 1, place.x, place.y));
  }
  ScreenMesh mesh;
  for (const auto& triangle : file.triangles) {
    ScreenTriangle& cell = mesh.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      cell[i] = {file.inPicture[triangle[i].inPicture], file.points[triangle[i].point]};
    if (windowArea(cell) == 0.0) mesh.pop_back();
  }
  if (mesh.size() < 2)
    meshFault(1, 1,
              fmt::format("the window shows {} triangle{}, expected two at least", mesh.size(),
                          mesh.size() == 1 ? "" : "s"));
  return mesh;
}

ScreenGrid parsePfmScreen(std::string_view content, GridRows rows) {
  const PfmGrid file = parsePfm(content, false, kMostGridPoints);
  if (file.columns * file.rows > kMostGridPoints)
    meshFault(2, 1,
              fmt::format("the grid has {} points, expected at most {}", file.columns * file.rows,
                          kMostGridPoints));
  ScreenGrid grid{static_cast<int>(file.columns), static_cast<int>(file.rows), {}};
  grid.places.reserve(file.columns * file.rows);
  for (std::size_t i = 0; i < file.rows; ++i) {
    const std::size_t row = rows == GridRows::fromBottom ? i : file.rows - 1 - i;
    for (std::size_t column = 0; column < file.columns; ++column) {
      const glm::vec3 point = file.point(column, row);
      const bool isThere = std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
      for (int part = 0; isThere && part < 3; ++part) {
        if (std::abs(point[part]) > kFarthest)
          meshFault(
              1, 1,
              fmt::format("point ({}, {}) has {:g}, at byte {}, expected a number from {:g} to {:g}", column,
                          row, point[part], file.byteOf(column, row, static_cast<std::size_t>(part)),
                          -kFarthest, kFarthest));
      }
      grid.places.push_back(isThere ? point : glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    }
  }
  requireCells(grid);
  return grid;
}

MeasuredPlaces readScreenFile(const MeasuredScreen& screen) {
  const std::string ending = screen.file.extension().string();
  const InputKind kind = ending == ".obj" ? InputKind::screenMesh : InputKind::screenGrid;
  try {
    if (screen.bytes) return parsed(ending, *screen.bytes, screen.rows);
    if (const std::string refusal = refusalOf(screen.file, kind); !refusal.empty()) meshFault(1, 1, refusal);
    return parsed(ending, contentOf(screen.file, kind), screen.rows);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(screen.file.string() + ":" + error.what());
  }
}

bool hasBlend(const std::filesystem::path& file) {
  if (file.extension() != ".vwf") return false;
  try {
    return !parseVwf(contentOf(file, InputKind::screenGrid)).blend.empty();
  } catch (const std::runtime_error&) {
    return false;  // readScreenFile or readWarp says why
  }
}

}  // namespace carom
