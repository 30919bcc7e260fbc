#include "cave/mesh_files/measured.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/mesh_files/screen_file.h"
#include "cave/screen/mesh_faults.h"
#include "cave/screen/screen_facts.h"

namespace carom {
namespace {

void putInRoom(ScreenMesh& mesh, const MeasuredScreen& measured) {
  for (ScreenTriangle& triangle : mesh) {
    for (ScreenPoint& point : triangle)
      point.inRoom_m = measured.roomFromScreen * (measured.unit_m * point.inRoom_m);
  }
}

void putInRoom(ScreenGrid& grid, const MeasuredScreen& measured) {
  for (glm::vec3& place : grid.places)
    place = glm::vec3(measured.roomFromScreen * (measured.unit_m * glm::dvec3(place)));
}

std::vector<glm::dvec3> placesOf(const ScreenMesh& mesh) {
  std::vector<glm::dvec3> places;
  for (const ScreenTriangle& triangle : mesh)
    for (const ScreenPoint& point : triangle) places.push_back(point.inRoom_m);
  return places;
}

std::vector<glm::dvec3> placesOf(const ScreenGrid& grid) {
  constexpr std::size_t kEnough = 10'000;  // to tell where the screen is
  const std::size_t step = std::max<std::size_t>(1, grid.places.size() / kEnough);
  std::vector<glm::dvec3> places;
  for (std::size_t i = 0; i < grid.places.size(); i += step)
    if (!std::isnan(grid.places[i].x)) places.emplace_back(grid.places[i]);
  return places;
}

/// As facingOf of a screen's triangles, from the cells of a grid.
glm::dvec3 facingOf(const ScreenGrid& grid) {
  glm::dvec3 area(0.0);
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const glm::dvec3 here(grid.at(column, row));
      const glm::dvec3 cell = glm::cross(glm::dvec3(grid.at(column + 1, row)) - here,
                                         glm::dvec3(grid.at(column, row + 1)) - here);
      if (!std::isnan(cell.x)) area += cell;
    }
  }
  return area;
}

/// Returns the place at the middle of the window; NaN: there is no screen.
glm::dvec3 centralOf(const ScreenMesh& mesh) {
  return inRoom_m(mesh, glm::dvec2(0.5)).value_or(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
}

glm::dvec3 centralOf(const ScreenGrid& grid) { return glm::dvec3(grid.at(grid.columns / 2, grid.rows / 2)); }

/// Returns places where eyes may be before a screen: where people stand, if that is on the side to which it
/// faces, or if it bends round them, mirrored as for projection from behind; else on the side to which it
/// faces.
template <class Measured>
std::vector<glm::dvec3> eyesBefore(const Measured& screen, const MeasuredWishes& wishes) {
  const std::vector<glm::dvec3> places = placesOf(screen);
  const glm::dvec3 facing = facingOf(screen);
  glm::dvec3 middle_m(0.0);
  if (places.empty()) return eyesAround(wishes.eyes_m * wishes.up, wishes.up, wishes.reach_m);
  for (const glm::dvec3& place : places) middle_m += place / static_cast<double>(places.size());
  double width_m = 0.0;
  for (const glm::dvec3& place : places) width_m = std::max(width_m, glm::distance(place, middle_m));
  glm::dvec3 eyes_m = wishes.eyes_m * wishes.up;
  const auto nearest_m = [&] {
    double least_m = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& place : places) least_m = std::min(least_m, glm::distance(place, eyes_m));
    return least_m;
  };
  constexpr double kNearest_m = 0.3;
  const bool isBefore = (glm::dot(eyes_m - middle_m, facing) > 0.0 ||
                         bendsRound(centralOf(screen) - middle_m, eyes_m - middle_m, facing)) &&
                        nearest_m() > kNearest_m;
  if (!isBefore && glm::length(facing) > 0.0)
    eyes_m = middle_m + std::max(1.0, width_m) * glm::normalize(facing);
  return eyesAround(eyes_m, wishes.up, std::min(wishes.reach_m, 0.5 * nearest_m()));
}

/// A screen's triangles, and for which eyes they are made.
struct Made {
  ScreenMesh mesh;
  std::vector<glm::dvec3> eyes_m;
};

Made madeOf(ScreenMesh mesh, const MeasuredScreen& measured, const MeasuredWishes& wishes) {
  putInRoom(mesh, measured);
  const std::string large = largeCellIn(mesh);
  if (!large.empty()) throw std::runtime_error(large);
  std::vector<glm::dvec3> eyes_m = eyesBefore(mesh, wishes);
  return {std::move(mesh), std::move(eyes_m)};
}

Made madeOf(ScreenGrid grid, const MeasuredScreen& measured, const MeasuredWishes& wishes) {
  putInRoom(grid, measured);
  const std::string large = largeCellIn(grid);
  if (!large.empty()) throw std::runtime_error(large);
  std::vector<glm::dvec3> eyes_m = eyesBefore(grid, wishes);
  ScreenMesh mesh = meshOf(grid, wishes.window_px, eyes_m).mesh;
  if (mesh.empty())
    throw std::runtime_error("the grid is too ragged or rough to be drawn, expected a smoother one");
  return {std::move(mesh), std::move(eyes_m)};
}

}  // namespace

CurvedScreen screenOf(const MeasuredScreen& measured, const MeasuredWishes& wishes) {
  MeasuredPlaces places = readScreenFile(measured);
  try {
    Made made = std::visit([&](auto& given) { return madeOf(std::move(given), measured, wishes); }, places);
    const std::string fold = foldIn(made.mesh);
    if (!fold.empty()) throw std::runtime_error(fold);
    CurvedScreen screen = curvedScreen(
        std::move(made.mesh), {wishes.window_px, wishes.texelsPerPixel, wishes.sagitta_m, made.eyes_m});
    screen.shape = measured;
    return screen;
  } catch (const std::runtime_error& fault) {
    throw std::runtime_error(fmt::format("{}:1:1: {}", measured.file.string(), fault.what()));
  }
}

}  // namespace carom
