#include "app/scenario/scenario_tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "app/scenario/scenario_lesson.h"
#include "app/toml/toml_values.h"
#include "engine/base/limits.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

std::vector<ThrustLeg> readTour(const TomlTable& tour, double c_m_s) {
  std::vector<ThrustLeg> legs;
  const double most_m_s2 = strongestThrust_m_s2(c_m_s);
  double free_s = 0.0;  // end of the previous leg
  for (const TomlTable& table : tour.tables("leg")) {
    const ThrustLeg leg{.from_s = table.numberOr("from_s", free_s),
                        .for_s = table.number("for_s"),
                        .thrust_m_s2 = toVec3(table.numbers<3>("thrust_m_s2"))};
    if (leg.from_s < free_s) {
      table.fault("from_s", fmt::format("from_s is {}, expected a time after the leg before it, {} or above",
                                        leg.from_s, free_s));
    }
    if (const double thrust_m_s2 = glm::length(leg.thrust_m_s2);
        thrust_m_s2 > most_m_s2 * (1.0 + kTouching)) {
      table.fault(
          "thrust_m_s2",
          fmt::format("the thrust is {:.6g} m/s², expected {:.6g} at most: with more, light from {:.3g} m "
                      "behind would never catch up with the person",
                      thrust_m_s2, most_m_s2, c_m_s * c_m_s / most_m_s2));
    }
    free_s = std::max(free_s, leg.from_s + (table.has("for_s") ? leg.for_s : 0.0));
    legs.push_back(leg);
  }
  if (legs.empty()) tour.fault("leg", "there is no leg here, expected one [[tour.leg]] at least");
  return legs;
}

bool readTourAtOnce(const TomlTable& tour) { return tour.choice("starts") == 1; }

/// Checks the speed at the ends of the legs: along a leg of constant thrust |γβ| is largest at one of them.
void checkTourSpeed(const std::vector<ThrustLeg>& legs, const ObserverStart& start, const TomlTable& tour,
                    double c_m_s) {
  const glm::dquat facing = glm::angleAxis(start.facing_rad - std::numbers::pi / 2, Vec3(0.0, 0.0, 1.0));
  Lorentz boardFromRoom = Lorentz::boost(uFromBeta(start.beta), c_m_s) * Lorentz::rotation(facing, c_m_s);
  const double most_u = std::max(kMostPlatformU, glm::length(boardFromRoom.u()));
  const std::vector<TomlTable> tables = tour.tables("leg");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    boardFromRoom =
        boardFromRoom * Lorentz::fromRapidity(legs[i].thrust_m_s2 * (legs[i].for_s / c_m_s), c_m_s);
    if (glm::length(boardFromRoom.u()) <= most_u) continue;
    tables[i].fault("for_s",
                    fmt::format("after this leg the platform is faster than {:.4g} of light's speed, "
                                "expected slower: the game would have to run more than {:.0f} s in "
                                "one of the person's",
                                most_u / std::hypot(1.0, most_u), std::hypot(1.0, most_u)));
    return;
  }
}

std::vector<Caption> readCaptions(const TomlTable& root) {
  std::vector<Caption> captions;
  double free_s = 0.0;  // end of the previous caption
  for (const TomlTable& table : root.tables("caption")) {
    Caption caption{.from_s = table.numberOr("from_s", free_s),
                    .for_s = table.number("for_s"),
                    .text = readWords(table, "text"),
                    .handText = {},
                    .views = readViews(table),
                    .colour = table.flag("colour")};
    caption.handText = table.has("hand_text") ? readWords(table, "hand_text") : caption.text;
    if (caption.from_s < free_s) {
      table.fault("from_s",
                  fmt::format("from_s is {}, expected a time after the caption before it, {} or above",
                              caption.from_s, free_s));
    }
    free_s = caption.from_s + (table.has("for_s") ? caption.for_s : 0.0);
    captions.push_back(caption);
  }
  return captions;
}

}  // namespace carom
