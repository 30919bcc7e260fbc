// What stands in the sculpture of spacetime: the bright line on a tube is the rim of the puck as it is seen,
// and the surfaces are those of the observer's moments.
#include "cave/sculpture/sculpture_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cave/frame/bodies.h"
#include "cave/room/off_axis.h"
#include "cave/sculpted_game.h"
#include "engine/billiard/billiard.h"
#include "engine/light/vertex_history.h"
#include "engine/random_game.h"
#include "engine/random_world.h"
#include "engine/sculpture/world_tube.h"

namespace carom {
namespace {

/// A wall that the place is seen on, a metre before the eye.
Wall wallTowards(const Vec3& way) {
  const Vec3 ahead = glm::normalize(way), up0(0.0, 0.0, 1.0);
  const Vec3 right = glm::normalize(glm::cross(ahead, std::abs(ahead.z) < 0.9 ? up0 : Vec3(1.0, 0.0, 0.0)));
  const Vec3 up = glm::cross(right, ahead);
  Wall wall;
  wall.lowerLeft_m = ahead - right - up;
  wall.lowerRight_m = ahead + right - up;
  wall.upperLeft_m = ahead - right + up;
  wall.pixels = {1920, 1920};
  return wall;
}

TEST(SculptureShape, TheBrightLineIsTheSeenRim) {
  int points = 0, games = 0;
  for (std::uint64_t seed = 1; games < 10; ++seed) {
    const test::RandomGame game = test::randomGame(seed, {.events = 60, .packed = 8});
    const BilliardSetup& setup = game.setup;
    if (setup.pucks.size() > 12 || game.until_s > 60.0) continue;
    ++games;
    SCOPED_TRACE(testing::Message() << "game " << seed << ", " << game.kind);
    const double c_m_s = setup.lightSpeed_m_s, now_s = std::min(game.until_s, 6.0);
    Billiard billiard(setup);
    billiard.advanceTo(now_s);
    World world;
    world.histories.push_back(restingWorldLine(c_m_s));
    for (const WorldLine& line : billiard.worldLines()) world.histories.push_back(line);
    test::Random random(seed);
    FrameRecord record;
    record.viewerCount = 2;
    for (ViewerState& viewer : record.present()) {
      viewer.observer.headFromBoard = Lorentz::boost(random.u(0.9), c_m_s);
      viewer.observer.middle.observation = {now_s, {random.in(-2.0, 2.0), random.in(-2.0, 2.0), 0.8}};
    }
    SculptureShape shape(test::sculptedOf(setup, glm::vec3(1.0F)));
    shape.follow(record, world);
    EXPECT_EQ(shape.cuts().size(), 5 * setup.pucks.size()) << "three moments of one viewer, two of the other";
    for (const TubeCut& cut : shape.cuts()) {
      const ObserverView& observer = record.viewers[cut.viewer].observer;
      const Event& eye = observer.middle.observation;
      const Puck& puck = setup.pucks[cut.body];
      for (const Event& event : cut.events) {
        if (puck.height_m == shape.game().top_m) {
          const Event on = surfaceEvent(observer, cut.moment, glm::dvec2(event.r_m), shape.game().top_m);
          ASSERT_NEAR(c_m_s * (on.t_s - event.t_s), 0.0, 1e-8 * (1.0 + glm::length(event.r_m - eye.r_m)));
        }
      }
      if (cut.moment != ViewTime::seen) continue;
      const std::size_t every = everyFor(puck, SculptureShape::kFine_m / record.sculpture.place.scale);
      std::vector<Vec2> rim;
      for (std::size_t i = 0; i < rimOf(puck).size(); i += every) rim.push_back(rimOf(puck)[i]);
      ASSERT_EQ(cut.events.size(), rim.size());
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const auto history =
            vertexHistory(world.histories[kFirstPuck + cut.body], Vec3(rim[i], 0.5 * puck.height_m));
        const Vec3 seen = (observer.headFromBoard * (eventOnPastCone(history, eye, c_m_s) - eye)).dr_m;
        const Vec3 drawn = (observer.headFromBoard * (cut.events[i] - eye)).dr_m;
        const auto clip = clipFromEye(wallTowards(seen), Vec3(0.0));
        ASSERT_TRUE(clip);
        const glm::dvec4 a = *clip * glm::dvec4(seen, 1.0), b = *clip * glm::dvec4(drawn, 1.0);
        ASSERT_LT(960.0 * glm::distance(glm::dvec2(a) / a.w, glm::dvec2(b) / b.w), 0.5);
        ++points;
      }
    }
  }
  EXPECT_GT(points, 2000);
}

TEST(SculptureShape, AViewersLineHasTheirOwnTime) {
  OwnLines lines;
  FrameRecord record;
  for (int frame = 0; frame < 600; ++frame) {
    record.number = static_cast<std::uint64_t>(frame);
    record.sculpture.place.past_s = 2.0;
    ObserverView& observer = record.viewers[0].observer;
    observer.headFromBoard = Lorentz(1.42);
    observer.properTime_s = frame / 60.0;
    observer.middle.observation = {frame / 50.0, {0.001 * frame, 0.0, 0.8}};
    lines.follow(record);
    lines.follow(record);  // once for each eye
  }
  const auto line = lines.of(0);
  ASSERT_GT(line.size(), 100u);
  EXPECT_LT(line.size(), 300u);
  for (std::size_t i = 1; i < line.size(); ++i) ASSERT_GT(line[i].properTime_s, line[i - 1].properTime_s);
  EXPECT_EQ(line.back().event.t_s, 599.0 / 50.0);
  record.viewers[0].observer.properTime_s = 0.0;
  lines.follow(record);
  EXPECT_EQ(lines.of(0).size(), 1u) << "a pass that begins again";
}

}  // namespace
}  // namespace carom
