#pragma once
// The hall around the table: a box at rest on the board, centred on its origin.

#include <array>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace carom {

/// A lamp whose light is followed. Board frame.
struct FollowedLamp {
  glm::dvec3 place_m{0.0};
  double on_s = 0.0;      ///< board time at which it goes on
  glm::vec3 light{1.0F};  ///< linear, as many times a lamp of the hall's
};

/// The most lamps that a game can have.
inline constexpr std::size_t kMostLamps = 3;

/// Colours of the walls towards x, −x, y, −y, and of the ceiling (linear, the share reflected).
inline constexpr std::array<glm::vec3, 5> kHallColours{{{0.64F, 0.38F, 0.31F},
                                                        {0.40F, 0.57F, 0.42F},
                                                        {0.36F, 0.47F, 0.62F},
                                                        {0.62F, 0.56F, 0.36F},
                                                        {0.72F, 0.70F, 0.66F}}};

struct Hall {
  /// Instead of the lamps over the table; the hall's own light is then off.
  std::vector<FollowedLamp> lamps{};
  double floor_m = -0.75;
  glm::dvec3 size_m{14.0, 12.0, 5.0};  ///< at least; larger around a large table
};

/// Returns the size of the hall's floor around a table of this size: at least 5 m from the table to each
/// wall.
inline glm::dvec2 hallFloor_m(const glm::dvec2& table_m, const Hall& hall = {}) {
  constexpr double kAroundTable_m = 5.0;
  return glm::max(glm::dvec2(hall.size_m), table_m + 2.0 * kAroundTable_m);
}

/// Returns how far its walls towards x and y are from its middle, and the heights of its floor and ceiling.
inline glm::vec4 hallBounds_m(const Hall& hall) {
  return {0.5 * glm::dvec2(hall.size_m), hall.floor_m, hall.floor_m + hall.size_m.z};
}

}  // namespace carom
