#pragma once
// Advances soft bodies that may touch one another, the cushions, or told bodies that hold them. c = 1,
// metres, board frame.
//
// A step is the midpoint rule, with contacts in both of its stages:
//     x += ½dt v;   π* = π + dt f(x, v), E* = E + dt (power at v), contacts;   v̄ = ½(v + v*);
//     π += dt f(x, v̄), E* = E + dt (power at v̄), contacts;
//     v̄ = ½(v + v');   E += dt (power at v̄);   v = v(π, E);   x += ½dt v
// A contact lets no node go farther in (restitution 0 of the single node); the body's own waves throw it
// back. A cushion takes momentum and no energy. Node i of one hull, inside the other's hull beside its edge
// (j, k) with the weights w of the nearest point and the edge's outward normal n, takes λ n while they
// approach, with
//     E_e = 1/(w_j²/E_j + w_k²/E_k)    V = (E_i v_i + E_e v_e)/(E_i + E_e)    λ = E_i (V − v_i)/(1 − V²)
// and the energies λ μ of it, μ the mean of the normal velocities at the beginning of the step and after all
// contacts, such that their sum is 0. Frictionless contact along the board-frame normal with the energy λ V
// is covariant. A node comes to stand as deep in the other body as it goes in a step, and teeth of this depth
// rub: so bodies near one another take kNearShare of the steps that they would take alone. Theory:
// app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "engine/soft/soft_body.h"

namespace carom {

/// A straight cushion, which soft bodies do not cross: the half plane normal · x <= offset is free.
struct SoftCushion {
  glm::dvec2 normal{1.0, 0.0};
  double offset = 0.0;
};

/// Nodes that a told body carries along: their velocity during the next steps.
struct HeldSide {
  std::size_t body = 0;
  std::vector<int> nodes;
  glm::dvec2 velocity{0.0};
};

/// What a body received from a cushion or from another body in a step.
struct SoftExchange {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::size_t body = 0;
  std::size_t other = kNone;  ///< the other body, of greater number
  std::size_t cushion = kNone;
  glm::dvec2 impulse{0.0};
  double since = 0.0;     ///< how long before the end of the step the first node got there, by its velocity
  glm::dvec2 place{0.0};  ///< of that node, on the surface
};

/// A step that cannot be followed, however short.
struct SoftStepFailure : std::runtime_error {
  explicit SoftStepFailure(std::size_t failed)
      : std::runtime_error("a soft body cannot be followed"), body(failed) {}
  std::size_t body;
};

class SoftGroup {
 public:
  /// `bodies` are the group's in the order of their names, and outlive it.
  SoftGroup(std::vector<SoftBody*> bodies, std::vector<SoftCushion> cushions)
      : bodies_(std::move(bodies)),
        cushions_(std::move(cushions)),
        impulses_(cushions_.size()),
        before_(bodies_.size()) {
    for (const SoftBody* body : bodies_) surveys_.push_back(body->survey());
  }

  /// Makes one step, of at most `most`. Returns its length. A step that cannot be followed, or in which a
  /// body's heat falls by a thousandth of its mass, is undone and tried again with half its length, down to a
  /// sixteenth; then throws SoftStepFailure.
  double step(double most);
  /// Steps until that much time has passed.
  void advance(double duration);

  std::vector<HeldSide>& held() { return held_; }
  /// Returns the momentum that the bodies have received from a cushion so far.
  const glm::dvec2& impulseOf(std::size_t cushion) const { return impulses_[cushion]; }
  /// Returns the energy and momentum that told bodies have given at the sides that they hold.
  const Vec21& givenByHolders() const { return given_; }
  /// Returns the exchanges of the last step.
  std::span<const SoftExchange> exchanges() const { return exchanges_; }
  /// Returns what the last step led to, and from what it started.
  const SoftSurvey& survey(std::size_t body) const { return surveys_[body]; }
  const SoftSurvey& surveyBefore(std::size_t body) const { return nextSurveys_[body]; }

 private:
  /// A node inside another body, and the nearest edge there.
  struct Touch {
    std::size_t body = 0, node = 0;
    std::size_t other = 0, edgeFrom = 0, edgeTo = 0;
    double shareFrom = 0.0, shareTo = 0.0;
    double depth = 0.0;
    glm::dvec2 normal{0.0};
    double impulse = 0.0;  // λ, of all passes of a stage
  };

  bool tryStep(double dt);
  SoftExchange& exchange(std::size_t body, std::size_t other, std::size_t cushion);
  void findTouches();
  void findTouches(std::size_t body, std::size_t other);
  void meetCushions(double dt, bool counts);
  bool meet(Touch& touch);
  void meetTouches(double dt, bool counts);
  void note(const Touch& touch, double dt);
  void giveEnergy(const Touch& touch);
  bool areNear(double reach) const;
  void hold(bool counts);
  void carryHeld();

  std::vector<SoftBody*> bodies_;
  std::vector<SoftCushion> cushions_;
  std::vector<glm::dvec2> impulses_;
  std::vector<HeldSide> held_;
  std::vector<Touch> touches_;
  std::vector<SoftBody::State> before_;  // the step that is made, to undo it
  std::vector<glm::dvec2> impulsesBefore_;
  Vec21 given_, givenBefore_;
  std::vector<SoftExchange> exchanges_;
  std::vector<SoftSurvey> surveys_, nextSurveys_;
  std::size_t failed_ = 0;  // the body that spoilt the last step tried
};

}  // namespace carom
