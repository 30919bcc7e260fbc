#include "engine/spacetime/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

TEST(Observer, TheStartingRoomFacesItsWayAndMovesWithItsSpeed) {
  test::Random random(86);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    ObserverStart start;
    start.facing_rad = random.in(-3.0, 3.0);
    start.beta = random.direction() * random.in(0.0, 0.9);
    const RoomAxes axes;
    const Lorentz room = startingRoom(start, axes, test::kC_m_s);
    EXPECT_LT(glm::length(betaFromU(room.u()) - start.beta), 1e-12);
    ObserverStart still = start;
    still.beta = Vec3(0.0);
    const Lorentz resting = startingRoom(still, axes, test::kC_m_s);
    const Vec3 forward = (resting * Displacement{0.0, axes.forward}).dr_m;
    EXPECT_LT(glm::length(forward - Vec3(std::cos(start.facing_rad), std::sin(start.facing_rad), 0.0)),
              1e-12);
    EXPECT_LT(glm::length((resting * Displacement{0.0, axes.up}).dr_m - Vec3(0.0, 0.0, 1.0)), 1e-12);
  }
}

ObserverView randomView(test::Random& random, const Vec3& right_m) {
  const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), test::kC_m_s);
  const EyeView middle{{random.in(0.0, 9.0), random.inBox(2.0)}, random.inBox(1.0), random.inBox(1.0)};
  return viewOfEyes(headFromBoard, middle, right_m, random.in(0.0, 9.0));
}

// For the head both eyes receive at one moment, and are as far apart as they are.
TEST(Observer, EyesAreSimultaneousForTheHead) {
  test::Random random(87);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const Vec3 right_m = random.direction() * 0.0325;
    const ObserverView view = randomView(random, right_m);
    const Displacement apart = view.headFromBoard * (view.right.observation - view.left.observation);
    EXPECT_NEAR(apart.dt_s, 0.0, 1e-14);
    EXPECT_LT(glm::length(apart.dr_m - 2.0 * right_m), 1e-13);
    EXPECT_LT(glm::length(view.right.positionInRoom_m - view.left.positionInRoom_m - 2.0 * right_m), 1e-14);
    EXPECT_EQ(&view.of(Eye::left), &view.left);
    EXPECT_EQ(&view.of(Eye::middle), &view.middle);
    EXPECT_EQ(view.all()[1].observation.t_s, view.right.observation.t_s);
  }
}

// Somebody at rest in the room shares its moment with the other.
TEST(Observer, OneAtRestSeesAtTheRoomsMoment) {
  test::Random random(88);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const ObserverView other = randomView(random, {0.03, 0.0, 0.0});
    const Lorentz boardFromRoom = Lorentz::boost(random.u(0.9), test::kC_m_s);
    const Vec3 place_m = random.inBox(2.0);
    const ObserverView view = viewAtRest(other, boardFromRoom, 5.0, place_m, {0.03, 0.0, 0.0});
    const Displacement apart = boardFromRoom.inverse() * (view.middle.observation - other.middle.observation);
    EXPECT_NEAR(apart.dt_s, 0.0, 1e-13);
    EXPECT_LT(glm::length(apart.dr_m - (place_m - other.middle.seenFromInRoom_m)), 1e-12);
    EXPECT_EQ(view.properTime_s, 5.0);
  }
}

TEST(Observer, AFrozenViewKeepsItsLightAndFollowsTheEyes) {
  test::Random random(89);
  const ObserverView sight = randomView(random, {0.03, 0.0, 0.0}), now = randomView(random, {0.03, 0.0, 0.0});
  const ObserverView frozen = frozenViewAt(sight, now);
  for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
    EXPECT_EQ(frozen.of(eye).observation.t_s, sight.middle.observation.t_s);
    EXPECT_EQ(frozen.of(eye).positionInRoom_m, now.of(eye).positionInRoom_m);
    EXPECT_EQ(frozen.of(eye).seenFromInRoom_m, sight.middle.seenFromInRoom_m);
  }
  EXPECT_EQ(frozen.properTime_s, sight.properTime_s);
}

}  // namespace
}  // namespace carom
