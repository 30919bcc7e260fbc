// Heads and wands that mouse and keys move: how far they walk, where they stop, where they point, how a wand
// is drawn.
#include "app/play/mouse_people.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <string>

namespace carom {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kHigh_m = 1.7;

/// A place by its coordinates to the right, up and forward.
struct Axes {
  std::string name;
  RoomAxes axes;
  Vec3 at(double right_m, double up_m, double forward_m) const {
    return right_m * axes.right + up_m * axes.up + forward_m * axes.forward;
  }
};
/// Or GoogleTest prints its bytes, among them a place in memory, as the name of a test.
void PrintTo(const Axes& axes, std::ostream* out) { *out << axes.name; }

/// A room of 3 m with a front, a left and a right wall and a floor, for this many people.
Rig roomOf(const Axes& axes, int people) {
  Rig rig;
  rig.axes = axes.axes;
  const auto wall = [&](const char* name, const Vec3& lowerLeft, const Vec3& lowerRight,
                        const Vec3& upperLeft) {
    Wall one;
    one.name = name;
    one.lowerLeft_m = lowerLeft;
    one.lowerRight_m = lowerRight;
    one.upperLeft_m = upperLeft;
    rig.walls.push_back(one);
  };
  wall("front", axes.at(-1.5, 0, 1.5), axes.at(1.5, 0, 1.5), axes.at(-1.5, 3, 1.5));
  wall("left", axes.at(-1.5, 0, -1.5), axes.at(-1.5, 0, 1.5), axes.at(-1.5, 3, -1.5));
  wall("right", axes.at(1.5, 0, 1.5), axes.at(1.5, 0, -1.5), axes.at(1.5, 3, 1.5));
  wall("floor", axes.at(-1.5, 0, -1.5), axes.at(1.5, 0, -1.5), axes.at(-1.5, 0, 1.5));
  rig.viewers.clear();
  for (int i = 0; i < people; ++i) {
    ViewerSetup viewer;
    viewer.head.sensor = {0, 2 * i};
    viewer.hand = HandSetup{{.tracker = 0, .sensor = 2 * i + 1}, {}};
    rig.viewers.push_back(viewer);
  }
  return rig;
}

class MousePeopleTest : public testing::TestWithParam<Axes> {
 protected:
  void frames(int count, std::size_t viewer = 0) {
    for (int i = 0; i < count; ++i) {
      people_.move(desk_, viewer, now_s_ += kFrame_s);
      std::vector<TrackerSample> samples;
      tracker_->poll(now_s_, samples);
      for (const TrackerSample& sample : samples) poses_[sample.sensor] = sample.pose;
      std::vector<Reading> inputs;
      tracker_->takeInputs(inputs);
      for (const Reading& input : inputs) down_[input.sensor] = input.value != 0.0;
    }
  }
  Vec3 at(double right_m, double up_m, double forward_m) const {
    return GetParam().at(right_m, up_m, forward_m);
  }
  void pointTo(const Vec3& place_m) { desk_.mouse = PointedWall{place_m}; }
  double forward_m(int sensor = 0) { return glm::dot(poses_[sensor].position_m, GetParam().axes.forward); }
  Vec3 directionOf(int sensor) { return poses_[sensor].orientation * GetParam().axes.forward; }
  /// How far a sensor's forward axis passes by a place.
  double misses_m(int sensor, const Vec3& place_m) {
    return glm::length(glm::cross(place_m - poses_[sensor].position_m, directionOf(sensor)));
  }

  DeskInput desk_;
  MousePeople people_{roomOf(GetParam(), 2)};
  std::unique_ptr<Tracker> tracker_ = people_.tracker();
  std::map<int, Pose> poses_;
  std::map<int, bool> down_;
  double now_s_ = 0.0;
};

void expectAt(const Vec3& a, const Vec3& b, double within) {
  EXPECT_LE(glm::distance(a, b), within) << a.x << " " << a.y << " " << a.z;
}

TEST_P(MousePeopleTest, TheyStandWhereATrackedPersonWould) {
  frames(1);
  expectAt(poses_[0].position_m, at(0, kHigh_m, 0), 1e-12);
  expectAt(directionOf(0), GetParam().axes.forward, 1e-12);
  EXPECT_GT(glm::distance(poses_[2].position_m, poses_[0].position_m), 0.5) << "the other one is beside them";
}

TEST_P(MousePeopleTest, ArrowsWalkAtAWalkersPaceAndStopSoftly) {
  frames(1);
  const Vec3 other_m = poses_[2].position_m;
  desk_.walk = {0, 1, 0};
  frames(60);
  // The distance under a speed that approaches v with the time constant 0.15 s: v (t − τ (1 − e^(−t/τ))).
  EXPECT_NEAR(forward_m(), 0.7 * (1.0 - 0.15), 0.01);
  desk_.walk = {};
  const double before_m = forward_m();
  frames(120);
  EXPECT_NEAR(forward_m() - before_m, 0.7 * 0.15, 0.01);
  const double still_m = forward_m();
  frames(1);
  EXPECT_NEAR(forward_m(), still_m, 1e-6);
  desk_.walk = {0, 0, -1};
  frames(30);
  EXPECT_LT(glm::dot(poses_[0].position_m, GetParam().axes.up), kHigh_m - 0.2) << "Page Down";
  expectAt(poses_[2].position_m, other_m, 1e-12);
}

TEST_P(MousePeopleTest, NobodyWalksThroughAWall) {
  for (const Vec3& way : {Vec3(1, 1, 0), Vec3(-1, 1, -1), Vec3(0, 0, -1)}) {
    desk_.walk = way;
    frames(600);
    const Vec3 m = poses_[0].position_m;
    const RoomAxes& axes = GetParam().axes;
    for (const double inside_m : {1.5 - glm::dot(m, axes.forward), 1.5 - glm::dot(m, axes.right),
                                  1.5 + glm::dot(m, axes.right), glm::dot(m, axes.up)})
      EXPECT_GE(inside_m, MousePeople::kNearestWall_m - 1e-9);
  }
  desk_.walk = {0, -1, 0};
  frames(3600);
  EXPECT_NEAR(forward_m(), -MousePeople::kFarthest_m, 0.5) << "behind there is no wall, and yet an end";
}

TEST_P(MousePeopleTest, HeadAndWandTurnToWhatTheMousePointsTo) {
  for (const Vec3& place_m : {at(0.7, 1.2, 1.5), at(-1.5, 0.4, 0.3), at(1.5, 2.5, -0.9), at(0.4, 0.0, 0.6)}) {
    pointTo(place_m);
    frames(120);
    EXPECT_LT(misses_m(0, place_m), 1e-9) << "the head";
    EXPECT_LT(misses_m(1, place_m), 1e-9) << "the wand";
    EXPECT_GT(glm::dot(directionOf(1), place_m - poses_[1].position_m), 0.0);
    const Vec3 right = poses_[0].orientation * GetParam().axes.right;
    EXPECT_NEAR(glm::dot(right, GetParam().axes.up), 0.0, 1e-9) << "it is not tilted to a side";
  }
  pointTo(at(0, 0, 0.001));
  frames(120);
  EXPECT_LT(glm::dot(directionOf(0), GetParam().axes.up), -0.9) << "down before the feet";
}

TEST_P(MousePeopleTest, KeysTurnThemUntilTheMouseMoves) {
  pointTo(at(0, kHigh_m, 1.5));
  frames(60);
  desk_.look = 1.0;
  frames(60);
  const double turned_rad = std::atan2(glm::dot(directionOf(0), GetParam().axes.right),
                                       glm::dot(directionOf(0), GetParam().axes.forward));
  EXPECT_NEAR(turned_rad, MousePeople::kTurn_rad_s, 0.02) << "to the right";
  desk_.look = 0.0;
  frames(60);
  expectAt(directionOf(0), glm::angleAxis(-turned_rad, GetParam().axes.up) * GetParam().axes.forward, 1e-9);
  expectAt(directionOf(1), directionOf(0), 1e-9);
  pointTo(at(0.001, kHigh_m, 1.5));
  frames(60);
  EXPECT_LT(misses_m(0, at(0.001, kHigh_m, 1.5)), 1e-9);
}

TEST_P(MousePeopleTest, TheLeftButtonDrawsTheWandAsTheMouseMovesOnTheCloth) {
  /// The place on the floor behind which the eyes see this place on the cloth, 0.75 m above the floor.
  const auto behind = [&](double right_m, double forward_m) {
    const double share = kHigh_m / (kHigh_m - 0.75);
    return at(share * right_m, 0.0, share * forward_m);
  };
  pointTo(behind(0.1, 0.6));
  frames(120);
  const Pose before = poses_[1];
  desk_.mouseHeld = true;
  frames(1);
  EXPECT_TRUE(down_[1]);
  expectAt(poses_[1].position_m, before.position_m, 1e-9);
  pointTo(behind(0.2, 0.3));
  frames(1);
  expectAt(poses_[1].position_m - before.position_m, at(0.1, 0.0, -0.3), 1e-9);
  expectAt(directionOf(1), before.orientation * GetParam().axes.forward, 1e-12);
  desk_.mouseHeld = false;
  frames(1);
  EXPECT_FALSE(down_[1]);
  expectAt(poses_[1].position_m - before.position_m, at(0.1, 0.0, -0.3), 0.05);
  pointTo(behind(0.1, 0.6));
  frames(120);
  expectAt(poses_[1].position_m, before.position_m, 1e-6);
}

TEST_P(MousePeopleTest, TheMouseIsTheirsOverWhoseWallsItIs) {
  frames(1);
  const Pose first = poses_[0];
  desk_.walk = {0, 1, 0};
  desk_.mouseHeld = true;
  frames(30, 1);
  expectAt(poses_[0].position_m, first.position_m, 1e-12);
  EXPECT_GT(forward_m(2), 0.1);
  EXPECT_TRUE(down_[3] && !down_[1]);
}

INSTANTIATE_TEST_SUITE_P(BothAxes, MousePeopleTest,
                         testing::Values(Axes{"YUp", {}}, Axes{"ZUp", {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}),
                         [](const testing::TestParamInfo<Axes>& axes) { return axes.param.name; });

}  // namespace
}  // namespace carom
