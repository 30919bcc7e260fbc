#pragma once
// A table with three pucks on it, and all that a game on it delivered as text.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom::test {

inline constexpr double kRounding = 1e-12;  // metres, seconds: a thousand roundings of a table's coordinates

inline double gammaOf(const Vec2& beta) { return 1.0 / std::sqrt(1.0 - glm::dot(beta, beta)); }

inline BilliardSetup table(double length_m, double width_m) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{length_m, width_m};
  return setup;
}

inline BilliardSetup threePucks() {
  BilliardSetup setup = table(2.84, 1.42);
  setup.pucks = {{"white", 0.0305, 0.02, 0.2, {-0.9, 0.0}, {0.8, 0.01}},
                 {"yellow", 0.0305, 0.02, 0.2, {0.3, 0.1}, {0.0, 0.0}},
                 {"red", 0.0305, 0.02, 0.2, {0.6, -0.02}, {-0.3, 0.1}}};
  return setup;
}

/// Returns everything a game delivered, as text of all digits.
inline std::string transcript(const Billiard& billiard, const std::vector<Puck>& pucks) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    std::ostringstream line;
    line << std::hexfloat << pucks[i].name;
    for (const Knot& k : billiard.worldLines()[i].knots()) {
      line << ' ' << k.turn.t_s << ' ' << k.turn.r_m.x << ' ' << k.turn.r_m.y << ' ' << k.u.x << ' ' << k.u.y
           << ' ' << k.properTime_s << ' ' << k.signal.t_s << ' ' << k.signal.r_m.x << ' ' << k.signal.r_m.y;
    }
    lines.push_back(line.str());
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines) all += line + '\n';
  return all;
}

}  // namespace carom::test
