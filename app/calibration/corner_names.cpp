#include "app/calibration/corner_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace carom {
namespace {

constexpr double kOnePlace_m = 0.005;

struct WallCorner {
  std::string_view key;
  glm::dvec3 at_m;
};

std::array<WallCorner, 4> cornersOf(const Wall& wall) {
  if (wall.skewed) {
    const auto& at_m = wall.skewed->corners_m;
    return {{{"lower_left", at_m[0]},
             {"lower_right", at_m[1]},
             {"upper_left", at_m[2]},
             {"upper_right", at_m[3]}}};
  }
  return {{{"lower_left", wall.lowerLeft_m},
           {"lower_right", wall.lowerRight_m},
           {"upper_left", wall.upperLeft_m},
           {"upper_right", wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m}}};
}

bool isNamed(const NamedCorner& corner, std::string_view name) {
  return corner.name == name ||
         std::find(corner.aliases.begin(), corner.aliases.end(), name) != corner.aliases.end();
}

}  // namespace

std::vector<NamedCorner> cornersOf(const Rig& rig) {
  std::vector<NamedCorner> corners;
  for (const Wall& wall : rig.walls) {
    for (const WallCorner& corner : cornersOf(wall)) {
      std::string name = fmt::format("{}.{}", wall.name, corner.key);
      const auto known = std::find_if(corners.begin(), corners.end(), [&](const NamedCorner& other) {
        return glm::distance(other.at_m, corner.at_m) <= kOnePlace_m;
      });
      if (known == corners.end()) {
        corners.push_back({std::move(name), {}, corner.at_m, normalOf(wall)});
      } else {
        known->aliases.push_back(std::move(name));
      }
    }
  }
  return corners;
}

std::string wordsFor(const NamedCorner& corner) {
  const std::size_t dot = corner.name.rfind('.');
  std::string place = corner.name.substr(dot + 1);
  std::replace(place.begin(), place.end(), '_', ' ');
  return fmt::format("the {} corner of wall '{}'", place, corner.name.substr(0, dot));
}

std::vector<NamedCorner> chosenCorners(const std::vector<NamedCorner>& corners, std::string_view names) {
  std::vector<NamedCorner> chosen;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const std::string_view name = names.substr(begin, end - begin);
    begin = end + 1;
    const auto found = std::find_if(corners.begin(), corners.end(),
                                    [&](const NamedCorner& corner) { return isNamed(corner, name); });
    if (found == corners.end()) {
      std::vector<std::string> known;
      for (const NamedCorner& corner : corners) known.push_back(corner.name);
      throw std::invalid_argument(
          fmt::format("'{}' is no corner of this rig, expected one of {}", name, fmt::join(known, ", ")));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace carom
