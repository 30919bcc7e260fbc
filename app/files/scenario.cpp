#include "app/files/scenario.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/files/toml_file.h"
#include "engine/base/limits.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

namespace {

constexpr double kDefaultPuckHeight_m = 0.02;
/// Rounding of what a file says exactly: pucks and cushions that touch to this fraction do not overlap.
constexpr double kTouching = 1e-12;

Vec2 toVec2(const std::array<double, 2>& a) { return {a[0], a[1]}; }
Vec3 toVec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

template <class Vec>
void checkSpeed(const TomlTable& table, const Vec& beta) {
  if (glm::dot(beta, beta) < 1.0) return;
  table.fault("beta",
              fmt::format("beta has magnitude {}, expected a speed below light, under 1", glm::length(beta)));
}

Vec2 readBeta2(const TomlTable& table) {
  const Vec2 beta = toVec2(table.numbers<2>("beta", {}));
  checkSpeed(table, beta);
  return beta;
}

Board readBoard(const TomlTable& table) {
  return {.length_m = table.number("length_m", kPositive), .width_m = table.number("width_m", kPositive)};
}

PhysicsRules readRules(const TomlTable& table) {
  constexpr Range kRestitution{.least = 0.0, .most = 1.0};
  constexpr std::array<std::string_view, 2> kEvents{"centre", "contact"};  // in the order of CollisionEvent
  PhysicsRules rules;
  rules.puckRestitution = table.number("puck_restitution", kRestitution, rules.puckRestitution);
  rules.cushionRestitution = table.number("cushion_restitution", kRestitution, rules.cushionRestitution);
  rules.friction_m_s2 = table.number("friction_m_s2", kNotNegative, rules.friction_m_s2);
  rules.collisionEvent = static_cast<CollisionEvent>(table.choice("collision_event", kEvents, 0));
  return rules;
}

ObserverStart readObserver(const TomlTable& table) {
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const ObserverStart start;
  const auto& p = start.position_m;
  ObserverStart observer;
  observer.position_m = toVec3(table.numbers<3>("position_m", {}, {{p.x, p.y, p.z}}));
  observer.facing_rad = table.number("facing_deg", {}, start.facing_rad / kRadPerDeg) * kRadPerDeg;
  observer.beta = toVec3(table.numbers<3>("beta", {}, {{0.0, 0.0, 0.0}}));
  if (table.has("beta")) checkSpeed(table, observer.beta);
  return observer;
}

std::optional<std::filesystem::path> readMesh(const TomlFile& file, const TomlTable& table) {
  if (!table.has("mesh")) return {};
  return file.existingFile(table, "mesh");
}

Puck readPuck(const TomlTable& table) {
  return {.name = table.text("name"),
          .radius_m = table.number("radius_m", kPositive),
          .height_m = table.number("height_m", kPositive, kDefaultPuckHeight_m),
          .mass_kg = table.number("mass_kg", kPositive),
          .position_m = toVec2(table.numbers<2>("position_m", {})),
          .beta = readBeta2(table)};
}

/// One leg of a scripted body.
struct Leg {
  double from_s = 0.0;  ///< of the first leg: unused
  Vec3 u{0.0};
};

std::vector<Leg> readLegs(const TomlTable& body) {
  std::vector<Leg> legs;
  double last_s = -std::numeric_limits<double>::infinity();
  for (const TomlTable& table : body.tables("leg")) {
    Leg leg;
    if (legs.empty()) {
      table.refuse("from_s",
                   "has no meaning on the first leg, which reaches back to the beginning; expected none");
    } else {
      leg.from_s = table.number("from_s", {});
      if (table.has("from_s") && !(leg.from_s > last_s)) {
        table.fault("from_s", fmt::format("from_s is {}, expected a time after the leg before it, above {}",
                                          leg.from_s, last_s));
      }
      last_s = leg.from_s;
    }
    const Vec3 beta = toVec3(table.numbers<3>("beta", {}));
    checkSpeed(table, beta);
    leg.u = glm::dot(beta, beta) < 1.0 ? uFromBeta(beta) : Vec3(0.0);
    legs.push_back(leg);
  }
  if (legs.empty()) body.fault("leg", "there is no leg here, expected one [[body.leg]] at least");
  return legs;
}

/// The centre on a straight leg that it passes at `event`, at board time `t_s`.
Event alongLeg(const Event& event, const Vec3& u, double t_s, double c_m_s) {
  return {t_s, event.r_m + betaFromU(u) * (c_m_s * (t_s - event.t_s))};
}

/// World line of a body whose centre passes `at`, on whichever leg holds that time: the events of its turns
/// follow from there in both directions.
WorldLine scriptedWorldLine(const std::vector<Leg>& legs, const Event& at, std::optional<double> appears_s,
                            double c_m_s) {
  std::size_t holding = 0;
  while (holding + 1 < legs.size() && legs[holding + 1].from_s <= at.t_s) ++holding;
  std::vector<Event> begins(legs.size(), at);  // of the first leg: an event on it
  for (std::size_t i = holding; i > 0; --i) {
    begins[i] = alongLeg(i == holding ? at : begins[i + 1], legs[i].u, legs[i].from_s, c_m_s);
    begins[i - 1] = begins[i];
  }
  for (std::size_t i = holding + 1; i < legs.size(); ++i) {
    begins[i] = alongLeg(i == holding + 1 ? at : begins[i - 1], legs[i - 1].u, legs[i].from_s, c_m_s);
  }

  std::vector<Knot> knots;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    Knot knot{.turn = begins[i], .u = legs[i].u, .signal = begins[i]};
    if (i > 0) knot.properTime_s = motionOnLeg(knots.back(), knot.turn.t_s, c_m_s).properTime_s;
    knots.push_back(knot);
  }

  // The clock shows 0 where the body appears, or at board time 0.
  const double zero_s = appears_s.value_or(0.0);
  const auto holdsZero = std::find_if(knots.rbegin(), knots.rend() - 1,
                                      [&](const Knot& knot) { return knot.turn.t_s <= zero_s; });
  const double shown_s = motionOnLeg(*holdsZero, zero_s, c_m_s).properTime_s;
  for (Knot& knot : knots) knot.properTime_s -= shown_s;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WorldLine line(knots.front(), c_m_s, kInfinity, appears_s.value_or(-kInfinity));
  for (std::size_t i = 1; i < knots.size(); ++i) line.append(knots[i]);
  return line;
}

/// A body as the file gives it, before its world line can be laid.
struct BodyText {
  TomlTable table;
  std::string name;
  std::optional<std::filesystem::path> mesh;
  Event at;
  std::optional<double> appears_s;
  std::vector<Leg> legs;
};

BodyText readBody(const TomlFile& file, const TomlTable& table) {
  BodyText body{table, table.text("name"), readMesh(file, table), {}, {}, {}};
  if (const auto at = table.requiredTable("at")) {
    body.at = {at->number("t_s", {}), toVec3(at->numbers<3>("r_m", {}))};
  }
  if (table.has("appears_s")) body.appears_s = table.number("appears_s", {});
  body.legs = readLegs(table);
  return body;
}

/// A stroke as the file gives it, before its puck is looked up.
struct StrokeText {
  TomlTable table;
  std::string puck;
  Stroke stroke;
};

StrokeText readStroke(const TomlTable& table) {
  StrokeText text{.table = table, .puck = table.text("puck"), .stroke = {}};
  text.stroke.at_s = table.number("at_s", kNotNegative);
  if (table.has("from_m")) text.stroke.from_m = toVec3(table.numbers<3>("from_m", {}));
  text.stroke.momentum_kg_m_s = toVec2(table.numbers<2>("momentum_kg_m_s", {}));
  return text;
}

Flash readFlash(const TomlTable& table, std::size_t index) {
  return {table.text("name", fmt::format("flash {}", index + 1)),
          {table.number("at_s", kNotNegative), toVec3(table.numbers<3>("r_m", {}))}};
}

/// A leg without `from_s` follows the one before it.
std::vector<ThrustLeg> readTour(const TomlTable& tour, double c_m_s) {
  std::vector<ThrustLeg> legs;
  const double most_m_s2 = strongestThrust_m_s2(c_m_s);
  double free_s = 0.0;  // from when on
  for (const TomlTable& table : tour.tables("leg")) {
    const ThrustLeg leg{.from_s = table.number("from_s", kNotNegative, free_s),
                        .for_s = table.number("for_s", kPositive),
                        .thrust_m_s2 = toVec3(table.numbers<3>("thrust_m_s2", {}))};
    if (leg.from_s < free_s) {
      table.fault("from_s", fmt::format("from_s is {}, expected a time after the leg before it, {} or above",
                                        leg.from_s, free_s));
    }
    if (const double thrust_m_s2 = glm::length(leg.thrust_m_s2);
        thrust_m_s2 > most_m_s2 * (1.0 + kTouching)) {
      table.fault(
          "thrust_m_s2",
          fmt::format("the thrust is {:.6g} m/s², expected {:.6g} at most: with more, light from {:.3g} m "
                      "behind would never catch up with the person",
                      thrust_m_s2, most_m_s2, c_m_s * c_m_s / most_m_s2));
    }
    free_s = std::max(free_s, leg.from_s + leg.for_s);
    legs.push_back(leg);
  }
  if (legs.empty()) tour.fault("leg", "there is no leg here, expected one [[tour.leg]] at least");
  return legs;
}

bool readTourAtOnce(const TomlTable& tour) {
  constexpr std::array<std::string_view, 2> kStarts{"asked", "at once"};
  return tour.choice("starts", kStarts, 0) == 1;
}

/// Along a leg of constant thrust |γβ| is largest at an end of it.
void checkTourSpeed(const std::vector<ThrustLeg>& legs, const ObserverStart& start, const TomlTable& tour,
                    double c_m_s) {
  const glm::dquat facing = glm::angleAxis(start.facing_rad - std::numbers::pi / 2, Vec3(0.0, 0.0, 1.0));
  Lorentz boardFromRoom = Lorentz::boost(uFromBeta(start.beta), c_m_s) * Lorentz::rotation(facing, c_m_s);
  const double most_u = std::max(kMostPlatformU, glm::length(boardFromRoom.u()));
  const std::vector<TomlTable> tables = tour.tables("leg");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    boardFromRoom =
        boardFromRoom * Lorentz::fromRapidity(legs[i].thrust_m_s2 * (legs[i].for_s / c_m_s), c_m_s);
    if (glm::length(boardFromRoom.u()) <= most_u) continue;
    tables[i].fault("for_s",
                    fmt::format("after this leg the platform is faster than {:.4g} of light's speed, "
                                "expected slower: the game would have to run more than {:.0f} s in "
                                "one of the person's",
                                most_u / std::hypot(1.0, most_u), std::hypot(1.0, most_u)));
    return;
  }
}

Pulse readPulse(const TomlTable& table) {
  Pulse pulse{.name = table.text("name"), .at_s = table.number("at_s", {}), .path_m = {}};
  for (const auto& place : table.points("path_m")) pulse.path_m.push_back(toVec3(place));
  if (!table.has("path_m")) return pulse;
  if (pulse.path_m.size() < 2) {
    table.fault("path_m", fmt::format("path_m has {}, expected two places at least",
                                      pulse.path_m.empty() ? "no place" : "one place"));
  }
  for (std::size_t i = 1; i < pulse.path_m.size(); ++i) {
    if (pulse.path_m[i] != pulse.path_m[i - 1]) continue;
    table.fault("path_m", fmt::format("path_m[{}] is the place before it, expected another", i));
  }
  return pulse;
}

/// In letters, not in bytes.
std::size_t lettersOf(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void checkLength(const TomlTable& table, FilePlace place, std::string_view name, std::string_view text,
                 std::size_t most) {
  const std::size_t letters = lettersOf(text);
  if (letters <= most) return;
  table.fault(place, fmt::format("{} has {} letters, expected {} at most, which a wall can show", name,
                                 letters, most));
}

std::string readWords(const TomlTable& table, std::string_view key, std::size_t most) {
  std::string text = table.text(key);
  checkLength(table, table.place(key), key, text, most);
  return text;
}

constexpr std::size_t kFewestAnswers = 2;

std::vector<std::string> readAnswers(const TomlTable& table) {
  std::vector<std::string> answers;
  for (const PlacedText& answer : table.texts("answers")) {
    checkLength(table, answer.place, fmt::format("answers[{}]", answers.size()), answer.text,
                Lesson::kAnswerLetters);
    answers.push_back(answer.text);
  }
  if (answers.size() < kFewestAnswers || answers.size() > kMostAnswers) {
    table.fault("answers",
                fmt::format("a lesson has {} answer{} here, expected answers = [...] with two to four",
                            answers.size(), answers.size() == 1 ? "" : "s"));
  }
  return answers;
}

TimeViews readViews(const TomlTable& table) {
  std::vector<std::string> names;
  for (const NamedView& view : kNamedViews) names.emplace_back(view.name);
  TimeViews views;
  for (const PlacedText& given : table.texts("views")) {
    const auto found = std::find(names.begin(), names.end(), given.text);
    if (found != names.end()) {
      views.*kNamedViews[static_cast<std::size_t>(found - names.begin())].value = 1;
      continue;
    }
    if (given.text.empty()) continue;  // a fault already
    const auto nearest = nearestWord(given.text, names);
    table.fault(given.place, fmt::format("there is no view '{}', expected {}", given.text,
                                         nearest ? fmt::format("'{}'?", *nearest)
                                                 : fmt::format("one of {}", fmt::join(names, ", "))));
  }
  return views;
}

Lesson readLesson(const TomlTable& table, const std::string& title) {
  Lesson lesson;
  LessonWords& words = lesson.words;
  words.title = title;
  words.question = readWords(table, "question", Lesson::kQuestionLetters);
  words.answers = readAnswers(table);
  const bool offered = words.answers.size() >= kFewestAnswers && words.answers.size() <= kMostAnswers;
  const std::size_t answers = offered ? words.answers.size() : kMostAnswers;
  words.right = static_cast<std::size_t>(table.integer("right", 1, static_cast<int>(answers)) - 1);
  words.todo = readWords(table, "todo", Lesson::kTextLetters);
  words.notice = readWords(table, "notice", Lesson::kTextLetters);
  words.number = readWords(table, "number", Lesson::kTextLetters);
  lesson.views = readViews(table);
  return lesson;
}

void checkNames(const std::vector<TomlTable>& pucks, const std::vector<TomlTable>& bodies,
                const std::vector<TomlTable>& flashes, const std::vector<TomlTable>& pulses) {
  std::map<std::string, FilePlace> first;
  for (const auto* tables : {&pucks, &bodies, &flashes, &pulses}) {
    for (const TomlTable& table : *tables) {
      if (tables == &flashes && !table.has("name")) continue;
      const std::string name = table.text("name");
      const auto [known, isNew] = first.emplace(name, table.place("name"));
      if (isNew) continue;
      table.fault("name", fmt::format("the name '{}' is taken in line {}, expected another", name,
                                      known->second.line));
    }
  }
}

/// Shape of the contracted puck in the board: the ellipse xᵀ S⁻¹ x = 1 with S = R²(1 − β βᵀ), semi-axes R/γ
/// along the motion and R across it.
glm::dmat2 shapeOf(const Puck& puck) {
  return puck.radius_m * puck.radius_m * (glm::dmat2(1.0) - glm::outerProduct(puck.beta, puck.beta));
}

/// Whether two pucks' ellipses overlap at board time 0: with d from centre to centre they do if and only if
/// λ(1−λ) dᵀ[(1−λ)A + λB]⁻¹d, concave in λ, stays below 1 on 0 < λ < 1 (Perram, Wertheim 1985, eq. 3.7).
bool overlap(const Puck& a, const Puck& b) {
  const Vec2 d = b.position_m - a.position_m;
  if (glm::length(d) >= (a.radius_m + b.radius_m) * (1.0 - kTouching)) return false;
  const glm::dmat2 shapeA = shapeOf(a), shapeB = shapeOf(b);
  const auto contact = [&](double l) {
    return l * (1.0 - l) * glm::dot(d, glm::inverse((1.0 - l) * shapeA + l * shapeB) * d);
  };
  double low = 0.0, high = 1.0;
  constexpr int kSteps = 90;  // (2/3)^90 of the interval is below rounding
  for (int i = 0; i < kSteps; ++i) {
    const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
    if (contact(left) < contact(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return contact(0.5 * (low + high)) < 1.0 - kTouching;
}

/// Distance from the centre to the rim along the board's x and y: sqrt(nᵀSn).
Vec2 reachOf(const Puck& puck) { return puck.radius_m * glm::sqrt(1.0 - puck.beta * puck.beta); }

void checkPlaces(const BilliardSetup& setup, const std::vector<TomlTable>& tables) {
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    if (setup.board) {
      const Vec2 room = 0.5 * Vec2(setup.board->length_m, setup.board->width_m) - reachOf(puck);
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(puck.position_m[axis]) <= room[axis] + kTouching * puck.radius_m) continue;
        tables[i].fault("position_m",
                        fmt::format("puck '{}' reaches over the {} cushion, expected its centre's {} "
                                    "within ±{:.6g} m",
                                    puck.name, "xy"[axis], "xy"[axis], room[axis]));
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!overlap(setup.pucks[j], puck)) continue;
      tables[i].fault("position_m", fmt::format("puck '{}' overlaps puck '{}' at t = 0, expected pucks apart",
                                                puck.name, setup.pucks[j].name));
    }
  }
}

/// What only the game itself can tell.
void checkPlayable(const BilliardSetup& setup, const TomlTable& root) {
  try {
    const Billiard trial(setup);
  } catch (const std::invalid_argument& error) {
    root.fault(FilePlace{}, fmt::format("{}, expected a game that can be played", error.what()));
  }
}

/// Under friction the points of a puck stay slower than light only while R a < c²/2.
void checkFriction(const BilliardSetup& setup, const TomlTable& physics) {
  const double most_m2_s2 = 0.5 * setup.lightSpeed_m_s * setup.lightSpeed_m_s;
  for (const Puck& puck : setup.pucks) {
    if (puck.radius_m * setup.rules.friction_m_s2 < most_m2_s2) continue;
    physics.fault("friction_m_s2",
                  fmt::format("friction_m_s2 is {}, expected below {:.6g}: times the radius of "
                              "puck '{}' it must stay under half the square of light_speed_m_s",
                              setup.rules.friction_m_s2, most_m2_s2 / puck.radius_m, puck.name));
    return;
  }
}

std::vector<Stroke> resolveStrokes(const std::vector<StrokeText>& texts, const std::vector<Puck>& pucks) {
  std::vector<Stroke> strokes;
  std::vector<std::string> names;
  for (const Puck& puck : pucks) names.push_back(puck.name);
  for (const StrokeText& text : texts) {
    strokes.push_back(text.stroke);
    const auto found = std::find(names.begin(), names.end(), text.puck);
    strokes.back().puck = static_cast<std::size_t>(found - names.begin());
    if (found != names.end()) continue;
    const auto nearest = nearestWord(text.puck, names);
    text.table.fault("puck",
                     fmt::format("there is no puck '{}', expected {}", text.puck,
                                 nearest ? fmt::format("'{}'?", *nearest) : "the name of a [[puck]]"));
  }
  return strokes;
}

Scenario readScenario(const TomlFile& file, const std::string& name) {
  const TomlTable& root = file.root();
  Scenario scenario;
  scenario.title = root.text("title", name);
  scenario.billiard.lightSpeed_m_s = root.number("light_speed_m_s", kPositive);
  if (const auto board = root.table("board")) scenario.billiard.board = readBoard(*board);
  const auto physics = root.table("physics");
  if (physics) scenario.billiard.rules = readRules(*physics);
  if (const auto observer = root.table("observer")) scenario.observer = readObserver(*observer);

  const std::vector<TomlTable> pucks = root.tables("puck");
  for (const TomlTable& puck : pucks) {
    scenario.billiard.pucks.push_back(readPuck(puck));
    scenario.puckMeshes.push_back(readMesh(file, puck));
  }
  const std::vector<TomlTable> bodyTables = root.tables("body");
  std::vector<BodyText> bodies;
  for (const TomlTable& body : bodyTables) bodies.push_back(readBody(file, body));
  std::vector<StrokeText> strokes;
  for (const TomlTable& stroke : root.tables("stroke")) strokes.push_back(readStroke(stroke));
  const std::vector<TomlTable> flashes = root.tables("flash");
  for (const TomlTable& flash : flashes)
    scenario.billiard.flashes.push_back(readFlash(flash, scenario.billiard.flashes.size()));
  const std::vector<TomlTable> pulses = root.tables("pulse");
  for (const TomlTable& pulse : pulses) scenario.pulses.push_back(readPulse(pulse));
  const auto tour = root.table("tour");
  if (tour) {
    scenario.tour = readTour(*tour, scenario.billiard.lightSpeed_m_s);
    scenario.tourAtOnce = readTourAtOnce(*tour);
  }
  if (const auto lesson = root.table("lesson")) scenario.lesson = readLesson(*lesson, scenario.title);
  file.throwFaults();

  checkNames(pucks, bodyTables, flashes, pulses);
  checkPlaces(scenario.billiard, pucks);
  if (physics) checkFriction(scenario.billiard, *physics);
  if (tour) checkTourSpeed(scenario.tour, scenario.observer, *tour, scenario.billiard.lightSpeed_m_s);
  scenario.billiard.strokes = resolveStrokes(strokes, scenario.billiard.pucks);
  file.throwFaults();
  checkPlayable(scenario.billiard, root);
  file.throwFaults();

  for (const BodyText& body : bodies) {
    scenario.bodies.push_back(
        {body.name, scriptedWorldLine(body.legs, body.at, body.appears_s, scenario.billiard.lightSpeed_m_s),
         body.mesh});
  }
  return scenario;
}

}  // namespace

Scenario readScenario(const std::filesystem::path& path) {
  return readScenario(TomlFile(path), path.stem().string());
}

Scenario readScenario(const std::filesystem::path& path, const std::string& kept) {
  return readScenario(TomlFile(path, kept), path.stem().string());
}

}  // namespace carom
