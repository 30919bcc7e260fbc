#pragma once
// The heat of rigid pucks: which collisions heated each of them, by how much, and where these are for one
// eye. What a collision takes from the motion of pucks is heat (engine/collision/kick.h), and the puck is
// heavier until it has radiated it. The game reckons as if that took no time, and a puck keeps its nominal
// mass. The picture of it cools slowly, so that it can be seen: of the heat of a blow the share
//   exp(−s/(c T)),   s² = c² (t − t_blow)² − |r − r_blow|²,   T = kCooling_s
// is left in matter at (t, r), and none is there before the news of the blow, which travels at light speed.
// The interval s is the own time of matter that went straight from the blow to there.
// Theory: app/doc/physics.md, Kick.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "engine/game/game_event.h"
#include "engine/spacetime/event.h"

namespace carom {

/// The own time in which the share 1/e of a puck's heat is left.
inline constexpr double kCooling_s = 10.0;

/// Heat that can be seen: at 900 K, 10⁻⁴ as bright as white in the hall.
inline constexpr double kLeastGlow = 0.04;

/// The collisions that heated one body, as one eye has them.
struct HotBlows {
  using Places = std::array<glm::vec4, 4>;
  Places fromEye_m{};     ///< c (t − t_o), and the place from the eye, on the board
  glm::vec4 heats{0.0F};  ///< what each adds to M/m
};

/// Returns the heat of each of two pucks of these cold masses, in the unit of `heat`, the sum, over that of
/// the masses. A kick without friction of the rims adds the same to the squares of both masses: m₁'² − m₁² =
/// m₂'² − m₂² (engine/collision/kick.h), so that m₁' − m₂' = (m₁² − m₂²)/(m₁' + m₂'). With friction, and of
/// bodies with corners, it is shared as without.
std::array<double, 2> sharedHeat(double heat, const std::array<double, 2>& masses);

/// Follows a game from frame to frame; remembers the four blows of each body that have left the most heat,
/// also when the game has forgotten them.
class HotBodies {
 public:
  /// `coldMasses_kg`: of the pucks, bodies from kFirstPuck on (cave/frame/bodies.h), of `bodies` in all.
  HotBodies(std::span<const double> coldMasses_kg, std::size_t bodies, double lightSpeed_m_s);

  /// Takes the events of a frame, after those with the number `eventsKept` or a higher one have left the list
  /// and new ones have come.
  void follow(std::span<const GameEvent> events, std::uint64_t eventsKept);

  /// Returns the blows of every body, as an eye at `observation` has them; valid until the next call. A body
  /// that cannot be seen to glow has none.
  std::span<const HotBlows> seenFrom(const Event& observation);

 private:
  struct Blow {
    std::uint64_t number = 0;  ///< of the event
    Event at;
    double heat = 0.0;  ///< over m c²; 0: there is no blow
  };
  using Blows = std::array<Blow, 4>;
  void add(std::size_t puck, const Blow& blow);

  std::vector<double> coldMasses_kg_;
  double c_m_s_;
  std::vector<Blows> blows_;  // of each puck
  std::vector<HotBlows> seen_;
};

}  // namespace carom
