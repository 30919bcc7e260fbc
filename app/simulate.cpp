#include "app/simulate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/json_text.h"
#include "app/scenario.h"
#include "app/whole_file.h"
#include "engine/billiard.h"

namespace carom {

namespace {

/// A puck at one board time, in the plane of the board.
struct PuckState {
  Vec2 position_m{0.0};
  Vec2 beta{0.0};
  double properTime_s = 0.0;
};

PuckState stateAt(const WorldLine& line, double t_s) {
  const Motion motion = line.at(t_s);
  return {Vec2(motion.event.r_m), Vec2(betaFromU(motion.u)), motion.properTime_s};
}

std::string_view nameOf(Cushion cushion) {
  constexpr std::array<std::string_view, 4> kNames{"+x", "-x", "+y", "-y"};  // in the order of Cushion
  return kNames[static_cast<std::size_t>(cushion)];
}

/// The collisions whose contact or first turn is at or before `until_s`, as they were committed; the turns of
/// each in the order of the file's pucks.
std::vector<Collision> collisionsUntil(const Billiard& billiard, double until_s) {
  std::vector<Collision> listed;
  for (Collision collision : billiard.collisions()) {
    const bool turned = std::any_of(collision.turns.begin(), collision.turns.end(),
                                    [&](const Turn& turn) { return turn.event.t_s <= until_s; });
    if (!turned && collision.contact.t_s > until_s) continue;
    Turns& turns = collision.turns;
    if (turns.size() == 2 && turns[1].puck < turns[0].puck) std::swap(turns[0], turns[1]);
    listed.push_back(collision);
  }
  return listed;
}

/// The times of the states: 0, D, 2D, … up to `until_s`, rounding of the last one forgiven.
std::vector<double> stateTimes_s(double until_s, double every_s) {
  std::vector<double> times_s;
  const auto last = static_cast<long>(std::floor(until_s / every_s * (1.0 + 1e-14)));
  for (long i = 0; i <= last; ++i) times_s.push_back(std::min(static_cast<double>(i) * every_s, until_s));
  return times_s;
}

Json toJson(const Event& event) { return {{"t_s", event.t_s}, {"r_m", vectorJson(Vec2(event.r_m))}}; }

Json toJson(const Collision& collision, const std::vector<Puck>& pucks) {
  Json names = Json::array(), turns = Json::array();
  for (const Turn& turn : collision.turns) {
    names.push_back(pucks[turn.puck].name);
    turns.push_back({{"puck", pucks[turn.puck].name},
                     {"t_s", turn.event.t_s},
                     {"r_m", vectorJson(Vec2(turn.event.r_m))},
                     {"beta_before", vectorJson(turn.betaBefore)},
                     {"beta_after", vectorJson(turn.betaAfter)},
                     {"proper_time_s", turn.properTime_s}});
  }
  Json json{{"kind", collision.cushion ? "puck-cushion" : "puck-puck"}, {"pucks", names}};
  if (collision.cushion) json["cushion"] = nameOf(*collision.cushion);
  json["contact"] = toJson(collision.contact);
  json["turns"] = turns;
  json["heat_j"] = collision.heat_j;
  return json;
}

Json toJson(const Puck& puck, const WorldLine& line, double t_s) {
  const PuckState state = stateAt(line, t_s);
  return {{"name", puck.name},
          {"mass_kg", puck.mass_kg},
          {"t_s", t_s},
          {"r_m", vectorJson(state.position_m)},
          {"beta", vectorJson(state.beta)},
          {"proper_time_s", state.properTime_s}};
}

Json statesJson(const Billiard& billiard, const SimulateOptions& options) {
  Json states = Json::array();
  for (const double t_s : stateTimes_s(options.until_s, *options.every_s)) {
    Json places = Json::array(), speeds = Json::array();
    for (const WorldLine& line : billiard.worldLines()) {
      const PuckState state = stateAt(line, t_s);
      places.push_back(vectorJson(state.position_m));
      speeds.push_back(vectorJson(state.beta));
    }
    states.push_back({{"t_s", t_s}, {"r_m", places}, {"beta", speeds}});
  }
  return states;
}

std::string jsonOf(const Scenario& scenario, const Billiard& billiard, const SimulateOptions& options) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  Json json{{"light_speed_m_s", scenario.billiard.lightSpeed_m_s}};
  json["collisions"] = Json::array();
  for (const Collision& collision : collisionsUntil(billiard, options.until_s)) {
    json["collisions"].push_back(toJson(collision, pucks));
  }
  json["pucks"] = Json::array();
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    json["pucks"].push_back(toJson(pucks[i], billiard.worldLines()[i], options.until_s));
  }
  if (options.every_s) json["states"] = statesJson(billiard, options);
  return jsonText(json);
}

std::string stateLine(double t_s, const std::string& name, const PuckState& state) {
  return fmt::format("{:10.4f}  {:<12} {:8.4f} {:8.4f}   {:7.4f} {:7.4f}   {:10.4f}\n", t_s, name,
                     state.position_m.x, state.position_m.y, state.beta.x, state.beta.y, state.properTime_s);
}

std::string tableOf(const Scenario& scenario, const Billiard& billiard, const SimulateOptions& options) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  std::string text = fmt::format("{}, light at {} m/s\n\n", scenario.title, scenario.billiard.lightSpeed_m_s);
  const std::vector<Collision> collisions = collisionsUntil(billiard, options.until_s);
  text += fmt::format("{} collisions up to t = {} s, and how each puck turns:\n", collisions.size(),
                      options.until_s);
  if (!collisions.empty()) {
    text +=
        " contact s         x m      y m   puck         meets        turns s    v/c before x, y      v/c "
        "after x, y\n";
  }
  for (const Collision& collision : collisions) {
    for (std::size_t i = 0; i < collision.turns.size(); ++i) {
      const Turn& turn = collision.turns[i];
      const std::string other = collision.cushion ? fmt::format("cushion {}", nameOf(*collision.cushion))
                                                  : pucks[collision.turns[1 - i].puck].name;
      text += fmt::format(
          "{:10.4f}  {:10.4f} {:8.4f}   {:<12} {:<12} {:7.4f}   {:7.4f} {:7.4f}     {:7.4f} {:7.4f}\n",
          collision.contact.t_s, collision.contact.r_m.x, collision.contact.r_m.y, pucks[turn.puck].name,
          other, turn.event.t_s, turn.betaBefore.x, turn.betaBefore.y, turn.betaAfter.x, turn.betaAfter.y);
    }
  }
  text += "\nPucks:\n       t s  puck              x m      y m     v/c x   v/c y   own clock s\n";
  std::vector<double> times_s{options.until_s};
  if (options.every_s) times_s = stateTimes_s(options.until_s, *options.every_s);
  if (times_s.back() < options.until_s) times_s.push_back(options.until_s);
  for (const double t_s : times_s) {
    for (std::size_t i = 0; i < pucks.size(); ++i) {
      text += stateLine(t_s, pucks[i].name, stateAt(billiard.worldLines()[i], t_s));
    }
  }
  return text;
}

/// Plays in steps, so that a long game can say how far it is to a person who watches.
void play(Billiard& billiard, double until_s) {
  constexpr int kSteps = 100;
  const bool watched = ::isatty(STDERR_FILENO) == 1;
  if (!watched) return billiard.advanceTo(until_s);
  for (int i = 1; i <= kSteps; ++i) {
    const double t_s = i == kSteps ? until_s : until_s * i / kSteps;
    billiard.advanceTo(t_s);
    fmt::print(stderr, "\rt = {:.6g} of {:.6g} s, {} collisions", t_s, until_s, billiard.collisions().size());
  }
  fmt::print(stderr, "\r\033[K");
}

}  // namespace

int runSimulate(const SimulateOptions& options) {
  const Scenario scenario = readScenario(options.scenario);
  WholeFile out(options.json.value_or("-"));
  Billiard billiard(scenario.billiard);
  play(billiard, options.until_s);
  if (!billiard.jams().empty()) {
    fmt::print(stderr,
               "note: jammed pucks were made to stick together {} times, first '{}' at t = {:.6g} s\n",
               billiard.jams().size(), scenario.billiard.pucks[billiard.jams().front().puck].name,
               billiard.jams().front().event.t_s);
  }
  out.commit(options.json ? jsonOf(scenario, billiard, options) : tableOf(scenario, billiard, options));
  return 0;
}

}  // namespace carom
