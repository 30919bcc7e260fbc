#include "engine/sculpture/world_tube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace carom {
namespace {

constexpr int kDiscPoints = 48;       // of a disc's rim: off by at most 0.2 % of the radius between them
constexpr int kSidePoints = 6;        // of each side of an outline
constexpr double kShortest_s = 1e-9;  // events nearer in time are one

/// Returns the board time between two events of a piece whose chord is off by `chord_m`: h = |a| Δt²/8.
double stepOn(const VertexPiece& piece, double chord_m) {
  const Knot& knot = piece.onLeg->knot;
  const double omega = std::abs(knot.spin.omega_rad_s), radius_m = glm::length(piece.onLeg->offset_m);
  const double acceleration_m_s2 = knot.deceleration_m_s2 + omega * omega * radius_m;
  return std::sqrt(8.0 * chord_m / std::max(acceleration_m_s2, 1e-6));
}

}  // namespace

std::vector<Vec2> rimOf(const Puck& puck) {
  std::vector<Vec2> rim;
  if (puck.outline_m.empty()) {
    for (int k = 0; k < kDiscPoints; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kDiscPoints;
      rim.emplace_back(puck.radius_m * std::cos(angle), puck.radius_m * std::sin(angle));
    }
    return rim;
  }
  for (std::size_t corner = 0; corner < puck.outline_m.size(); ++corner) {
    const Vec2 from = puck.outline_m[corner], to = puck.outline_m[(corner + 1) % puck.outline_m.size()];
    for (int k = 0; k < kSidePoints; ++k) rim.push_back(from + (to - from) * (double(k) / kSidePoints));
  }
  return rim;
}

std::size_t everyFor(const Puck& puck, double fine_m) {
  if (!puck.outline_m.empty())
    return puck.radius_m > 150.0 * fine_m ? 1 : puck.radius_m > 16.0 * fine_m ? 3 : 6;
  for (const int every : {12, 8, 6, 4, 3, 2})
    if (puck.radius_m * (1.0 - std::cos(std::numbers::pi * every / kDiscPoints)) <= fine_m)
      return static_cast<std::size_t>(every);
  return 1;
}

WorldTube worldTube(const Puck& puck, const WorldLine& line, const Span& span, double widened,
                    std::size_t every) {
  WorldTube tube{line.lightSpeed_m_s(), {std::max(span.from_s, line.appears_s()), span.until_s}, {}};
  const std::vector<Vec2> rim = rimOf(puck);
  for (std::size_t i = 0; i < rim.size(); i += every)
    tube.generators.push_back(vertexHistory(line, Vec3(rim[i] * widened, 0.5 * puck.height_m)));
  return tube;
}

std::vector<Event> eventsAlong(const std::vector<VertexPiece>& history, const Span& span, double c_m_s,
                               double chord_m) {
  std::vector<Event> events;
  const auto add = [&](const VertexPiece& piece, double t_s) {
    if (events.empty() || t_s > events.back().t_s + kShortest_s)
      events.push_back({t_s, placeAt(piece, t_s, c_m_s)});
  };
  for (std::size_t k = 0; k < history.size(); ++k) {
    const VertexPiece& piece = history[k];
    const double begins_s = k == 0 ? span.from_s : std::max(piece.start.t_s, span.from_s);
    const double ends_s =
        k + 1 < history.size() ? std::min(history[k + 1].start.t_s, span.until_s) : span.until_s;
    if (!(begins_s <= ends_s)) continue;
    add(piece, begins_s);
    if (!piece.onLeg) continue;
    const auto steps = static_cast<std::size_t>(std::ceil((ends_s - begins_s) / stepOn(piece, chord_m)));
    for (std::size_t i = 1; i < steps; ++i)
      add(piece, begins_s + (ends_s - begins_s) * static_cast<double>(i) / static_cast<double>(steps));
  }
  const Event last{span.until_s, placeAt(pieceAt(history, span.until_s), span.until_s, c_m_s)};
  if (events.size() > 1 && last.t_s < events.back().t_s + kShortest_s) events.pop_back();
  events.push_back(last);
  return events;
}

void addSides(const std::vector<std::vector<Event>>& events, std::uint32_t first,
              std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::uint32_t whole = first;
  for (std::size_t k = 0; k < events.size(); ++k) {
    const std::vector<Event>&a = events[k], &b = events[(k + 1) % events.size()];
    const std::uint32_t other = k + 1 < events.size() ? first + static_cast<std::uint32_t>(a.size()) : whole;
    for (std::uint32_t i = 0, j = 0; i + 1 < a.size() || j + 1 < b.size();) {
      const bool alongA = j + 1 == b.size() || (i + 1 < a.size() && a[i + 1].t_s <= b[j + 1].t_s);
      if (alongA) {
        triangles.push_back({first + i, other + j, first + i + 1});
        ++i;
      } else {
        triangles.push_back({first + i, other + j, other + j + 1});
        ++j;
      }
    }
    first = other;
  }
}

SolidMesh solidOf(const WorldTube& tube, const SpacetimeFrame& frame) {
  SolidMesh solid;
  std::vector<std::vector<Event>> events;
  std::vector<std::uint32_t> firsts;
  for (const auto& generator : tube.generators) {
    firsts.push_back(static_cast<std::uint32_t>(solid.points.size()));
    events.push_back(eventsAlong(generator, tube.span, tube.c_m_s));
    for (const Event& event : events.back()) solid.points.push_back(frame.at(event));
  }
  const auto count = static_cast<std::uint32_t>(events.size());
  const auto lid = [&](bool above) {
    const auto rim = [&](std::uint32_t k) {
      return firsts[k] + (above ? static_cast<std::uint32_t>(events[k].size()) - 1 : 0);
    };
    Vec3 sum(0.0);
    for (std::uint32_t k = 0; k < count; ++k) sum += solid.points[rim(k)];
    const auto middle = static_cast<std::uint32_t>(solid.points.size());
    solid.points.push_back(sum / static_cast<double>(count));
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t here = rim(k), next = rim((k + 1) % count);
      solid.triangles.push_back(above ? std::array{middle, here, next} : std::array{middle, next, here});
    }
  };
  addSides(events, 0, solid.triangles);
  lid(false);
  lid(true);
  return solid;
}

}  // namespace carom
