#include "engine/soft/row_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMoved = 0.9995;   // a node that came faster than this was not moved by the simulation
constexpr double kDoorShare = 0.7;  // a door allows a square of places: 1/√2, and rounding

std::int16_t rounded(double value, double unit) {
  const double most = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(value / unit, -most, most)));
}

}  // namespace

RowRecorder::RowRecorder(std::size_t number, double time, std::vector<glm::dvec2> drawn, bool wasRigid)
    : now_{time, std::move(drawn), {}} {
  last_.body = number;
  last_.time = time;
  last_.wasRigid = wasRigid ? 1 : 0;
  now_.velocities.resize(now_.places.size());
  doors_.resize(now_.places.size());
}

bool RowRecorder::follow(double time, std::span<const glm::dvec2> places, const SoftBody& body) {
  std::swap(now_, before_);
  now_.places.resize(places.size());
  now_.velocities.resize(places.size());
  now_.time = time;
  const double step = time - before_.time;
  constexpr double kSame = 1e-12;
  bool areThere = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 way = places[i] - before_.places[i];
    const double length = glm::length(way);
    const bool isThere = length <= kMoved * step || length <= kSame;
    now_.places[i] = isThere ? places[i] : before_.places[i] + way * (kCatchUp * step / length);
    now_.velocities[i] = body.velocity(i);
    areThere = areThere && isThere;
  }
  return areThere;
}

// The velocity v since the last row misses no step if |x_r + v (t − t_r) − x(t)| ≤ off at all t.
bool RowRecorder::misses() {
  const double per = 1.0 / (now_.time - last_.time), off = kDoorShare * kOff * per;
  bool misses = false;
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    Door& door = doors_[i];
    const glm::dvec2 v = (now_.places[i] - door.from) * per;
    misses = misses || v.x < door.least.x || v.y < door.least.y || v.x > door.most.x || v.y > door.most.y;
    door.least = glm::max(door.least, v - off);
    door.most = glm::min(door.most, v + off);
  }
  return misses;
}

// Energies, strain and heat of the step before are taken for those of the present: a step changes them
// little.
void RowRecorder::add(const Step& step, const SoftBody& body, bool isStill, SoftRows& to) {
  const std::size_t count = step.places.size();
  glm::dvec2 centre{0.0};
  double energy = 0.0, reach2 = 0.0;
  for (std::size_t i = 0; i < count; ++i) centre += body.energy(i) * step.places[i], energy += body.energy(i);
  centre /= energy;
  if (!lastNodes_.empty()) last_.wasRigid = 0;
  lastNodes_.clear();
  const std::vector<SoftBody::NodeState> states = body.nodeStates();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 arm = step.places[i] - centre, v = step.velocities[i];
    reach2 = std::max(reach2, glm::dot(arm, arm));
    lastNodes_.push_back({static_cast<float>(arm.x),
                          static_cast<float>(arm.y),
                          {rounded(v.x, SoftNode::kVelocityUnit), rounded(v.y, SoftNode::kVelocityUnit)},
                          rounded(states[i].strain, SoftNode::kShareUnit),
                          rounded(states[i].heat, SoftNode::kShareUnit)});
    doors_[i] = {step.places[i], glm::dvec2(-kInfinite), glm::dvec2(kInfinite)};
  }
  const glm::dvec2 velocity = body.meanVelocity();
  last_.time = step.time;
  last_.centreX = centre.x, last_.centreY = centre.y;
  last_.velocityX = velocity.x, last_.velocityY = velocity.y;
  last_.reach = std::sqrt(reach2);
  last_.nodes = static_cast<std::uint32_t>(count);
  last_.isStill = isStill ? 1 : 0;
  to.rows.push_back(last_);
  to.nodes.insert(to.nodes.end(), lastNodes_.begin(), lastNodes_.end());
}

void RowRecorder::take(double time, std::span<const glm::dvec2> places, const SoftBody& body, bool isRelaxed,
                       SoftRows& to) {
  const bool areThere = follow(time, places, body);
  const bool becomesStill = isRelaxed && areThere;
  if (lastNodes_.empty()) return add(now_, body, becomesStill, to);
  if (!(time > last_.time) || (isStill() && becomesStill)) return;
  if (isStill() || becomesStill || time - last_.time >= kLongest) return add(now_, body, becomesStill, to);
  if (!misses()) return;
  if (before_.time > last_.time) {
    add(before_, body, false, to);
    misses();
  } else {
    add(now_, body, false, to);
  }
}

}  // namespace carom
