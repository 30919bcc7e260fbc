#include "engine/light/vertex_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace carom {

VertexRing::VertexRing(std::size_t vertexCount, std::size_t capacity, double c_m_s)
    : vertexCount_(vertexCount), capacity_(capacity), c_m_s_(c_m_s) {
  if (vertexCount == 0 || capacity < 3 || capacity > std::numeric_limits<std::uint16_t>::max()) {
    throw std::invalid_argument("VertexRing: expected at least one vertex and 3 to 65535 samples, not " +
                                std::to_string(vertexCount) + " and " + std::to_string(capacity));
  }
  runs_.resize(capacity * runCount());
  ownTimes_s_.resize(capacity * vertexCount);
  anchors_.resize(capacity);
  order_.reserve(capacity);
  free_.resize(capacity);
  std::iota(free_.rbegin(), free_.rend(), std::uint16_t{0});
  properTime_.assign(vertexCount, 0.0);
}

Event VertexRing::eventOf(std::size_t sample, std::size_t vertex) const {
  const glm::dvec4 d(fromAnchor(sample, vertex));
  return anchorOf(sample) + Displacement{d.x / c_m_s_, {d.y, d.z, d.w}};
}

double VertexRing::properTime_s(std::size_t sample, std::size_t vertex) const {
  const std::size_t row = order_[sample];
  return anchors_[row].properTime_s + ownTimes_s_[row * vertexCount_ + vertex];
}

// Δs² = c²Δt² − Δr² > 0 with Δt > 0: slower than light. Δτ = sqrt(Δs²)/c.
double VertexRing::properTimeSince(std::size_t last, const MeshSample& sample, std::size_t vertex) const {
  const glm::vec4 now(sample.ct_m[vertex], sample.x_m[vertex], sample.y_m[vertex], sample.z_m[vertex]);
  const glm::dvec4 step(glm::dvec4(now) - glm::dvec4(fromAnchor(last, vertex)));
  const Displacement anchors = sample.anchor - anchorOf(last);
  const Displacement d = anchors + Displacement{step.x / c_m_s_, {step.y, step.z, step.w}};
  const double squared_m2 = interval_m2(d, c_m_s_);
  return d.dt_s > 0.0 && squared_m2 > 0.0 ? std::sqrt(squared_m2) / c_m_s_ : -1.0;
}

void VertexRing::append(const MeshSample& sample) {
  for (const auto& coordinates : {sample.ct_m, sample.x_m, sample.y_m, sample.z_m}) {
    if (coordinates.size() != vertexCount_) {
      throw std::invalid_argument("VertexRing::append: a sample of " + std::to_string(coordinates.size()) +
                                  " vertices, expected " + std::to_string(vertexCount_));
    }
  }
  if (!order_.empty()) {
    const std::size_t last = order_.size() - 1;
    for (std::size_t i = 0; i < vertexCount_; ++i) {
      if (properTimeSince(last, sample, i) > 0.0) continue;
      throw std::invalid_argument("VertexRing::append: vertex " + std::to_string(i) +
                                  " is not slower than light and later than in the last sample");
    }
    for (std::size_t i = 0; i < vertexCount_; ++i) properTime_[i] += properTimeSince(last, sample, i);
  }
  if (order_.size() == capacity_) giveWay();
  const std::uint16_t row = free_.back();
  free_.pop_back();
  fillRow(row, sample);
  order_.push_back(row);
}

void VertexRing::fillRow(std::uint16_t row, const MeshSample& sample) {
  anchors_[row] = {sample.anchor, properTime_[0]};
  Run* const runs = runs_.data() + row * runCount();
  float* const own_s = ownTimes_s_.data() + row * vertexCount_;
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    Run& run = runs[i / kRun];
    run.ct_m[i % kRun] = sample.ct_m[i];
    run.x_m[i % kRun] = sample.x_m[i];
    run.y_m[i % kRun] = sample.y_m[i];
    run.z_m[i % kRun] = sample.z_m[i];
    own_s[i] = static_cast<float>(properTime_[i] - properTime_[0]);
  }
}

void VertexRing::giveWay() {
  const double last_s = eventOf(order_.size() - 1, 0).t_s;
  std::size_t leastMissed = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < order_.size(); ++i) {
    const double gap_s = eventOf(i + 1, 0).t_s - eventOf(i - 1, 0).t_s;
    const double missed = gap_s / (last_s - eventOf(i, 0).t_s);
    if (missed < least) {
      least = missed;
      leastMissed = i;
    }
  }
  free_.push_back(order_[leastMissed]);
  order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(leastMissed));
}

bool VertexRing::insideCone(std::size_t sample, const Event& eye) const {
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    const Displacement d = eye - eventOf(sample, i);
    if (!(c_m_s_ * d.dt_s - glm::length(d.dr_m) >= kEyeStepsBack_m)) return false;
  }
  return true;
}

void VertexRing::trim(std::span<const Event> eyes) {
  std::size_t gone = 0;
  while (gone + 1 < order_.size() &&
         std::all_of(eyes.begin(), eyes.end(), [&](const Event& eye) { return insideCone(gone + 1, eye); })) {
    free_.push_back(order_[gone++]);
  }
  order_.erase(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(gone));
}

}  // namespace carom
