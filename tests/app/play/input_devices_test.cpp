// Whose hand holds the cue, and what hands ask of the drive; a wand's readings through a tracker that a test
// feeds.
#include "app/play/input_devices.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "app/fed_tracker.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using namespace test;

class HandsTest : public testing::Test {
 protected:
  HandsTest() { use(rigWith(TrackerKind::dtrack)); }

  void use(const Rig& rig) {
    HandTracking::Trackers trackers;
    trackers.wand.reset(wand_ = new FedTracker);
    trackers.spaceMouse.reset(cap_ = new FedTracker);
    tracking_.emplace(rig, rig.viewers.front(), std::move(trackers));
    wand_->fed = {at(3, {0.3, 0.2, -0.4}), at(4, {9, 9, 9})};
    observer_.left.positionInRoom_m = {-0.032, 1.7, 0.0};
    observer_.right.positionInRoom_m = {0.032, 1.7, 0.0};
    observer_.middle.positionInRoom_m = {0.0, 1.7, 0.0};
    for (EyeView* eye : {&observer_.left, &observer_.right, &observer_.middle})
      eye->observation.r_m.z = 0.9;  // above the cloth: which is at y = 0.8
  }

  /// A frame of 20 ms.
  HandInput frame() {
    now_s_ += 0.02;
    hands_.begin(desk_, asks_);
    tracking_->follow(now_s_, {}, {});
    return hands_.cue(tracking_->devices(), observer_, roomFromHead_, now_s_);
  }
  HandInput frames(int count) {
    for (int i = 1; i < count; ++i) frame();
    return frame();
  }
  /// The mouse on the wall 1.5 m before the eyes, pointing to the cloth at (x, 0.8, z).
  void pointTo(double x_m, double z_m, Eye eye = Eye::middle) {
    const glm::dvec3 from_m = observer_.of(eye).positionInRoom_m, along = glm::dvec3(x_m, 0.8, z_m) - from_m;
    desk_.mouse = PointedWall{from_m + along * ((-1.5 - from_m.z) / along.z), eye};
  }

  std::optional<HandTracking> tracking_;
  FedTracker *wand_ = nullptr, *cap_ = nullptr;
  InputDevices hands_{RoomAxes{}};
  DeskInput desk_;
  ObserverView observer_;
  Pose roomFromHead_{{0.0, 1.7, 0.0}, {1, 0, 0, 0}};
  double now_s_ = 0.0;
  bool asks_ = false;
};

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double within = 1e-12) {
  EXPECT_NEAR(a.x, b.x, within);
  EXPECT_NEAR(a.y, b.y, within);
  EXPECT_NEAR(a.z, b.z, within);
}

// In a dry run the mouse moves the wand and is no device of its own; its right button turns the room all the
// same.
TEST_F(HandsTest, AMouseThatMovesTheWandDoesNotAim) {
  pointTo(-0.6, -2.0);
  frame();
  pointTo(-0.5, -2.0);
  EXPECT_EQ(frame().device, kHandDevices[1]) << "the mouse, which has moved";
  desk_.mouseAims = false;
  pointTo(-0.3, -2.0);
  desk_.mouseHeld = true;
  const HandInput hand = frame();
  EXPECT_EQ(hand.device, kHandDevices[0]) << "the wand";
  EXPECT_FALSE(hand.held);
  desk_.mouseHeld = false;
  desk_.mouseTurns = true;
  frame();
  pointTo(0.7, -1.0);
  frame();
  EXPECT_NE(hands_.drive().turn_rad, 0.0);
}

// What the mouse took hold of stays under it: after the room has turned, the place on the board is in the
// direction in which the mouse points now.
TEST_F(HandsTest, TheRightButtonTurnsTheRoomWithTheMouse) {
  pointTo(-0.5, -2.0);
  desk_.mouseTurns = true;
  frame();
  EXPECT_EQ(hands_.drive().turn_rad, 0.0) << "it takes hold here";
  const auto azimuth_rad = [](const glm::dvec3& place_m) { return std::atan2(-place_m.x, -place_m.z); };
  pointTo(0.7, -1.0);
  frame();
  const double turn_rad = hands_.drive().turn_rad;
  const double held_rad = azimuth_rad({-0.5, 0.0, -2.0}), now_rad = azimuth_rad({0.7, 0.0, -1.0});
  EXPECT_NEAR(held_rad - turn_rad, now_rad, 1e-12);
  frame();
  EXPECT_EQ(hands_.drive().turn_rad, 0.0) << "it stands still";
  desk_.mouseTurns = false;
  pointTo(-0.7, -1.0);
  frame();
  EXPECT_EQ(hands_.drive().turn_rad, 0.0);
  desk_.mouseTurns = true;
  frame();
  EXPECT_EQ(hands_.drive().turn_rad, 0.0) << "a new hold";
}

TEST_F(HandsTest, AWandPointsWhereItsSensorDoes) {
  HandInput input = frame();
  EXPECT_EQ(input.device, "wand");
  expectNear(input.from_m, {0.3, 1.2, -0.4});
  expectNear(input.along, {0, 0, -1});
  EXPECT_EQ(input.eye, Eye::middle);
  EXPECT_FALSE(input.held);
  const glm::dquat left = glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 1, 0));
  wand_->fed = {at(3, {0.3, 0.2, -0.4}, left)};
  expectNear(frame().along, {-1, 0, 0});
}

TEST_F(HandsTest, AHandIsWhereTheRigHasItOnItsSensor) {
  Rig rig = rigWith(TrackerKind::dtrack);
  // The sensor sits 0.1 m to the right of the hand and is turned: its forward is the hand's left.
  rig.viewers.front().hand->handFromSensor = {{0.1, 0.0, 0.0},
                                              glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 1, 0))};
  use(rig);
  wand_->fed = {at(3, {0.0, 0.0, 0.0})};
  const HandInput input = frame();
  // sensor_from_hand turns the hand's forward, −z, to the right: that of a sensor that lies along the room's
  // axes.
  expectNear(input.along, {1, 0, 0});
  expectNear(input.from_m, {0.0, 1.0, -0.1});
}

TEST_F(HandsTest, AWandsPullIsItsWaySinceThePress) {
  frame();
  wand_->press(0, true, 3);
  HandInput input = frame();
  EXPECT_TRUE(input.held);
  expectNear(input.pull_m, {0, 0, 0});
  wand_->fed = {at(3, {0.3, 0.15, -0.1})};
  input = frame();
  expectNear(input.pull_m, {0.0, -0.05, 0.3});
  wand_->press(0, false, 3);
  input = frame();
  EXPECT_EQ(input.device, "wand") << "who lets go is who held";
  EXPECT_FALSE(input.held);
}

TEST_F(HandsTest, ButtonsOfOtherSticksAreNotTheWands) {
  wand_->press(0, true, 4);
  EXPECT_FALSE(frame().held);
  use(rigWith(TrackerKind::vrpn));  // a server numbers buttons for itself
  wand_->press(0, true, 0);
  EXPECT_TRUE(frame().held);
}

TEST_F(HandsTest, AWandThatIsLostMidStrokeHasTheCueNoMore) {
  frame();
  wand_->press(0, true, 3);
  EXPECT_TRUE(frame().held);
  const std::vector<TrackerSample> fed = std::exchange(wand_->fed, {});
  EXPECT_EQ(frames(14).device, "wand") << "0.28 s: a blink of the cameras";
  EXPECT_EQ(frames(3).device, "");
  wand_->fed = fed;
  const HandInput back = frame();
  EXPECT_EQ(back.device, "wand");
  EXPECT_FALSE(back.held) << "until it is pressed anew";
  wand_->press(0, false, 3);
  frame();
  wand_->press(0, true, 3);
  EXPECT_TRUE(frame().held);
}

TEST_F(HandsTest, WhoPressesFirstHoldsTheCue) {
  pointTo(0.2, -1.0);
  frame();
  wand_->press(0, true, 3);
  EXPECT_EQ(frame().device, "wand");
  desk_.mouseHeld = true;
  HandInput input = frame();
  EXPECT_EQ(input.device, "wand");
  EXPECT_STREQ(input.refused, "The cue is in the wand's hand");
  EXPECT_STREQ(frame().refused, "") << "said once";
  wand_->press(0, false, 3);
  EXPECT_EQ(frame().device, "wand");
  input = frame();
  EXPECT_FALSE(input.held) << "the mouse has to press anew";
  desk_.mouseHeld = false;
  frame();
  desk_.mouseHeld = true;
  input = frame();
  EXPECT_EQ(input.device, "mouse");
  EXPECT_TRUE(input.held);
  wand_->press(0, true, 3);
  EXPECT_STREQ(frame().refused, "The cue is in the mouse's hand");
}

TEST_F(HandsTest, TheMousePointsFromItsEyeAndPullsAlongTheCloth) {
  wand_->fed.clear();
  pointTo(0.0, -1.0, Eye::right);
  frame();
  pointTo(0.2, -1.0, Eye::right);
  HandInput input = frame();
  EXPECT_EQ(input.device, "mouse");
  EXPECT_EQ(input.eye, Eye::right);
  expectNear(input.from_m, observer_.right.positionInRoom_m);
  expectNear(input.along, glm::normalize(glm::dvec3(0.2, 0.8, -1.0) - observer_.right.positionInRoom_m));
  desk_.mouseHeld = true;
  expectNear(frame().pull_m, {0, 0, 0});
  pointTo(0.1, -0.7, Eye::right);
  expectNear(frame().pull_m, {-0.1, 0.0, 0.3});
  pointTo(0.1, -0.7, Eye::right);
  desk_.mouse->onWall_m.y = 3.0;  // the sky
  expectNear(frame().pull_m, {-0.1, 0.0, 0.3});
  desk_.mouse.reset();  // off the wall
  input = frame();
  EXPECT_TRUE(input.held);
  expectNear(input.pull_m, {-0.1, 0.0, 0.3});
  desk_.mouseHeld = false;
  input = frame();
  EXPECT_EQ(input.device, "mouse");
  EXPECT_FALSE(input.held);
  EXPECT_EQ(frame().device, "") << "it is over no wall";
}

TEST_F(HandsTest, ThePadAimsByLookingAndItsStickPullsLevel) {
  wand_->fed.clear();
  desk_.hasPad = true;
  // Looking to the right and down.
  const glm::dquat turned = glm::angleAxis(-glm::half_pi<double>(), glm::dvec3(0, 1, 0)) *
                            glm::angleAxis(-0.4, glm::dvec3(1, 0, 0));
  roomFromHead_.orientation = turned;
  desk_.padPull = {0.0, 0.1, 0.0};
  HandInput input = frame();
  EXPECT_EQ(input.device, "gamepad");
  expectNear(input.along, {std::cos(0.4), -std::sin(0.4), 0.0});
  desk_.padHeld = true;
  desk_.padPull = {0.0, 1.0, 0.0};  // back: towards the person
  expectNear(frame().pull_m, {-InputDevices::kPadPull_m, 0.0, 0.0});
  desk_.padPull = {0.5, 0.0, 0.0};  // to the right, which is the room's back
  expectNear(frame().pull_m, {0.0, 0.0, 0.5 * InputDevices::kPadPull_m});
  desk_ = {};
  EXPECT_EQ(frame().device, "") << "pulled out of the machine";
}

TEST_F(HandsTest, WhoWasUsedLastAims) {
  pointTo(0.2, -1.0);
  desk_.hasPad = true;
  EXPECT_EQ(frame().device, "wand") << "a mouse lies there";
  pointTo(0.21, -1.0);
  EXPECT_EQ(frame().device, "mouse");
  EXPECT_EQ(frames(249).device, "mouse");
  EXPECT_EQ(frames(4).device, "wand") << "after five seconds of rest";
  pointTo(0.3, -1.0);
  EXPECT_EQ(frame().device, "mouse");
  desk_.padPull = {0.0, 0.5, 0.0};
  EXPECT_EQ(frame().device, "gamepad");
  desk_.padPull = Vec3(0.0);
  wand_->fed.clear();
  EXPECT_EQ(frames(300).device, "") << "nobody touches anything";
}

TEST_F(HandsTest, WhileALessonAsksTheWandsButtonsAnswer) {
  frame();
  asks_ = true;
  for (int button = 0; button < 4; ++button) {
    wand_->press(button, true, 3);
    EXPECT_FALSE(frame().held);
    EXPECT_EQ(hands_.lessonCommand(), Command(ChooseInLesson{button + 1}));
    EXPECT_FALSE(hands_.drive().brake || hands_.drive().home);
    frame();
    EXPECT_FALSE(hands_.lessonCommand());
    wand_->press(button, false, 3);
    frame();
  }
  wand_->press(0, true, 3);
  frame();
  asks_ = false;
  EXPECT_FALSE(frame().held) << "it was an answer";
  wand_->press(3, true, 3);
  frame();
  EXPECT_EQ(hands_.lessonCommand(), Command(AdvanceLesson{}));
  frame();
  EXPECT_FALSE(hands_.lessonCommand());
}

TEST_F(HandsTest, SticksSteerAlongWhereTheWandPointsAndKeysAlongTheRoom) {
  wand_->fed = {at(3, {0, 0, 0},
                   glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 1, 0)) *
                       glm::angleAxis(0.5, glm::dvec3(1, 0, 0)))};  // left and up
  wand_->push(1, 1.0, 3);
  frame();
  expectNear(hands_.drive().steer, {-1, 0, 0});
  wand_->push(1, 0.0, 3);
  wand_->push(0, 1.0, 3);  // to its right: the room's forward
  frame();
  expectNear(hands_.drive().steer, {0, 0, -1});
  desk_.steer = {0.0, 1.0, 0.0};
  frame();
  expectNear(hands_.drive().steer, {0, 0, -2});  // more than the drive gives: it says so
  wand_->push(0, 0.0, 3);
  desk_.steer = {1.0, 1.0, 0.0};
  frame();
  expectNear(hands_.drive().steer, {1, 0, -1});
}

TEST_F(HandsTest, AWandThatIsLostDoesNotSteerOn) {
  wand_->push(1, 1.0, 3);
  wand_->press(1, true, 3);
  frame();
  EXPECT_TRUE(hands_.drive().brake);
  wand_->fed.clear();
  frames(20);
  EXPECT_FALSE(hands_.drive().brake);
  EXPECT_EQ(hands_.drive().steer, Vec3(0.0));
}

TEST_F(HandsTest, ASpaceMouseSteersBrakesAndGoesHome) {
  cap_->push(0, 1.0);
  frame();
  expectNear(hands_.drive().steer, {1, 0, 0});
  cap_->push(0, 0.0);
  cap_->push(2, -1.0);  // pushed away
  frame();
  expectNear(hands_.drive().steer, {0, 0, -1});
  cap_->push(2, 0.0);
  cap_->push(1, 1.0);
  frame();
  expectNear(hands_.drive().steer, {0, 1, 0});
  cap_->press(0, true);
  frame();
  EXPECT_TRUE(hands_.drive().brake);
  EXPECT_FALSE(hands_.drive().home);
  cap_->press(1, true);
  frame();
  EXPECT_TRUE(hands_.drive().home);
  frame();
  EXPECT_FALSE(hands_.drive().home) << "once";
}

}  // namespace
}  // namespace carom
