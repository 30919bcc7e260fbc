#include "app/game.h"

#include <limits>

#include "cave/scene.h"

namespace carom {
namespace {

constexpr std::size_t kFirstPuck = kRestingBody + 1;  // bodies of a scene: the board, the pucks, the told

}  // namespace

std::vector<WorldLine> startingHistories(const Scenario& scenario) {
  std::vector<WorldLine> histories{restingWorldLine(scenario.billiard.lightSpeed_m_s)};
  const Billiard atStart(scenario.billiard);
  for (const WorldLine& puck : atStart.worldLines()) histories.push_back(puck);
  for (const ToldBody& body : scenario.bodies) histories.push_back(body.worldLine);
  return histories;
}

Game::Game(const Scenario& scenario) : billiard_(scenario.billiard) { billiard_.takeChanges(); }

void Game::advance(double t_s, FrameState& state) {
  billiard_.advanceTo(t_s);
  const Changes changes = billiard_.takeChanges();
  state.record.truncateFrom_s = changes.truncatedFrom_s.value_or(std::numeric_limits<double>::infinity());
  state.record.pucks = billiard_.worldLines().size();
  state.knots.clear();
  for (const Changes::NewKnot& change : changes.knots) {
    state.knots.push_back({kFirstPuck + change.puck, change.knot});
  }
}

}  // namespace carom
