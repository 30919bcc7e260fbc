#include "engine/soft/soft_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr int kPasses = 4;    // over the touches of a stage
constexpr int kHalvings = 4;  // of a step that cannot be followed

/// The box around a hull.
struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  bool holds(const glm::dvec2& place) const {
    return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
  }
};

Box boxOf(const SoftBody& body) {
  Box box;
  for (const int node : body.mesh().hull()) {
    const glm::dvec2 place = body.place(static_cast<std::size_t>(node));
    box.low = glm::min(box.low, place);
    box.high = glm::max(box.high, place);
  }
  return box;
}

/// Whether a hull, which runs anticlockwise, holds a place: by crossings of a ray along +x.
bool holds(const SoftBody& body, const glm::dvec2& place) {
  const std::span<const int> hull = body.mesh().hull();
  bool inside = false;
  glm::dvec2 from = body.place(static_cast<std::size_t>(hull.back()));
  for (const int node : hull) {
    const glm::dvec2 to = body.place(static_cast<std::size_t>(node));
    if ((from.y > place.y) != (to.y > place.y) &&
        place.x < from.x + (place.y - from.y) / (to.y - from.y) * (to.x - from.x)) {
      inside = !inside;
    }
    from = to;
  }
  return inside;
}

}  // namespace

void SoftGroup::findTouches(std::size_t body, std::size_t other) {
  const SoftBody &own = *bodies_[body], &its = *bodies_[other];
  const Box box = boxOf(its);
  const std::span<const int> hull = its.mesh().hull();
  for (const int node : own.mesh().hull()) {
    const glm::dvec2 place = own.place(static_cast<std::size_t>(node));
    if (!box.holds(place) || !holds(its, place)) continue;
    Touch touch{body, static_cast<std::size_t>(node), other, 0, 0, 0.0, 0.0, {}};
    double least = std::numeric_limits<double>::infinity();
    auto from = static_cast<std::size_t>(hull.back());
    for (const int next : hull) {
      const auto to = static_cast<std::size_t>(next);
      const glm::dvec2 start = its.place(from), along = its.place(to) - start;
      const double share = std::clamp(glm::dot(place - start, along) / glm::dot(along, along), 0.0, 1.0);
      const glm::dvec2 away = place - (start + share * along);
      const double distance2 = glm::dot(away, away);
      if (distance2 < least) {
        least = distance2;
        touch.edgeFrom = from, touch.edgeTo = to;
        touch.shareFrom = 1.0 - share, touch.shareTo = share;
        touch.normal = glm::dvec2(along.y, -along.x) / glm::length(along);
      }
      from = to;
    }
    touches_.push_back(touch);
  }
}

void SoftGroup::findTouches() {
  touches_.clear();
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (std::size_t other = 0; other < bodies_.size(); ++other) {
      if (other != body) findTouches(body, other);
    }
  }
}

/// Takes the part of the velocities that goes on into a cushion. `counts`: in the stage that holds.
void SoftGroup::meetCushions(bool counts) {
  for (std::size_t k = 0; k < cushions_.size(); ++k) {
    const SoftCushion& cushion = cushions_[k];
    for (SoftBody* body : bodies_) {
      for (const int node : body->mesh().hull()) {
        const auto i = static_cast<std::size_t>(node);
        if (glm::dot(cushion.normal, body->place(i)) <= cushion.offset) continue;
        const SoftBody::Trial trial = body->trial(i);
        const double into = trial.ux * cushion.normal.x + trial.uy * cushion.normal.y;
        if (!(into > 0.0)) continue;
        const glm::dvec2 after = glm::dvec2(trial.ux, trial.uy) - into * cushion.normal;
        const glm::dvec2 momentum = trial.e * after - body->stressMomentum(i, after);
        const glm::dvec2 impulse =
            glm::dot(momentum - glm::dvec2(trial.px, trial.py), cushion.normal) * cushion.normal;
        trial.px += impulse.x;
        trial.py += impulse.y;
        trial.ux = after.x;
        trial.uy = after.y;
        if (counts) impulses_[k] += impulse, touched_[k] = true;
      }
    }
  }
}

/// Exchanges momentum and energy at a touch. Returns whether the two approached.
bool SoftGroup::meet(const Touch& touch) {
  SoftBody &own = *bodies_[touch.body], &its = *bodies_[touch.other];
  const glm::dvec2& n = touch.normal;
  const SoftBody::Trial i = own.trial(touch.node), j = its.trial(touch.edgeFrom), k = its.trial(touch.edgeTo);
  const double wj = touch.shareFrom, wk = touch.shareTo;
  const double ownSpeed = i.ux * n.x + i.uy * n.y;
  const double edgeSpeed = wj * (j.ux * n.x + j.uy * n.y) + wk * (k.ux * n.x + k.uy * n.y);
  if (!(ownSpeed - edgeSpeed < 0.0)) return false;
  const double edgeEnergy = 1.0 / (wj * wj / j.e + wk * wk / k.e);
  const double V = (i.e * ownSpeed + edgeEnergy * edgeSpeed) / (i.e + edgeEnergy);
  const double lambda = i.e * (V - ownSpeed) / (1.0 - V * V);
  const double changeJ = wj * (edgeEnergy / j.e) * (V - edgeSpeed),
               changeK = wk * (edgeEnergy / k.e) * (V - edgeSpeed);
  // Mean normal velocities, from the beginning of the step: with the candidate's, a lasting contact would heat its nodes.
  const double muI = 0.5 * (glm::dot(own.velocity(touch.node), n) + V);
  const double muJ = 0.5 * (glm::dot(its.velocity(touch.edgeFrom), n) + (j.ux * n.x + j.uy * n.y) + changeJ);
  const double muK = 0.5 * (glm::dot(its.velocity(touch.edgeTo), n) + (k.ux * n.x + k.uy * n.y) + changeK);
  const double rest = 0.5 * lambda * (wj * muJ + wk * muK - muI);
  const auto take = [&n](const SoftBody::Trial& trial, double impulse, double energy, double change) {
    trial.px += impulse * n.x;
    trial.py += impulse * n.y;
    trial.e += energy;
    trial.ux += change * n.x;
    trial.uy += change * n.y;
  };
  take(i, lambda, lambda * muI + rest, V - ownSpeed);
  take(j, -wj * lambda, -wj * lambda * muJ + wj * rest, changeJ);
  take(k, -wk * lambda, -wk * lambda * muK + wk * rest, changeK);
  return true;
}

/// Gives the held nodes the velocity V of the told body: λ = (E V − L τ v − π)/(1 − V²) along each axis, E += λ·V.
void SoftGroup::hold() {
  for (const HeldSide& side : held_) {
    SoftBody& body = *bodies_[side.body];
    for (const int node : side.nodes) {
      const auto i = static_cast<std::size_t>(node);
      const SoftBody::Trial trial = body.trial(i);
      const glm::dvec2 V = side.velocity,
                       lacks = trial.e * V - body.stressMomentum(i, V) - glm::dvec2(trial.px, trial.py);
      // (E + λ·V) V = π + λ + Lτv, solved for λ: the part along V counts 1/(1 − V²) times.
      const double speed2 = glm::dot(V, V);
      const glm::dvec2 along = speed2 > 0.0 ? glm::dot(lacks, V) / speed2 * V : glm::dvec2(0.0);
      const glm::dvec2 impulse = lacks + (1.0 / (1.0 - speed2) - 1.0) * along;
      trial.px += impulse.x;
      trial.py += impulse.y;
      trial.e += glm::dot(impulse, V);
      trial.ux = V.x;
      trial.uy = V.y;
    }
  }
}

bool SoftGroup::tryStep(double dt) {
  for (SoftBody* body : bodies_) body->drift(0.5 * dt);
  findTouches();
  for (const bool middle : {false, true}) {
    for (SoftBody* body : bodies_) body->tryStep(dt, middle);
    meetCushions(middle);
    for (int pass = 0; pass < kPasses; ++pass) {
      bool approached = false;
      for (const Touch& touch : touches_) approached = meet(touch) || approached;
      if (!approached) break;
    }
    hold();
    for (SoftBody* body : bodies_) body->setMiddle();
  }
  for (SoftBody* body : bodies_) {
    body->commit(dt);
  }
  for (const HeldSide& side : held_) {
    for (const int node : side.nodes)
      bodies_[side.body]->carry(static_cast<std::size_t>(node), side.velocity);
  }
  for (SoftBody* body : bodies_) body->drift(0.5 * dt);
  return std::all_of(bodies_.begin(), bodies_.end(), [](const SoftBody* body) { return body->isSound(); });
}

double SoftGroup::step(double most) {
  double dt = most;
  for (const SoftBody* body : bodies_) dt = std::min(dt, body->longestStep());
  for (std::size_t k = 0; k < bodies_.size(); ++k) before_[k] = bodies_[k]->state();
  impulsesBefore_ = impulses_;
  for (int halving = 0; halving <= kHalvings; ++halving) {
    touched_.assign(cushions_.size(), false);
    if (tryStep(dt)) return dt;
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k]->restore(before_[k]);
    impulses_ = impulsesBefore_;
    dt *= 0.5;
  }
  throw std::runtime_error("a soft body cannot be followed");
}

void SoftGroup::advance(double duration) {
  while (duration > 0.0) duration -= step(duration);
}

}  // namespace carom
