#include "app/scenario/starting_histories.h"

#include "cave/frame/bodies.h"
#include "engine/billiard/billiard.h"

namespace carom {

std::vector<WorldLine> startingHistories(const Scenario& scenario) {
  std::vector<WorldLine> histories{restingWorldLine(scenario.billiard.lightSpeed_m_s)};
  const Billiard atStart(scenario.billiard);
  for (const WorldLine& puck : atStart.worldLines()) histories.push_back(puck);
  for (const ScriptedBody& body : scenario.bodies) histories.push_back(body.worldLine);
  return histories;
}

}  // namespace carom
