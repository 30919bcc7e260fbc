#include "cave/bodies/hot_bodies.h"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "cave/frame/bodies.h"

namespace carom {
namespace {

bool heatsRigid(EventKind kind) {
  return kind == EventKind::puckPuck || kind == EventKind::puckCushion || kind == EventKind::jam;
}

}  // namespace

std::array<double, 2> sharedHeat(double heat, const std::array<double, 2>& masses) {
  const double sum = masses[0] + masses[1] + heat;
  const double difference = (masses[0] - masses[1]) * (masses[0] + masses[1]) / sum;
  const double first = 0.5 * (sum + difference) - masses[0];
  return {first, heat - first};
}

HotBodies::HotBodies(std::span<const double> coldMasses_kg, std::size_t bodies, double lightSpeed_m_s)
    : coldMasses_kg_(coldMasses_kg.begin(), coldMasses_kg.end()),
      c_m_s_(lightSpeed_m_s),
      blows_(coldMasses_kg.size()),
      seen_(bodies) {}

/// Replaces the blow that has left the least heat at any one moment, if this one leaves more.
void HotBodies::add(std::size_t puck, const Blow& blow) {
  const auto left = [&](const Blow& of) {
    return of.heat * std::exp(std::min((of.at.t_s - blow.at.t_s) / kCooling_s, 100.0));
  };
  const auto least = std::min_element(blows_[puck].begin(), blows_[puck].end(),
                                      [&](const Blow& a, const Blow& b) { return left(a) < left(b); });
  if (left(*least) < blow.heat) *least = blow;
}

void HotBodies::follow(std::span<const GameEvent> events, std::uint64_t eventsKept) {
  // Those that the list has are taken anew: a stroke may have changed them.
  const std::uint64_t known = events.empty() ? eventsKept : std::min(eventsKept, events.front().number);
  for (Blows& blows : blows_) {
    for (Blow& blow : blows)
      if (blow.number >= known) blow = {};
  }
  if (blows_.empty()) return;
  const double c2 = c_m_s_ * c_m_s_;
  for (const GameEvent& event : events) {
    if (!(event.heat_j > 0.0) || event.turns.empty() || !heatsRigid(event.kind)) continue;
    const Turns& turns = event.turns;
    const auto mass_kg = [&](std::size_t i) { return coldMasses_kg_.at(turns[i].puck); };
    std::array<double, 2> heats_kg{event.heat_j / c2, 0.0};
    if (turns.size() == 2) heats_kg = sharedHeat(heats_kg[0], {mass_kg(0), mass_kg(1)});
    for (std::size_t i = 0; i < turns.size(); ++i) {
      // A kick that acts at once comes with the turn itself.
      const Event& at = event.withoutDelay ? turns[i].event : event.at;
      add(turns[i].puck, {event.number, at, heats_kg[i] / mass_kg(i)});
    }
  }
}

std::span<const HotBlows> HotBodies::seenFrom(const Event& observation) {
  for (std::size_t puck = 0; puck < blows_.size(); ++puck) {
    HotBlows& seen = seen_[kFirstPuck + puck];
    seen.heats = glm::vec4(0.0F);
    for (int i = 0; i < 4; ++i) {
      const auto& [number, at, heat] = blows_[puck][static_cast<std::size_t>(i)];
      if (heat <= 0.0 || at.t_s >= observation.t_s) continue;
      const glm::vec3 way_m(at.r_m - observation.r_m);
      seen.fromEye_m[static_cast<std::size_t>(i)] =
          glm::vec4(static_cast<float>(c_m_s_ * (at.t_s - observation.t_s)), way_m);
      seen.heats[i] = static_cast<float>(heat);
    }
    // Light that is late left more of it, so all of it counts.
    if (seen.heats.x + seen.heats.y + seen.heats.z + seen.heats.w < static_cast<float>(kLeastGlow))
      seen.heats = glm::vec4(0.0F);
  }
  return seen_;
}

}  // namespace carom
