#include "engine/soft/soft_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr int kPasses = 4;         // over the touches of a stage
constexpr int kHalvings = 4;       // of a step that cannot be followed
constexpr double kCooling = 1e-3;  // of a body's mass, by which its heat must not fall in a step

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
    Touch touch{body, static_cast<std::size_t>(node), other, 0, 0, 0.0, 0.0, 0.0, {}};
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
        touch.depth = std::sqrt(distance2);
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

SoftExchange& SoftGroup::exchange(std::size_t body, std::size_t other, std::size_t cushion) {
  for (SoftExchange& known : exchanges_) {
    if (known.body == body && known.other == other && known.cushion == cushion) return known;
  }
  return exchanges_.emplace_back(SoftExchange{body, other, cushion, {}, -1.0, {}});
}

namespace {

/// Notes a node that is `depth` beyond a surface in the middle of a step and went there at `speed`, if it was
/// the first.
void noteArrival(SoftExchange& exchange, double dt, double depth, double speed, const glm::dvec2& surface) {
  const double since = 0.5 * dt + (speed > 0.0 ? std::min(depth / speed, dt) : 0.0);
  if (since > exchange.since) exchange.since = since, exchange.place = surface;
}

}  // namespace

/// Takes the part of the velocities that goes on into a cushion. `counts`: in the stage that holds.
void SoftGroup::meetCushions(double dt, bool counts) {
  for (std::size_t k = 0; k < cushions_.size(); ++k) {
    const SoftCushion& cushion = cushions_[k];
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      SoftBody* body = bodies_[b];
      for (const int node : body->mesh().hull()) {
        const auto i = static_cast<std::size_t>(node);
        const double depth = glm::dot(cushion.normal, body->place(i)) - cushion.offset;
        if (depth <= 0.0) continue;
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
        if (!counts) continue;
        impulses_[k] += impulse;
        SoftExchange& noted = exchange(b, SoftExchange::kNone, k);
        noted.impulse += impulse;
        noteArrival(noted, dt, depth, glm::dot(body->velocity(i), cushion.normal),
                    body->place(i) - depth * cushion.normal);
      }
    }
  }
}

/// Exchanges momentum and energy at a touch. Returns whether the two approached.
bool SoftGroup::meet(const Touch& touch, double dt, bool counts) {
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
  // Mean normal velocities, from the beginning of the step: with the candidate's, a lasting contact would
  // heat its nodes.
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
  if (counts) {
    const bool inOrder = touch.body < touch.other;
    SoftExchange& noted =
        exchange(inOrder ? touch.body : touch.other, inOrder ? touch.other : touch.body, SoftExchange::kNone);
    noted.impulse += (inOrder ? lambda : -lambda) * n;
    const double closing = glm::dot(
        wj * its.velocity(touch.edgeFrom) + wk * its.velocity(touch.edgeTo) - own.velocity(touch.node), n);
    noteArrival(noted, dt, touch.depth, closing, own.place(touch.node) + touch.depth * n);
  }
  take(i, lambda, lambda * muI + rest, V - ownSpeed);
  take(j, -wj * lambda, -wj * lambda * muJ + wj * rest, changeJ);
  take(k, -wk * lambda, -wk * lambda * muK + wk * rest, changeK);
  return true;
}

/// Gives the held nodes the velocity V of the told body: λ = (E V − L τ v − π)/(1 − V²) along each axis, E +=
/// λ·V.
void SoftGroup::hold(bool counts) {
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
      if (counts) given_ = given_ + Vec21{glm::dot(impulse, V), impulse.x, impulse.y};
      trial.ux = V.x;
      trial.uy = V.y;
    }
  }
}

void SoftGroup::carryHeld() {
  for (const HeldSide& side : held_) {
    for (const int node : side.nodes)
      bodies_[side.body]->carry(static_cast<std::size_t>(node), side.velocity);
  }
}

bool SoftGroup::tryStep(double dt) {
  exchanges_.clear();
  carryHeld();
  for (SoftBody* body : bodies_) body->drift(0.5 * dt);
  findTouches();
  for (const bool middle : {false, true}) {
    for (SoftBody* body : bodies_) body->tryStep(dt, middle);
    meetCushions(dt, middle);
    for (int pass = 0; pass < kPasses; ++pass) {
      bool approached = false;
      for (const Touch& touch : touches_) approached = meet(touch, dt, middle) || approached;
      if (!approached) break;
    }
    hold(middle);
    for (SoftBody* body : bodies_) body->setMiddle();
  }
  for (SoftBody* body : bodies_) {
    body->commit(dt);
  }
  carryHeld();
  for (SoftBody* body : bodies_) body->drift(0.5 * dt);
  nextSurveys_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    nextSurveys_.push_back(bodies_[k]->survey());
    const SoftSurvey& survey = nextSurveys_.back();
    failed_ = k;
    if (!(survey.isSound && survey.heat >= surveys_[k].heat - kCooling * bodies_[k]->mass())) return false;
  }
  std::swap(surveys_, nextSurveys_);
  return true;
}

double SoftGroup::step(double most) {
  double dt = most;
  for (const SoftSurvey& survey : surveys_) dt = std::min(dt, survey.longestStep);
  for (std::size_t k = 0; k < bodies_.size(); ++k) before_[k] = bodies_[k]->state();
  impulsesBefore_ = impulses_;
  givenBefore_ = given_;
  for (int halving = 0; halving <= kHalvings; ++halving) {
    if (tryStep(dt)) return dt;
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k]->restore(before_[k]);
    impulses_ = impulsesBefore_;
    given_ = givenBefore_;
    dt *= 0.5;
  }
  throw SoftStepFailure(failed_);
}

void SoftGroup::advance(double duration) {
  while (duration > 0.0) duration -= step(duration);
}

}  // namespace carom
