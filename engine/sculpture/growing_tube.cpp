#include "engine/sculpture/growing_tube.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {
namespace {

bool isSame(const Knot& a, const Knot& b) {
  return a.turn.t_s == b.turn.t_s && a.turn.r_m == b.turn.r_m && a.u == b.u && a.signal.t_s == b.signal.t_s &&
         a.signal.r_m == b.signal.r_m && a.deceleration_m_s2 == b.deceleration_m_s2 && a.spin == b.spin;
}

/// Returns the board time before which no point knows of the knot.
double heardFrom_s(const Knot& knot) { return std::min(knot.signal.t_s, knot.turn.t_s); }

/// Returns a world line with the knots from `first` to `last`, and those before them that its points may
/// still be leaving: from the last leg that all points had joined when it ended.
WorldLine lately(const WorldLine& line, std::size_t first, std::size_t last) {
  const Knots knots = line.knots();
  if (first > 0) --first;
  while (first > 0 && !line.settlesBeforeNext(first)) --first;
  WorldLine part(knots[first], line.lightSpeed_m_s(), line.radius_m(), line.appears_s());
  for (std::size_t k = first + 1; k <= last; ++k) part.append(knots[k]);
  return part;
}

/// Returns the slices that are shown, from the first to behind the last.
Span windowOf(double past_s, double now_s) {
  constexpr double kSlice_s = GrowingTube::kSlice_s;
  return {kSlice_s * std::floor((now_s - past_s) / kSlice_s),
          kSlice_s * std::ceil((now_s + GrowingTube::kAhead_s + kSlice_s) / kSlice_s)};
}

}  // namespace

void thin(std::vector<Event>& events, double off_m) {
  const auto isNear = [&](std::size_t from, std::size_t to) {
    const Event &a = events[from], &b = events[to];
    for (std::size_t k = from + 1; k < to; ++k) {
      const double share = (events[k].t_s - a.t_s) / (b.t_s - a.t_s);
      if (!(glm::distance(a.r_m + (b.r_m - a.r_m) * share, events[k].r_m) <= off_m)) return false;
    }
    return true;
  };
  if (events.size() < 3) return;
  // Events that are kept lie before those that are still examined.
  std::size_t kept = 1, from = 0;
  const Event last = events.back();
  for (std::size_t to = 2; to < events.size(); ++to) {
    if (isNear(from, to)) continue;
    from = to - 1;
    events[kept++] = events[from];
  }
  events[kept++] = last;
  events.resize(kept);
}

bool GrowingTube::isSame(const Part& part, const Wanted& wanted, const WorldLine* line) {
  if (part.span.from_s != wanted.span.from_s || part.span.until_s != wanted.span.until_s) return false;
  if (!(part.rows == wanted.rows) || part.knots.size() != wanted.behind - wanted.firstLeg) return false;
  for (std::size_t k = 0; k < part.knots.size(); ++k)
    if (!carom::isSame(part.knots[k], line->knots()[wanted.firstLeg + k])) return false;
  return true;
}

void GrowingTube::clear() {
  parts_.clear();
  points_.clear();
  triangles_.clear();
}

bool GrowingTube::isUpToDate(const WorldLine& line, const Span& window, double base_s, double fine_m) {
  const Knots knots = line.knots();
  const Made made{knots.size(), knots.front(), knots.back(), window, base_s, fine_m, false};
  const bool isWhole = made.base_s == made_.base_s && made.fine_m == made_.fine_m && !made_.isSoft;
  const bool same = isWhole && made.knots == made_.knots && carom::isSame(made.first, made_.first) &&
                    carom::isSame(made.last, made_.last) && window.from_s == made_.window.from_s &&
                    window.until_s == made_.window.until_s;
  if (!isWhole) clear();
  made_ = made;
  return same;
}

void GrowingTube::findParts(const WorldLine& line, const Span& window) {
  const Knots knots = line.knots();
  wanted_.clear();
  std::size_t first = 0, behind = 0;  // behind the last that is heard
  for (double from_s = window.from_s; from_s < window.until_s; from_s += kSlice_s) {
    const Span span{from_s, from_s + kSlice_s};
    while (behind < knots.size() && (behind == 0 || heardFrom_s(knots[behind]) < span.until_s)) ++behind;
    while (first + 1 < behind && heardFrom_s(knots[first + 1]) <= span.from_s) ++first;
    wanted_.push_back({span, first, behind, {}});
  }
}

void GrowingTube::findParts(const SoftRim& rim, const Span& window) {
  wanted_.clear();
  for (double from_s = window.from_s; from_s < window.until_s; from_s += kSlice_s) {
    const Span span{from_s, from_s + kSlice_s};
    wanted_.push_back({span, 0, 0, rowsOf(rim, span)});
  }
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

void GrowingTube::add(const Puck& puck, const WorldLine& line, const Wanted& wanted) {
  Part part;
  part.span = wanted.span;
  part.firstLeg = wanted.firstLeg;
  part.knots.reserve(wanted.behind - wanted.firstLeg);
  for (std::size_t k = wanted.firstLeg; k < wanted.behind; ++k) part.knots.push_back(line.knots()[k]);
  const Span span{std::max(part.span.from_s, line.appears_s()), part.span.until_s};
  std::vector<std::vector<Event>> events;
  if (span.from_s < span.until_s) {
    const std::size_t last = part.firstLeg + part.knots.size() - 1;
    const double fine_m = 0.5 * made_.fine_m;  // of each of two steps that make it coarser
    const WorldTube tube =
        worldTube(puck, lately(line, part.firstLeg, last), span, 1.0, everyFor(puck, made_.fine_m));
    for (const auto& generator : tube.generators)
      thin(events.emplace_back(eventsAlong(generator, span, tube.c_m_s, fine_m)), fine_m);
  }
  append(events, line.lightSpeed_m_s(), std::move(part));
}

void GrowingTube::add(const SoftRim& rim, const Wanted& wanted) {
  Part part;
  part.span = wanted.span;
  part.rows = wanted.rows;
  std::vector<std::vector<Event>> events;
  for (std::size_t node = 0; node < rim.nodes.size(); ++node)
    thin(events.emplace_back(softEventsAlong(rim, node, part.span)), made_.fine_m);
  append(events, rim.lightSpeed_m_s, std::move(part));
}

void GrowingTube::append(const std::vector<std::vector<Event>>& events, double c_m_s, Part part) {
  part.points = points_.size();
  part.triangles = triangles_.size();
  for (const std::vector<Event>& generator : events)
    for (const Event& event : generator)
      points_.emplace_back(event.r_m.x, event.r_m.y, c_m_s * (event.t_s - made_.base_s));
  addSides(events, static_cast<std::uint32_t>(part.points), triangles_);
  parts_.push_back(std::move(part));
}

/// Makes anew from the first part on that is not the wanted one; returns whether there is one.
template <typename Add>
bool GrowingTube::remake(const WorldLine* line, const Add& add) {
  const auto isKept = [&](const Part& part, const Wanted& wanted) { return isSame(part, wanted, line); };
  const auto [had, wants] =
      std::mismatch(parts_.begin(), parts_.end(), wanted_.begin(), wanted_.end(), isKept);
  const bool isNew = had != parts_.end() || wants != wanted_.end();
  if (had != parts_.end()) {
    points_.resize(had->points);
    triangles_.resize(had->triangles);
    parts_.erase(had, parts_.end());
  }
  for (auto wanted = wants; wanted != wanted_.end(); ++wanted) add(*wanted);
  return isNew;
}

bool GrowingTube::follow(const Puck& puck, const WorldLine& line, double past_s, double now_s, double base_s,
                         double fine_m) {
  const Span window = windowOf(past_s, now_s);
  if (isUpToDate(line, window, base_s, fine_m)) return false;
  forgetBefore(window.from_s);
  findParts(line, window);
  remake(&line, [&](const Wanted& wanted) { add(puck, line, wanted); });
  return true;
}

bool GrowingTube::follow(const SoftRim& rim, double past_s, double now_s, double base_s, double fine_m) {
  const Span window = windowOf(past_s, now_s);
  const bool isWhole = made_.isSoft && made_.base_s == base_s && made_.fine_m == fine_m;
  const bool isSame = isWhole && made_.window.from_s == window.from_s;
  if (!isWhole) clear();
  made_ = {0, {}, {}, window, base_s, fine_m, true};
  forgetBefore(window.from_s);
  findParts(rim, window);
  const bool isNew = remake(nullptr, [&](const Wanted& wanted) { add(rim, wanted); });
  return isNew || !isSame;
}

TriangleRange GrowingTube::trianglesIn(const Span& span) const {
  const auto first =
      std::ranges::find_if(parts_, [&](const Part& p) { return p.span.until_s > span.from_s; });
  const auto behind =
      std::find_if(first, parts_.end(), [&](const Part& p) { return p.span.from_s > span.until_s; });
  const auto beginOf = [&](auto part) { return part == parts_.end() ? triangles_.size() : part->triangles; };
  return {beginOf(first), beginOf(behind) - beginOf(first)};
}

}  // namespace carom
