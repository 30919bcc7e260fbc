// Where moments cut the tubes: the events lie on the rim's world lines by their whole histories, and on the
// observer's light cone, on the plane of the observer's present, or on the board's.
#include "engine/sculpture/rim_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/billiard/billiard.h"
#include "engine/light/vertex_history.h"
#include "engine/random_game.h"
#include "engine/random_world.h"
#include "engine/sculpture/world_tube.h"

namespace carom {
namespace {

constexpr double kExact_m = 1e-9;

TEST(RimCut, LiesOnTheTubeAndOnTheMomentsSurface) {
  int events = 0, fast = 0;
  BodyView view;
  std::vector<Event> cut;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const test::RandomGame game = test::randomGame(seed, {.events = 60, .packed = 8});
    const BilliardSetup& setup = game.setup;
    if (setup.pucks.size() > 12 || game.until_s > 60.0) continue;
    SCOPED_TRACE(testing::Message() << "game " << seed << ", " << game.kind);
    const double c_m_s = setup.lightSpeed_m_s, until_s = std::min(game.until_s, 6.0);
    Billiard billiard(setup);
    billiard.advanceTo(until_s);
    test::Random random(seed);
    for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck) {
      const WorldLine& line = billiard.worldLines()[puck];
      const Event eye{random.in(0.2, until_s), Vec3(random.in(-2.0, 2.0), random.in(-2.0, 2.0), 0.7)};
      const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), c_m_s);
      const Knots knots = line.knots();
      const bool isFast = std::any_of(knots.begin(), knots.end(),
                                      [](const Knot& knot) { return glm::length(betaFromU(knot.u)) > 0.95; });
      Rim rim;
      for (const Vec2& point_m : rimOf(setup.pucks[puck]))
        rim.emplace_back(point_m, 0.5 * setup.pucks[puck].height_m);
      for (const ViewTime moment : {ViewTime::seen, ViewTime::myNow, ViewTime::boardNow}) {
        cutRim(rim, line, eye, headFromBoard, moment, view, cut);
        ASSERT_EQ(cut.size(), rim.size());
        for (std::size_t i = 0; i < rim.size(); i += 3) {
          const Event& event = cut[i];
          const double size = 1.0 + glm::length(event.r_m - eye.r_m) + c_m_s * std::abs(event.t_s - eye.t_s);
          const Vec3 place_m = placeAt(pieceAt(vertexHistory(line, rim[i]), event.t_s), event.t_s, c_m_s);
          const Displacement own = headFromBoard * (event - eye);
          const double off_m = moment == ViewTime::seen
                                   ? c_m_s * (eye.t_s - event.t_s) - glm::length(eye.r_m - event.r_m)
                               : moment == ViewTime::myNow ? c_m_s * own.dt_s
                                                           : c_m_s * (event.t_s - eye.t_s);
          ASSERT_NEAR(off_m, 0.0, kExact_m * size) << "moment " << static_cast<int>(moment);
          ASSERT_LT(glm::distance(place_m, event.r_m), kExact_m * size)
              << "moment " << static_cast<int>(moment) << ", puck " << puck << ", point " << i;
          ++events;
          fast += isFast;
        }
      }
    }
  }
  EXPECT_GT(events, 5000);
  EXPECT_GT(fast, 1000);
}

}  // namespace
}  // namespace carom
