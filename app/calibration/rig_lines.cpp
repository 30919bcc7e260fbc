#include "app/calibration/rig_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace carom {
namespace {

/// Returns the number without zeros at its end.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

}  // namespace

/// The matrix of Rz(c) Ry(b) Rx(a) has -sin b in its last row's first place, cos b sin a and cos b cos a
/// behind it, and cos b sin c below cos b cos c in its first column.
glm::dvec3 rotation_deg(const glm::dquat& rotation) {
  const glm::dmat3 m = glm::mat3_cast(rotation);  // m[column][row]
  const double b = std::asin(std::clamp(-m[0][2], -1.0, 1.0));
  if (std::hypot(m[0][0], m[0][1]) < 1e-9) {  // x points along z: only a combination of a and c counts
    return glm::degrees(glm::dvec3(std::atan2(-m[2][1], m[1][1]), b, 0.0));
  }
  return glm::degrees(glm::dvec3(std::atan2(m[1][2], m[2][2]), b, std::atan2(m[0][1], m[0][0])));
}

std::string lengthText(double length_m, double unit_m) {
  const int decimals = std::max(1, static_cast<int>(std::ceil(5.0 + std::log10(unit_m))));
  return trimmed(fmt::format("{:.{}f}", length_m / unit_m, decimals));
}

std::string poseLine(std::string_view key, const Pose& pose, double unit_m) {
  const glm::dvec3& t = pose.position_m;
  const glm::dvec3 turn_deg = rotation_deg(pose.orientation);
  const auto degrees = [](double value) { return trimmed(fmt::format("{:.3f}", value)); };
  return fmt::format("{} = {{ translation = [{}, {}, {}], rotation_deg = [{}, {}, {}] }}", key,
                     lengthText(t.x, unit_m), lengthText(t.y, unit_m), lengthText(t.z, unit_m),
                     degrees(turn_deg.x), degrees(turn_deg.y), degrees(turn_deg.z));
}

std::string directionWords(const glm::dquat& roomFromTracker, const RoomAxes& axes) {
  struct Direction {
    std::string_view words;
    glm::dvec3 at;
  };
  const std::array<Direction, 6> directions{{{"to the right", axes.right},
                                             {"to the left", -axes.right},
                                             {"up", axes.up},
                                             {"down", -axes.up},
                                             {"ahead", axes.forward},
                                             {"back", -axes.forward}}};
  std::string words;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    const glm::dvec3 points = roomFromTracker * unit;
    const auto nearest =
        std::max_element(directions.begin(), directions.end(), [&](const Direction& a, const Direction& b) {
          return glm::dot(a.at, points) < glm::dot(b.at, points);
        });
    const double off_deg =
        glm::degrees(std::atan2(glm::length(glm::cross(nearest->at, points)), glm::dot(nearest->at, points)));
    words += fmt::format("{}{} {} ({:.1f} degrees off)", axis == 0 ? "" : ", ", "xyz"[axis], nearest -> words,
                         off_deg);
  }
  return words;
}

}  // namespace carom
