// What the shipped lessons say is so: every number in their questions, right answers and explanations is
// computed here, from the same file, and must stand in the text; a number that nobody computes must not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "app/scenario/scenario.h"
#include "cave/frame/lesson_readings.h"
#include "engine/billiard/billiard.h"
#include "engine/light/light_cone.h"
#include "engine/light/vertex_history.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observers.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kEyes_m = 1.7;  // of a person who stands

/// The numbers of a text, each to be accounted for.
class Numbers {
 public:
  explicit Numbers(const std::string& text) : text_(text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto before = static_cast<unsigned char>(i > 0 ? text[i - 1] : ' ');
      const auto digit = [&](std::size_t at) { return at < text.size() && std::isdigit(text[at]) != 0; };
      if (!digit(i)) continue;
      std::size_t end = i;
      while (digit(end) || (end < text.size() && text[end] == '.' && digit(end + 1))) ++end;
      // The 1 of θ1 is a name.
      if (before < 0x80 && std::isalpha(before) == 0) left_.push_back(text.substr(i, end - i));
      i = end;
    }
  }
  ~Numbers() {
    EXPECT_TRUE(left_.empty()) << "nothing tells whether " << left_.front() << " is right in: " << text_;
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  /// That it is there, rounded to so many decimals.
  Numbers& has(double value, int decimals) {
    const std::string number = fmt::format("{:.{}f}", value, decimals);
    if (std::erase(left_, number) == 0 && std::find(found_.begin(), found_.end(), number) == found_.end())
      ADD_FAILURE() << number << " is missing in: " << text_;
    found_.push_back(number);
    return *this;
  }

 private:
  std::string text_;
  std::vector<std::string> left_, found_;
};

Scenario shipped(const std::string& name) {
  return readScenario(std::string(CAROM_CONFIG_DIR "/scenarios/") + name + ".toml");
}

/// Question, right answer and explanation.
std::string claims(const Scenario& scenario) {
  const LessonWords& words = scenario.lesson.value().words;
  return words.question + " | " + words.answers.at(words.right) + " | " + words.number;
}

Vec3 standingEye_m(const Scenario& scenario) { return scenario.observer.position_m + Vec3(0, 0, kEyes_m); }

/// The observer of the lesson's explanation: at rest in the room, at its moment.
struct Explained {
  explicit Explained(const Scenario& scenario) {
    const LessonPlan& plan = scenario.lesson.value().plan;
    const double c_m_s = scenario.billiard.lightSpeed_m_s, moment_s = plan.interval.moment_s;
    Vec3 beta = scenario.observer.beta, place_m = standingEye_m(scenario) + beta * (c_m_s * moment_s);
    if (!plan.observers.empty()) {
      beta = plan.observers.at(plan.explainedFor).beta;
      place_m = standingEye_m(scenario);
    }
    boardFromRoom = Lorentz::boost(uFromBeta(beta), c_m_s);
    observer.middle.observation = {moment_s, place_m};
  }
  double reads_s(const Stopwatch& watch) const {
    return reading_s(watch, {observer, boardFromRoom, LessonPhase::explains});
  }
  /// What the gauge of this number reads, above this puck, and which it is.
  double gauges(const Scenario& scenario, std::size_t gauge, const WorldLine& puck) const {
    const Gauge& chosen = scenario.lesson.value().plan.gauges.at(gauge);
    const Motion seen = centreSeen(puck, observer.middle.observation);
    return gauged(chosen.quantity, seen, {observer, boardFromRoom, LessonPhase::explains});
  }
  ObserverView observer;
  Lorentz boardFromRoom{1.0};
};

/// The lesson's stopwatch with this name.
const Stopwatch& watchNamed(const Scenario& scenario, const std::string& name) {
  const auto& watches = scenario.lesson.value().plan.stopwatches;
  const auto found = std::find_if(watches.begin(), watches.end(),
                                  [&](const Stopwatch& watch) { return watch.name == name; });
  if (found == watches.end()) throw std::out_of_range(name);
  return *found;
}

/// The game, played for so long.
Billiard played(const Scenario& scenario, double until_s) {
  Billiard game(scenario.billiard);
  game.advanceTo(until_s);
  return game;
}

std::size_t puckNamed(const Scenario& scenario, const std::string& name) {
  const auto& pucks = scenario.billiard.pucks;
  const auto found = std::find_if(pucks.begin(), pucks.end(), [&](const Puck& p) { return p.name == name; });
  EXPECT_NE(found, pucks.end()) << name;
  return static_cast<std::size_t>(found - pucks.begin());
}

const Flash& flashNamed(const Scenario& scenario, const std::string& name) {
  const auto& flashes = scenario.billiard.flashes;
  const auto found =
      std::find_if(flashes.begin(), flashes.end(), [&](const Flash& f) { return f.name == name; });
  if (found == flashes.end()) throw std::out_of_range(name);
  return *found;
}

/// Seconds by the clocks of who moves with u, from one event to the other.
double elapsedFor_s(const Vec3& u, const Event& from, const Event& to, double c_m_s) {
  return (Lorentz::boost(u, c_m_s).inverse() * (to - from)).dt_s;
}

/// How far a mesh reaches along x and z.
std::pair<Vec3, Vec3> boundsOf(const ScriptedBody& body) {
  std::ifstream in(body.mesh.value());
  Vec3 least(1e9), most(-1e9);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    Vec3 v(0.0);
    if (!(words >> kind >> v.x >> v.y >> v.z) || kind != "v") continue;
    least = glm::min(least, v);
    most = glm::max(most, v);
  }
  return {least, most};
}

TEST(LessonNumbers, ParallelTracks) {
  const Scenario scenario = shipped("parallel-tracks");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Billiard game = played(scenario, 2.0);
  const Vec3 eye_m = standingEye_m(scenario);
  std::vector<double> seen_s;  // when each is seen on the line
  for (const WorldLine& line : game.worldLines()) {
    const Event crossing = line.at(1.0).event;
    EXPECT_NEAR(crossing.r_m.x, 0.0, 1e-6) << "they are side by side after one second";
    seen_s.push_back(1.0 + glm::distance(eye_m, crossing.r_m) / c_m_s);
  }
  EXPECT_TRUE(std::is_sorted(seen_s.begin(), seen_s.end())) << "the nearest first";
  EXPECT_GT(seen_s.back() - seen_s.front(), 0.3);
  const auto& pucks = scenario.billiard.pucks;
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const Event crossing = game.worldLines()[i].at(1.0).event;
    const Event flash = flashNamed(scenario, pucks[i].name + " crosses").at;
    EXPECT_EQ(flash.t_s, 1.0);
    EXPECT_NEAR(glm::distance(flash.r_m, crossing.r_m), 0.0, 1e-6) << pucks[i].name;
  }
  const Explained explained(scenario);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "Light's travel time: near lane")), seen_s.front() - 1.0,
              1e-6);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "far lane")), seen_s.back() - 1.0, 1e-6);
  EXPECT_NEAR(scenario.lesson->plan.interval.moment_s, seen_s.front(), 0.005) << "the slowest is on the line";
  const Motion fastest = centreSeen(game.worldLines().back(), {seen_s.front(), eye_m});
  Numbers(claims(scenario))
      .has(seen_s.front() - 1.0, 2)
      .has(seen_s.back() - 1.0, 2)
      .has(-fastest.event.r_m.x, 2);
  EXPECT_EQ(scenario.lesson->words.right, 2u);
}

TEST(LessonNumbers, TwoCushions) {
  const Scenario scenario = shipped("two-cushions");
  const Billiard game = played(scenario, 2.0);
  std::optional<Event> left, right;
  for (const GameEvent& event : game.events()) {
    if (event.cushion == Cushion::plusX && !right) right = event.at;
    if (event.cushion == Cushion::minusX && !left) left = event.at;
  }
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->t_s, right->t_s, 1e-12);
  const Vec3 flying = uFromBeta({0.5, 0.0, 0.0});
  const double earlier_s = elapsedFor_s(flying, *right, *left, scenario.billiard.lightSpeed_m_s);
  EXPECT_GT(earlier_s, 0.0) << "the right one first: the second answer";
  for (const auto& [name, hit] : {std::pair{"left hit", *left}, {"right hit", *right}}) {
    const Event flash = flashNamed(scenario, name).at;
    EXPECT_NEAR(flash.t_s, hit.t_s, 1e-9) << name;
    EXPECT_NEAR(glm::distance(flash.r_m, hit.r_m), 0.0, 1e-9) << name;
  }
  const Explained explained(scenario);
  EXPECT_NEAR(explained.reads_s(scenario.lesson->plan.stopwatches.at(0)), earlier_s, 1e-9) << "as is drawn";
  const Event& now = explained.observer.middle.observation;
  EXPECT_NEAR(elapsed_s(now, *right, {0.5, 0.0, 0.0}, scenario.billiard.lightSpeed_m_s), -0.5 * now.r_m.x,
              1e-9)
      << "at the moment the right puck touches its cushion";
  EXPECT_NEAR(elapsedFor_s(-flying, *left, *right, scenario.billiard.lightSpeed_m_s), earlier_s, 1e-12);
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  Numbers(claims(scenario))
      .has(0.5, 1)
      .has(earlier_s, 2)
      .has(gammaFromU(flying), 3)
      .has(right->r_m.x - left->r_m.x, 2);
}

TEST(LessonNumbers, BarMeetsBar) {
  const Scenario scenario = shipped("bar-meets-bar");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Billiard game = played(scenario, 1.0);
  const auto isPair = [](const GameEvent& event) { return event.kind == EventKind::puckPuck; };
  const auto met = std::find_if(game.events().begin(), game.events().end(), isPair);
  ASSERT_NE(met, game.events().end());
  EXPECT_TRUE(met->sideOnSide);
  const Event right = flashNamed(scenario, "right ends").at, left = flashNamed(scenario, "left ends").at;
  for (const Event& end : {right, left}) {
    EXPECT_NEAR(end.t_s, met->at.t_s, 1e-12);
    EXPECT_NEAR(end.r_m.y, met->at.r_m.y, 1e-12);
  }
  EXPECT_NEAR(met->at.r_m.x, 0.0, 1e-12);
  const double length_m = right.r_m.x - left.r_m.x;
  for (const Puck& bar : scenario.billiard.pucks)  // it moves across its length
    EXPECT_NEAR(2.0 * bar.outline_m[2].x, length_m, 1e-12);
  const Vec3 flying = uFromBeta({0.5, 0.0, 0.0});
  const double earlier_s = elapsedFor_s(flying, right, left, c_m_s);
  EXPECT_GT(earlier_s, 0.0) << "the right ones first: the second answer";
  EXPECT_EQ(elapsedFor_s(Vec3(0.0), right, left, c_m_s), 0.0);
  const Explained explained(scenario);
  EXPECT_NEAR(explained.reads_s(scenario.lesson->plan.stopwatches.at(0)), earlier_s, 1e-9);
  EXPECT_NEAR(elapsedFor_s(flying, explained.observer.middle.observation, right, c_m_s), 0.0, 1e-9)
      << "the moment at which the right ends touch";
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  Numbers(claims(scenario)).has(0.5, 1).has(earlier_s, 3).has(gammaFromU(flying), 3).has(length_m, 1);
}

/// At which speed of light's a puck is seen to move along x, by an eye on its line.
double apparentBeta(const WorldLine& line, const Vec3& eye_m, double at_s) {
  constexpr double kApart_s = 0.05;
  const Event early = centreSeen(line, {at_s, eye_m}).event,
              late = centreSeen(line, {at_s + kApart_s, eye_m}).event;
  return (late.r_m.x - early.r_m.x) / (kApart_s * line.lightSpeed_m_s());
}

TEST(LessonNumbers, ComesAndGoes) {
  const Scenario scenario = shipped("comes-and-goes");
  const Billiard game = played(scenario, 8.0);
  const WorldLine& puck = game.worldLines().front();
  const Vec3 eye_m(scenario.observer.position_m.x, 0.0, puck.at(0.0).event.r_m.z);
  const double going = apparentBeta(puck, eye_m, 3.0);
  const double turn_s = puck.knots()[2].turn.t_s;  // rest, on its way, back
  const double coming =
      -apparentBeta(puck, eye_m, turn_s + (puck.knots()[2].turn.r_m.x - eye_m.x) / 1.42 + 0.1);
  const double beta = glm::length(betaFromU(puck.knots()[1].u));
  EXPECT_NEAR(glm::length(betaFromU(puck.knots()[2].u)), beta, 1e-9);
  EXPECT_GT(coming, 1.0) << "faster than light: the second answer";
  EXPECT_LT(going, beta);
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  const Explained explained(scenario);
  // By where its centre is seen a little earlier and later, from the person's eyes.
  const auto placeSeen_m = [&](double after_s) {
    Event eyes = explained.observer.middle.observation;
    eyes.t_s += after_s;
    return centreSeen(puck, eyes).event.r_m;
  };
  constexpr double kAside_s = 1e-4;
  const double drawn = glm::distance(placeSeen_m(kAside_s), placeSeen_m(-kAside_s)) / (2.0 * kAside_s) /
                       scenario.billiard.lightSpeed_m_s;
  EXPECT_GT(drawn, 1.0) << "it comes at the moment";
  EXPECT_NEAR(explained.gauges(scenario, 0, puck), drawn, 1e-3);
  Numbers(claims(scenario))
      .has(beta, 1)
      .has(going, 3)
      .has(coming, 1)
      .has(drawn, 2)
      .has(1.0, 0);  // the 1 of the formulas
}

TEST(LessonNumbers, Angles) {
  const Scenario scenario = shipped("angles");
  const Billiard game = played(scenario, 1.4);
  const auto degrees = [](double rad) { return rad * 180.0 / std::numbers::pi; };
  Numbers numbers(claims(scenario));
  int met = 0;
  for (const GameEvent& event : game.events()) {
    if (event.kind != EventKind::puckPuck) continue;
    ++met;
    const Vec2 a = glm::normalize(event.turns[0].betaAfter), b = glm::normalize(event.turns[1].betaAfter);
    const double between_deg = degrees(std::acos(glm::dot(a, b)));
    EXPECT_LT(between_deg, 90.0);
    numbers.has(between_deg, 1);
    const bool first = glm::length(event.turns[0].betaBefore) > 0.0;
    const Turn& striker = event.turns[first ? 0 : 1];
    numbers.has(glm::length(striker.betaBefore), 1);
    EXPECT_NEAR(degrees(std::abs(std::atan2(striker.betaAfter.y, striker.betaAfter.x))), 60.0, 0.01);
  }
  EXPECT_EQ(met, 2);
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  numbers.has(60.0, 0).has(90.0, 0).has(2.0, 0).has(1.0, 0);  // tan 1 × tan 2 = 2/(γ + 1), as follows
  for (const double beta : {0.2, 0.9}) {
    const double gamma = gammaFromU(uFromBeta({beta, 0.0, 0.0}));
    const double tan1 = std::tan(std::numbers::pi / 3), tan2 = 2.0 / (gamma + 1.0) / tan1;
    const std::string between = fmt::format("{:.1f}", 60.0 + degrees(std::atan(tan2)));
    EXPECT_NE(scenario.lesson->words.number.find(between), std::string::npos) << between;
  }
}

/// Both stories of the train.
struct Train {
  explicit Train(const std::string& name) : scenario(shipped(name)) {}
  Scenario scenario;
  const ScriptedBody& tunnel = scenario.bodies.at(0);
  const ScriptedBody& train = scenario.bodies.at(1);
  Vec3 u = train.worldLine.knots().front().u;
  double c_m_s = scenario.billiard.lightSpeed_m_s;
  Event nearDoor = flashNamed(scenario, "near door").at, farDoor = flashNamed(scenario, "far door").at;
  static double lengthOf_m(const ScriptedBody& body) {
    return boundsOf(body).second.x - boundsOf(body).first.x;
  }
  /// How far a door's two leaves are apart.
  double gapOf_m(const std::string& door, double t_s) const {
    double gap_m = 0.0;
    for (const ScriptedBody& body : scenario.bodies) {
      if (body.name.starts_with(door)) gap_m += std::abs(body.worldLine.at(t_s).event.r_m.y);
    }
    return gap_m;
  }
  /// That both doors are shut at that moment, and that neither touches the train, of this length and 0.076 m
  /// wide, when it passes through.
  void expectDoorsShutAt(double t_s, double length_m) const {
    const double speed_m_s = glm::length(betaFromU(u)) * c_m_s;
    EXPECT_NEAR(gapOf_m("near door", t_s), 0.0, 1e-9);
    EXPECT_NEAR(gapOf_m("far door", t_s), 0.0, 1e-9);
    const double slack_s = 0.5 * (1.0 - length_m) / speed_m_s;
    EXPECT_GT(gapOf_m("near door", t_s - slack_s), 0.076) << "when the back of the train enters";
    EXPECT_GT(gapOf_m("far door", t_s + slack_s), 0.076) << "when its front leaves";
  }
  /// On the train the far door flashes first.
  double apartOnTrain_s() const { return elapsedFor_s(u, farDoor, nearDoor, c_m_s); }
};

TEST(LessonNumbers, TrainInTunnel) {
  const Train story("train-in-tunnel");
  const double gamma = gammaFromU(story.u);
  const double train_m = Train::lengthOf_m(story.train), tunnel_m = Train::lengthOf_m(story.tunnel);
  EXPECT_EQ(story.nearDoor.t_s, story.farDoor.t_s);
  EXPECT_NEAR(story.farDoor.r_m.x - story.nearDoor.r_m.x, tunnel_m, 1e-12);
  const double middle_m = story.train.worldLine.at(story.nearDoor.t_s).event.r_m.x;
  EXPECT_LT(middle_m + 0.5 * train_m / gamma, story.farDoor.r_m.x) << "all of it is inside then";
  EXPECT_GT(middle_m - 0.5 * train_m / gamma, story.nearDoor.r_m.x);
  // By the train's clocks: where its back is when the far door flashes.
  const Displacement door = Lorentz::boost(story.u, story.c_m_s).inverse() *
                            (story.farDoor - story.train.worldLine.at(story.farDoor.t_s).event);
  EXPECT_GT(0.5 * train_m, door.dr_m.x - tunnel_m / gamma) << "its front is inside";
  EXPECT_LT(-0.5 * train_m, door.dr_m.x - tunnel_m / gamma) << "its back is not";
  EXPECT_GT(story.apartOnTrain_s(), 0.0);
  const Explained explained(story.scenario);
  EXPECT_NEAR(explained.reads_s(watchNamed(story.scenario, "train's frame")), story.apartOnTrain_s(), 1e-9);
  EXPECT_EQ(story.scenario.lesson->plan.interval.moment_s, story.nearDoor.t_s);
  story.expectDoorsShutAt(story.nearDoor.t_s, train_m / gamma);
  Numbers(claims(story.scenario))
      .has(train_m, 1)
      .has(glm::length(betaFromU(story.u)), 1)
      .has(tunnel_m, 0)
      .has(1.0 / gamma, 1)
      .has(train_m / gamma, 1)
      .has(story.apartOnTrain_s(), 2)
      .has(gamma, 3);
  EXPECT_EQ(story.scenario.lesson->words.right, 1u);
}

TEST(LessonNumbers, TrainAboard) {
  const Train story("train-aboard");
  const ObserverStart& start = story.scenario.observer;
  EXPECT_NEAR(glm::distance(start.beta, betaFromU(story.u)), 0.0, 1e-12) << "the person rides with the train";
  EXPECT_NEAR(start.position_m.x, story.train.worldLine.at(0.0).event.r_m.x - 1.0, 1e-9)
      << "behind its middle";
  const double gamma = gammaFromU(story.u), tunnel_m = Train::lengthOf_m(story.tunnel);
  EXPECT_LT(tunnel_m / gamma, Train::lengthOf_m(story.train));
  EXPECT_GT(story.apartOnTrain_s(), 0.0);
  EXPECT_NEAR(Explained(story.scenario).reads_s(story.scenario.lesson->plan.stopwatches.at(0)),
              story.apartOnTrain_s(), 1e-9);
  story.expectDoorsShutAt(story.nearDoor.t_s, Train::lengthOf_m(story.train) / gamma);
  Numbers(claims(story.scenario))
      .has(Train::lengthOf_m(story.train), 1)
      .has(tunnel_m, 0)
      .has(glm::length(betaFromU(story.u)), 1)
      .has(1.0 / gamma, 1)
      .has(story.apartOnTrain_s(), 2);
  EXPECT_EQ(story.scenario.lesson->words.right, 1u);
}

/// A pulse goes up and down in its clock: checks that it is at a mirror at each of its corners; the times of
/// its ticks.
std::vector<double> ticksOf_s(const Scenario& scenario, const Pulse& pulse, const ScriptedBody& clock,
                              const std::string& flashes) {
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const double knob_m = 0.024;  // beyond the mirror's face, on either side
  const double halfHeight_m = boundsOf(clock).second.z - knob_m;
  std::vector<double> ticks_s;
  double t_s = pulse.at_s;
  for (std::size_t i = 0; i < pulse.path_m.size(); ++i) {
    if (i > 0) t_s += glm::distance(pulse.path_m[i], pulse.path_m[i - 1]) / c_m_s;
    const Vec3 middle_m = clock.worldLine.at(t_s).event.r_m;
    const Vec3 mirror_m = middle_m + Vec3(0.0, 0.0, i % 2 == 0 ? -halfHeight_m : halfHeight_m);
    EXPECT_NEAR(glm::distance(pulse.path_m[i], mirror_m), 0.0, 2e-4) << pulse.name << ' ' << i;
    if (i == 0 || i % 2 != 0) continue;
    ticks_s.push_back(t_s);
    const Event flash = flashNamed(scenario, fmt::format("{} {}", flashes, ticks_s.size())).at;
    EXPECT_NEAR(flash.t_s, t_s, 1e-9);
    EXPECT_EQ(flash.r_m, pulse.path_m[i]);
  }
  return ticks_s;
}

TEST(LessonNumbers, LightClock) {
  const Scenario scenario = shipped("light-clock");
  const Pulse &resting = scenario.pulses.at(0), &flying = scenario.pulses.at(1);
  const auto rested_s = ticksOf_s(scenario, resting, scenario.bodies.at(0), "resting tick");
  const auto flew_s = ticksOf_s(scenario, flying, scenario.bodies.at(1), "flying tick");
  ASSERT_FALSE(rested_s.empty() || flew_s.empty());
  EXPECT_NEAR(rested_s.back(), flew_s.back(), 1e-9) << "both have ticked for as long";
  const Vec3 first_m = flying.path_m.front(), last_m = flying.path_m.at(2 * flew_s.size());
  EXPECT_NEAR(first_m.x, -last_m.x, 1e-9) << "as far from an observer in the middle";
  const Event seen = Explained(scenario).observer.middle.observation;
  ASSERT_EQ(scenario.lesson->plan.counters.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& ticks = scenario.lesson->plan.counters[i].ticks;
    const auto count = std::count_if(ticks.begin(), ticks.end(), [&](const Event& tick) {
      return seen.t_s - tick.t_s >= glm::distance(seen.r_m, tick.r_m) / scenario.billiard.lightSpeed_m_s;
    });
    EXPECT_EQ(static_cast<std::size_t>(count), (i == 0 ? rested_s : flew_s).size())
        << "counted at the moment";
  }
  const double gamma = gammaFromU(scenario.bodies.at(1).worldLine.knots().front().u);
  EXPECT_NEAR(static_cast<double>(rested_s.size()) / static_cast<double>(flew_s.size()), gamma, 1e-12);
  const Vec3 slanted_m = flying.path_m.at(1) - flying.path_m.at(0);
  Numbers(claims(scenario))
      .has(glm::length(betaFromU(scenario.bodies.at(1).worldLine.knots().front().u)), 1)
      .has(static_cast<double>(rested_s.size()), 0)
      .has(static_cast<double>(flew_s.size()), 0)
      .has(rested_s.front(), 2)
      .has(flew_s.front(), 2)
      .has(gamma, 2)
      .has(slanted_m.z, 3)
      .has(slanted_m.x, 4)
      .has(glm::length(slanted_m), 4)
      .has(1.0, 0);  // of 1/√(1 − β²)
  EXPECT_EQ(scenario.lesson->words.right, 1u);
}

TEST(LessonNumbers, PairsOfFour) {
  const Scenario scenario = shipped("pairs-4");
  Numbers numbers(claims(scenario));
  for (const int lane : {1, 2}) {
    const auto uOf = [&](const char* side) {
      const Puck& puck = scenario.billiard.pucks[puckNamed(scenario, fmt::format("{} {}", side, lane))];
      return uFromBeta(Vec3(puck.beta, 0.0));
    };
    const double c_m_s = scenario.billiard.lightSpeed_m_s, beta = betaFromU(uOf("left")).x;
    const Lorentz oneFromOther =
        Lorentz::boost(uOf("left"), c_m_s).inverse() * Lorentz::boost(uOf("right"), c_m_s);
    const double relative = glm::length(betaFromU(oneFromOther.u()));
    EXPECT_NEAR(relative, 2.0 * beta / (1.0 + beta * beta), 1e-12);
    numbers.has(relative, 3);
    if (lane == 1) {
      numbers.has(relative, 2).has(beta, 1);
    } else {
      numbers.has(2.0 * beta, 1).has(1.0 + beta * beta, 2);
    }
  }
  const Billiard game = played(scenario, 2.0);
  const Explained explained(scenario);
  const double drawn[] = {explained.gauges(scenario, 0, game.worldLines()[puckNamed(scenario, "left 1")]),
                          explained.gauges(scenario, 1, game.worldLines()[puckNamed(scenario, "right 1")])};
  EXPECT_NEAR(drawn[0], 0.0, 1e-6);
  EXPECT_NEAR(drawn[1], 1.2 / 1.36, 1e-6);
  numbers.has(std::abs(drawn[0]), 2).has(drawn[1], 2).has(1.0, 0);
  EXPECT_EQ(scenario.lesson->words.right, 1u);
}

/// How long a puck is seen to be along x between these points of it, `half_m` before and behind its centre,
/// in lengths at rest.
double seenLength(const WorldLine& line, double half_m, const Event& eye) {
  const auto seen = [&](double offset_m) {
    return emission(line, {offset_m, 0.0, 0.0}, eye, Lorentz(line.lightSpeed_m_s())).value().event.r_m.x;
  };
  return (seen(half_m) - seen(-half_m)) / (2.0 * half_m);
}

TEST(LessonNumbers, SeenLength) {
  const Scenario scenario = shipped("seen-length");
  const Billiard game = played(scenario, 9.0);
  const std::size_t moving = puckNamed(scenario, "moving"), resting = puckNamed(scenario, "at rest");
  const WorldLine& line = game.worldLines()[moving];
  const double radius_m = scenario.billiard.pucks[moving].radius_m;
  const double beta = glm::length(betaFromU(line.at(1.0).u));
  EXPECT_EQ(radius_m, scenario.billiard.pucks[resting].radius_m);
  const Vec3 onItsLine_m(scenario.observer.position_m.x, line.at(0.0).event.r_m.y, line.at(0.0).event.r_m.z);
  const double going = seenLength(line, radius_m, {2.5, onItsLine_m});
  const double coming = seenLength(line, radius_m, {5.8, onItsLine_m});
  EXPECT_NEAR(coming, 2.0, 1e-6) << "twice: the second answer";
  EXPECT_EQ(scenario.lesson->words.answers[scenario.lesson->words.right], "Twice as long");
  const Explained explained(scenario);
  const Event now = explained.observer.middle.observation;
  EXPECT_LT(centreSeen(line, now).u.x, 0.0) << "it comes at the moment";
  const double drawn[] = {explained.gauges(scenario, 0, line),
                          explained.gauges(scenario, 1, game.worldLines()[resting])};
  EXPECT_NEAR(drawn[0], seenLength(line, 1e-4, now), 1e-5);
  EXPECT_NEAR(drawn[0], seenLength(line, radius_m, now), 0.01)
      << "the whole puck looks as long, as far as one reads";
  EXPECT_NEAR(drawn[1], 1.0, 1e-12);
  Numbers(claims(scenario))
      .has(beta, 1)
      .has(coming, 0)
      .has(going, 1)
      .has(std::sqrt(1.0 - beta * beta), 1)
      .has(drawn[0], 2)
      .has(drawn[1], 2)
      .has(1.0, 0);
}

// By the points' own world lines.
TEST(LessonNumbers, RollingWheel) {
  const Scenario scenario = shipped("rolling-wheel");
  const Billiard game = played(scenario, 6.0);
  const WorldLine& line = game.worldLines()[0];
  const Puck& wheel = scenario.billiard.pucks[0];
  const double c_m_s = scenario.billiard.lightSpeed_m_s, omega = line.knots()[0].spin.omega_rad_s;
  for (const GameEvent& event : game.events())
    EXPECT_EQ(event.kind, EventKind::flash) << "it touches the cushion and meets nothing";
  const double hub = glm::length(betaFromU(line.at(1.0).u)), rim = omega * wheel.radius_m / c_m_s;
  EXPECT_NEAR(rim, hub, 1e-12);
  double slowest = 1.0, fastest = 0.0;
  const auto history = vertexHistory(line, {wheel.radius_m, 0.0, 0.0});
  for (double t_s = 1.0; t_s < 5.0; t_s += 1e-3) {
    const double speed = glm::length(betaFromU(uAt(pieceAt(history, t_s), t_s, c_m_s)));
    slowest = std::min(slowest, speed), fastest = std::max(fastest, speed);
  }
  EXPECT_LT(slowest, 5e-3) << "it rests: the second answer";
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  const double gamma = 1.0 / std::sqrt(1.0 - hub * hub);
  // The wedge of the mesh is at its +y, and rests where it touches the cushion.
  const auto wedge = vertexHistory(line, {0.0, wheel.radius_m, 0.0});
  for (const char* name : {"wedge at the cushion", "wedge there again"}) {
    const Event flash = flashNamed(scenario, name).at;
    const VertexPiece& piece = pieceAt(wedge, flash.t_s);
    EXPECT_NEAR(glm::distance(placeAt(piece, flash.t_s, c_m_s), flash.r_m), 0.0, 1e-5) << name;
    EXPECT_LT(glm::length(uAt(piece, flash.t_s, c_m_s)), 1e-4) << name;
  }
  const double turn_s = 2.0 * std::numbers::pi / omega;  // of the hub's clock
  const Explained explained(scenario);
  EXPECT_NEAR(
      explained.reads_s(watchNamed(scenario, "One turn since the wedge left the cushion: table's frame")),
      gamma * turn_s, 1e-5);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "hub's frame")), turn_s, 1e-5);
  Numbers(claims(scenario))
      .has(hub, 1)
      .has(2.0 * hub, 1)
      .has(hub * hub, 2)
      .has(fastest, 2)
      .has(gamma, 2)
      .has(gamma * turn_s, 2)
      .has(turn_s, 2)
      .has(0.0, 0)
      .has(1.0, 0)
      .has(2.0, 0);
}

TEST(LessonNumbers, SpinningDisc) {
  const Scenario scenario = shipped("spinning-disc");
  const Billiard game = played(scenario, 11.0);
  const WorldLine& line = game.worldLines()[0];
  const double c_m_s = scenario.billiard.lightSpeed_m_s, radius_m = scenario.billiard.pucks[0].radius_m;
  const auto history = vertexHistory(line, {radius_m, 0.0, 0.0});
  const double rim_s = properTimeAt(pieceAt(history, 10.0), 10.0, c_m_s);
  const double rim = line.knots()[0].spin.omega_rad_s * radius_m / c_m_s, gamma = 10.0 / rim_s;
  EXPECT_EQ(scenario.lesson->words.right, 1u) << "less";
  // What the clocks in the middle and on the rim are seen to show, cut off after tenths as they are drawn.
  const Event now = Explained(scenario).observer.middle.observation;
  const auto shown_s = [&](const Vec3& point_m) {
    const auto way = vertexHistory(line, point_m);
    const double left_s = eventOnPastCone(way, now, c_m_s).t_s;
    return std::floor(10.0 * properTimeAt(pieceAt(way, left_s), left_s, c_m_s)) / 10.0;
  };
  double least_s = 1e9, most_s = -1e9;
  for (int k = 0; k < 6; ++k) {
    const double angle_rad = std::numbers::pi * k / 3.0;
    const double clock_s = shown_s({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), 0.0});
    least_s = std::min(least_s, clock_s), most_s = std::max(most_s, clock_s);
  }
  Numbers(claims(scenario))
      .has(rim, 1)
      .has(gamma, 2)
      .has(rim_s, 1)
      .has(shown_s(Vec3(0.0)), 1)
      .has(least_s, 1)
      .has(most_s, 1);
}

TEST(LessonNumbers, SeenAtOnce) {
  const Scenario scenario = shipped("seen-at-once");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Event left = flashNamed(scenario, "left flash").at, right = flashNamed(scenario, "right flash").at;
  EXPECT_EQ(left.t_s, right.t_s) << "neither: the second answer";
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  const Vec3 eye_m = standingEye_m(scenario);
  const double left_m = glm::distance(eye_m, left.r_m), right_m = glm::distance(eye_m, right.r_m);
  const Explained explained(scenario);
  EXPECT_GT(explained.observer.middle.observation.t_s, right.t_s + right_m / c_m_s) << "both have been seen";
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "Travel time: left")), left_m / c_m_s, 1e-9);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "right")), right_m / c_m_s, 1e-9);
  const double earlier_s = elapsedFor_s(uFromBeta({0.5, 0.0, 0.0}), right, left, c_m_s);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "Right to left flash, your frame")), earlier_s, 1e-9);
  Numbers(claims(scenario))
      .has(left_m / c_m_s, 2)
      .has(right_m / c_m_s, 2)
      .has(right_m - left_m, 2)
      .has((right_m - left_m) / c_m_s, 2)
      .has(0.5, 1)
      .has(earlier_s, 2);
}

// Flown here in steps of a millisecond by the observer's own hyperbolae, at rest in the room.
TEST(LessonNumbers, Twins) {
  const Scenario scenario = shipped("twins");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Head head{{{0.0, 0.0, kEyes_m}, {1.0, 0.0, 0.0, 0.0}}, Vec3(0.0)};
  Observers traveller(Lorentz(c_m_s), {0.0, scenario.observer.position_m}, head);
  const Vec3 home_m = traveller.headEvent().r_m;
  constexpr double kStep_s = 1e-3;
  Numbers numbers(claims(scenario));
  double firstLeg_s = 0.0, leg_s = 0.0, size_m_s2 = 0.0;
  for (const ThrustLeg& leg : scenario.tour) {
    size_m_s2 = glm::length(leg.thrust_m_s2);
    leg_s = leg_s == 0.0 ? leg.for_s : std::min(leg_s, leg.for_s);
    for (int i = 0; i < static_cast<int>(std::lround(leg.for_s / kStep_s)); ++i) {
      traveller.step(kStep_s, head, 1.0, leg.thrust_m_s2);
    }
    if (firstLeg_s == 0.0) firstLeg_s = traveller.headEvent().t_s;
  }
  EXPECT_NEAR(glm::distance(traveller.headEvent().r_m, home_m), 0.0, 1e-6) << "back home";
  EXPECT_NEAR(glm::length(traveller.boardFromRoom().u()), 0.0, 1e-6) << "and at rest";
  EXPECT_NEAR(firstLeg_s, c_m_s / size_m_s2 * std::sinh(size_m_s2 * leg_s / c_m_s), 1e-6);
  EXPECT_GT(traveller.headEvent().t_s, traveller.properTime_s()) << "longer: the second answer";
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  const Event& back = traveller.headEvent();
  EXPECT_NEAR(scenario.lesson->plan.interval.moment_s, back.t_s, 0.001) << "the end of the flight";
  Explained explained(scenario);
  explained.observer.properTime_s = traveller.properTime_s();
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "Your clock")), traveller.properTime_s(), 1e-12);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "Clock at home, now")), back.t_s, 0.001);
  const Puck& home = scenario.billiard.pucks.at(puckNamed(scenario, "home"));
  const Vec3 clock_m(home.position_m, 0.5 * home.height_m);
  const double light_s = glm::distance(clock_m, back.r_m) / c_m_s;
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "as you see it")), back.t_s - light_s, 0.001);
  numbers.has(traveller.properTime_s(), 0)
      .has(traveller.properTime_s(), 2)
      .has(back.t_s, 2)
      .has(light_s, 2)
      .has(traveller.properTime_s() / leg_s, 0)
      .has(leg_s, 0)
      .has(size_m_s2, 1)
      .has(firstLeg_s, 2);
}

// Walked here to and fro in steps of a frame, by the clocks of two observers in one room.
TEST(LessonNumbers, TwinsInOneRoom) {
  const Scenario scenario = shipped("twins-in-one-room");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  constexpr double kWalk_m_s = 0.6, kWalked_s = 20.0, kStep_s = 1.0 / 60.0;
  std::array<Head, 2> heads;
  heads[1].roomFromHead.position_m = {0.7, 0.0, 0.3};
  Observers pair(Lorentz(c_m_s), {0.0, scenario.observer.position_m}, heads);
  const int frames = static_cast<int>(std::lround(kWalked_s / kStep_s));
  for (int frame = 0; frame < frames; ++frame) {
    const double way = frame % 120 < 60 ? 1.0 : -1.0;
    heads[0].roomFromHead.position_m.x += way * kWalk_m_s * kStep_s;
    pair.beginFrame();
    pair.step(kStep_s, heads);
  }
  const double walked_s = pair.properTime_s(0), stood_s = pair.properTime_s(1);
  EXPECT_NEAR(walked_s, kWalked_s, 1e-9) << "who moves fastest keeps the display's time";
  EXPECT_EQ(scenario.lesson->words.right, 2u) << "theirs who stood";
  Numbers(claims(scenario))
      .has(kWalked_s, 0)
      .has(kWalk_m_s, 2)
      .has(c_m_s, 2)
      .has(walked_s, 1)
      .has(stood_s, 1)
      .has(stood_s / walked_s, 3)
      .has(1.0, 0);  // under the root
}

/// The velocity of a puck for an observer who moves along x at 0.6 c.
double betaFor(const WorldLine& line, double at_s) {
  const double beta = betaFromU(line.at(at_s).u).x;
  return (beta - 0.6) / (1.0 - 0.6 * beta);
}

TEST(LessonNumbers, SameLaws) {
  const Scenario scenario = shipped("same-laws");
  const LessonInterval& interval = scenario.lesson->plan.interval;
  const Billiard game = played(scenario, interval.until_s);
  const Vec3 eye_m = scenario.observer.position_m + Vec3(0.0, 0.0, 1.7);
  const auto seen_s = [&](const GameEvent& event) {
    return event.at.t_s + glm::distance(event.at.r_m, eye_m) / scenario.billiard.lightSpeed_m_s;
  };
  const double hit_s = game.events().front().at.t_s, after_s = hit_s + 0.5;
  for (const GameEvent& event : game.events().subspan(1)) {
    EXPECT_GT(event.at.t_s, after_s);
    EXPECT_GT(seen_s(event), interval.until_s)
        << "one collision, and no cushion is seen while the lesson shows";
  }
  EXPECT_GT(seen_s(game.events().front()), interval.from_s + 0.5) << "one sees before it";
  EXPECT_LT(seen_s(game.events().front()), interval.moment_s - 0.2) << "and after it";
  const WorldLine& white = game.worldLines()[puckNamed(scenario, "white")];
  const WorldLine& red = game.worldLines()[puckNamed(scenario, "red")];
  const auto beta = [](const WorldLine& line, double at_s) { return betaFromU(line.at(at_s).u).x; };
  EXPECT_NEAR(beta(white, 0.0), 0.6, 1e-12);
  EXPECT_EQ(beta(red, 0.0), 0.0);
  EXPECT_NEAR(beta(white, after_s), 0.0, 1e-12);
  EXPECT_NEAR(beta(red, after_s), 0.6, 1e-12);
  // In the frame that moves with white at first the roles are exchanged: the first answer.
  EXPECT_NEAR(betaFor(white, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(betaFor(red, 0.0), -0.6, 1e-12);
  EXPECT_NEAR(betaFor(white, after_s), -0.6, 1e-12);
  EXPECT_NEAR(betaFor(red, after_s), 0.0, 1e-12);
  EXPECT_EQ(scenario.lesson->words.right, 0u);
  EXPECT_EQ(scenario.lesson->plan.observers.at(1).beta, Vec3(0.6, 0.0, 0.0));
  const Explained explained(scenario);
  EXPECT_NEAR(explained.gauges(scenario, 0, white), -betaFor(white, after_s), 1e-9);
  EXPECT_NEAR(explained.gauges(scenario, 1, red), betaFor(red, after_s), 1e-9);
  Numbers(claims(scenario))
      .has(0.6, 1)
      .has(-betaFor(white, after_s), 2)
      .has(std::abs(betaFor(red, after_s)), 2)
      .has(0.6 / std::sqrt(1.0 - 0.36), 2);
}

TEST(LessonNumbers, Cause) {
  const Scenario scenario = shipped("cause");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Event a = flashNamed(scenario, "A").at, b = flashNamed(scenario, "B").at,
              c = flashNamed(scenario, "C").at;
  const double toB_s = glm::distance(a.r_m, b.r_m) / c_m_s, toC_s = glm::distance(a.r_m, c.r_m) / c_m_s;
  EXPECT_LT(toB_s, b.t_s - a.t_s) << "a signal from A reaches B in time";
  EXPECT_GT(toC_s, c.t_s - a.t_s) << "none reaches C: the second answer";
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  // In every frame B is after A; in some C is before it.
  for (double beta = -0.99; beta < 1.0; beta += 0.01)
    EXPECT_GT(elapsedFor_s(uFromBeta({beta, 0.0, 0.0}), a, b, c_m_s), 0.0) << beta;
  const Vec3 moving = uFromBeta(scenario.lesson->plan.observers.at(1).beta);
  const double aToB_s = elapsedFor_s(moving, a, b, c_m_s), cToA_s = elapsedFor_s(moving, c, a, c_m_s);
  EXPECT_GT(cToA_s, 0.0);
  const Explained explained(scenario);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "From A to B, your frame")), aToB_s, 1e-9);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "From A to C, your frame")), -cToA_s, 1e-9);
  // At the moment that it holds the ring of A's light has passed B, which has just flashed, and not reached
  // C.
  const double now_s = explained.observer.middle.observation.t_s, ring_m = c_m_s * (now_s - a.t_s);
  EXPECT_GT(ring_m, glm::distance(a.r_m, b.r_m));
  EXPECT_LT(ring_m, glm::distance(a.r_m, c.r_m));
  EXPECT_GT(now_s, b.t_s);
  EXPECT_LT(now_s, b.t_s + 0.1);
  EXPECT_GT(now_s, c.t_s);
  for (const LessonLabel& label : scenario.lesson->plan.labels)
    EXPECT_EQ(label.at_m, flashNamed(scenario, label.words).at.r_m) << label.words;
  EXPECT_EQ(scenario.lesson->plan.labels.size(), 3U);
  Numbers(claims(scenario))
      .has(glm::distance(a.r_m, b.r_m), 1)
      .has(b.t_s - a.t_s, 2)
      .has(glm::distance(a.r_m, c.r_m), 1)
      .has(c.t_s - a.t_s, 2)
      .has(toB_s, 2)
      .has(toC_s, 2)
      .has(0.6, 1)
      .has(cToA_s, 2)
      .has(aToB_s, 2);
}

TEST(LessonNumbers, OneSpacetime) {
  const Scenario scenario = shipped("one-spacetime");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Event a = flashNamed(scenario, "A").at, b = flashNamed(scenario, "B").at,
              c = flashNamed(scenario, "C").at;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {a, c}}) {
    EXPECT_GT(to.t_s, from.t_s) << "by the table's clocks";
    EXPECT_LT(interval_m2(to - from, c_m_s), 0.0) << "no light connects them";
  }
  const Lesson& lesson = *scenario.lesson;
  EXPECT_EQ(lesson.words.right, 2u);
  EXPECT_EQ(lesson.views.spacetime, 1);
  EXPECT_EQ(lesson.explains.spacetime, 1);
  const Vec3 moving = uFromBeta(lesson.plan.observers.at(1).beta);
  const double cToA_s = elapsedFor_s(moving, c, a, c_m_s), bToA_s = elapsedFor_s(moving, b, a, c_m_s);
  EXPECT_GT(bToA_s, 0.0) << "B is before A for the friend,";
  EXPECT_GT(cToA_s, bToA_s) << "and C before B: the third answer";
  const Explained explained(scenario);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "From C to A, your frame")), cToA_s, 1e-9);
  EXPECT_NEAR(explained.reads_s(watchNamed(scenario, "From B to A, your frame")), bToA_s, 1e-9);
  const Event& now = explained.observer.middle.observation;
  for (const Event& flash : {a, b, c}) {
    EXPECT_LT(flash.t_s + glm::distance(flash.r_m, now.r_m) / c_m_s, now.t_s)
        << "has been seen at the moment";
  }
  Numbers(claims(scenario))
      .has(b.t_s - a.t_s, 2)
      .has(c.t_s - a.t_s, 2)
      .has(0.6, 1)
      .has(cToA_s, 2)
      .has(bToA_s, 2)
      .has(1.0 / std::sqrt(1.0 - 0.36), 2);
}

TEST(LessonNumbers, MassEnergy) {
  const Scenario scenario = shipped("mass-energy");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Billiard game = played(scenario, 4.0);
  ASSERT_EQ(game.events().size(), 1U);
  const GameEvent& meeting = game.events().front();
  double masses = 0.0;  // in units of one puck's
  const double mass_kg = scenario.billiard.pucks.front().mass_kg;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scenario.billiard.pucks[i].mass_kg, mass_kg);
    EXPECT_EQ(game.worldLines()[i].at(3.0).u, Vec3(0.0)) << "both rest afterwards";
    masses += std::sqrt(1.0 + glm::dot(game.worldLines()[i].at(0.0).u, game.worldLines()[i].at(0.0).u));
  }
  const double heat = meeting.heat_j / (mass_kg * c_m_s * c_m_s);
  EXPECT_NEAR(heat, masses - 2.0, 1e-9) << "the game's own account";
  const Explained explained(scenario);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(explained.gauges(scenario, i, game.worldLines()[i]), 1.0, 1e-9) << "they are seen at rest";
  ASSERT_EQ(scenario.lesson->plan.labels.size(), 1U);
  EXPECT_EQ(scenario.lesson->plan.labels.front().words, fmt::format("hot: {:.1f} M", masses));
  EXPECT_EQ(scenario.lesson->words.right, 1u);
  Numbers(claims(scenario))
      .has(0.6, 1)
      .has(2.0, 0)
      .has(masses, 1)
      .has(masses / 2.0, 2)
      .has(meeting.heat_j, 2)
      .has(mass_kg, 1)
      .has(c_m_s, 2);
}

// A force F along the motion gives a = F/(γ³m), one across F/(γm): from p = γ m v by differences.
TEST(LessonNumbers, Heavier) {
  const Scenario scenario = shipped("heavier");
  const auto momentum = [](double mass_kg, const Vec3& beta) {
    return mass_kg / std::sqrt(1.0 - glm::dot(beta, beta)) * beta;
  };
  EXPECT_TRUE(scenario.lesson->plan.holds);
  EXPECT_EQ(scenario.lesson->words.right, 2u);
  Numbers numbers(claims(scenario));
  const Billiard game = played(scenario, 1.0);
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    constexpr double kStep = 1e-6;
    const Puck& puck = scenario.billiard.pucks[i];
    const Vec3 beta = betaFromU(game.worldLines()[i].at(1.0).u);  // after the stroke
    const auto inertia = [&](const Vec3& way) {
      return glm::length(momentum(puck.mass_kg, beta + kStep * way) - momentum(puck.mass_kg, beta)) / kStep;
    };
    const double along_kg = inertia({1.0, 0.0, 0.0}), across_kg = inertia({0.0, 1.0, 0.0});
    EXPECT_EQ(puck.mass_kg, 0.2);
    if (beta.x == 0.0) {
      EXPECT_NEAR(along_kg, across_kg, 1e-6);
      numbers.has(beta.x, 0).has(along_kg, 1);
    } else {
      numbers.has(beta.x, 1).has(along_kg, beta.x > 0.85 ? 1 : 2).has(across_kg, 2);
    }
  }
}

/// A shock into matter at rest whose end is pushed to V, c = 1: momentum and energy are kept across it, with
/// the rest energy 1 + (a/2)(s + 1/s − 2) + q of matter stretched s times.
struct Shock {
  double speed = 0.0, stretch = 0.0;  ///< on the board; of the matter behind it, in its own frame
};
Shock shockOf(double V, double a) {
  const double gamma2 = 1.0 / (1.0 - V * V);
  const auto lacks = [&](double S) {
    const double s = std::sqrt(gamma2) * (S - V) / S, p = 0.5 * a * (1.0 / (s * s) - 1.0);
    const double density = p / (gamma2 * V * (S - V)) - p;  // of own energy, from the balance of momentum
    return gamma2 * (density + p * V * V) * (S - V) - S - p * V;
  };
  double low = V + 1e-3, high = 1.0 - 1e-9;
  const bool sign = lacks(low) > 0.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    ((lacks(middle) > 0.0) == sign ? low : high) = middle;
  }
  return {low, std::sqrt(gamma2) * (low - V) / low};
}

/// How much matter is stretched whose end is pulled to V: along the smooth wave the rapidity grows by c_s
/// ds/s.
double stretchOfPull(double V, double a) {
  double s = 1.0;
  constexpr double kStep = 1e-6;
  for (double rapidity = 0.0; rapidity < std::atanh(V); s += kStep) {
    const double p = 0.5 * a * (1.0 / (s * s) - 1.0), e = 1.0 + 0.5 * a * (s + 1.0 / s - 2.0);
    rapidity += std::sqrt((a / s) / (e + s * p)) * kStep / s;
  }
  return s;
}

/// When the far side of a soft puck hears for the first time.
double farSideHears_s(const Billiard& game, std::size_t puck) {
  for (const GameEvent& event : game.events()) {
    if (event.kind == EventKind::farSide && event.turns.front().puck == puck) return event.at.t_s;
  }
  ADD_FAILURE() << "the far side never hears";
  return 0.0;
}

TEST(LessonNumbers, Solid) {
  const Scenario scenario = shipped("solid");
  const double c_m_s = scenario.billiard.lightSpeed_m_s, V = scenario.bodies.front().worldLine.at(2.0).u.x;
  const double pushed = V / std::sqrt(1.0 + V * V);
  const Billiard game = played(scenario, 2.5);
  Numbers numbers(claims(scenario));
  numbers.has(pushed, 1);
  for (const std::string name : {"behind", "in front"}) {
    const std::size_t number = puckNamed(scenario, name);
    const Puck& rod = scenario.billiard.pucks[number];
    const double length_m = 2.0 * std::abs(rod.outline_m.front().x), sound = rod.soft->soundSpeed;
    const Shock shock = shockOf(pushed, sound * sound);
    const double light_s = length_m / c_m_s, needs_s = light_s / shock.speed;
    EXPECT_NEAR(farSideHears_s(game, number) - 1.0, needs_s, 0.07 * light_s) << "as it is played";
    const auto flash = std::find_if(scenario.billiard.flashes.begin(), scenario.billiard.flashes.end(),
                                    [&](const Flash& one) { return one.name == "start, " + name; });
    ASSERT_NE(flash, scenario.billiard.flashes.end());
    EXPECT_NEAR(flash->at.t_s, 1.0 + needs_s, 1e-3);
    EXPECT_NEAR(flash->at.r_m.x, rod.position_m.x + 0.5 * length_m, 1e-12);
    if (name == "behind") numbers.has(shock.speed, 3);
    numbers.has(sound, 1).has(1.0 / shock.speed, 2).has(needs_s, 2).has(light_s, 2);
    // At the lesson's moment the near end is seen to have gone, and the far end not.
    const double moment_s = scenario.lesson->plan.interval.moment_s;
    const auto seen_s = [&](double x_m) {
      return moment_s - glm::distance(standingEye_m(scenario), Vec3(x_m, rod.position_m.y, 0.0)) / c_m_s;
    };
    EXPECT_GT(seen_s(rod.position_m.x - 0.5 * length_m), 1.15);
    EXPECT_LT(seen_s(rod.position_m.x + 0.5 * length_m), 1.0 + needs_s - 0.1);
  }
  EXPECT_EQ(scenario.lesson->words.right, 2u);
}

TEST(LessonNumbers, BellString) {
  const Scenario scenario = shipped("bell-string");
  const Puck& string = scenario.billiard.pucks.front();
  const double sound = string.soft->soundSpeed, half_m = std::abs(string.outline_m.front().x);
  const double light_s = 2.0 * half_m / scenario.billiard.lightSpeed_m_s;
  const double u = scenario.bodies.front().worldLine.at(2.0).u.x, V = u / std::hypot(1.0, u);
  const Shock push = shockOf(V, sound * sound);
  const double middleHears_s = 0.5 * light_s / std::max(push.speed, sound);
  Billiard game(scenario.billiard);
  const std::vector<SoftPoint> points{{0, {-0.9 * half_m, 0.0}}, {0, {0.0, 0.0}}, {0, {0.9 * half_m, 0.0}}};
  const auto at = [&](double t_s) {
    game.advanceTo(t_s);
    return game.softAt(t_s, points).points;
  };
  const auto waits = at(1.0 + 0.9 * middleHears_s);
  EXPECT_NEAR(waits[0]->beta.x, V, 0.03);
  EXPECT_NEAR(waits[1]->beta.x, 0.0, 0.01) << "the middle rests";
  EXPECT_NEAR(waits[2]->beta.x, V, 0.05);
  EXPECT_GT(at(1.0 + 1.2 * middleHears_s)[1]->beta.x, 0.05);
  const auto last = at(9.0);
  EXPECT_NEAR((last[2]->position_m.x - last[0]->position_m.x) / (1.8 * half_m), 1.0, 0.01)
      << "as far apart as before, on the board";
  EXPECT_EQ(scenario.lesson->words.right, 2u);
  Numbers(claims(scenario))
      .has(V, 1)
      .has(1.0 / std::sqrt(1.0 - V * V), 3)
      .has(1.0, 0)
      .has(middleHears_s, 2)
      .has(push.stretch, 2)
      .has(stretchOfPull(V, sound * sound), 2);
}

TEST(LessonNumbers, SoftAndRigid) {
  const Scenario scenario = shipped("soft-and-rigid");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const std::size_t rigid = puckNamed(scenario, "rigid"), soft = puckNamed(scenario, "soft");
  const Puck& puck = scenario.billiard.pucks[soft];
  const double came = puck.beta.x, gamma = 1.0 / std::sqrt(1.0 - came * came);
  Billiard game(scenario.billiard);
  const std::vector<SoftPoint> ends{{soft, {-puck.radius_m, 0.0}}, {soft, {puck.radius_m, 0.0}}};
  double least_m = 2.0 * puck.radius_m;
  SoftMoment moment;
  for (double t_s = 0.9; t_s < 2.5; t_s += 0.005) {
    game.advanceTo(t_s);
    moment = game.softAt(t_s, ends);
    least_m = std::min(least_m, moment.points[1]->position_m.x - moment.points[0]->position_m.x);
  }
  ASSERT_EQ(moment.contacts.size(), 1u);
  const double lasts_s = moment.contacts[0].parted_s.value() - moment.contacts[0].contact.t_s;
  const double mass = moment.pucks[soft]->restMass_kg / puck.mass_kg;
  EXPECT_FALSE(moment.pucks[rigid]) << "it stays rigid";
  EXPECT_NEAR(betaFromU(game.worldLines()[rigid].at(2.5).u).x, -came, 1e-12);
  // On the board energy is kept: what the mass has gained, the motion has lost.
  const double speed = -moment.pucks[soft]->beta.x;
  EXPECT_NEAR(mass / std::sqrt(1.0 - speed * speed), gamma, 1e-9);
  EXPECT_EQ(scenario.lesson->words.right, 2u);
  Numbers(claims(scenario))
      .has(came, 1)
      .has(2.0 / gamma, 2)
      .has(least_m / puck.radius_m, 2)
      .has(lasts_s * c_m_s / puck.radius_m, 1)
      .has(speed, 2)
      .has(mass, 2)
      .has(100.0 * (mass - 1.0) / (gamma - 1.0), 0);
}

}  // namespace
}  // namespace carom
