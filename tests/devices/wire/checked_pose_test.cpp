#include "devices/wire/checked_pose.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(CheckedPose, TakesPosesAndNormalisesThem) {
  test::Random random(72);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const glm::dquat turn = glm::angleAxis(random.in(-3.0, 3.0), random.direction());
    const Vec3 place_m = random.inBox(500.0);
    const auto pose = checkedPose(place_m, turn * random.in(0.981, 1.019));
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->position_m, place_m);
    EXPECT_NEAR(glm::dot(pose->orientation, turn), 1.0, 1e-14);
  }
}

TEST(CheckedPose, RefusesWhatIsNone) {
  const glm::dquat still(1.0, 0.0, 0.0, 0.0);
  EXPECT_FALSE(checkedPose({1001.0, 0.0, 0.0}, still)) << "farther than any tracker sees";
  EXPECT_FALSE(checkedPose({kNaN, 0.0, 0.0}, still));
  EXPECT_FALSE(checkedPose({std::numeric_limits<double>::infinity(), 0.0, 0.0}, still));
  EXPECT_FALSE(checkedPose({}, glm::dquat(0.0, 0.0, 0.0, 0.0)));
  EXPECT_FALSE(checkedPose({}, still * 1.03));
  EXPECT_FALSE(checkedPose({}, glm::dquat(kNaN, 0.0, 0.0, 1.0)));
}

TEST(CheckedPose, ReadsRotationsFromTheirColumns) {
  test::Random random(73);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const glm::dquat turn = glm::angleAxis(random.in(-3.0, 3.0), random.direction());
    std::array<double, 9> columns;
    for (int k = 0; k < 3; ++k) {
      const Vec3 column = turn * Vec3(k == 0, k == 1, k == 2);
      for (int n = 0; n < 3; ++n) columns[3 * k + n] = std::round(column[n] * 1e6) * 1e-6;
    }
    const auto read = checkedRotation(columns);
    ASSERT_TRUE(read);
    EXPECT_NEAR(std::abs(glm::dot(*read, turn)), 1.0, 1e-10);
    columns[4] += 0.1;
    EXPECT_FALSE(checkedRotation(columns));
  }
  EXPECT_FALSE(checkedRotation({1, 0, 0, 0, 1, 0, 0, 0, -1})) << "a mirror";
  EXPECT_FALSE(checkedRotation({kNaN, 0, 0, 0, 1, 0, 0, 0, 1}));
}

}  // namespace
}  // namespace carom
