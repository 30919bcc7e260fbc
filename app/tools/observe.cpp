#include "app/tools/observe.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/toml_file.h"
#include "app/tables/json_text.h"
#include "engine/base/whole_file.h"
#include "engine/billiard/billiard.h"
#include "engine/light/light_cone.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

namespace {

/// Everything that can be seen, by name.
struct SeenBody {
  std::string name;
  const WorldLine* line;
};

std::vector<SeenBody> bodiesOf(const Scenario& scenario, const Billiard& billiard) {
  std::vector<SeenBody> bodies;
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    bodies.push_back({scenario.billiard.pucks[i].name, &billiard.worldLines()[i]});
  }
  for (const ToldBody& body : scenario.bodies) bodies.push_back({body.name, &body.worldLine});
  return bodies;
}

std::vector<std::string> namesIn(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Puck& puck : scenario.billiard.pucks) names.push_back(puck.name);
  for (const ToldBody& body : scenario.bodies) names.push_back(body.name);
  return names;
}

std::vector<BodyPoint> centresOf(const std::vector<std::string>& names) {
  std::vector<BodyPoint> points;
  for (const std::string& name : names) points.push_back({name});
  return points;
}

void checkNames(const std::vector<BodyPoint>& points, const std::vector<std::string>& names) {
  for (const BodyPoint& point : points) {
    if (std::find(names.begin(), names.end(), point.body) != names.end()) continue;
    const auto nearest = nearestWord(point.body, names);
    throw UnknownBody(fmt::format("--point: there is no puck or body '{}', expected {}", point.body,
                                  nearest ? fmt::format("'{}'?", *nearest) : "a name of the scenario"));
  }
}

/// A point and what is seen of it: nothing if its light has not arrived.
struct SeenPoint {
  BodyPoint point;
  std::optional<Emission> emission;
};

Json toJson(const Event& event) { return {{"t_s", event.t_s}, {"r_m", vectorJson(event.r_m)}}; }

Json toJson(const SeenPoint& seen) {
  Json json{{"name", seen.point.body},
            {"offset_m", vectorJson(seen.point.offset_m)},
            {"status", seen.emission ? "seen" : "unseen"}};
  if (!seen.emission) return json;
  json["emission"] = toJson(seen.emission->event);
  json["seen_m"] = vectorJson(seen.emission->seen.dr_m);
  json["distance_m"] = glm::length(seen.emission->seen.dr_m);
  json["doppler"] = seen.emission->doppler;
  json["proper_time_s"] = seen.emission->properTime_s;
  json["beta_at_emission"] = vectorJson(betaFromU(seen.emission->u));
  return json;
}

std::string jsonOf(const ObserveOptions& options, const std::vector<SeenPoint>& points) {
  Json json{{"event", toJson(options.event)}, {"beta", vectorJson(options.beta)}, {"points", Json::array()}};
  for (const SeenPoint& point : points) json["points"].push_back(toJson(point));
  return jsonText(json);
}

std::string tableOf(const ObserveOptions& options, const Scenario& scenario,
                    const std::vector<SeenPoint>& points) {
  const Event& event = options.event;
  std::string text = fmt::format(
      "{}, light at {} m/s\nAn eye at t = {} s, ({}, {}, {}) m, moving at ({}, {}, {}) c, sees:\n",
      scenario.title, scenario.billiard.lightSpeed_m_s, event.t_s, event.r_m.x, event.r_m.y, event.r_m.z,
      options.beta.x, options.beta.y, options.beta.z);
  text +=
      "name          light left s at x, y, z m                   seen from the eye at x, y, z m   doppler  "
      "its clock s\n";
  for (const auto& [point, emission] : points) {
    if (!emission) {
      text += fmt::format("{:<12}  unseen: its light has not arrived yet\n", point.body);
      continue;
    }
    const Vec3& r = emission->event.r_m;
    const Vec3& seen = emission->seen.dr_m;
    text += fmt::format(
        "{:<12} {:10.4f}   ({:8.4f}, {:8.4f}, {:8.4f})   ({:8.4f}, {:8.4f}, {:8.4f}) {:9.5f} {:11.4f}\n",
        point.body, emission->event.t_s, r.x, r.y, r.z, seen.x, seen.y, seen.z, emission->doppler,
        emission->properTime_s);
  }
  return text;
}

}  // namespace

int runObserve(const ObserveOptions& options, const SeenSceneText& seenScene) {
  if (options.vtp && !seenScene) {
    throw std::runtime_error("--vtp: this program was built without VTK, expected a build that has it");
  }
  const Scenario scenario = readScenario(options.scenario);
  const std::vector<std::string> names = namesIn(scenario);
  const std::vector<BodyPoint> points = options.points.empty() ? centresOf(names) : options.points;
  checkNames(points, names);
  WholeFile out(options.json.value_or("-"));
  std::optional<WholeFile> scene;
  if (options.vtp) scene.emplace(*options.vtp);

  Billiard billiard(scenario.billiard);
  billiard.advanceTo(options.event.t_s);
  const std::vector<SeenBody> bodies = bodiesOf(scenario, billiard);
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta(options.beta), c_m_s).inverse();
  std::vector<SeenPoint> seen;
  for (const BodyPoint& point : points) {
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.name == point.body; });
    seen.push_back({point, emission(*body->line, point.offset_m, options.event, headFromBoard)});
  }
  const std::string sceneText =
      scene ? seenScene(scenario, billiard.worldLines(), options.event, headFromBoard) : std::string();
  if (scene) scene->commit(sceneText);
  out.commit(options.json ? jsonOf(options, seen) : tableOf(options, scenario, seen));
  return 0;
}

}  // namespace carom
