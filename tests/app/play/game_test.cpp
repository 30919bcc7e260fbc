// A game of hours, as the frame loop plays it: what no eye can see any more is forgotten, and nobody sees a
// difference.

#include "app/play/game.h"
#include "app/scenario/starting_histories.h"
#include "engine/spacetime/observers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/light/light_cone.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kEyeSeparation_m = 0.064;

bool sameBits(const BodyView& a, const BodyView& b) {
  const auto bytes = [](const BodyView& view) { return std::as_bytes(std::span<const LegView>(view.legs)); };
  return a.appears_m == b.appears_m && a.legs.size() == b.legs.size() &&
         std::memcmp(bytes(a).data(), bytes(b).data(), bytes(a).size()) == 0;
}

std::size_t knotsOf(std::span<const WorldLine> histories) {
  std::size_t knots = 0;
  for (const WorldLine& history : histories) knots += history.knots().size();
  return knots;
}

// A person walks to and fro beside the table, at up to 3 m/s of celerity, for four hours of their time. Of
// the histories one copy forgets and one does not; at moments all over the session both eyes see the same
// bits in both, with contraction and without.
TEST(Game, ForgetsOnlyWhatNoEyeSeesAnyMore) {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  Game game(scenario);
  World kept{startingHistories(scenario), {}}, forgetting = kept;
  const auto headAt = [](double t_s) {
    const double swing_m = 2.0, perSecond = 1.5;
    Head head;
    head.roomFromHead.position_m = {swing_m * std::sin(perSecond * t_s), 0.0, 1.7};
    head.celerity_m_s = {swing_m * perSecond * std::cos(perSecond * t_s), 0.0, 0.0};
    return head;
  };
  Observers observer(Lorentz(c_m_s), {0.0, scenario.observer.position_m}, headAt(0.0));

  const double step_s = 0.1, end_s = 4.0 * 3600.0;
  std::size_t mostKnots = 0, compared = 0;
  FrameState state;
  BodyView all, left;
  for (int frame = 0; frame * step_s < end_s; ++frame) {
    observer.step(step_s, headAt(frame * step_s));
    const ObserverView eyes = observer.view(kEyeSeparation_m);
    state.record = {};
    game.advance(eyes.middle.observation.t_s + 1.0, state);
    applyFrame(state, kept);
    if (frame % 100 == 0) game.forget(forgetting, {&eyes, 1}, state);
    applyFrame(state, forgetting);
    mostKnots = std::max(mostKnots, knotsOf(forgetting.histories));
    if (frame % 97 != 0) continue;
    for (const EyeView& eye : eyes.all()) {
      for (std::size_t body = 0; body < kept.histories.size(); ++body) {
        for (const std::uint8_t contraction : {std::uint8_t{1}, std::uint8_t{0}}) {
          Switches switches;
          switches.contraction = contraction;
          viewBody(kept.histories[body], eye.observation, eyes.headFromBoard, all, switches);
          viewBody(forgetting.histories[body], eye.observation, eyes.headFromBoard, left, switches);
          ASSERT_TRUE(sameBits(all, left)) << "body " << body << " at " << eye.observation.t_s << " s";
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 10000u);
  EXPECT_GT(knotsOf(kept.histories), 10000u);
  // Two minutes of the game, of four hours (and more on the board's clock).
  EXPECT_LT(mostKnots, knotsOf(kept.histories) / 50);
}

// A session that goes on brings all of the game with its first frame, over what the file has of it already.
TEST(Game, ItsFirstFrameBringsAllKnotsAndEvents) {
  Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  scenario.billiard.flashes = {{"lamp", {1.0, {0.0, 0.0, 0.5}}}};
  World lived{startingHistories(scenario), {}}, again = lived;
  FrameState state;
  Game game(scenario);
  for (int frame = 1; frame <= 100; ++frame) {
    state.record = {};
    game.advance(0.1 * frame, state);
    applyFrame(state, lived);
  }
  ASSERT_GT(lived.events.size(), 5u);
  again.events = {lived.events.begin(), lived.events.begin() + 3};  // as the file has them
  Game resumed(scenario);
  state.record = {};
  resumed.advance(10.0, state);
  applyFrame(state, again);
  ASSERT_EQ(again.events.size(), lived.events.size());
  bool flashed = false;
  for (std::size_t i = 0; i < again.events.size(); ++i) {
    EXPECT_EQ(again.events[i].number, i);
    EXPECT_EQ(again.events[i].at.t_s, lived.events[i].at.t_s);
    EXPECT_EQ(again.events[i].kind, lived.events[i].kind);
    flashed = flashed || again.events[i].kind == EventKind::flash;
  }
  EXPECT_TRUE(flashed);
  EXPECT_EQ(knotsOf(again.histories), knotsOf(lived.histories));
}

// A soft puck too fast for its few cells.
TEST(Game, ACrushedPuckIsToldOnce) {
  Scenario scenario;
  scenario.billiard.lightSpeed_m_s = 1.42;
  scenario.billiard.board = Board{0.5, 0.5};
  Puck puck;
  puck.name = "jelly";
  puck.radius_m = 0.03, puck.height_m = 0.02, puck.mass_kg = 0.2;
  puck.beta = {0.998, 0.0};
  puck.soft = SoftMatter{0.7, 4, 0.05, {}};
  scenario.billiard.pucks = {puck};
  const test::LogLines lines;
  Game game(scenario);
  FrameState frame;
  for (double t_s = 0.02; t_s < 0.5; t_s += 0.02) game.advance(t_s, frame);
  ASSERT_EQ(lines.said().size(), 1U);
  EXPECT_NE(lines.said()[0].find("puck 'jelly' was crushed more than can be computed at t = 0.1"),
            std::string::npos)
      << lines.said()[0];
}

}  // namespace
}  // namespace carom
