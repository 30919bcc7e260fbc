#include "engine/soft/far_sides.h"

#include <limits>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kShare = 0.1;  // of the push's speed

/// Returns the node of the hull that is farthest in a direction; of several, the one nearest to the middle.
std::size_t farthest(const SoftBody& body, const glm::dvec2& direction) {
  constexpr double kAside = 1e-3;  // how much being aside counts
  const glm::dvec2 centre = body.centre(), across(-direction.y, direction.x);
  std::size_t found = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (const int node : body.mesh().hull()) {
    const glm::dvec2 place = body.place(static_cast<std::size_t>(node)) - centre;
    const double far = glm::dot(place, direction) - kAside * std::abs(glm::dot(place, across));
    if (far > most) most = far, found = static_cast<std::size_t>(node);
  }
  return found;
}

}  // namespace

void FarSides::push(std::size_t number, const SoftBody& body, const glm::dvec2& direction, double speed) {
  const std::size_t node = farthest(body, direction);
  waiting_.push_back({number, node, body.velocity(node), kShare * speed});
}

void FarSides::look(std::size_t number, const SoftBody& body, double time, std::vector<Heard>& heard) {
  std::erase_if(waiting_, [&](const Waiting& one) {
    if (one.body != number || glm::distance(body.velocity(one.node), one.before) < one.change) return false;
    const glm::dvec2 place = body.place(one.node);
    heard.push_back({number, {time, place.x, place.y}});
    return true;
  });
}

void FarSides::forget(std::size_t number) {
  std::erase_if(waiting_, [number](const Waiting& one) { return one.body == number; });
}

}  // namespace carom
