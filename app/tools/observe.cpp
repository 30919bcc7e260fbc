#include "app/tools/observe.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "app/tables/json_text.h"
#include "app/toml/toml_file.h"
#include "app/tools/option_values.h"
#include "engine/base/bisection.h"
#include "engine/billiard/billiard.h"
#include "engine/light/point_emission.h"
#include "engine/soft/soft_play.h"
#include "engine/spacetime/lorentz.h"
#include "engine/text/whole_file.h"

namespace carom {

namespace {

/// A visible body and its name.
struct SeenBody {
  std::string name;
  const WorldLine* line;
};

std::vector<SeenBody> bodiesOf(const Scenario& scenario, const Billiard& billiard) {
  std::vector<SeenBody> bodies;
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    bodies.push_back({scenario.billiard.pucks[i].name, &billiard.worldLines()[i]});
  }
  for (const ScriptedBody& body : scenario.bodies) bodies.push_back({body.name, &body.worldLine});
  return bodies;
}

std::vector<std::string> namesIn(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Puck& puck : scenario.billiard.pucks) names.push_back(puck.name);
  for (const ScriptedBody& body : scenario.bodies) names.push_back(body.name);
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
    throw UnknownPoint(fmt::format("--point: there is no puck or body '{}', expected {}", point.body,
                                   nearest ? fmt::format("'{}'?", *nearest) : "a name of the scenario"));
  }
}

const ToldBody* historyOf(const std::string& name, const std::vector<ToldBody>& told) {
  const auto body =
      std::find_if(told.begin(), told.end(), [&](const ToldBody& one) { return one.name == name; });
  return body == told.end() ? nullptr : &*body;
}

void checkVertices(const std::vector<ToldVertex>& vertices, const std::vector<ToldBody>& told) {
  for (const ToldVertex& asked : vertices) {
    const ToldBody* body = historyOf(asked.body, told);
    if (body == nullptr)
      throw UnknownPoint(fmt::format(
          "--vertex: there is no body '{}' with a history, expected the name of one", asked.body));
    if (asked.vertex < body->history.vertexCount()) continue;
    throw UnknownPoint(fmt::format("--vertex: '{}' has no vertex {}, expected a number from 0 to {}",
                                   asked.body, asked.vertex, body->history.vertexCount() - 1));
  }
}

/// Refuses a point that the body's spin would carry round as fast as light.
void checkSpin(const BodyPoint& point, const WorldLine& line) {
  const double reach_m = std::hypot(point.offset_m.x, point.offset_m.y);
  double turn_rad_s = 0.0;
  for (const Knot& knot : line.knots()) turn_rad_s = std::max(turn_rad_s, std::abs(knot.spin.omega_rad_s));
  if (turn_rad_s * reach_m < line.lightSpeed_m_s()) return;
  throw UnknownPoint(
      fmt::format("--point: '{}' spins at {:.6g} rad/s, so this point would move at {:.6g} c, "
                  "expected one less than {:.6g} m from its axis",
                  point.body, turn_rad_s, turn_rad_s * reach_m / line.lightSpeed_m_s(),
                  line.lightSpeed_m_s() / turn_rad_s));
}

/// A point and its emission event; empty if its light has not arrived.
struct SeenPoint {
  BodyPoint point;
  std::optional<Emission> emission;
  std::optional<std::size_t> vertex{};  ///< of a told history, instead of the offset
};

/// The search for the light of places of soft pucks: their matter's states are known while the game is
/// played.
class SoftSight {
 public:
  SoftSight(const Scenario& scenario, const std::vector<BodyPoint>& points, const Event& eye)
      : setup_(scenario.billiard), eye_(eye) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (std::size_t puck = 0; puck < setup_.pucks.size(); ++puck) {
        if (setup_.pucks[puck].name != points[k].body) continue;
        wanted_.push_back({puck, Vec2(points[k].offset_m)});
        z_m_.push_back(0.5 * setup_.pucks[puck].height_m + points[k].offset_m.z);
        places_.push_back(k);
      }
    }
    found_.resize(points.size());
  }

  /// Plays the game up to the eye's time. Finds nothing of pucks that were rigid, and of what left before
  /// board time 0.
  const std::vector<std::optional<Emission>>& find(Billiard& billiard, const Lorentz& headFromBoard) {
    const bool hasSoft =
        std::any_of(setup_.pucks.begin(), setup_.pucks.end(), [](const Puck& puck) { return puck.soft; });
    const double step_s = SoftPlay::kSlice / setup_.lightSpeed_m_s;
    for (double t_s = 0.0; hasSoft && t_s <= eye_.t_s; t_s += step_s) {
      billiard.advanceTo(t_s);
      const SoftMoment moment = billiard.softAt(t_s, wanted_);
      for (std::size_t k = 0; k < wanted_.size(); ++k) {
        const double inside_m = insideBy_m(moment, k, t_s);
        if (inside_m >= 0.0 && insideBy_m(billiard.softAt(t_s + step_s, wanted_), k, t_s + step_s) < 0.0)
          found_[places_[k]] = emissionIn(billiard, k, t_s, t_s + step_s, headFromBoard);
      }
    }
    return found_;
  }

 private:
  /// Returns c (t_o − t) − |r_o − r|, which falls along a world line; a number above 0 for a rigid puck.
  double insideBy_m(const SoftMoment& moment, std::size_t k, double t_s) const {
    if (!moment.points[k]) return 1.0;
    const Vec3 place_m(moment.points[k]->position_m, z_m_[k]);
    return setup_.lightSpeed_m_s * (eye_.t_s - t_s) - glm::length(eye_.r_m - place_m);
  }

  std::optional<Emission> emissionIn(Billiard& billiard, std::size_t k, double low_s, double high_s,
                                     const Lorentz& headFromBoard) const {
    constexpr int kHalvings = 60;
    const auto isInside = [&](double t_s) {
      return insideBy_m(billiard.softAt(t_s, wanted_), k, t_s) >= 0.0;
    };
    const double t_s = bisect({low_s, high_s}, kHalvings, isInside).low;
    const std::optional<SoftPointState> state = billiard.softAt(t_s, wanted_).points[k];
    if (!state) return std::nullopt;
    Emission seen;
    seen.event = {t_s, Vec3(state->position_m, z_m_[k])};
    const Displacement fromEye = seen.event - eye_;
    seen.seen = headFromBoard * fromEye;
    seen.u = uFromBeta(Vec3(state->beta, 0.0));
    seen.doppler = dopplerFactor(fromEye, seen.u, headFromBoard.inverse().u());
    seen.properTime_s = state->properTime_s;
    return seen;
  }

  const BilliardSetup& setup_;
  Event eye_;
  std::vector<SoftPoint> wanted_;
  std::vector<double> z_m_;
  std::vector<std::size_t> places_;  // of the wanted among the points
  std::vector<std::optional<Emission>> found_;
};

Json toJson(const Event& event) { return {{"t_s", event.t_s}, {"r_m", vectorJson(event.r_m)}}; }

Json toJson(const SeenPoint& seen) {
  Json json{{"name", seen.point.body}};
  if (seen.vertex) {
    json["vertex"] = *seen.vertex;
  } else {
    json["offset_m"] = vectorJson(seen.point.offset_m);
  }
  json["status"] = seen.emission ? "seen" : "unseen";
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
  for (const auto& [point, emission, vertex] : points) {
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
  const bool asksNone = options.points.empty() && options.vertices.empty();
  const std::vector<BodyPoint> points = asksNone ? centresOf(names) : options.points;
  checkNames(points, names);
  checkVertices(options.vertices, scenario.told);
  WholeFile out(options.json.value_or("-"));
  std::optional<WholeFile> scene;
  if (options.vtp) scene.emplace(*options.vtp);

  Billiard billiard(scenario.billiard);
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta(options.beta), c_m_s).inverse();
  SoftSight soft(scenario, points, options.event);
  const std::vector<std::optional<Emission>>& ofSoft = soft.find(billiard, headFromBoard);
  billiard.advanceTo(options.event.t_s);
  const std::vector<SeenBody> bodies = bodiesOf(scenario, billiard);
  std::vector<SeenPoint> seen;
  for (const BodyPoint& point : points) {
    if (const std::optional<Emission>& found = ofSoft[seen.size()]) {
      seen.push_back({point, found});
      continue;
    }
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.name == point.body; });
    checkSpin(point, *body->line);
    seen.push_back({point, emission(*body->line, point.offset_m, options.event, headFromBoard)});
  }
  for (const ToldVertex& asked : options.vertices) {
    const SampledHistory& history = historyOf(asked.body, scenario.told)->history;
    seen.push_back({{asked.body}, history.seenAt(asked.vertex, options.event, headFromBoard), asked.vertex});
  }
  const std::string sceneText =
      scene ? seenScene(scenario, billiard.worldLines(), options.event, headFromBoard) : std::string();
  if (scene) scene->commit(sceneText);
  out.commit(options.json ? jsonOf(options, seen) : tableOf(options, scenario, seen));
  return 0;
}

void addObserve(CLI::App& app, int& status, const SeenSceneText& seenScene) {
  using Point = std::tuple<std::string, double, double, double>;
  struct Line {
    std::filesystem::path scenario;
    std::vector<double> event, beta{0.0, 0.0, 0.0};
    std::vector<Point> points;
    std::vector<std::tuple<std::string, double>> vertices;
    std::optional<std::filesystem::path> json, vtp;
  };
  CLI::App* command = app.add_subcommand("observe", "Compute what an eye at one event of the board sees");
  auto line = std::make_shared<Line>();
  command->add_option("SCENARIO", line->scenario, "Scenario file, or the name of a shipped one")
      ->required()
      ->transform(shipped({"scenarios"}));
  command->add_option("--event", line->event, "Board time (s) and place (m) at which the eye receives light")
      ->required()
      ->expected(4)
      ->type_name("T X Y Z")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command->add_option("--beta", line->beta, "Velocity v/c of the eye on the board; by default at rest")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option("--point", line->points,
                   "A point of a puck or body, from its centre in its rest frame (m). May be given several "
                   "times; by default every centre")
      ->type_name("NAME DX DY DZ")
      ->allow_extra_args(false);
  command
      ->add_option("--vertex", line->vertices,
                   "A vertex of a body with a history, counted from 0. May be given several times; they "
                   "follow the points")
      ->type_name("NAME I")
      ->allow_extra_args(false);
  addJson(*command, line->json);
  command->add_option("--vtp", line->vtp, "Write the whole seen scene to this file, as a mesh for ParaView")
      ->type_name("FILE");
  command->footer(
      "Example: an eye 1 m above the board's edge, walking along it at half the speed of light\n"
      "  carom observe three-pucks --event 2 0 -0.7 1 --beta 0.5 0 0 --point red 0.03 "
      "0 0");
  command->callback([line, seenScene, &status] {
    ObserveOptions options{line->scenario,
                           {line->event[0], {line->event[1], line->event[2], line->event[3]}},
                           toVec3(line->beta),
                           {},
                           {},
                           line->json,
                           line->vtp};
    for (const auto& [name, vertex] : line->vertices) {
      if (!(vertex >= 0.0 && vertex <= kFurthest && vertex == std::floor(vertex)))
        throw CLI::ValidationError("--vertex", "is no vertex number, expected a whole number from 0");
      options.vertices.push_back({name, static_cast<std::size_t>(vertex)});
    }
    if (!(glm::dot(options.beta, options.beta) < 1.0)) {
      throw CLI::ValidationError("--beta", "is not below the speed of light, expected a magnitude under 1");
    }
    for (const auto& [name, dx, dy, dz] : line->points) {
      const Vec3 offset_m(dx, dy, dz);
      if (!(glm::length(offset_m) <= kFurthest)) {
        throw CLI::ValidationError("--point", "is no number, expected offsets between -1e9 and 1e9");
      }
      options.points.push_back({name, offset_m});
    }
    try {
      status = runObserve(options, seenScene);
    } catch (const UnknownPoint& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

}  // namespace carom
