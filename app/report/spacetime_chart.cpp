#include "app/report/spacetime_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "cave/frame/body_colour.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kShown_s = 5.0;    // board time shown below the present event
constexpr double kLeast_s = 0.2;    // shortest board time for a diagram
constexpr double kSteady_s = 0.15;  // of a told head, a velocity from a shorter time is noise
constexpr double kFuture = 0.5;     // fraction of the time below the present that is shown above it
constexpr double kMargin_m = 0.3;   // beside the board
/// Colours of the flashes that the legend names, told apart by the colour-blind (Okabe and Ito 2008).
const std::array<glm::vec3, 6> kFlashColours{{{0.84F, 0.37F, 0.0F},
                                              {0.0F, 0.45F, 0.70F},
                                              {0.0F, 0.62F, 0.45F},
                                              {0.80F, 0.47F, 0.65F},
                                              {0.90F, 0.62F, 0.0F},
                                              {0.34F, 0.71F, 0.91F}}};
constexpr int kHeight_px = 1100, kLeastWidth_px = 760, kMostWidth_px = 2400;

/// Maps a board event to a point of the chart.
class Plane {
 public:
  Plane(char along, double c_m_s) : axis_(along == 'x' ? 0 : 1), c_m_s_(c_m_s) {}
  glm::dvec2 operator()(const Event& event) const { return {event.r_m[axis_], c_m_s_ * event.t_s}; }
  double along(const Vec3& v) const { return v[axis_]; }

 private:
  int axis_;
  double c_m_s_;
};

/// Returns the line colour of a body: linear light as sRGB, dark enough to be visible on white paper.
glm::vec3 inkOf(const std::string& name, std::size_t index) {
  const glm::vec3 ink = glm::pow(colourOf(name, index), glm::vec3(1.0F / 2.2F));
  const float light = glm::dot(ink, glm::vec3(0.3F, 0.6F, 0.1F));
  return light > 0.75F ? ink * (0.6F / light) : ink;
}

ChartLine lineOf(const WorldLine& line, const Plane& plane, double from_s, double until_s) {
  constexpr int kPerLeg = 48;  // points of a leg that may be curved
  ChartLine drawn;
  const double start_s = std::max(from_s, line.appears_s());
  std::vector<double> times_s{start_s};
  for (const Knot& knot : line.knots()) {
    if (knot.turn.t_s > start_s && knot.turn.t_s < until_s) times_s.push_back(knot.turn.t_s);
  }
  times_s.push_back(until_s);
  for (std::size_t leg = 1; leg < times_s.size(); ++leg) {
    for (int i = 0; i < kPerLeg; ++i) {
      drawn.points.push_back(
          plane(line.at(glm::mix(times_s[leg - 1], times_s[leg], i / double(kPerLeg - 1))).event));
    }
  }
  return drawn;
}

/// Returns the straight line through an event in a direction (x, c t), across the whole chart.
ChartLine through(const glm::dvec2& event, const glm::dvec2& direction, const std::string& name,
                  const glm::vec3& colour, ChartLine::Style style, float width_px) {
  constexpr double kFar_m = 1e3;
  return {name, {event - kFar_m * direction, event + kFar_m * direction}, colour, width_px, style};
}

/// The board times that a diagram shows.
struct Period {
  double from_s;
  double until_s;
};

/// Returns half the board's extent along the diagram's axis (m); of an open plane 1 m.
double halfExtent_m(const DiagramSubject& subject, char along) {
  return subject.board ? (along == 'x' ? subject.board->length_m : subject.board->width_m) / 2 : 1.0;
}

/// Returns the least and greatest place across of the people of another room and of me, as far as told.
glm::dvec2 reachOfPeople(const DiagramSubject& subject, const Plane& plane) {
  glm::dvec2 reach_m(plane(subject.mine.back()).x);
  for (const OtherObserver& other : subject.told) {
    if (other.line.empty()) continue;
    const double there_m = plane(other.line.back()).x;
    reach_m = {std::min(reach_m.x, there_m), std::max(reach_m.y, there_m)};
  }
  return reach_m;
}

/// Sets size and ranges: light goes at 45°, and the board and all people's presents are in sight.
void setRanges(Chart& chart, double c_m_s, const Period& span, double half_m, const glm::dvec2& people_m) {
  chart.yRange = c_m_s * glm::dvec2(span.from_s, span.until_s);
  chart.xRange = {std::min(-half_m, people_m.x) - kMargin_m, std::max(half_m, people_m.y) + kMargin_m};
  // The width follows from light at 45°, but is limited; if the limit is reached, more future is shown.
  const double least_m =
      (chart.xRange.y - chart.xRange.x) * (kHeight_px - kChartBottom_px - kChartTop_px) / kMostWidth_px;
  chart.yRange.y = std::max(chart.yRange.y, chart.yRange.x + least_m);
  const double px_m = (kHeight_px - kChartBottom_px - kChartTop_px) / (chart.yRange.y - chart.yRange.x);
  const int width_px =
      static_cast<int>(px_m * (chart.xRange.y - chart.xRange.x)) + kChartLeft_px + kChartRight_px;
  chart.size_px = {std::max(width_px, kLeastWidth_px), kHeight_px};
  const double more_m = (chart.size_px.x - width_px) / px_m;
  chart.xRange += glm::dvec2(-more_m / 2, more_m / 2);
}

void addCushions(Chart& chart, double half_m) {
  for (const double side : {-half_m, half_m}) {
    chart.lines.push_back({side < 0 ? texts::diagram::kCushions.words() : "",
                           {{side, chart.yRange.x}, {side, chart.yRange.y}},
                           glm::vec3(0.6F),
                           5.0F,
                           ChartLine::Style::solid});
  }
}

void addBodies(Chart& chart, const DiagramSubject& subject, const Plane& plane, const Period& span) {
  for (std::size_t i = 0; i < subject.lines.size(); ++i) {
    const double known_s = std::max(subject.knownUntil_s, subject.lines[i].knots().back().turn.t_s);
    const double end_s = std::min(known_s, std::max(span.until_s, chart.yRange.y / subject.c_m_s));
    if (end_s <= span.from_s) continue;
    ChartLine line = lineOf(subject.lines[i], plane, span.from_s, end_s);
    line.name = texts::other(subject.names[i]);
    line.colour = inkOf(subject.names[i], i);
    line.width_px = 2.5F;
    chart.lines.push_back(line);
  }
}

/// Adds the sides of soft pucks, in the colours of their centres.
void addSoftSides(Chart& chart, const DiagramSubject& subject, const Plane& plane, const Period& span) {
  for (const SoftSides& puck : subject.softSides) {
    for (const std::vector<Event>& side : puck.lines) {
      ChartLine line{"", {}, inkOf(subject.names[puck.puck], puck.puck), 1.2F, ChartLine::Style::solid};
      for (const Event& event : side) {
        if (event.t_s >= span.from_s) line.points.push_back(plane(event));
      }
      if (!line.points.empty()) chart.lines.push_back(line);
    }
  }
}

/// Adds my light cone, time axis and line of simultaneity through my present event.
void addMyAxes(Chart& chart, const glm::dvec2& here, double beta) {
  using Style = ChartLine::Style;
  const glm::vec3 light(0.9F, 0.55F, 0.0F), mine(0.1F, 0.2F, 0.7F);
  chart.lines.push_back(
      through(here, {1.0, 1.0}, texts::diagram::kLightCone.words(), light, Style::dashed, 1.5F));
  chart.lines.push_back(through(here, {-1.0, 1.0}, "", light, Style::dashed, 1.5F));
  const double shown = std::abs(beta) < 0.005 ? 0.0 : beta;  // not "-0.00 c"
  chart.lines.push_back(
      through(here, {beta, 1.0}, texts::format(texts::diagram::kTimeAxis, shown), mine, Style::dotted, 2.0F));
  chart.lines.push_back(
      through(here, {1.0, beta}, texts::diagram::kSimultaneity.words(), mine, Style::dashed, 2.0F));
}

/// Adds a flash with its name and its light.
void addFlash(Chart& chart, const std::string& name, const glm::dvec2& at, const glm::vec3& colour) {
  constexpr double kFar_m = 1e3;
  chart.lines.push_back({"",
                         {at + kFar_m * glm::dvec2(-1.0, 1.0), at, at + kFar_m * glm::dvec2(1.0, 1.0)},
                         colour,
                         1.0F,
                         ChartLine::Style::solid});
  chart.lines.push_back(
      {texts::format(texts::diagram::kFlash, name), {at}, colour, 9.0F, ChartLine::Style::marks});
}

void addEvents(Chart& chart, const DiagramSubject& subject, const Plane& plane, const Period& span) {
  ChartLine happened{texts::diagram::kEvents.words(), {}, glm::vec3(0.35F), 6.0F, ChartLine::Style::marks};
  std::size_t flashes = 0;
  for (const GameEvent& event : subject.events) {
    if (event.at.t_s < span.from_s || event.at.t_s > span.until_s) continue;
    const bool isNamed = event.kind == EventKind::flash && event.which < subject.flashes.size();
    if (isNamed && flashes < kFlashColours.size()) {
      addFlash(chart, texts::other(subject.flashes[event.which]), plane(event.at), kFlashColours[flashes++]);
    } else {
      happened.points.push_back(plane(event.at));
    }
  }
  if (!happened.points.empty()) chart.lines.push_back(happened);
}

/// Adds my world line, from the last event below the lower edge on.
void addMe(Chart& chart, const DiagramSubject& subject, const Plane& plane, double from_s) {
  ChartLine me{texts::diagram::kMe.words(), {}, glm::vec3(0.0F), 3.5F, ChartLine::Style::solid};
  for (std::size_t i = 0; i < subject.mine.size(); ++i) {
    if (i + 1 == subject.mine.size() || subject.mine[i + 1].t_s >= from_s)
      me.points.push_back(plane(subject.mine[i]));
  }
  chart.lines.push_back(me);
  chart.lines.push_back({"", {plane(subject.mine.back())}, glm::vec3(0.0F), 10.0F, ChartLine::Style::marks});
}

/// Adds the world lines of the others in the room, their present events, and the lines of simultaneity of
/// each.
void addOthers(Chart& chart, std::span<const OtherObserver> others, std::size_t firstColour,
               const Plane& plane, double from_s) {
  using Style = ChartLine::Style;
  constexpr std::array<glm::vec3, kMostViewers - 1> kColours{
      {{0.65F, 0.1F, 0.5F}, {0.0F, 0.5F, 0.35F}, {0.55F, 0.35F, 0.05F}}};
  for (std::size_t i = 0; i < others.size(); ++i) {
    const OtherObserver& other = others[i];
    if (other.line.empty()) continue;
    const glm::vec3 colour = kColours[(firstColour + i) % kColours.size()];
    ChartLine line{other.name, {}, colour, 3.5F, Style::solid};
    for (std::size_t point = 0; point < other.line.size(); ++point) {
      if (point + 1 == other.line.size() || other.line[point + 1].t_s >= from_s)
        line.points.push_back(plane(other.line[point]));
    }
    chart.lines.push_back(line);
    const glm::dvec2 here = plane(other.line.back());
    chart.lines.push_back({"", {here}, colour, 10.0F, Style::marks});
    chart.lines.push_back(through(here, {1.0, plane.along(other.beta)},
                                  texts::format(texts::diagram::kSimultaneityOf, other.name), colour,
                                  Style::dashed, 2.0F));
  }
}

}  // namespace

DiagramSubject subjectOf(const Scenario& scenario) {
  DiagramSubject subject;
  subject.title = scenario.title;
  subject.c_m_s = scenario.billiard.lightSpeed_m_s;
  for (const Puck& puck : scenario.billiard.pucks) subject.names.push_back(puck.name);
  for (const ScriptedBody& body : scenario.bodies) subject.names.push_back(body.name);
  for (const Flash& flash : scenario.billiard.flashes) subject.flashes.push_back(flash.name);
  subject.board = scenario.billiard.board;
  return subject;
}

void continueLine(std::vector<Event>& line, double c_m_s, const Event& here) {
  if (!line.empty()) {
    const Displacement step = here - line.back();
    if (step.dt_s == 0.0) return;
    if (step.dt_s < 0.0 || glm::length(step.dr_m) > c_m_s * step.dt_s) line.clear();
  }
  line.push_back(here);
}

void follow(DiagramSubject& subject, const FrameRecord& record, std::span<const std::string> names) {
  const auto betaOf = [](const ViewerState& viewer) {
    return betaFromU(viewer.observer.headFromBoard.inverse().u());
  };
  continueLine(subject.mine, subject.c_m_s, record.viewers.front().observer.middle.observation);
  subject.beta = betaOf(record.viewers.front());
  subject.others.resize(record.viewerCount - 1);
  for (std::size_t i = 0; i < subject.others.size(); ++i) {
    const ViewerState& viewer = record.viewers[i + 1];
    OtherObserver& other = subject.others[i];
    other.name = i + 1 < names.size() ? names[i + 1] : "";
    other.beta = betaOf(viewer);
    continueLine(other.line, subject.c_m_s, viewer.observer.middle.observation);
  }
}

void followTold(DiagramSubject& subject, std::span<const ToldPath> people, double from_s) {
  subject.told.clear();
  for (const ToldPath& path : people) {
    OtherObserver& other = subject.told.emplace_back();
    for (const ToldMoment& moment : path.moments()) {
      if (moment.kind == ToldKind::ends || moment.head.t_s < from_s) continue;
      other.name = moment.nameText();
      other.line.push_back(moment.head);
    }
    if (other.line.size() < 2) continue;
    const Event& last = other.line.back();
    const auto before =
        std::ranges::find_if(other.line.rbegin() + 1, other.line.rend(),
                             [&](const Event& event) { return event.t_s < last.t_s - kSteady_s; });
    const Displacement way = last - (before == other.line.rend() ? other.line.front() : *before);
    other.beta = way.dr_m / (subject.c_m_s * way.dt_s);
  }
}

Chart spacetimeChart(const DiagramSubject& subject, const DiagramFrame& frame) {
  const Plane plane(frame.along, subject.c_m_s);
  const Event present = subject.mine.back();
  const double from_s = frame.from_s.value_or(std::max(0.0, present.t_s - kShown_s));
  if (!(present.t_s - from_s >= kLeast_s)) {
    throw std::runtime_error(
        fmt::format("a diagram from {:g} s to my present event at {:g} s shows nothing, expected {:g} s at "
                    "least between them",
                    from_s, present.t_s, kLeast_s));
  }
  const double until_s = present.t_s + kFuture * (present.t_s - from_s);

  Chart chart;
  chart.title = texts::format(texts::diagram::kTitle, texts::other(subject.title), subject.c_m_s);
  chart.xTitle = texts::format(texts::diagram::kAcross, frame.along);
  chart.yTitle = texts::diagram::kUpwards;
  const double half_m = halfExtent_m(subject, frame.along);
  const Period span{from_s, until_s};
  setRanges(chart, subject.c_m_s, span, half_m, reachOfPeople(subject, plane));
  if (subject.board) addCushions(chart, half_m);
  addBodies(chart, subject, plane, span);
  addSoftSides(chart, subject, plane, span);
  addMyAxes(chart, plane(present), plane.along(subject.beta));
  addEvents(chart, subject, plane, span);
  addOthers(chart, subject.others, 0, plane, from_s);
  addOthers(chart, subject.told, subject.others.size(), plane, from_s);
  addMe(chart, subject, plane, from_s);
  return chart;
}

}  // namespace carom
