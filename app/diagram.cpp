#include "app/diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/chart_file.h"
#include "app/game.h"
#include "app/scenario.h"
#include "app/session_file.h"
#include "cave/puck_model.h"

namespace carom {
namespace {

constexpr double kShown_s = 5.0;   // of board time, below the present event
constexpr double kLeast_s = 0.2;   // that a diagram shows
constexpr double kFuture = 0.5;    // of the time below the present, shown above it
constexpr double kEyes_m = 1.7;    // above the floor, where a scenario begins
constexpr double kMargin_m = 0.3;  // beside the board
constexpr int kHeight_px = 1100, kLeastWidth_px = 760, kMostWidth_px = 2400;

/// What a diagram is of. Board frame.
struct Subject {
  std::string title;
  double c_m_s = 1.0;
  std::vector<std::string> names;
  std::vector<WorldLine> lines;  ///< one for each name
  std::optional<Board> board;
  std::vector<Event> mine;  ///< my world line, to the present event
  Vec3 beta{0.0};           ///< mine, there
};

std::vector<std::string> namesOf(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Puck& puck : scenario.billiard.pucks) names.push_back(puck.name);
  for (const ToldBody& body : scenario.bodies) names.push_back(body.name);
  return names;
}

/// Of a scenario: the room goes on as it begins.
Subject subjectOf(const Scenario& scenario, double until_s) {
  Billiard billiard(scenario.billiard);
  billiard.advanceTo((1.0 + kFuture) * until_s);
  Subject subject{scenario.title,
                  scenario.billiard.lightSpeed_m_s,
                  namesOf(scenario),
                  {},
                  scenario.billiard.board,
                  {},
                  {}};
  subject.lines.assign(billiard.worldLines().begin(), billiard.worldLines().end());
  for (const ToldBody& body : scenario.bodies) subject.lines.push_back(body.worldLine);
  subject.beta = scenario.observer.beta;
  const Vec3 eyes_m = scenario.observer.position_m + Vec3(0.0, 0.0, kEyes_m);
  for (const double t_s : {0.0, until_s})
    subject.mine.push_back({t_s, eyes_m + subject.beta * (subject.c_m_s * t_s)});
  return subject;
}

/// Of a recorded session, to its end or to a board time.
Subject subjectOf(const std::filesystem::path& file, const std::optional<double>& until_s) {
  SessionFile session(file);
  const Scenario scenario = readScenario(session.facts().scenario, session.facts().scenarioText);
  Subject subject{scenario.title,
                  session.facts().lightSpeed_m_s,
                  namesOf(scenario),
                  {},
                  scenario.billiard.board,
                  {},
                  {}};
  World world{startingHistories(scenario), {}};
  for (FrameState state; session.next(state);) {
    const Event& here = state.record.observer.eyes[2].observation;
    if (until_s && here.t_s > *until_s) break;
    applyFrame(state, world);
    subject.mine.push_back(here);
    subject.beta = betaFromU(state.record.observer.headFromBoard.inverse().u());
  }
  if (subject.mine.empty())
    throw std::runtime_error(fmt::format("session file {}: no frame of it is that early", file.string()));
  subject.lines.assign(world.histories.begin() + 1, world.histories.end());  // without what rests on the board
  return subject;
}

/// A board event as a point of the figure.
class Plane {
 public:
  Plane(char along, double c_m_s) : axis_(along == 'x' ? 0 : 1), c_m_s_(c_m_s) {}
  glm::dvec2 operator()(const Event& event) const { return {event.r_m[axis_], c_m_s_ * event.t_s}; }
  double along(const Vec3& v) const { return v[axis_]; }

 private:
  int axis_;
  double c_m_s_;
};

/// Linear light to what a figure's colours are, and no paler than can be told from the paper.
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

/// The straight line through an event, its slope dx/d(ct), from one edge of the figure to the other.
ChartLine through(const glm::dvec2& event, const glm::dvec2& direction, const std::string& name,
                  const glm::vec3& colour, ChartLine::Style style, float width_px) {
  constexpr double kFar_m = 1e3;
  return {name, {event - kFar_m * direction, event + kFar_m * direction}, colour, width_px, style};
}

Chart chartOf(const Subject& subject, const DiagramOptions& options) {
  using Style = ChartLine::Style;
  const Plane plane(options.along, subject.c_m_s);
  const Event present = subject.mine.back();
  const double from_s = options.from_s.value_or(std::max(0.0, present.t_s - kShown_s));
  if (!(present.t_s - from_s >= kLeast_s)) {
    throw std::runtime_error(
        fmt::format("a diagram from {:g} s to my present event at {:g} s shows nothing, expected {:g} s at "
                    "least between them",
                    from_s, present.t_s, kLeast_s));
  }
  const double until_s = present.t_s + kFuture * (present.t_s - from_s);

  Chart chart;
  chart.title = fmt::format("{}: light at {} m/s goes at 45°", subject.title, subject.c_m_s);
  chart.xTitle = fmt::format("{} (m)", options.along);
  chart.yTitle = "ct (m)";
  chart.yRange = subject.c_m_s * glm::dvec2(from_s, until_s);
  const double half_m =
      subject.board ? (options.along == 'x' ? subject.board->length_m : subject.board->width_m) / 2 : 1.0;
  const glm::dvec2 here = plane(present);
  chart.xRange = {std::min(-half_m, here.x) - kMargin_m, std::max(half_m, here.x) + kMargin_m};
  // As wide as light at 45° asks for, but no wider than a page: then time goes on above.
  const double least_m =
      (chart.xRange.y - chart.xRange.x) * (kHeight_px - kChartBottom_px - kChartTop_px) / kMostWidth_px;
  chart.yRange.y = std::max(chart.yRange.y, chart.yRange.x + least_m);
  const double px_m = (kHeight_px - kChartBottom_px - kChartTop_px) / (chart.yRange.y - chart.yRange.x);
  const int width_px =
      static_cast<int>(px_m * (chart.xRange.y - chart.xRange.x)) + kChartLeft_px + kChartRight_px;
  chart.size_px = {std::max(width_px, kLeastWidth_px), kHeight_px};
  const double more_m = (chart.size_px.x - width_px) / px_m;
  chart.xRange += glm::dvec2(-more_m / 2, more_m / 2);

  if (subject.board) {
    for (const double side : {-half_m, half_m}) {
      chart.lines.push_back({side < 0 ? "cushions" : "",
                             {{side, chart.yRange.x}, {side, chart.yRange.y}},
                             glm::vec3(0.6F),
                             5.0F,
                             Style::solid});
    }
  }
  for (std::size_t i = 0; i < subject.lines.size(); ++i) {
    ChartLine line =
        lineOf(subject.lines[i], plane, from_s, std::max(until_s, chart.yRange.y / subject.c_m_s));
    line.name = subject.names[i];
    line.colour = inkOf(subject.names[i], i);
    line.width_px = 2.5F;
    chart.lines.push_back(line);
  }
  const glm::vec3 light(0.9F, 0.55F, 0.0F), mine(0.1F, 0.2F, 0.7F);
  chart.lines.push_back(through(here, {1.0, 1.0}, "light of my present event", light, Style::dashed, 1.5F));
  chart.lines.push_back(through(here, {-1.0, 1.0}, "", light, Style::dashed, 1.5F));
  const double beta = plane.along(subject.beta);
  chart.lines.push_back(
      through(here, {beta, 1.0}, fmt::format("my time: {:.2f} c", beta), mine, Style::dotted, 2.0F));
  chart.lines.push_back(through(here, {1.0, beta}, "my now", mine, Style::dashed, 2.0F));
  ChartLine me{"me", {}, glm::vec3(0.0F), 3.5F, Style::solid};
  for (const Event& event : subject.mine) me.points.push_back(plane(event));
  chart.lines.push_back(me);
  chart.lines.push_back({"", {here}, glm::vec3(0.0F), 10.0F, Style::marks});
  return chart;
}

bool isScenario(const std::filesystem::path& source) { return source.extension() == ".toml"; }

}  // namespace

int runDiagram(const DiagramOptions& options) {
  const Subject subject = isScenario(options.source)
                              ? subjectOf(readScenario(options.source), options.until_s.value_or(kShown_s))
                              : subjectOf(options.source, options.until_s);
  writeChart(chartOf(subject, options), options.figure);
  fmt::print(stderr, "The diagram is in {}.\n", options.figure.string());
  return 0;
}

}  // namespace carom
