#pragma once
// The moments at which the far sides of soft bodies hear of a push. c = 1, metres, board frame.
//
// A push on one side of a body is news to the other: until the wave has crossed the body, the far side goes
// on as if nothing had happened. The far side is the node of the rim that is farthest in the direction of the
// push. It has heard when its velocity differs by a tenth of the push's speed from the one it had when the
// push began; the front of the wave is as steep as a triangle is long, so this is the arrival to within one.
// In a body that still rings from an earlier push the ringing counts, too. Theory: app/doc/physics.md, Soft
// bodies.

#include <cstddef>
#include <vector>

#include "engine/soft/soft_body.h"

namespace carom {

class FarSides {
 public:
  /// A far side that has heard.
  struct Heard {
    std::size_t body = 0;
    Vec21 event;  ///< the node's, at the end of the step in which it did
  };

  /// Notes that a body is pushed: in a direction, and as fast as `speed`.
  void push(std::size_t number, const SoftBody& body, const glm::dvec2& direction, double speed);
  /// Looks at a body after a step, and adds those of its far sides that have heard.
  void look(std::size_t number, const SoftBody& body, double time, std::vector<Heard>& heard);
  /// Takes a body for undisturbed: it has fallen asleep.
  void forget(std::size_t number);

 private:
  struct Waiting {
    std::size_t body = 0, node = 0;
    glm::dvec2 before{0.0};
    double change = 0.0;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace carom
