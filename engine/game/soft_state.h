#pragma once
// The state of the soft pucks of a game at one board time, in SI units.
// Theory: app/doc/physics.md, Soft bodies.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/game/game_event.h"

namespace carom {

struct SoftPuckState {
  Vec2 position_m{0.0};  ///< of the centre of energy
  Vec2 beta{0.0};        ///< P c/E
  double restMass_kg = 0.0;
  double heat_j = 0.0;
  double elastic_j = 0.0;
  double spin_kg_m2_s = 0.0;
  double properTime_s = 0.0;  ///< of the material centre
  bool isAwake = false;
  std::optional<double> becameSoft_s{};  ///< board time; none: it was soft from the beginning
};

/// A collision of a soft puck with a cushion or with another soft one, which lasts.
struct SoftContactState {
  std::array<std::size_t, 2> pucks{};  ///< the same twice for a collision with a cushion
  std::optional<Cushion> cushion{};
  Event contact;                     ///< the first touch
  std::optional<double> parted_s{};  ///< none while they touch
  Vec2 impulse_kg_m_s{0.0};          ///< received by the first
  double heat_j = 0.0;               ///< of both
};

/// A place of a puck's matter, from the centre of the relaxed body.
struct SoftPoint {
  std::size_t puck = 0;
  Vec2 offset_m{0.0};
};

struct SoftPointState {
  Vec2 position_m{0.0};
  Vec2 beta{0.0};
  double properTime_s = 0.0;
};

struct SoftMoment {
  std::vector<std::optional<SoftPuckState>> pucks;    ///< in the order of the setup; none: still rigid
  std::vector<SoftContactState> contacts;             ///< in the order of the events
  std::vector<std::optional<SoftPointState>> points;  ///< as they were asked for; none: still rigid
};

/// A soft puck that could not be followed and went on in its mean motion.
struct FrozenPuck {
  std::size_t puck = 0;
  double t_s = 0.0;
};

}  // namespace carom
