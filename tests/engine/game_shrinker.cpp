#include "engine/game_shrinker.h"

namespace carom::test {

namespace {

void removePuck(BilliardSetup& setup, std::size_t puck) {
  setup.pucks.erase(setup.pucks.begin() + static_cast<std::ptrdiff_t>(puck));
  std::erase_if(setup.strokes, [&](const Stroke& stroke) { return stroke.puck == puck; });
  for (Stroke& stroke : setup.strokes) stroke.puck -= stroke.puck > puck ? 1 : 0;
}

}  // namespace

RandomGame shrunk(const RandomGame& game, const std::function<bool(const RandomGame&)>& isWrong, int tries) {
  RandomGame best = game;
  bool better = true;
  const auto attempt = [&](const auto& change) {
    RandomGame smaller = best;
    change(smaller);
    if (--tries < 0 || !isWrong(smaller)) return false;
    best = std::move(smaller);
    return better = true;
  };
  while (better && tries > 0) {
    better = false;
    attempt([](RandomGame& g) { g.until_s *= 0.5; });
    attempt([](RandomGame& g) { g.until_s *= 0.9; });
    for (std::size_t i = best.setup.strokes.size(); i-- > 0;)
      attempt([&](RandomGame& g) {
        g.setup.strokes.erase(g.setup.strokes.begin() + static_cast<std::ptrdiff_t>(i));
      });
    for (std::size_t i = best.setup.pucks.size(); i-- > 0;)
      attempt([&](RandomGame& g) { removePuck(g.setup, i); });
    if (best.setup.board) attempt([](RandomGame& g) { g.setup.board.reset(); });
    if (best.setup.rules.friction_m_s2 > 0.0)
      attempt([](RandomGame& g) { g.setup.rules.friction_m_s2 = 0.0; });
  }
  return best;
}

}  // namespace carom::test
