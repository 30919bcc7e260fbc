// Where bodies are at one moment of the room, against each of their points followed through the board by
// itself.
#include "cave/spectator/room_simultaneity.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
constexpr double kNear_m = 1e-7;

/// A point of a body on a straight way, on the board: its centre, and the offset contracted along the motion.
Event pointAt(const Knot& knot, const Vec3& offset_m, double t_s) {
  const double gamma = gammaFromU(knot.u);
  const Vec3 v_m_s = knot.u / gamma * kC_m_s;
  Vec3 contracted_m = offset_m;
  if (const double speed = glm::length(knot.u); speed > 0.0) {
    const Vec3 along = knot.u / speed;
    contracted_m += (1.0 / gamma - 1.0) * glm::dot(offset_m, along) * along;
  }
  return {t_s, knot.turn.r_m + v_m_s * (t_s - knot.turn.t_s) + contracted_m};
}

TEST(RoomSimultaneity, EveryPointIsWhereItsOwnWorldLineCrossesTheMoment) {
  test::Random random(8);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Lorentz boardFromRoom =
        Lorentz::boost(random.u(0.9), kC_m_s) *
        Lorentz::rotation(glm::normalize(glm::dquat(1.0, random.inBox(1.0))), kC_m_s);
    const Event head{random.in(-3.0, 3.0), random.inBox(2.0)};
    const Vec3 headInRoom_m = random.inBox(1.0);
    const Knot knot{{random.in(-1.0, 1.0), random.inBox(1.0)}, random.u(0.9), 0.0, {}, 0.0};
    const Vec3 offset_m = random.inBox(0.3);
    const auto place =
        RoomSimultaneity(boardFromRoom, head, headInRoom_m).roomFromBody(WorldLine(knot, kC_m_s, 0.5));
    ASSERT_TRUE(place);
    const Vec3 found_m(*place * glm::dvec4(offset_m, 1.0));

    // Room time is linear in board time along the point's straight way: two of its events give the third.
    const Lorentz roomFromBoard = boardFromRoom.inverse();
    const Displacement one = roomFromBoard * (pointAt(knot, offset_m, 0.0) - head);
    const Displacement other = roomFromBoard * (pointAt(knot, offset_m, 1.0) - head);
    const double share = -one.dt_s / (other.dt_s - one.dt_s);
    const Vec3 expected_m = headInRoom_m + one.dr_m + share * (other.dr_m - one.dr_m);
    ASSERT_LT(glm::distance(found_m, expected_m), kNear_m * (1.0 + std::abs(share)));
  }
}

TEST(RoomSimultaneity, ATableIsShorterForARoomThatMovesAlongIt) {
  const Lorentz boardFromRoom = Lorentz::boost(uFromBeta({0.6, 0.0, 0.0}), kC_m_s);
  const RoomSimultaneity moment(boardFromRoom, {0.0, {0.0, -1.0, 1.0}}, {0.0, 0.0, 1.7});
  const auto place = moment.roomFromBody(WorldLine(Knot{}, kC_m_s));
  ASSERT_TRUE(place);
  const auto at = [&](double x, double y) { return Vec3(*place * glm::dvec4(x, y, 0.0, 1.0)); };
  EXPECT_NEAR(glm::distance(at(-1.42, 0.0), at(1.42, 0.0)), 2.84 * 0.8, kNear_m);
  EXPECT_NEAR(glm::distance(at(0.0, -0.71), at(0.0, 0.71)), 1.42, kNear_m);
}

TEST(RoomSimultaneity, ABodyThatHasNotAppearedIsNowhere) {
  const WorldLine late(Knot{}, kC_m_s, 0.1, 2.0);
  const Lorentz atRest(kC_m_s);
  EXPECT_FALSE(RoomSimultaneity(atRest, {1.9, Vec3(0.0)}, Vec3(0.0)).roomFromBody(late));
  EXPECT_TRUE(RoomSimultaneity(atRest, {2.1, Vec3(0.0)}, Vec3(0.0)).roomFromBody(late));
}

}  // namespace
}  // namespace carom
