#include "engine/soft/soft_history.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

namespace carom {

void SoftHistory::append(const SoftRow& row, std::span<const SoftNode> nodes) {
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("SoftHistory::append: " + why);
  };
  if (row.nodes != nodes.size() || row.nodes == 0) refuse("a row without its nodes");
  if (rowCount() > 0) {
    const SoftRow& last = rows_.back();
    const double step = row.time - last.time;
    if (row.nodes != last.nodes)
      refuse("a row of " + std::to_string(row.nodes) + " nodes, expected " + std::to_string(last.nodes));
    if (!(step > 0.0)) refuse("a row that is not later than the last");
    const std::span<const SoftNode> before = nodesOf(rowCount() - 1);
    const glm::dvec2 centres = row.centre() - last.centre();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const glm::dvec2 way =
          centres + glm::dvec2(nodes[i].x, nodes[i].y) - glm::dvec2(before[i].x, before[i].y);
      if (!(glm::dot(way, way) < step * step))
        refuse("node " + std::to_string(i) + " is not slower than light since the last row");
    }
  }
  rows_.push_back(row);
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
}

void SoftHistory::truncateFrom(double time) {
  const std::size_t count = nodeCount();
  while (rowCount() > 0 && rows_.back().time >= time) rows_.pop_back();
  if (rowCount() == 0) return clear();
  nodes_.resize(rows_.size() * count);
}

void SoftHistory::forgetBefore(double time) {
  while (rowCount() > 1 && row(1).time <= time) ++first_;
  if (first_ < 64 || 2 * first_ < rows_.size()) return;  // the rest is moved once for as many rows at least
  nodes_.erase(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(first_ * nodeCount()));
  rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
}

void SoftHistory::clear() {
  rows_.clear();
  nodes_.clear();
  first_ = 0;
}

}  // namespace carom
