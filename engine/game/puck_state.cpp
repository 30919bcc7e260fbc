#include "engine/game/puck_state.h"

#include <algorithm>

namespace carom {

namespace {

constexpr int kKicksOfAJam = 64;
constexpr double kJamPerRadius = 1e-6;  // of the time in which light crosses the radius
constexpr int kImpactsByPressed = 16;   // the number that the kick of a pressed puck counts

}  // namespace

bool PuckState::noteKick(double turnTime, double radius) {
  lastKick = turnTime;
  if (jammed) return false;
  if (kicksInRun == 0 || turnTime - runBegan > kJamPerRadius * radius) {
    runBegan = turnTime;
    kicksInRun = 0;
  }
  jammed = ++kicksInRun >= kKicksOfAJam;
  return jammed;
}

void PuckState::noteRest(double turnTime, double radius) {
  if (!jammed || !(turnTime - lastKick > kJamPerRadius * radius)) return;
  jammed = false;
  kicksInRun = 0;
}

void PuckState::noteImpact(double turnTime, double radius, double closing, bool byMany) {
  const bool peace = turnTime - lastImpact > radius;
  const bool newRun = impacts < kImpactsOfAJam && turnTime - impactsBegan > radius;
  if (peace || newRun) {
    impactsBegan = turnTime;
    impacts = 0;
    jams = 0;
    hardestImpact = 0.0;
  }
  impacts += byMany ? kImpactsByPressed : 1;
  lastImpact = std::max(lastImpact, turnTime);
  hardestImpact = std::max(hardestImpact, closing);
}

}  // namespace carom
