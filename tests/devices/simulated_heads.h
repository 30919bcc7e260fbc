#pragma once
// Heads of closed form whose true velocity is known: walking, swaying, turning, reaching.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "devices/recorded_head.h"

namespace carom {

/// A movement from rest to rest. Its course has the least mean jerk, as measured for arms and heads (Flash
/// and Hogan 1985): the share 10u³ − 15u⁴ + 6u⁵ of the way after the share u of the time.
struct Movement {
  double begin_s = 0.0, lasts_s = 1.0;
  glm::dvec3 way{0.0};

  glm::dvec3 after(double time_s) const {
    const double u = std::clamp((time_s - begin_s) / lasts_s, 0.0, 1.0);
    return u * u * u * (10.0 - u * (15.0 - 6.0 * u)) * way;
  }
};

struct SimulatedHead {
  std::string name;
  Path path;
};

namespace simulated_heads {

using Course = std::function<glm::dvec3(double time_s)>;
inline constexpr double kLasts_s = 60.0;

inline glm::dvec3 sumOf(const std::vector<Movement>& movements, double time_s) {
  glm::dvec3 sum(0.0);
  for (const Movement& movement : movements) sum += movement.after(time_s);
  return sum;
}

/// Postural sway: sines of 0.15 to 1.2 Hz, the slower the larger.
inline Course swaying(std::mt19937_64& random, double size_m) {
  struct Wave {
    glm::dvec3 size_m;
    double turns_hz, phase;
  };
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Wave> waves;
  for (const double turns_hz : {0.15, 0.23, 0.37, 0.55, 0.8, 1.2}) {
    const double x = uniform(random), y = uniform(random), z = uniform(random), phase = uniform(random);
    waves.push_back(
        {size_m * 0.3 / turns_hz * glm::dvec3(x, 0.15 * y, z), turns_hz, std::numbers::pi * phase});
  }
  return [waves](double time_s) {
    glm::dvec3 sum(0.0);
    for (const Wave& wave : waves)
      sum += std::sin(2.0 * std::numbers::pi * wave.turns_hz * time_s + wave.phase) * wave.size_m;
    return sum;
  };
}

/// Walks of 1 to 2.5 m with halts between. The head rises and falls by 2 cm at each step, and leans to the
/// side at every other (Hirasaki et al. 1999).
inline Course walking(std::mt19937_64& random, double speed_m_s, double steps_hz) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Movement> walks, going;
  glm::dvec3 place(0.0);
  for (double begin_s = 2.0; begin_s < kLasts_s;) {
    const double angle = 2.0 * std::numbers::pi * uniform(random), length_m = 1.0 + 1.5 * uniform(random);
    const double lasts_s = 1.875 * length_m / speed_m_s;  // whose quickest moment has this speed
    const glm::dvec3 way = length_m * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
    walks.push_back({begin_s, lasts_s, way});
    going.push_back({begin_s, 0.25 * lasts_s, glm::dvec3(1.0)});
    going.push_back({begin_s + 0.75 * lasts_s, 0.25 * lasts_s, glm::dvec3(-1.0)});
    begin_s += lasts_s + 0.5 + 1.5 * uniform(random);
  }
  const Course sway = swaying(random, 0.01);
  return [=](double time_s) {
    const double turn = 2.0 * std::numbers::pi * steps_hz * time_s, share = sumOf(going, time_s).x;
    const glm::dvec3 bob(0.015 * std::sin(0.5 * turn), 0.02 * std::sin(turn), 0.004 * std::sin(turn + 1.0));
    return sumOf(walks, time_s) + share * bob + sway(time_s);
  };
}

/// Looks about: the eyes turn about the neck, 12 cm behind and 8 cm below them, by 20 to 90° and back.
inline Course turning(std::mt19937_64& random, double quickest_rad_s) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Movement> turns;
  glm::dvec3 gaze_rad(0.0);
  for (double begin_s = 1.0; begin_s < kLasts_s;) {
    const glm::dvec3 next_rad(2.4 * uniform(random) - 1.2, 0.8 * uniform(random) - 0.4, 0.0);
    const double most_rad = std::max(std::abs(next_rad.x - gaze_rad.x), 0.3);
    const double lasts_s = std::max(0.3, 1.875 * most_rad / quickest_rad_s);
    turns.push_back({begin_s, lasts_s, next_rad - gaze_rad});
    gaze_rad = next_rad;
    begin_s += lasts_s + 0.2 + 1.2 * uniform(random);
  }
  const Course sway = swaying(random, 0.006);
  return [=](double time_s) {
    const glm::dvec3 at_rad = sumOf(turns, time_s);
    const double yaw = at_rad.x, pitch = at_rad.y;
    const double ahead_m = 0.12 * std::cos(pitch) - 0.08 * std::sin(pitch);
    const double up_m = 0.12 * std::sin(pitch) + 0.08 * std::cos(pitch);
    return glm::dvec3(-std::sin(yaw) * ahead_m, up_m, -std::cos(yaw) * ahead_m) + sway(time_s);
  };
}

/// Leans over to reach for something, 15 to 45 cm far, stays, and comes back.
inline Course reaching(std::mt19937_64& random, double quickest_m_s) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Movement> leans;
  for (double begin_s = 1.5; begin_s < kLasts_s;) {
    const double angle = 2.0 * std::numbers::pi * uniform(random), far_m = 0.15 + 0.3 * uniform(random);
    const glm::dvec3 way = far_m * glm::dvec3(std::cos(angle), -0.4 * uniform(random), std::sin(angle));
    const double lasts_s = 1.875 * far_m / quickest_m_s;
    leans.push_back({begin_s, lasts_s, way});
    begin_s += lasts_s + 0.2 + 0.8 * uniform(random);
    leans.push_back({begin_s, 1.2 * lasts_s, -way});
    begin_s += 1.2 * lasts_s + 0.4 + 1.2 * uniform(random);
  }
  const Course sway = swaying(random, 0.008);
  return [=](double time_s) { return sumOf(leans, time_s) + sway(time_s); };
}

inline Path sampled(const Course& course, double rate_hz) {
  constexpr double kStep_s = 1e-4;
  Path path;
  for (int i = 0; i < static_cast<int>(kLasts_s * rate_hz); ++i) {
    const double time_s = i / rate_hz;
    path.times_s.push_back(time_s);
    path.positions_m.push_back(course(time_s) + glm::dvec3(0.2, 1.7, -0.3));
    path.velocities_m_s.push_back((course(time_s + kStep_s) - course(time_s - kStep_s)) / (2.0 * kStep_s));
  }
  return path;
}

}  // namespace simulated_heads

/// Eleven heads, a minute each.
inline std::vector<SimulatedHead> simulatedHeads(double rate_hz) {
  using namespace simulated_heads;
  std::mt19937_64 random(2026);
  const std::vector<std::pair<const char*, Course>> courses = {
      {"walks at 0.5 m/s", walking(random, 0.5, 1.5)}, {"walks at 0.9 m/s", walking(random, 0.9, 1.8)},
      {"walks at 1.3 m/s", walking(random, 1.3, 2.0)}, {"walks at 1.7 m/s", walking(random, 1.7, 2.2)},
      {"sways by 1 cm", swaying(random, 0.01)},        {"sways by 4 cm", swaying(random, 0.04)},
      {"turns at 60 deg/s", turning(random, 1.0)},     {"turns at 140 deg/s", turning(random, 2.5)},
      {"turns at 230 deg/s", turning(random, 4.0)},    {"reaches at 0.4 m/s", reaching(random, 0.4)},
      {"reaches at 0.8 m/s", reaching(random, 0.8)}};
  std::vector<SimulatedHead> heads;
  for (const auto& [name, course] : courses) heads.push_back({name, sampled(course, rate_hz)});
  return heads;
}

}  // namespace carom
