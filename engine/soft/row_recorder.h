#pragma once
// Makes the rows of one soft body (engine/soft/soft_history.h) from the steps of its simulation. c = 1,
// metres, board frame.
//
// A row is due where the straight way of a node since the last row would miss its place at a step in between
// by kOff, and after kLongest at the latest. Which velocities miss none so far is kept for each node as a
// rectangle that only shrinks (the "swinging door" of process recorders; Bristol 1990), so a step costs a few
// operations a node and no step is kept.
//
// The drawn place of a node is that of the simulation, unless it would have to outrun light to get there:
// where a rigid puck becomes soft while its rim still moves as before a bounce, and where a body is taken for
// relaxed at once. Then it goes there with kCatchUp of light speed.
//
// Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/soft/soft_body.h"
#include "engine/soft/soft_history.h"

namespace carom {

class RowRecorder {
 public:
  static constexpr double kOff = 1e-4;      ///< by which straight ways may miss a step
  static constexpr double kLongest = 0.02;  ///< from row to row while a body is awake
  static constexpr double kCatchUp = 0.95;  ///< of light speed

  /// Begins at a time with the places at which the nodes are drawn then. `number` stands in the rows.
  RowRecorder(std::size_t number, double time, std::vector<glm::dvec2> drawn, bool wasRigid);

  /// Takes the state of a body at a time, with its nodes at `places`, and adds a row to `to` if one is due.
  /// `isRelaxed`: it is asleep, and all nodes keep to their places in it.
  void take(double time, std::span<const glm::dvec2> places, const SoftBody& body, bool isRelaxed,
            SoftRows& to);
  /// Whether its last row says all that is to come until it wakes.
  bool isStill() const { return !lastNodes_.empty() && last_.isStill; }
  double time() const { return now_.time; }
  /// The last row, as it was added.
  const SoftRow& last() const { return last_; }
  std::span<const SoftNode> lastNodes() const { return lastNodes_; }

 private:
  struct Door {
    glm::dvec2 from{0.0}, least{0.0}, most{0.0};  ///< the place at the last row; velocities
  };
  /// The drawn nodes at a time.
  struct Step {
    double time = 0.0;
    std::vector<glm::dvec2> places, velocities;
  };
  /// Moves the drawn nodes; returns whether all are at their places.
  bool follow(double time, std::span<const glm::dvec2> places, const SoftBody& body);
  bool misses();
  void add(const Step& step, const SoftBody& body, bool isStill, SoftRows& to);

  SoftRow last_;  // before the first one: number, time and wasRigid
  std::vector<SoftNode> lastNodes_;
  Step now_, before_;
  std::vector<Door> doors_;
};

}  // namespace carom
