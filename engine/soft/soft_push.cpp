#include "engine/soft/soft_push.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/base/never.h"

namespace carom {
namespace {}  // namespace

bool SoftPush::reachesBefore(const SoftPlayer& player, double time, double slice, double end) const {
  const Vec21& hand = stroke_.hand;
  if (isOver_) return false;
  if (!stroke_.hasPlace) return hand.t < end;
  const double apart = glm::length(player.centreAt(time) - glm::dvec2(hand.x, hand.y));
  const double nearest = std::max(0.0, apart - player.reach - slice);
  return end - hand.t >= std::hypot(nearest, stroke_.height);
}

void SoftPush::begin(const SoftPlayer& player, double time, FarSides& farSides) {
  const SoftMesh& mesh = *player.entry->mesh;
  const glm::dvec2 axis = player.body.turned(), way = glm::normalize(stroke_.momentum);
  began_ = time;
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    const glm::dvec2 X = mesh.places()[i], turned(axis.x * X.x - axis.y * X.y, axis.y * X.x + axis.x * X.y);
    shares_.push_back(mesh.nodeShare(i) * std::max(0.0, -glm::dot(turned, way)));
    begins_.push_back(kNever);
    sum += shares_.back();
  }
  for (double& share : shares_) share /= sum;
  const double given = glm::length(stroke_.momentum), energy = player.body.totals().momentum.t;
  farSides.push(stroke_.body, player.body, way, given / std::hypot(given, energy));
}

/// Whether the light of the hand has reached a node.
bool SoftPush::isLit(const SoftPlayer& player, std::size_t node, double time) const {
  if (!stroke_.hasPlace) return true;
  const glm::dvec2 way = player.body.place(node) - glm::dvec2(stroke_.hand.x, stroke_.hand.y);
  const double since = time - stroke_.hand.t;
  return since * since >= glm::dot(way, way) + stroke_.height * stroke_.height;
}

void SoftPush::act(SoftPlayer& player, double time, FarSides& farSides) {
  if (isOver_ || time < stroke_.hand.t) return;
  if (stroke_.momentum == glm::dvec2(0.0)) {
    isOver_ = true;
    return;
  }
  const double lasts = player.soundTime();
  const glm::dvec2 force = stroke_.momentum / lasts;
  isOver_ = began_.has_value();
  for (std::size_t i = 0; i < player.body.size(); ++i) {
    if (!began_ && isLit(player, i, time)) begin(player, time, farSides);
    if (!began_ || shares_[i] == 0.0) continue;
    if (begins_[i] == kNever && isLit(player, i, time)) begins_[i] = time;
    if (time >= begins_[i] + lasts) continue;
    isOver_ = false;
    player.quietSince = time;
    if (begins_[i] < kNever) player.body.push(i, shares_[i] * force);
  }
  // What is over is never looked at again, and is copied with every snapshot.
  if (isOver_) shares_ = begins_ = {};
}

double SoftPush::nextChange(const SoftPlayer& player, double time, double end) const {
  double next = end;
  const auto consider = [&](double change) {
    if (change > time) next = std::min(next, change);
  };
  if (isOver_) return next;
  consider(stroke_.hand.t);
  for (const double begin : begins_) consider(begin + player.soundTime());
  return next;
}

}  // namespace carom
