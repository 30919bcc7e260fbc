#include "app/session/frame_statistics.h"

#include "engine/text/log.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace carom {
namespace {

constexpr double kWindow_s = 5.0;  // duration of the overlay's statistics
constexpr double kNewNumbers_s = 0.25;

std::size_t framesIn(double duration_s, double display_hz) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(duration_s * display_hz)));
}

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

FrameStatistics::FrameStatistics(Cluster& cluster, NodeLock& lock, double display_hz, bool realTime)
    : cluster_(cluster),
      lock_(lock),
      display_hz_(display_hz),
      gathers_(realTime && cluster.rank() == 0),
      window_(framesIn(kWindow_s, display_hz)),
      stopwatch_(display_hz),
      own_(window_) {
  view_.node = cluster.nameOf(cluster.rank());
  view_.display_hz = display_hz;
  view_.lockWhyNot = lock.whyNot();
  cluster_.report({{}, lock_.state(), 0});
  if (cluster.rank() > 0) return;
  for (int rank = 0; rank < cluster.size(); ++rank) {
    nodes_.push_back({cluster.nameOf(rank), FrameHistory(window_), SessionLateness(display_hz), {}});
    view_.nodes.push_back({nodes_.back().name, {}, {}});
  }
  rows_.reserve(nodes_.size() * kFrameParts.size());
}

void FrameStatistics::decided(const DecisionTiming& timing) {
  stopwatch_.mark(FramePart::decide);
  stopwatch_.set(FramePart::decide, timing.took_s);
  stopwatch_.set(FramePart::sample, timing.sampleAge_s);
}

const LatencyView* FrameStatistics::view(const FrameRecord& record) {
  return record.controls.latency ? &numbers(record) : nullptr;
}

const LatencyView& FrameStatistics::numbers(const FrameRecord& record) {
  view_.frame = record.number;
  view_.lock = lock_.state();
  if (sinceViewed_ < framesIn(kNewNumbers_s, display_hz_)) return view_;
  sinceViewed_ = 0;
  for (std::size_t part = 0; part < kFrameParts.size(); ++part) {
    view_.parts[part] = own_.statistics(static_cast<FramePart>(part), window_);
  }
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    view_.nodes[node].late = nodes_[node].frames.statistics(FramePart::late, window_);
    view_.nodes[node].lock = nodes_[node].lock;
  }
  return view_;
}

void FrameStatistics::shown(const Decision& decision) {
  const FrameRecord& record = decision.frame.record;
  own_.add(stopwatch_.swapped(record.number));
  ++sinceViewed_;
  rows_.clear();
  if (gathers_) {
    gather();
    ++untold_;
    if (record.display_s - told_s_ >= 1.0) {
      summarize(record);
      told_s_ = record.display_s;
      untold_ = 0;
    }
  }
  lock_.swapped(steadySeconds());
  cluster_.report({own_.newest(), lock_.state(), 1});
}

void FrameStatistics::gather() {
  for (int rank = 0; rank < cluster_.size(); ++rank) {
    NodeFrames& node = nodes_[static_cast<std::size_t>(rank)];
    const NodeReport& report = cluster_.reportOf(rank);
    if (report.measured) {
      node.frames.add(report.stamps);
      node.lateness.add(report.stamps[FramePart::late]);
    }
    if (report.lock == node.lock) continue;
    if (report.lock == LockState::lost) {
      log::warn(
          fmt::format("{}: the graphics card's frame lock is lost; the nodes' messages still hold "
                      "the swaps together.",
                      node.name));
    } else {
      log::note(
          fmt::format("{}: frame lock: {}.", node.name, kLockStates[static_cast<std::size_t>(report.lock)]));
    }
    node.lock = report.lock;
  }
}

void FrameStatistics::summarize(const FrameRecord& record) {
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const FrameHistory& frames = nodes_[node].frames;
    for (std::size_t part = 0; part < kFrameParts.size(); ++part) {
      const PartStatistics statistics = frames.statistics(static_cast<FramePart>(part), untold_);
      if (statistics.frames == 0) continue;
      rows_.push_back({record.display_s, frames.newest().frame, static_cast<int>(node),
                       static_cast<FramePart>(part), statistics});
    }
  }
}

void FrameStatistics::sayHowItWent() const {
  for (const NodeFrames& node : nodes_) {
    if (node.lateness.frames() == 0) continue;
    log::note(fmt::format("{}: {} frames, {} missed, 99 % at most {:.1f} ms late.", node.name,
                          node.lateness.frames() + 1, node.lateness.missed(), 1e3 * node.lateness.p99_s()));
  }
}

}  // namespace carom
