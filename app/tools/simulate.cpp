#include "app/tools/simulate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "app/scenario/scenario.h"
#include "app/scenario/scenario_soft.h"
#include "app/tables/json_text.h"
#include "app/tools/option_values.h"
#include "engine/billiard/billiard.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {

namespace {

/// A puck at one board time, in the plane of the board.
struct PuckState {
  Vec2 position_m{0.0};
  Vec2 beta{0.0};
  double properTime_s = 0.0;
  double spin_kg_m2_s = 0.0, spin_rad_s = 0.0, angle_rad = 0.0;
};

PuckState stateAt(const Puck& puck, const WorldLine& line, double t_s) {
  const Motion motion = line.at(t_s);
  const Knot& knot = line.knots()[motion.leg];
  const double own_s = motion.properTime_s - knot.properTime_s;
  return {Vec2(motion.event.r_m),
          Vec2(betaFromU(motion.u)),
          motion.properTime_s,
          spinOfRim_kg_m2_s(puck, rimUAfter(knot.spin, own_s), line.lightSpeed_m_s()),
          omegaAfter(knot.spin, own_s),
          angleAfter(knot.spin, own_s)};
}

/// A point that is in no puck.
struct UnknownPuckPoint : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether an event is part of a collision that lasts.
bool isSoft(EventKind kind) {
  return kind == EventKind::softCushion || kind == EventKind::softSoft || kind == EventKind::parted ||
         kind == EventKind::farSide;
}

/// Returns the collisions whose contact or first turn is at or before `until_s`, in the order of their
/// commitment, each with its turns in the order of the file's pucks. Collisions after `until_s` that turn a
/// puck before the signal of a listed contact reaches it are not included.
std::vector<GameEvent> collisionsUntil(const Billiard& billiard, double until_s) {
  std::vector<GameEvent> listed;
  for (GameEvent collision : billiard.events()) {
    if (collision.kind == EventKind::stroke || collision.kind == EventKind::flash || isSoft(collision.kind))
      continue;
    const bool turned = std::any_of(collision.turns.begin(), collision.turns.end(),
                                    [&](const Turn& turn) { return turn.event.t_s <= until_s; });
    if (!turned && collision.at.t_s > until_s) continue;
    Turns& turns = collision.turns;
    if (turns.size() == 2 && turns[1].puck < turns[0].puck) std::swap(turns[0], turns[1]);
    listed.push_back(collision);
  }
  return listed;
}

/// Returns the times of the states: 0, D, 2D, … up to `until_s`, with a tolerance for rounding at the last
/// one.
std::vector<double> stateTimes_s(double until_s, double every_s) {
  std::vector<double> times_s;
  const auto last = static_cast<long>(std::floor(until_s / every_s * (1.0 + 1e-14)));
  for (long i = 0; i <= last; ++i) times_s.push_back(std::min(static_cast<double>(i) * every_s, until_s));
  return times_s;
}

Json onBoardJson(const Event& event) { return {{"t_s", event.t_s}, {"r_m", vectorJson(Vec2(event.r_m))}}; }

/// Returns one collision: an event, or the events of all pucks that one jam moves.
Json toJson(std::span<const GameEvent> collision, const std::vector<Puck>& pucks) {
  std::vector<Turn> all;
  double heat_j = 0.0;
  for (const GameEvent& event : collision) {
    heat_j += event.heat_j;
    all.insert(all.end(), event.turns.begin(), event.turns.end());
  }
  std::sort(all.begin(), all.end(), [](const Turn& a, const Turn& b) { return a.puck < b.puck; });
  Json names = Json::array(), turns = Json::array();
  for (const Turn& turn : all) {
    names.push_back(pucks[turn.puck].name);
    turns.push_back({{"puck", pucks[turn.puck].name},
                     {"t_s", turn.event.t_s},
                     {"r_m", vectorJson(Vec2(turn.event.r_m))},
                     {"beta_before", vectorJson(turn.betaBefore)},
                     {"beta_after", vectorJson(turn.betaAfter)},
                     {"proper_time_s", turn.properTime_s},
                     {"spin_before_kg_m2_s", turn.spinBefore_kg_m2_s},
                     {"spin_after_kg_m2_s", turn.spinAfter_kg_m2_s}});
  }
  const GameEvent& first = collision.front();
  Json json{{"kind", nameOf(first.kind)}, {"pucks", names}};
  if (first.cushion) json["cushion"] = nameOf(*first.cushion);
  json["contact"] = onBoardJson(first.at);
  json["turns"] = turns;
  json["heat_j"] = heat_j;
  if (first.withoutDelay) json["without_delay"] = true;
  if (first.sideOnSide) json["side_on_side"] = true;
  return json;
}

/// Returns the events of each collision: the pucks that one jam moves have one event each, with the same
/// contact.
std::vector<std::span<const GameEvent>> byCollision(std::span<const GameEvent> events) {
  const auto isOneJam = [](const GameEvent& a, const GameEvent& b) {
    return a.kind == EventKind::jam && b.kind == EventKind::jam && a.at.t_s == b.at.t_s &&
           a.at.r_m == b.at.r_m;
  };
  std::vector<std::span<const GameEvent>> collisions;
  for (std::size_t first = 0, next = 0; first < events.size(); first = next) {
    while (++next < events.size() && isOneJam(events[first], events[next])) {
    }
    collisions.push_back(events.subspan(first, next - first));
  }
  return collisions;
}

/// The game at one board time.
struct Moment {
  double t_s = 0.0;
  SoftMoment soft;
  std::vector<SoftPointState> points;
};

/// Returns a place of a rigid puck: contracted along its motion, at one board time.
SoftPointState pointOf(const WorldLine& line, const Vec2& offset_m, double t_s) {
  const Motion motion = line.at(t_s);
  const Vec2 beta(betaFromU(motion.u));
  const double gamma = std::sqrt(1.0 + glm::dot(motion.u, motion.u));
  const Vec2 contracted_m = offset_m - gamma / (gamma + 1.0) * glm::dot(beta, offset_m) * beta;
  return {Vec2(motion.event.r_m) + contracted_m, beta, motion.properTime_s};
}

/// Whether a place is beside a soft rectangle: its sides are along x and y.
bool isBesideRectangle(const Puck& puck, const Vec2& offset_m) {
  if (!puck.soft || puck.outline_m.empty()) return false;
  const Vec2 beyond_m = glm::abs(offset_m) - glm::abs(puck.outline_m.front());
  return !(std::max(beyond_m.x, beyond_m.y) <= 1e-9 * puck.radius_m);
}

std::vector<SoftPoint> pointsOf(const SimulateOptions& options, const std::vector<Puck>& pucks) {
  std::vector<SoftPoint> points;
  for (const PuckPoint& point : options.points) {
    const auto puck =
        std::find_if(pucks.begin(), pucks.end(), [&](const Puck& one) { return one.name == point.puck; });
    if (puck == pucks.end())
      throw UnknownPuckPoint(
          fmt::format("--point: there is no puck '{}', expected a name of the scenario", point.puck));
    if (isBesideRectangle(*puck, point.offset_m))
      throw UnknownPuckPoint(
          fmt::format("--point: ({}, {}) m is not in puck '{}', expected a place between its sides",
                      point.offset_m.x, point.offset_m.y, point.puck));
    if (!(glm::length(point.offset_m) <= puck->radius_m * (1.0 + 1e-9)))
      throw UnknownPuckPoint(
          fmt::format("--point: ({}, {}) m is not in puck '{}', expected at most {} m from its centre",
                      point.offset_m.x, point.offset_m.y, point.puck, puck->radius_m));
    points.push_back({static_cast<std::size_t>(puck - pucks.begin()), point.offset_m});
  }
  return points;
}

Moment momentAt(const Billiard& billiard, const std::vector<SoftPoint>& points, double t_s) {
  Moment moment{t_s, billiard.softAt(t_s, points), {}};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool isKnown = k < moment.soft.points.size() && moment.soft.points[k];
    moment.points.push_back(isKnown
                                ? *moment.soft.points[k]
                                : pointOf(billiard.worldLines()[points[k].puck], points[k].offset_m, t_s));
  }
  return moment;
}

const SoftPuckState* softState(const Moment& moment, std::size_t puck) {
  return puck < moment.soft.pucks.size() && moment.soft.pucks[puck] ? &*moment.soft.pucks[puck] : nullptr;
}

Json pointsJson(const Moment& moment, const SimulateOptions& options) {
  Json points = Json::array();
  for (std::size_t k = 0; k < moment.points.size(); ++k) {
    const SoftPointState& state = moment.points[k];
    points.push_back({{"puck", options.points[k].puck},
                      {"offset_m", vectorJson(options.points[k].offset_m)},
                      {"t_s", moment.t_s},
                      {"r_m", vectorJson(state.position_m)},
                      {"beta", vectorJson(state.beta)},
                      {"proper_time_s", state.properTime_s}});
  }
  return points;
}

/// Returns a collision that lasts. The pucks are in the order of the file.
Json toJson(const SoftContactState& contact, const std::vector<Puck>& pucks) {
  const bool isTurned = contact.pucks[1] < contact.pucks[0];
  Json names = Json::array({pucks[contact.pucks[isTurned ? 1 : 0]].name});
  if (!contact.cushion) names.push_back(pucks[contact.pucks[isTurned ? 0 : 1]].name);
  Json json{{"kind", nameOf(contact.cushion ? EventKind::softCushion : EventKind::softSoft)},
            {"pucks", names}};
  if (contact.cushion) json["cushion"] = nameOf(*contact.cushion);
  json["contact"] = onBoardJson(contact.contact);
  json["parted"] = contact.parted_s ? Json{{"t_s", *contact.parted_s}} : Json();
  json["impulse_kg_m_s"] = vectorJson(isTurned ? -contact.impulse_kg_m_s : contact.impulse_kg_m_s);
  json["turns"] = Json::array();
  json["heat_j"] = contact.heat_j;
  return json;
}

/// Returns what is told of a rigid puck and of a soft one alike.
template <typename State>
Json motionJson(const Puck& puck, const State& state, double t_s) {
  return {{"name", puck.name},
          {"mass_kg", puck.mass_kg},
          {"t_s", t_s},
          {"r_m", vectorJson(state.position_m)},
          {"beta", vectorJson(state.beta)},
          {"proper_time_s", state.properTime_s},
          {"spin_kg_m2_s", state.spin_kg_m2_s}};
}

Json toJson(const Puck& puck, const SoftPuckState& state, double t_s) {
  Json json = motionJson(puck, state, t_s);
  json["rest_mass_kg"] = state.restMass_kg;
  json["heat_j"] = state.heat_j;
  json["elastic_j"] = state.elastic_j;
  json["awake"] = state.isAwake;
  if (state.becameSoft_s) json["became_soft_s"] = *state.becameSoft_s;
  return json;
}

Json toJson(const Puck& puck, const WorldLine& line, double t_s) {
  const PuckState state = stateAt(puck, line, t_s);
  Json json = motionJson(puck, state, t_s);
  json["spin_rad_s"] = state.spin_rad_s;
  json["angle_rad"] = state.angle_rad;
  json["rest_mass_kg"] = restMass_kg(puck, state.spin_kg_m2_s, line.lightSpeed_m_s());
  return json;
}

/// Returns where a puck is and how it moves; of a soft one, its centre of energy.
PuckState stateAt(const std::vector<Puck>& pucks, const Billiard& billiard, const Moment& moment,
                  std::size_t puck) {
  PuckState state = stateAt(pucks[puck], billiard.worldLines()[puck], moment.t_s);
  if (const SoftPuckState* soft = softState(moment, puck)) {
    state.position_m = soft->position_m;
    state.beta = soft->beta;
    state.spin_kg_m2_s = soft->spin_kg_m2_s;
    state.properTime_s = soft->properTime_s;
  }
  return state;
}

Json statesJson(const std::vector<Puck>& pucks, const Billiard& billiard, const SimulateOptions& options,
                std::span<const Moment> moments) {
  Json states = Json::array();
  for (const Moment& moment : moments) {
    Json places = Json::array(), speeds = Json::array(), spins = Json::array(), angles = Json::array(),
         masses = Json::array();
    for (std::size_t i = 0; i < pucks.size(); ++i) {
      const PuckState state = stateAt(pucks, billiard, moment, i);
      const SoftPuckState* soft = softState(moment, i);
      const double c_m_s = billiard.worldLines()[i].lightSpeed_m_s();
      const double mass_kg = soft ? soft->restMass_kg : restMass_kg(pucks[i], state.spin_kg_m2_s, c_m_s);
      places.push_back(vectorJson(state.position_m));
      speeds.push_back(vectorJson(state.beta));
      spins.push_back(state.spin_kg_m2_s);
      angles.push_back(state.angle_rad);
      masses.push_back(mass_kg);
    }
    states.push_back({{"t_s", moment.t_s},
                      {"r_m", places},
                      {"beta", speeds},
                      {"spin_kg_m2_s", spins},
                      {"angle_rad", angles},
                      {"rest_mass_kg", masses}});
    if (!moment.points.empty()) states.back()["points"] = pointsJson(moment, options);
  }
  return states;
}

/// Returns the collisions that last, in the order of their contacts.
std::vector<SoftContactState> lastingUntil(const Moment& end) {
  std::vector<SoftContactState> lasting = end.soft.contacts;
  std::stable_sort(lasting.begin(), lasting.end(), [](const SoftContactState& a, const SoftContactState& b) {
    return a.contact.t_s < b.contact.t_s;
  });
  return lasting;
}

/// Returns all collisions up to the last of the moments: the rigid ones in the order of the events, and each
/// that lasts before the first of those whose contact is later.
Json collisionsJson(const std::vector<Puck>& pucks, const Billiard& billiard, const Moment& end) {
  const std::vector<SoftContactState> lasting = lastingUntil(end);
  Json collisions = Json::array();
  auto next = lasting.begin();
  const auto listUntil = [&](double t_s) {
    for (; next != lasting.end() && next->contact.t_s <= t_s; ++next)
      collisions.push_back(toJson(*next, pucks));
  };
  const std::vector<GameEvent> events = collisionsUntil(billiard, end.t_s);
  for (const std::span<const GameEvent> collision : byCollision(events)) {
    listUntil(collision.front().at.t_s);
    collisions.push_back(toJson(collision, pucks));
  }
  listUntil(std::numeric_limits<double>::infinity());
  return collisions;
}

/// `moments` are those of the states, and the end.
std::string jsonOf(const Scenario& scenario, const Billiard& billiard, const SimulateOptions& options,
                   std::span<const Moment> moments) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  const Moment& end = moments.back();
  Json json{{"light_speed_m_s", scenario.billiard.lightSpeed_m_s}};
  json["collisions"] = collisionsJson(pucks, billiard, end);
  json["pucks"] = Json::array();
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const SoftPuckState* soft = softState(end, i);
    json["pucks"].push_back(soft ? toJson(pucks[i], *soft, end.t_s)
                                 : toJson(pucks[i], billiard.worldLines()[i], end.t_s));
  }
  if (!options.points.empty()) json["points"] = pointsJson(end, options);
  if (options.every_s)
    json["states"] = statesJson(pucks, billiard, options, moments.first(moments.size() - 1));
  return jsonText(json);
}

std::string stateLine(double t_s, const std::string& name, const PuckState& state, bool spins) {
  const std::string line = fmt::format("{:10.4f}  {:<12} {:8.4f} {:8.4f}   {:7.4f} {:7.4f}   {:10.4f}", t_s,
                                       name, state.position_m.x, state.position_m.y, state.beta.x + 0.0,
                                       state.beta.y + 0.0, state.properTime_s);  // at rest: 0, not -0
  if (!spins) return line + '\n';
  return line +
         fmt::format("   {:12.6g} {:9.4f} {:8.4f}\n", state.spin_kg_m2_s, state.spin_rad_s, state.angle_rad);
}

/// Whether any puck turns at any time.
bool anySpins(const Billiard& billiard) {
  const auto lines = billiard.worldLines();
  return std::any_of(lines.begin(), lines.end(), [](const WorldLine& line) {
    return std::any_of(line.knots().begin(), line.knots().end(),
                       [](const Knot& knot) { return spins(knot); });
  });
}

/// Returns the table of the collisions that last.
std::string lastingTable(const std::vector<Puck>& pucks, const Moment& end) {
  const std::vector<SoftContactState> lasting = lastingUntil(end);
  if (lasting.empty()) return "";
  std::string text = fmt::format("\n{} collisions of soft pucks, which last:\n", lasting.size()) +
                     " contact s         x m      y m   puck         meets        parted s   received x, y "
                     "kg m/s       heat J\n";
  for (const SoftContactState& one : lasting) {
    const std::string other =
        one.cushion ? fmt::format("cushion {}", nameOf(*one.cushion)) : pucks[one.pucks[1]].name;
    const std::string parted = one.parted_s ? fmt::format("{:8.4f}", *one.parted_s) : "       -";
    text += fmt::format("{:10.4f}  {:10.4f} {:8.4f}   {:<12} {:<12} {}   {:9.5f} {:9.5f}   {:10.6g}\n",
                        one.contact.t_s, one.contact.r_m.x, one.contact.r_m.y, pucks[one.pucks[0]].name,
                        other, parted, one.impulse_kg_m_s.x + 0.0, one.impulse_kg_m_s.y + 0.0, one.heat_j);
  }
  return text;
}

/// Returns the table of what only soft pucks have.
std::string softTable(const std::vector<Puck>& pucks, std::span<const Moment> moments) {
  std::string text;
  for (const Moment& moment : moments) {
    for (std::size_t i = 0; i < pucks.size(); ++i) {
      const SoftPuckState* soft = softState(moment, i);
      if (!soft) continue;
      text += fmt::format("{:10.4f}  {:<12} {:12.6g} {:12.6g} {:12.6g} {:14.6g}   {}", moment.t_s,
                          pucks[i].name, soft->restMass_kg, soft->heat_j, soft->elastic_j, soft->spin_kg_m2_s,
                          soft->isAwake ? "awake" : "asleep");
      if (soft->becameSoft_s) text += fmt::format(", soft since {:.4f} s", *soft->becameSoft_s);
      text += '\n';
    }
  }
  if (text.empty()) return "";
  return "\nSoft pucks:\n       t s  puck         rest mass kg       heat J    elastic J   spin kg m²/s   "
         "waves\n" +
         text;
}

/// `moments` are those of the states, and the end.
std::string tableOf(const Scenario& scenario, const Billiard& billiard, const SimulateOptions& options,
                    std::span<const Moment> moments) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  std::string text = fmt::format("{}, light at {} m/s\n\n", scenario.title, scenario.billiard.lightSpeed_m_s);
  const std::vector<GameEvent> collisions = collisionsUntil(billiard, options.until_s);
  text += fmt::format("{} collisions up to t = {} s, and how each puck turns:\n",
                      byCollision(collisions).size(), options.until_s);
  if (!collisions.empty()) {
    text +=
        " contact s         x m      y m   puck         meets        turns s    v/c before x, y      v/c "
        "after x, y\n";
  }
  for (const GameEvent& collision : collisions) {
    for (std::size_t i = 0; i < collision.turns.size(); ++i) {
      const Turn& turn = collision.turns[i];
      const std::string other = collision.cushion ? fmt::format("cushion {}", nameOf(*collision.cushion))
                                : collision.kind == EventKind::jam ? "a jam"
                                                                   : pucks[collision.turns[1 - i].puck].name;
      text += fmt::format(
          "{:10.4f}  {:10.4f} {:8.4f}   {:<12} {:<12} {:7.4f}   {:7.4f} {:7.4f}     {:7.4f} {:7.4f}\n",
          collision.at.t_s, collision.at.r_m.x, collision.at.r_m.y, pucks[turn.puck].name, other,
          turn.event.t_s, turn.betaBefore.x, turn.betaBefore.y, turn.betaAfter.x, turn.betaAfter.y);
    }
  }
  text += lastingTable(pucks, moments.back());
  const bool spins = anySpins(billiard);
  text +=
      fmt::format("\nPucks:\n       t s  puck              x m      y m     v/c x   v/c y   own clock s{}\n",
                  spins ? "   spin kg m²/s     rad/s  angle rad" : "");
  const std::size_t count = moments.size();
  if (count > 1 && moments[count - 2].t_s == moments[count - 1].t_s) moments = moments.first(count - 1);
  for (const Moment& moment : moments) {
    for (std::size_t i = 0; i < pucks.size(); ++i)
      text += stateLine(moment.t_s, pucks[i].name, stateAt(pucks, billiard, moment, i), spins);
  }
  return text + softTable(pucks, moments);
}

/// Returns the ledger including friction on the unfinished legs up to `until_s`, which the billiard adds only
/// when they end.
Ledger ledgerAt(const Scenario& scenario, const Billiard& billiard, double until_s) {
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  Ledger ledger = billiard.ledger();
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    const WorldLine& line = billiard.worldLines()[i];
    const Knot& last = line.knots().back();
    if (last.turn.t_s >= until_s) continue;
    const Puck& puck = scenario.billiard.pucks[i];
    const Motion now = line.at(until_s);
    const double rimNow_u = rimUAfter(last.spin, now.properTime_s - last.properTime_s);
    const double then_kg_m_s =
        c_m_s * restMass_kg(puck, spinOfRim_kg_m2_s(puck, last.spin.rim_u, c_m_s), c_m_s);
    const double now_kg_m_s = c_m_s * restMass_kg(puck, spinOfRim_kg_m2_s(puck, rimNow_u, c_m_s), c_m_s);
    const double energy_j = c_m_s * (then_kg_m_s * gammaFromU(last.u) - now_kg_m_s * gammaFromU(now.u));
    const Vec2 momentum_kg_m_s = then_kg_m_s * Vec2(last.u) - now_kg_m_s * Vec2(now.u);
    ledger.motion.energy_j -= energy_j;
    ledger.motion.momentum_kg_m_s -= momentum_kg_m_s;
    ledger.lostToFriction.energy_j += energy_j;
    ledger.lostToFriction.momentum_kg_m_s += momentum_kg_m_s;
  }
  return ledger;
}

std::string balanceOf(const Scenario& scenario, const Ledger& start, const Ledger& end) {
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  double rest_j = 0.0;
  for (const Puck& puck : scenario.billiard.pucks) rest_j += puck.mass_kg * c_m_s * c_m_s;
  const auto energy = [](std::string_view what, double energy_j) {
    return fmt::format("  {:<34} {:14.8g} J\n", what, energy_j);
  };
  const auto both = [](std::string_view what, const Ledger::Account& account) {
    return fmt::format("  {:<34} {:14.8g} J   {:12.6g} {:12.6g}\n", what, account.energy_j,
                       account.momentum_kg_m_s.x, account.momentum_kg_m_s.y);
  };
  const auto kinetic = [rest_j](const Ledger& ledger) {
    return Ledger::Account{ledger.motion.energy_j - rest_j, ledger.motion.momentum_kg_m_s};
  };
  return "\nBalance of all that is decided by then:   energy           momentum x, y in kg m/s\n" +
         both("kinetic, at the start", kinetic(start)) + both("+ what strokes gave", end.givenByStrokes) +
         both("= kinetic, now", kinetic(end)) + both("+ radiated as heat", end.radiated) +
         both("+ taken by cushions", end.takenByCushions) + both("+ lost to friction", end.lostToFriction) +
         energy("heat, in the pucks' rest frames", end.heat_j);
}

/// Prints the progress of a long game to standard error.
class Progress {
 public:
  void say(double t_s, double until_s, std::size_t collisions) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + (watched_ ? std::chrono::milliseconds(200) : std::chrono::seconds(5));
    fmt::print(stderr, "{}t = {:.6g} of {:.6g} s, {} collisions{}", watched_ ? "\r" : "", t_s, until_s,
               collisions, watched_ ? "" : "\n");
    said_ = true;
  }
  ~Progress() {
    if (said_ && watched_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool watched_ = ::isatty(STDERR_FILENO) == 1;
  bool said_ = false;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

/// Advances the game in steps of about a tenth of a second of computing time.
void play(Billiard& billiard, double until_s) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kStep = std::chrono::milliseconds(100);
  Progress progress;
  double step_s = 1e-6 * until_s;
  for (double t_s = 0.0; t_s < until_s;) {
    const Clock::time_point begin = Clock::now();
    t_s = std::min(t_s + step_s, until_s);
    billiard.advanceTo(t_s);
    step_s = std::max(step_s, 1e-9 * until_s);
    step_s *= Clock::now() - begin < kStep / 2 ? 2.0 : Clock::now() - begin > kStep ? 0.5 : 1.0;
    const std::size_t collisions = billiard.events().size();
    if (collisions > kMostCollisions) {
      throw std::runtime_error(fmt::format(
          "more than {} collisions, by board time {:.6g} s of {:.6g} s: they are all kept for the "
          "answer; expected an earlier --until",
          kMostCollisions, t_s, until_s));
    }
    progress.say(t_s, until_s, collisions);
  }
  billiard.advanceTo(until_s);
}

}  // namespace

int runSimulate(const SimulateOptions& options) {
  const Scenario scenario = readScenario(options.scenario);
  WholeFile out(options.json.value_or("-"));
  const std::vector<SoftPoint> points = pointsOf(options, scenario.billiard.pucks);
  Billiard billiard(scenario.billiard);
  const Ledger start = billiard.ledger();
  std::vector<double> times_s;
  if (options.every_s) times_s = stateTimes_s(options.until_s, *options.every_s);
  times_s.push_back(options.until_s);
  // The state of a soft puck is known while it is played.
  const bool isSoftGame = std::any_of(scenario.billiard.pucks.begin(), scenario.billiard.pucks.end(),
                                      [](const Puck& puck) { return puck.soft.has_value(); });
  if (!isSoftGame) play(billiard, options.until_s);
  std::vector<Moment> moments;
  for (const double t_s : times_s) {
    if (isSoftGame) play(billiard, t_s);
    if (!moments.empty()) moments.back().soft.contacts.clear();
    moments.push_back(momentAt(billiard, points, t_s));
  }
  for (const FrozenPuck& frozen : billiard.frozen()) {
    log::warn(fmt::format("{}: {}", options.scenario.string(),
                          crushedText(scenario.billiard.pucks[frozen.puck].name, frozen.t_s)));
  }
  if (!billiard.jams().empty()) {
    const JamNote& first = billiard.jams().front();
    double heat_j = 0.0;
    for (const JamNote& jam : billiard.jams()) heat_j += jam.heat_j;
    log::note(
        fmt::format("note: jammed pucks moved on together {} times, which gave {:.6g} J of heat; the first "
                    "time {} pucks, "
                    "'{}' among them, at t = {:.6g} s",
                    billiard.jams().size(), heat_j, first.pucks, scenario.billiard.pucks[first.puck].name,
                    first.event.t_s));
  }
  out.commit(options.json ? jsonOf(scenario, billiard, options, moments)
                          : tableOf(scenario, billiard, options, moments) +
                                balanceOf(scenario, start, ledgerAt(scenario, billiard, options.until_s)));
  return 0;
}

void addSimulate(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("simulate", "Play a scenario: every collision, and where the pucks are");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("SCENARIO", options->scenario, "Scenario file, or the name of a shipped one")
      ->required()
      ->transform(shipped({"scenarios"}));
  command->add_option("--until", options->until_s, "Board time to play to, in seconds")
      ->required()
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command->add_option("--every", options->every_s, "Also give the states at 0, D, 2D, … seconds")
      ->type_name("D")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  auto points = std::make_shared<std::vector<std::tuple<std::string, double, double>>>();
  command
      ->add_option(
          "--point", *points,
          "Also give this place of a puck's matter, from the centre of the relaxed puck (m). May be given "
          "several times")
      ->type_name("NAME DX DY")
      ->allow_extra_args(false);
  addJson(*command, options->json);
  command->footer("Example:\n  carom simulate three-pucks --until 10 --every 0.5 --json game.json");
  command->callback([options, points, &status] {
    if (options->every_s && options->until_s / *options->every_s > kMostStates) {
      throw CLI::ValidationError("--every", "gives over a million states, expected a longer step");
    }
    for (const auto& [name, dx, dy] : *points) options->points.push_back({name, {dx, dy}});
    try {
      status = runSimulate(*options);
    } catch (const UnknownPuckPoint& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

}  // namespace carom
