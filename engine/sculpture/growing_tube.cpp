#include "engine/sculpture/growing_tube.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

bool isSame(const Knot& a, const Knot& b) {
  return a.turn.t_s == b.turn.t_s && a.turn.r_m == b.turn.r_m && a.u == b.u && a.signal.t_s == b.signal.t_s &&
         a.signal.r_m == b.signal.r_m && a.deceleration_m_s2 == b.deceleration_m_s2 && a.spin == b.spin;
}

/// Returns the board time before which no point knows of the knot.
double heardFrom_s(const Knot& knot) { return std::min(knot.signal.t_s, knot.turn.t_s); }

/// Returns a world line with the knot `leg`, and those before it that its points may still be leaving: from
/// the last leg that all points had joined when it ended.
WorldLine lately(const WorldLine& line, std::size_t leg) {
  const Knots knots = line.knots();
  std::size_t first = leg > 0 ? leg - 1 : 0;
  while (first > 0 && !line.settlesBeforeNext(first)) --first;
  WorldLine part(knots[first], line.lightSpeed_m_s(), line.radius_m(), line.appears_s());
  for (std::size_t k = first + 1; k <= leg; ++k) part.append(knots[k]);
  return part;
}

}  // namespace

bool GrowingTube::Part::isSame(const Part& other) const {
  return span.from_s == other.span.from_s && span.until_s == other.span.until_s &&
         carom::isSame(knot, other.knot);
}

bool GrowingTube::isUpToDate(const WorldLine& line, double now_s, double base_s) {
  const Knots knots = line.knots();
  // The window's end is another on a border between two slices than behind it.
  const double slice = std::floor(now_s / kSlice_s) + std::ceil(now_s / kSlice_s);
  const Made made{knots.size(), knots.front(), knots.back(), slice, base_s};
  const bool same = made.knots == made_.knots && carom::isSame(made.first, made_.first) &&
                    carom::isSame(made.last, made_.last) && made.slice == made_.slice &&
                    made.base_s == made_.base_s;
  if (made.base_s != made_.base_s) {
    parts_.clear();
    points_.clear();
    triangles_.clear();
  }
  made_ = made;
  return same;
}

// The surface is cut where the first point may hear of a knot, and of all later ones, and at each slice.
void GrowingTube::findParts(const WorldLine& line, const Span& window) {
  const Knots knots = line.knots();
  wanted_.clear();
  double until_s = window.until_s;
  for (std::size_t leg = knots.size(); leg-- > 0 && until_s > window.from_s;) {
    const Knot knot = knots[leg];
    const double from_s = leg == 0 ? window.from_s : std::max(heardFrom_s(knot), window.from_s);
    while (from_s < until_s) {
      const double slice_s = kSlice_s * (std::ceil(until_s / kSlice_s) - 1.0);
      const double begins_s = std::max(from_s, slice_s);
      wanted_.push_back({knot, {begins_s, until_s}, leg});
      until_s = begins_s;
    }
  }
  std::reverse(wanted_.begin(), wanted_.end());
}

/// Removes the parts that end before `from_s`.
void GrowingTube::forgetBefore(double from_s) {
  const auto kept = std::find_if(parts_.begin(), parts_.end(),
                                 [&](const Part& part) { return part.span.until_s > from_s; });
  if (kept == parts_.begin()) return;
  const std::size_t points = kept == parts_.end() ? points_.size() : kept->points;
  const std::size_t triangles = kept == parts_.end() ? triangles_.size() : kept->triangles;
  points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(points));
  triangles_.erase(triangles_.begin(), triangles_.begin() + static_cast<std::ptrdiff_t>(triangles));
  for (auto& triangle : triangles_)
    for (std::uint32_t& corner : triangle) corner -= static_cast<std::uint32_t>(points);
  parts_.erase(parts_.begin(), kept);
  for (Part& part : parts_) part.points -= points, part.triangles -= triangles;
}

void GrowingTube::add(const Puck& puck, const WorldLine& line, Part part) {
  part.points = points_.size();
  part.triangles = triangles_.size();
  const Span span{std::max(part.span.from_s, line.appears_s()), part.span.until_s};
  if (span.from_s < span.until_s) {
    const WorldTube tube = worldTube(puck, lately(line, part.leg), span, 1.0, kEvery);
    std::vector<std::vector<Event>> events;
    for (const auto& generator : tube.generators) {
      events.push_back(eventsAlong(generator, span, tube.c_m_s, kChord_m));
      for (const Event& event : events.back())
        points_.emplace_back(event.r_m.x, event.r_m.y, tube.c_m_s * (event.t_s - made_.base_s));
    }
    addSides(events, static_cast<std::uint32_t>(part.points), triangles_);
  }
  parts_.push_back(part);
}

bool GrowingTube::follow(const Puck& puck, const WorldLine& line, double past_s, double now_s,
                         double base_s) {
  if (isUpToDate(line, now_s, base_s)) return false;
  const Span window{kSlice_s * std::floor((now_s - past_s) / kSlice_s),
                    kSlice_s * std::ceil((now_s + kAhead_s + kSlice_s) / kSlice_s)};
  forgetBefore(window.from_s);
  findParts(line, window);
  const auto isKept = [](const Part& a, const Part& b) { return a.isSame(b); };
  const auto [had, wants] =
      std::mismatch(parts_.begin(), parts_.end(), wanted_.begin(), wanted_.end(), isKept);
  if (had != parts_.end()) {
    points_.resize(had->points);
    triangles_.resize(had->triangles);
    parts_.erase(had, parts_.end());
  }
  for (auto part = wants; part != wanted_.end(); ++part) add(puck, line, *part);
  return true;
}

}  // namespace carom
