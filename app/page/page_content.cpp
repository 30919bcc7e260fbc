#include "app/page/page_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <glm/gtc/matrix_access.hpp>
#include <nlohmann/json.hpp>

#include "app/page/page_bulk.h"
#include "app/page/page_meshes.h"
#include "app/page/page_rows.h"
#include "app/page/page_shaders.h"
#include "cave/bodies/body_shaders.h"
#include "cave/frame/bodies.h"
#include "cave/frame/lesson_language.h"
#include "cave/gl/view_colours.h"
#include "cave/room/wall_eyes.h"
#include "cave/texts/texts.h"
#include "engine/light/spin_steps.h"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostResting = 60000;  // vertices of what rests: what a phone draws quickly

Json jsonOf(const PageColumn& column) {
  return {{"at", column.at}, {"count", column.count}, {"kind", column.kind}};
}

template <typename Vector>
Json vectorOf(const Vector& v) {
  Json json = Json::array();
  for (int i = 0; i < Vector::length(); ++i) json.push_back(v[i]);
  return json;
}

/// Adds rows of numbers of equal length as one column, the first numbers of all rows first.
Json addRows(PageBulk& bulk, const std::vector<std::vector<double>>& rows) {
  std::vector<double> column;
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  for (std::size_t i = 0; i < width; ++i)
    for (const std::vector<double>& row : rows) column.push_back(row[i]);
  Json json = jsonOf(bulk.add(column));
  json["rows"] = rows.size();
  return json;
}

Json framesOf(const Visit& visit, PageBulk& bulk) {
  std::vector<std::vector<double>> rows;
  std::vector<std::uint32_t> states;
  for (const VisitFrame& frame : visit.frames) {
    rows.push_back(numbersOf(frame));
    const std::vector<std::uint32_t> state = statesOf(frame);
    states.insert(states.end(), state.begin(), state.end());
  }
  return {{"numbers", addRows(bulk, rows)}, {"states", jsonOf(bulk.add(states))}};
}

/// The changes of the game: of each the frame, from when the pucks are cut, and how many knots follow; and
/// all knots with their bodies.
Json changesOf(const Visit& visit, PageBulk& bulk) {
  std::vector<std::vector<double>> changes, knots;
  for (const VisitChange& change : visit.changes) {
    changes.push_back({static_cast<double>(change.frame), std::min(change.cutFrom_s, 1e300),
                       static_cast<double>(change.knots.size())});
    for (const BodyKnot& one : change.knots) {
      knots.push_back(numbersOf(one.knot));
      knots.back().push_back(static_cast<double>(one.body));
    }
  }
  return {{"changes", addRows(bulk, changes)}, {"knots", addRows(bulk, knots)}};
}

Json bodiesOf(const Visit& visit, const Scene& scene) {
  const Scenario& scenario = visit.scenario;
  const std::vector<WorldLine> lines = reachingTo(visit.atStart, scene.reach_m);
  Json bodies = Json::array();
  for (std::size_t body = 0; body < lines.size(); ++body) {
    const WorldLine& line = lines[body];
    const std::size_t told = body - kFirstPuck - scenario.billiard.pucks.size();
    const std::string name = body == kRestingBody ? ""
                             : body <= scenario.billiard.pucks.size()
                                 ? scenario.billiard.pucks[body - kFirstPuck].name
                                 : scenario.bodies[told].name;
    Json knots = Json::array();
    for (const Knot& knot : line.knots()) knots.push_back(numbersOf(knot));
    bodies.push_back({{"name", texts::other(name)},
                      {"reach_m", scene.reach_m[body]},
                      {"stripes_m", ghostStripes_m(scene.reach_m[body])},
                      {"radius_m", std::isfinite(line.radius_m()) ? Json(line.radius_m()) : Json("endless")},
                      {"appears_s", std::isfinite(line.appears_s()) ? Json(line.appears_s()) : Json(nullptr)},
                      {"knots", std::move(knots)}});
  }
  return bodies;
}

Json addMesh(PageBulk& bulk, const PageMesh& mesh) {
  glm::vec3 low(0.0F), high(0.0F);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    low = i == 0 ? mesh.vertices[i].place_m : glm::min(low, mesh.vertices[i].place_m);
    high = i == 0 ? mesh.vertices[i].place_m : glm::max(high, mesh.vertices[i].place_m);
  }
  constexpr float kMost = 32767.0F;
  const glm::vec3 middle = 0.5F * (low + high), half = glm::max(0.5F * (high - low), glm::vec3(1e-9F));
  std::vector<std::int16_t> places, normals;
  std::vector<float> surfaces;
  std::vector<std::uint8_t> lit;
  const auto whole = [](float value) { return static_cast<std::int16_t>(std::lround(value)); };
  for (int axis = 0; axis < 3; ++axis) {
    for (const MeshVertex& vertex : mesh.vertices) {
      places.push_back(whole(kMost * (vertex.place_m[axis] - middle[axis]) / half[axis]));
      normals.push_back(whole(kMost * std::clamp(vertex.normal[axis], -1.0F, 1.0F)));
      surfaces.push_back(vertex.surface[axis]);
    }
  }
  for (std::size_t light = 0; light < 4; ++light)
    for (const MeshVertex& vertex : mesh.vertices) lit.push_back(vertex.lit[light]);
  return {{"middle_m", vectorOf(middle)},
          {"half_m", vectorOf(half)},
          {"places", jsonOf(bulk.add(places))},
          {"normals", jsonOf(bulk.add(normals))},
          {"surfaces", jsonOf(bulk.add(surfaces))},
          {"lit", jsonOf(bulk.add(lit))},
          {"indices", jsonOf(bulk.add(mesh.indices))}};
}

void addScene(const Visit& visit, const Scene& scene, PageBulk& bulk, Json& json) {
  const PageMeshes made = pageMeshes(scene, kMostResting);
  for (const PageMesh& mesh : made.meshes) json["meshes"].push_back(addMesh(bulk, mesh));
  std::vector<Paint> resting, moving;
  for (const PagePart& one : made.parts) {
    const ScenePart& part = scene.parts[one.part];
    json["parts"].push_back({{"body", part.body},
                             {"mesh", one.mesh},
                             {"number", one.part},
                             {"paint", static_cast<int>(part.paint)},
                             {"isDecal", part.paint == Paint::shadow},
                             {"isClock", part.paint == Paint::clock},
                             {"colour", vectorOf(part.colour)},
                             {"roughness", part.roughness},
                             {"isRound", part.isRound}});
    std::vector<Paint>& paints = part.body == kRestingBody ? resting : moving;
    if (std::find(paints.begin(), paints.end(), part.paint) == paints.end()) paints.push_back(part.paint);
  }
  std::vector<Switches> recorded{Switches{}, kNoSwitches};
  if (visit.live) recorded = {{1, 1, 1, 0, 0}, {1, 1, 1, 1, 0}, {1, 1, 1, 0, 1}, {1, 1, 1, 1, 1}};  // any
  for (const VisitFrame& frame : visit.frames)
    for (const Switches& one : {frame.switches, frame.views.beside})
      if (std::find(recorded.begin(), recorded.end(), one) == recorded.end()) recorded.push_back(one);
  json["ghostPaint"] = static_cast<int>(Paint::plain);
  const PageShaders shaders = pageShaders(resting, moving, recorded, !scene.hall.lamps.empty());
  json["shaders"]["parts"] = shaders.parts;
  for (const PageVariant& one : shaders.variants)
    json["shaders"]["variants"][nameOf(one.variant)] = {one.vertex, one.fragment};
  for (const glm::dvec3& lamp_m : scene.lamps_m) json["lamps_m"].push_back(vectorOf(lamp_m));
  json["hall_m"] = vectorOf(hallBounds_m(scene.hall));
  json["followed"] = Json::array();
  for (const FollowedLamp& lamp : scene.hall.lamps)
    json["followed"].push_back(
        {{"place_m", vectorOf(lamp.place_m)}, {"on_s", lamp.on_s}, {"light", vectorOf(lamp.light)}});
}

Json wallsOf(const Visit& visit) {
  Json walls = Json::array();
  for (const Wall& wall : visit.walls) {
    Json eyes = Json::array();
    for (const ViewerEye& eye : eyesOf(wall)) eyes.push_back(nameOf(eye.eye));
    walls.push_back({{"name", wall.name},
                     {"lowerLeft_m", vectorOf(wall.lowerLeft_m)},
                     {"lowerRight_m", vectorOf(wall.lowerRight_m)},
                     {"upperLeft_m", vectorOf(wall.upperLeft_m)},
                     {"pixels", vectorOf(wall.pixels)},
                     {"eyes", eyes}});
  }
  return walls;
}

Json numberOrEndless(double value) { return std::isfinite(value) ? Json(value) : Json("endless"); }

/// The game as it can be played on.
Json gameOf(const Visit& visit) {
  const BilliardSetup& setup = visit.scenario.billiard;
  const PhysicsRules& rules = setup.rules;
  Json game{
      {"board", nullptr}, {"pucks", Json::array()}, {"strokes", Json::array()}, {"flashes", Json::array()}};
  if (setup.board) game["board"] = {setup.board->length_m, setup.board->width_m};
  for (const double value : {rules.puckRestitution, rules.cushionRestitution, rules.friction_m_s2,
                             static_cast<double>(rules.collisionEvent), rules.puckFriction,
                             rules.cushionFriction, rules.tangentialRestitution, rules.spinDeceleration_m_s2})
    game["rules"].push_back(numberOrEndless(value));
  for (const Puck& puck : setup.pucks) {
    Json outline = Json::array();
    for (const glm::dvec2& corner : puck.outline_m) outline.push_back(vectorOf(corner));
    game["pucks"].push_back({{"name", puck.name},
                             {"numbers",
                              {puck.radius_m, puck.height_m, puck.mass_kg, puck.position_m.x,
                               puck.position_m.y, puck.beta.x, puck.beta.y, puck.inertia, puck.spin_kg_m2_s}},
                             {"outline_m", outline}});
  }
  const auto addStrokes = [&](const std::vector<Stroke>& strokes) {
    for (const Stroke& stroke : strokes) {
      const Vec3 from_m = stroke.from_m.value_or(Vec3(0.0));
      game["strokes"].push_back({stroke.puck, stroke.at_s, stroke.from_m ? 1 : 0, from_m.x, from_m.y,
                                 from_m.z, stroke.momentum_kg_m_s.x, stroke.momentum_kg_m_s.y,
                                 stroke.offset_m});
    }
  };
  addStrokes(setup.strokes);
  game["strokesOfScenario"] = setup.strokes.size();
  addStrokes(visit.strokes);
  for (const Flash& flash : setup.flashes)
    game["flashes"].push_back({flash.at.t_s, flash.at.r_m.x, flash.at.r_m.y, flash.at.r_m.z});
  return game;
}

Json eventsOf(const Visit& visit) {
  Json events = Json::array();
  for (const GameEvent& event : visit.events) {
    Json pucks = Json::array();
    for (const Turn& turn : event.turns) pucks.push_back(turn.puck + kFirstPuck);
    events.push_back({{"number", event.number},
                      {"kind", static_cast<int>(event.kind)},
                      {"cushion", event.cushion ? 1 + static_cast<int>(*event.cushion) : 0},
                      {"at", {event.at.t_s, event.at.r_m.x, event.at.r_m.y, event.at.r_m.z}},
                      {"pucks", pucks}});
  }
  return events;
}

Json textsOf() {
  Json texts;
  for (const auto& [name, words] : texts::pageWords("page")) texts[name] = words;
  return texts;
}

Json lessonOf(const Scenario& scenario) {
  if (!scenario.lesson) return nullptr;
  const LessonWords words = inLanguage(scenario.lesson->words);
  return {{"title", words.title}, {"question", words.question}, {"answers", words.answers},
          {"todo", words.todo},   {"notice", words.notice},     {"number", words.number}};
}

Json captionsOf(const Scenario& scenario) {
  Json captions = Json::array();
  for (const Caption& caption : scenario.captions)
    captions.push_back({{"from_s", caption.from_s}, {"for_s", caption.for_s}, {"text", caption.text}});
  return captions;
}

}  // namespace

std::string pageContent(const Visit& visit, const Scene& scene) {
  PageBulk bulk;
  Json json{{"title", texts::other(visit.scenario.title)},
            {"point", texts::language() ? texts::language()->digits().point : "."},
            {"lightSpeed_m_s", visit.scenario.billiard.lightSpeed_m_s},
            {"pucks", visit.scenario.billiard.pucks.size()},
            {"known_s", visit.known_s},
            {"axes",
             {{"right", vectorOf(visit.axes.right)},
              {"up", vectorOf(visit.axes.up)},
              {"forward", vectorOf(visit.axes.forward)}}},
            {"fewSpinSteps", kFewSpinSteps},
            {"eyeBesideMiddle_m", vectorOf(visit.eyeBesideMiddle_m)},
            {"ghostColours", {vectorOf(linearOf(kBoardNowColour)), vectorOf(linearOf(kMyNowColour))}},
            {"walls", wallsOf(visit)},
            {"bodies", bodiesOf(visit, scene)},
            {"frames", framesOf(visit, bulk)},
            {"changes", changesOf(visit, bulk)},
            {"events", eventsOf(visit)},
            {"game", gameOf(visit)},
            {"lesson", lessonOf(visit.scenario)},
            {"captions", captionsOf(visit.scenario)},
            {"live", visit.live ? Json(*visit.live) : Json(nullptr)},
            {"texts", textsOf()}};
  addScene(visit, scene, bulk, json);
  const std::string text = json.dump();
  std::string bytes;
  for (std::size_t i = 0; i < 4; ++i) bytes += static_cast<char>(text.size() >> 8 * i & 0xff);
  return bytes + text + bulk.bytes();
}

}  // namespace carom
