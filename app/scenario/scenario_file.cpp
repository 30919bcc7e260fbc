#include "app/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <string_view>
#include <unordered_map>

#include "app/file_keys/scenario_keys.h"
#include "app/scenario/scenario_bodies.h"
#include "app/scenario/scenario_checks.h"
#include "app/scenario/scenario_lesson.h"
#include "app/scenario/scenario_outline.h"
#include "app/scenario/scenario_soft.h"
#include "app/scenario/scenario_spin.h"
#include "app/scenario/scenario_tour.h"
#include "app/toml/toml_values.h"
#include "engine/game/setup_check.h"

namespace carom {

namespace {

Vec2 readBeta2(const TomlTable& table) {
  const Vec2 beta = toVec2(table.numbers<2>("beta"));
  checkSpeed(table, beta);
  return beta;
}

Board readBoard(const TomlTable& table) {
  return {.length_m = table.number("length_m"), .width_m = table.number("width_m")};
}

PhysicsRules readRules(const TomlTable& table) {
  PhysicsRules rules;
  rules.puckRestitution = table.number("puck_restitution");
  rules.cushionRestitution = table.number("cushion_restitution");
  rules.friction_m_s2 = table.number("friction_m_s2");
  rules.puckFriction = table.number("puck_friction");
  rules.cushionFriction = table.number("cushion_friction");
  rules.tangentialRestitution = table.number("tangential_restitution");
  rules.spinDeceleration_m_s2 = table.number("spin_deceleration_m_s2");
  rules.stiffSoundSpeed = table.number("stiff_sound_speed");
  rules.collisionEvent = static_cast<CollisionEvent>(table.choice("collision_event"));
  return rules;
}

ObserverStart readObserver(const TomlTable& table) {
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  ObserverStart observer;
  observer.position_m = toVec3(table.numbers<3>("position_m"));
  observer.facing_rad = table.number("facing_deg") * kRadPerDeg;
  observer.beta = toVec3(table.numbers<3>("beta"));
  if (table.has("beta")) checkSpeed(table, observer.beta);
  return observer;
}

/// Reads in how many sectors the puck's mesh is painted.
void readSectors(const TomlTable& table, std::optional<PuckMesh>& mesh) {
  if (!table.has("sectors")) return;
  const int sectors = table.integer("sectors");
  if (!mesh) table.fault("sectors", "sectors paint a mesh, expected the key mesh, too");
  if (sectors % 2 != 0)
    table.fault("sectors", fmt::format("sectors is {}, expected an even number: they alternate", sectors));
  if (mesh && sectors % 2 == 0) mesh->sectors = sectors;
}

Puck readPuck(const TomlTable& table, double c_m_s, std::optional<PuckMesh>& mesh) {
  Puck puck;
  puck.name = table.text("name");
  readShape(table, puck, mesh);
  readSectors(table, mesh);
  puck.height_m = table.number("height_m");
  puck.mass_kg = table.number("mass_kg");
  puck.position_m = toVec2(table.numbers<2>("position_m"));
  puck.beta = readBeta2(table);
  puck.inertia = table.numberOr("inertia", puck.inertia);  // that of its shape
  if (puck.inertia < kLeastInertia) {
    table.fault("inertia", fmt::format("inertia is {}, expected at least {}", puck.inertia, kLeastInertia));
    puck.inertia = kLeastInertia;
  }
  puck.spin_kg_m2_s = readSpin(table, puck, c_m_s);
  readSoft(table, puck);
  return puck;
}

/// A stroke as given in the file, before its puck is looked up.
struct StrokeText {
  TomlTable table;
  std::string puck;
  Stroke stroke;
};

StrokeText readStroke(const TomlTable& table) {
  StrokeText text{.table = table, .puck = table.text("puck"), .stroke = {}};
  text.stroke.at_s = table.number("at_s");
  if (table.has("from_m")) text.stroke.from_m = toVec3(table.numbers<3>("from_m"));
  text.stroke.momentum_kg_m_s = toVec2(table.numbers<2>("momentum_kg_m_s"));
  text.stroke.offset_m = table.number("offset_m");
  return text;
}

Flash readFlash(const TomlTable& table, std::size_t index) {
  return {table.text("name", fmt::format("flash {}", index + 1)),
          {table.number("at_s"), toVec3(table.numbers<3>("r_m"))}};
}

Pulse readPulse(const TomlTable& table) {
  Pulse pulse{.name = table.text("name"), .at_s = table.number("at_s"), .path_m = {}};
  const auto places = table.points("path_m");
  if (!places) return pulse;
  for (const PlacedPoint& place : *places) pulse.path_m.push_back({place.at[0], place.at[1], place.at[2]});
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

FollowedLamp readLamp(const TomlTable& table) {
  return {toVec3(table.numbers<3>("position_m")), table.number("on_s"),
          glm::vec3(table.number("power") * toVec3(table.numbers<3>("colour")))};
}

std::vector<Stroke> resolveStrokes(const std::vector<StrokeText>& texts, const std::vector<Puck>& pucks) {
  std::vector<Stroke> strokes;
  std::vector<std::string> names;
  std::unordered_map<std::string_view, std::size_t> places;
  for (const Puck& puck : pucks) {
    places.emplace(puck.name, names.size());
    names.push_back(puck.name);
  }
  constexpr std::size_t kSearched = 1000;  // names, in which a mistyped one is looked for
  std::size_t mistyped = 0;
  for (const StrokeText& text : texts) {
    strokes.push_back(text.stroke);
    if (const auto found = places.find(text.puck); found != places.end()) {
      strokes.back().puck = found->second;
      checkOffset(text.table, text.stroke, pucks[found->second]);
      continue;
    }
    const bool isSearched = ++mistyped < kMostFindings && names.size() < kSearched;
    const auto nearest = isSearched ? nearestWord(text.puck, names) : std::nullopt;
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
  scenario.billiard.lightSpeed_m_s = root.number("light_speed_m_s");
  if (const auto board = root.table("board")) scenario.billiard.board = readBoard(*board);
  const auto physics = root.table("physics");
  if (physics) scenario.billiard.rules = readRules(*physics);
  if (const auto observer = root.table("observer")) {
    scenario.observer = readObserver(*observer);
    scenario.most_u = readMost_u(*observer);
  }

  const std::vector<TomlTable> pucks = root.tables("puck");
  for (const TomlTable& puck : pucks) {
    std::optional<PuckMesh>& mesh = scenario.puckMeshes.emplace_back();
    if (const auto path = readMesh(file, puck)) mesh = {*path, {}};
    scenario.billiard.pucks.push_back(readPuck(puck, scenario.billiard.lightSpeed_m_s, mesh));
  }
  const std::vector<TomlTable> bodyTables = root.tables("body");
  std::vector<BodyText> bodies;
  for (const TomlTable& body : bodyTables) bodies.push_back(readBody(file, body));
  holdSides(scenario.billiard, pucks, bodies);
  checkSoft(scenario.billiard, pucks, physics ? &*physics : nullptr);
  std::vector<StrokeText> strokes;
  for (const TomlTable& stroke : root.tables("stroke")) strokes.push_back(readStroke(stroke));
  const std::vector<TomlTable> flashes = root.tables("flash");
  for (const TomlTable& flash : flashes)
    scenario.billiard.flashes.push_back(readFlash(flash, scenario.billiard.flashes.size()));
  const std::vector<TomlTable> pulses = root.tables("pulse");
  for (const TomlTable& pulse : pulses) scenario.pulses.push_back(readPulse(pulse));
  for (const TomlTable& lamp : root.tables("lamp")) scenario.lamps.push_back(readLamp(lamp));
  const auto tour = root.table("tour");
  if (tour) {
    scenario.tour = readTour(*tour, scenario.billiard.lightSpeed_m_s);
    scenario.tourAtOnce = readTourAtOnce(*tour);
  }
  scenario.captions = readCaptions(root);
  if (const auto lesson = root.table("lesson")) {
    LessonGame game{scenario.billiard, {}};
    for (const Puck& puck : scenario.billiard.pucks) game.bodies.push_back(puck.name);
    for (const BodyText& body : bodies) game.bodies.push_back(body.name);
    scenario.lesson = readLesson(*lesson, scenario.title, game);
  }
  if (const auto table = root.table("spacetime")) scenario.spacetime = readSpacetime(*table);
  scenario.tasks = readTasks(root, scenario.billiard.pucks);
  scenario.choices = root.flag("choices", scenario.lesson.has_value());
  file.throwFaults();

  checkNames(pucks, bodyTables, flashes, pulses);
  checkPlaces(scenario.billiard, pucks);
  if (physics) checkFriction(scenario.billiard, *physics);
  if (tour) checkTourSpeed(scenario.tour, scenario.observer, *tour, scenario.billiard.lightSpeed_m_s);
  scenario.billiard.strokes = resolveStrokes(strokes, scenario.billiard.pucks);
  file.throwFaults();
  checkPlayable(scenario.billiard, root);
  file.throwFaults();
  if (physics) scenario.odd = oddFriction(*physics, scenario.billiard.rules);
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    std::ranges::move(oddSpin(pucks[i], scenario.billiard.pucks[i], scenario.puckMeshes[i].has_value(),
                              scenario.billiard.lightSpeed_m_s),
                      std::back_inserter(scenario.odd));
    std::ranges::move(oddOutline(pucks[i], scenario.billiard.pucks[i], scenario.puckMeshes[i]),
                      std::back_inserter(scenario.odd));
  }

  std::ranges::move(oddSoft(scenario.billiard, pucks), std::back_inserter(scenario.odd));
  for (const BodyText& body : bodies) {
    if (body.history) {
      scenario.told.push_back(toldBody(body, scenario.billiard.lightSpeed_m_s));
      continue;
    }
    scenario.bodies.push_back(scriptedBody(body, scenario.billiard.lightSpeed_m_s));
  }
  file.throwFaults();
  return scenario;
}

}  // namespace

Scenario readScenario(const std::filesystem::path& path) {
  return readScenario(TomlFile(path, scenarioKeys()), path.stem().string());
}

Scenario readScenario(const std::filesystem::path& path, const std::string& kept,
                      const std::filesystem::path& root) {
  return readScenario(TomlFile(path, scenarioKeys(), kept, root), path.stem().string());
}

}  // namespace carom
