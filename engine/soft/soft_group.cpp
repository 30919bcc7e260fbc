#include "engine/soft/soft_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr int kPasses = 4;                // over the touches of a stage
constexpr double kNearShare = 1.0 / 3.0;  // of the longest step of bodies that fly alone
constexpr int kHalvings = 4;              // of a step that cannot be followed
constexpr double kCooling = 1e-3;         // of a body's mass, by which its heat must not fall in a step

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
    Touch touch{body, static_cast<std::size_t>(node), other, 0, 0, 0.0, 0.0, 0.0, {}, 0.0};
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

/// Exchanges momentum at a touch. Returns whether the two approached.
bool SoftGroup::meet(Touch& touch) {
  const glm::dvec2& n = touch.normal;
  SoftBody& its = *bodies_[touch.other];
  const SoftBody::Trial i = bodies_[touch.body]->trial(touch.node), j = its.trial(touch.edgeFrom),
                        k = its.trial(touch.edgeTo);
  const double wj = touch.shareFrom, wk = touch.shareTo;
  const double ownSpeed = i.ux * n.x + i.uy * n.y;
  const double edgeSpeed = wj * (j.ux * n.x + j.uy * n.y) + wk * (k.ux * n.x + k.uy * n.y);
  if (!(ownSpeed - edgeSpeed < 0.0)) return false;
  const double edgeEnergy = 1.0 / (wj * wj / j.e + wk * wk / k.e);
  const double V = (i.e * ownSpeed + edgeEnergy * edgeSpeed) / (i.e + edgeEnergy);
  const double lambda = i.e * (V - ownSpeed) / (1.0 - V * V);
  touch.impulse += lambda;
  const auto take = [&n](const SoftBody::Trial& trial, double impulse, double change) {
    trial.px += impulse * n.x;
    trial.py += impulse * n.y;
    trial.ux += change * n.x;
    trial.uy += change * n.y;
  };
  take(i, lambda, V - ownSpeed);
  take(j, -wj * lambda, wj * (edgeEnergy / j.e) * (V - edgeSpeed));
  take(k, -wk * lambda, wk * (edgeEnergy / k.e) * (V - edgeSpeed));
  return true;
}

/// Gives the nodes of a touch the energies of its impulse. Their mean normal velocities begin with those at
/// the beginning of the step, and end with those after all contacts: otherwise a lasting contact would heat
/// its nodes.
void SoftGroup::giveEnergy(const Touch& touch) {
  const glm::dvec2& n = touch.normal;
  SoftBody &own = *bodies_[touch.body], &its = *bodies_[touch.other];
  const auto mean = [&n](SoftBody& body, std::size_t node) {
    const SoftBody::Trial trial = body.trial(node);
    return 0.5 * (glm::dot(body.velocity(node), n) + (trial.ux * n.x + trial.uy * n.y));
  };
  const double lambda = touch.impulse, wj = touch.shareFrom, wk = touch.shareTo;
  const double muI = mean(own, touch.node), muJ = mean(its, touch.edgeFrom), muK = mean(its, touch.edgeTo);
  const double rest = 0.5 * lambda * (wj * muJ + wk * muK - muI);
  own.trial(touch.node).gained += lambda * muI + rest;
  its.trial(touch.edgeFrom).gained += -wj * lambda * muJ + wj * rest;
  its.trial(touch.edgeTo).gained += -wk * lambda * muK + wk * rest;
}

void SoftGroup::note(const Touch& touch, double dt) {
  const SoftBody &own = *bodies_[touch.body], &its = *bodies_[touch.other];
  const glm::dvec2& n = touch.normal;
  const bool inOrder = touch.body < touch.other;
  SoftExchange& noted =
      exchange(inOrder ? touch.body : touch.other, inOrder ? touch.other : touch.body, SoftExchange::kNone);
  noted.impulse += (inOrder ? touch.impulse : -touch.impulse) * n;
  const glm::dvec2 edge =
      touch.shareFrom * its.velocity(touch.edgeFrom) + touch.shareTo * its.velocity(touch.edgeTo);
  noteArrival(noted, dt, touch.depth, glm::dot(edge - own.velocity(touch.node), n),
              own.place(touch.node) + touch.depth * n);
}

/// `counts`: in the stage that holds.
void SoftGroup::meetTouches(double dt, bool counts) {
  for (Touch& touch : touches_) touch.impulse = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    bool approached = false;
    for (Touch& touch : touches_) approached = meet(touch) || approached;
    if (!approached) break;
  }
  for (const Touch& touch : touches_) {
    if (!counts || touch.impulse == 0.0) continue;
    note(touch, dt);
    giveEnergy(touch);
  }
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
      trial.gained += glm::dot(impulse, V);
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
    meetTouches(dt, middle);
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

/// Whether the boxes around two hulls are within a reach of each other.
bool SoftGroup::areNear(double reach) const {
  std::vector<Box> boxes;
  for (const SoftBody* body : bodies_) {
    const Box box = boxOf(*body);
    for (const Box& other : boxes) {
      if (box.low.x - other.high.x < reach && other.low.x - box.high.x < reach &&
          box.low.y - other.high.y < reach && other.low.y - box.high.y < reach)
        return true;
    }
    boxes.push_back(box);
  }
  return false;
}

double SoftGroup::step(double most) {
  double longest = std::numeric_limits<double>::infinity();
  for (const SoftSurvey& survey : surveys_) longest = std::min(longest, survey.longestStep);
  double dt = std::min(most, areNear(2.0 * longest) ? kNearShare * longest : longest);
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
