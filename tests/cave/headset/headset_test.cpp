#include "cave/headset/headset.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include <GL/glew.h>
#include <GL/glx.h>

#include "cave/headset/headset_pacer.h"
#include "cave/room/headset_walls.h"
#include "cave/room/off_axis.h"
#include "counted_new.h"
#include "xr_double.h"

namespace carom {
namespace test {

XrDouble& xrDouble(const std::string& library, bool anew) {
  static void* const handle = dlopen(library.c_str(), RTLD_NOW);
  using Get = XrDouble*(bool);
  return *reinterpret_cast<Get*>(dlsym(handle, "caromXrDouble"))(anew);
}

}  // namespace test

namespace {

using test::XrDouble;
using test::XrDoubleFrame;
using State = Headset::State;

/// A texture whose bytes tell the pixel and the eye.
class Picture {
 public:
  Picture(glm::ivec2 size, unsigned eye) {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        for (const unsigned value : {3U * unsigned(x), 2U * unsigned(y), 100U + 50U * eye, 255U})
          bytes_.push_back(static_cast<unsigned char>(value));
      }
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  operator unsigned() const { return texture_; }
  const std::vector<unsigned char>& bytes() const { return bytes_; }

 private:
  std::vector<unsigned char> bytes_;
  GlTexture texture_;
};

class HeadsetTest : public ::testing::Test {
 protected:
  HeadsetTest() : runtime_(test::xrDouble(CAROM_XR_DOUBLE, true)) {
    setenv("XR_RUNTIME_JSON", CAROM_XR_MANIFEST, 1);
  }
  void TearDown() override {
    EXPECT_EQ(runtime_.faults, std::vector<std::string>());
    EXPECT_EQ(runtime_.instances, 0);
    EXPECT_EQ(runtime_.sessions, 0);
    EXPECT_EQ(runtime_.chains, 0);
    EXPECT_EQ(runtime_.handTrackers, 0);
  }

  /// Returns the next frame, once the session runs.
  static HeadsetFrame firstFrame(Headset& headset) {
    EXPECT_EQ(headset.poll(), State::running);
    headset.poll();  // the focus
    const auto frame = headset.nextFrame();
    EXPECT_TRUE(frame);
    return frame.value_or(HeadsetFrame{});
  }

  XrDouble& runtime_;
  Graphics graphics_;
};

TEST_F(HeadsetTest, PicturesArriveByteForByteWithTheEyesForWhichTheyWereDrawn) {
  runtime_.script = [](std::uint64_t number) {
    XrDoubleFrame frame;
    frame.shouldRender = number > 0;
    for (std::size_t eye = 0; eye < 2; ++eye)
      frame.eyes[eye].position.z = -0.01F * static_cast<float>(number);
    return frame;
  };
  const GLXContext context = glXGetCurrentContext();
  for (const bool isRude : {false, true}) {
    runtime_.isRude = isRude;
    runtime_.ends.clear();
    Headset headset(graphics_);
    const Picture left(headset.pixels(), 0), right(headset.pixels(), 1);
    const std::array<unsigned, 2> pictures{left, right};
    HeadsetFrame frame = firstFrame(headset);
    EXPECT_FALSE(frame.isSeen);
    headset.submit(&pictures);
    std::int64_t before_ns = frame.display_ns;
    for (int i = 1; i < 5; ++i) {
      const auto next = headset.nextFrame();
      ASSERT_TRUE(next && next->isSeen && next->isTracked);
      EXPECT_EQ(next->display_ns - before_ns, 11'111'111);
      before_ns = next->display_ns;
      headset.submit(&pictures);
      EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
      EXPECT_EQ(glXGetCurrentContext(), context);
      const test::XrDoubleEnd& end = runtime_.ends.back();
      ASSERT_EQ(end.layers, 1U);
      EXPECT_EQ(end.rgba[0], left.bytes());
      EXPECT_EQ(end.rgba[1], right.bytes());
      for (std::size_t eye = 0; eye < 2; ++eye) {
        EXPECT_EQ(static_cast<double>(end.eyes[eye].position.z), next->eyes[eye].roomFromEye.position_m.z);
        EXPECT_EQ(std::tan(static_cast<double>(end.fov[eye].angleLeft)), next->eyes[eye].frustum.left);
      }
    }
    EXPECT_EQ(runtime_.ends.front().layers, 0U) << "a frame that is not seen has no pictures";
  }
}

TEST_F(HeadsetTest, TimeIsThatOfTheDisplayHoweverLongAFrameTakes) {
  const std::vector<XrDuration> steps{11'111'111, 22'222'222, 150'000'000, 11'111'111};
  runtime_.script = [&](std::uint64_t number) {
    XrDoubleFrame frame;
    frame.step_ns = steps[number % steps.size()];
    return frame;
  };
  Headset headset(graphics_);
  std::int64_t before_ns = firstFrame(headset).display_ns;
  headset.submit(nullptr);
  for (std::size_t i = 1; i < 20; ++i) {
    const auto frame = headset.nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->display_ns - before_ns, steps[i % steps.size()]) << i;
    before_ns = frame->display_ns;
    headset.submit(nullptr);
  }
}

TEST_F(HeadsetTest, TakenOffThereAreNoFramesAndPutOnAgainTheyGoOn) {
  Headset headset(graphics_);
  firstFrame(headset);
  headset.submit(nullptr);
  runtime_.takeOff();
  EXPECT_EQ(headset.poll(), State::idle);
  EXPECT_FALSE(headset.nextFrame());
  runtime_.putOn();
  EXPECT_EQ(headset.poll(), State::running);
  EXPECT_TRUE(headset.nextFrame());
  headset.submit(nullptr);
  headset.askToEnd();
  EXPECT_EQ(headset.poll(), State::ended);
  EXPECT_FALSE(headset.nextFrame());
}

TEST_F(HeadsetTest, EyesThatAreLostOrSenselessStayWhereTheyWere) {
  std::vector<XrDoubleFrame> frames(6);
  frames[1].flags = XR_VIEW_STATE_POSITION_VALID_BIT;
  frames[1].eyes[0].position.x = 5.0F;
  frames[2].eyes[1].position.y = std::nanf("");
  frames[3].eyes[0].orientation = {0, 0, 0, 0};
  frames[4].fov[0].angleLeft = frames[4].fov[0].angleRight;
  frames[5].fov[1].angleUp = 1.6F;
  runtime_.script = [&](std::uint64_t number) { return frames[number]; };
  Headset headset(graphics_);
  const Picture left(headset.pixels(), 0), right(headset.pixels(), 1);
  const std::array<unsigned, 2> pictures{left, right};
  const HeadsetFrame known = firstFrame(headset);
  EXPECT_TRUE(known.isTracked);
  headset.submit(&pictures);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto frame = headset.nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_FALSE(frame->isTracked) << i;
    for (std::size_t eye = 0; eye < 2; ++eye) {
      EXPECT_EQ(frame->eyes[eye].roomFromEye.position_m, known.eyes[eye].roomFromEye.position_m) << i;
      EXPECT_EQ(frame->eyes[eye].frustum.up, known.eyes[eye].frustum.up) << i;
    }
    headset.submit(&pictures);
    EXPECT_EQ(runtime_.ends.back().eyes[0].position.x, runtime_.ends.front().eyes[0].position.x) << i;
  }
}

TEST_F(HeadsetTest, WithoutPlacesTheHeadTurnsWhereItIs) {
  std::vector<XrDoubleFrame> frames(3);
  frames[0].flags = frames[2].flags = XR_VIEW_STATE_ORIENTATION_VALID_BIT;
  frames[1].eyes[0].position = {-0.032F, 1.2F, -0.5F};
  frames[1].eyes[1].position = {0.032F, 1.2F, -0.5F};
  for (std::size_t eye = 0; eye < 2; ++eye) {
    frames[0].eyes[eye].position = {std::nanf(""), 0, 0};
    frames[2].eyes[eye] = {{0, 0.70710678F, 0, 0.70710678F}, {9, 9, 9}};  // 90° to the left
  }
  runtime_.script = [&](std::uint64_t number) { return frames[number]; };
  Headset headset(graphics_);
  const HeadsetFrame first = firstFrame(headset);
  EXPECT_TRUE(first.isTracked);
  EXPECT_FALSE(first.hasPosition);
  EXPECT_LT(glm::distance(headBetween(first.eyes).position_m, glm::dvec3(0, 1.7, 0)), 1e-6);
  headset.submit(nullptr);
  EXPECT_TRUE(headset.nextFrame()->hasPosition);
  headset.submit(nullptr);
  const auto turned = headset.nextFrame();
  ASSERT_TRUE(turned && turned->isTracked && !turned->hasPosition);
  EXPECT_LT(glm::distance(turned->eyes[0].roomFromEye.position_m, glm::dvec3(0, 1.2, -0.468)), 1e-6);
  EXPECT_LT(glm::distance(turned->eyes[1].roomFromEye.position_m, glm::dvec3(0, 1.2, -0.532)), 1e-6);
  headset.submit(nullptr);
}

TEST_F(HeadsetTest, WithoutAFloorTheEyesStandAboveIt) {
  runtime_.hasStage = false;
  runtime_.script = [](std::uint64_t) {
    XrDoubleFrame frame;
    for (XrPosef& eye : frame.eyes) eye.position.y = 0.1F;
    return frame;
  };
  Headset headset(graphics_);
  EXPECT_FALSE(headset.hasFloor());
  EXPECT_NEAR(firstFrame(headset).eyes[0].roomFromEye.position_m.y, 1.8, 1e-6);
  headset.submit(nullptr);
}

TEST_F(HeadsetTest, TheRuntimesVelocityIsGivenOnlyWhereItHasOne) {
  runtime_.script = [](std::uint64_t number) {
    XrDoubleFrame frame;
    frame.velocity = {0.5F, 0, -0.25F};
    if (number > 0) frame.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
    return frame;
  };
  Headset headset(graphics_);
  EXPECT_FALSE(firstFrame(headset).runtimeVelocity_m_s);
  headset.submit(nullptr);
  const auto frame = headset.nextFrame();
  ASSERT_TRUE(frame && frame->runtimeVelocity_m_s);
  EXPECT_EQ(*frame->runtimeVelocity_m_s, glm::dvec3(0.5, 0, -0.25));
  headset.submit(nullptr);
}

TEST_F(HeadsetTest, ARecentredRoomIsToldOnce) {
  Headset headset(graphics_);
  EXPECT_FALSE(firstFrame(headset).isRecentred);
  headset.submit(nullptr);
  runtime_.recentres = true;
  headset.poll();
  for (const bool expected : {true, false}) {
    const auto frame = headset.nextFrame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->isRecentred, expected);
    headset.submit(nullptr);
  }
}

TEST_F(HeadsetTest, ATriggerIsHeldUntilItIsWellReleased) {
  const std::vector<float> pulled{0.0F, 0.6F, 0.75F, 0.5F, 0.41F, 0.39F, 0.65F, 0.71F};
  const std::vector<bool> held{false, false, true, true, true, false, false, true};
  runtime_.script = [&](std::uint64_t number) {
    XrDoubleFrame frame;
    frame.hands[1].trigger = pulled[number];
    frame.hands[1].stick = {0.5F, -1.0F};
    frame.hands[0].first = number == 3;
    frame.hands[0].flags = number == 4 ? 0 : 15;
    return frame;
  };
  Headset headset(graphics_);
  HeadsetFrame frame = firstFrame(headset);
  for (std::size_t i = 0;; ++i) {
    EXPECT_EQ(frame.hands[1].trigger, held[i]) << i;
    EXPECT_EQ(frame.hands[1].stick, glm::dvec2(0.5, -1.0));
    EXPECT_EQ(frame.hands[0].first, i == 3);
    EXPECT_EQ(frame.hands[0].isTracked, i != 4);
    EXPECT_EQ(frame.hands[1].roomFromAim.position_m, glm::dvec3(glm::vec3(0, 1.2F, -0.3F)));
    headset.submit(nullptr);
    if (i + 1 == pulled.size()) break;
    const auto next = headset.nextFrame();
    ASSERT_TRUE(next);
    frame = *next;
  }
  headset.knock(0.5, 0.02);
  EXPECT_EQ(runtime_.knocks, (std::vector<std::pair<int, float>>{{1, 0.5F}}));
}

TEST_F(HeadsetTest, AHandWithoutAControllerAimsAlongItselfAndItsPinchIsTheTrigger) {
  // The tips' distances at which a trigger is held and released, by the definition of a pinch: 2 and 3.5 cm.
  const std::vector<float> apart_m{0.06F, 0.021F, 0.019F, 0.03F, 0.034F, -1.0F, 0.036F, 0.021F, 0.0F};
  const std::vector<bool> held{false, false, true, true, true, true, false, false, true};
  const XrPosef palm{{0, 0.38268343F, 0, 0.92387953F}, {0.2F, 1.1F, -0.4F}};  // 45° to the left
  runtime_.seesHands = true;
  runtime_.script = [&](std::uint64_t number) {
    XrDoubleFrame frame;
    for (auto& hand : frame.hands) hand.flags = 0;
    frame.hands[1].tipsApart_m = apart_m[number];
    frame.hands[1].aim = palm;
    return frame;
  };
  Headset headset(graphics_);
  HeadsetFrame frame = firstFrame(headset);
  for (std::size_t i = 0;; ++i) {
    EXPECT_EQ(frame.hands[1].trigger, held[i]) << i << ": a hand that is lost keeps its pinch";
    EXPECT_EQ(frame.hands[1].isTracked, apart_m[i] >= 0.0F) << i;
    EXPECT_FALSE(frame.hands[0].isTracked || frame.hands[0].trigger) << i;
    const glm::dvec3 ray = frame.hands[1].roomFromAim.orientation * glm::dvec3(0, 0, -1);
    EXPECT_LT(glm::distance(ray, glm::dvec3(-std::sqrt(0.5), 0, -std::sqrt(0.5))), 1e-7) << i;
    EXPECT_EQ(frame.hands[1].roomFromAim.position_m, glm::dvec3(glm::vec3(0.2F, 1.1F, -0.4F))) << i;
    headset.submit(nullptr);
    if (i + 1 == apart_m.size()) break;
    const auto next = headset.nextFrame();
    ASSERT_TRUE(next);
    frame = *next;
  }
  EXPECT_EQ(runtime_.handTrackers, 2);
}

TEST_F(HeadsetTest, AControllerGoesBeforeTheHandThatHoldsIt) {
  runtime_.seesHands = true;
  runtime_.script = [&](std::uint64_t) {
    XrDoubleFrame frame;
    frame.hands[1].tipsApart_m = 0.0F;  // around the grip
    return frame;
  };
  Headset headset(graphics_);
  const HeadsetFrame frame = firstFrame(headset);
  EXPECT_TRUE(frame.hands[1].isTracked);
  EXPECT_FALSE(frame.hands[1].trigger);
  headset.submit(nullptr);
}

TEST_F(HeadsetTest, WithoutTheFocusNoHandActs) {
  runtime_.script = [](std::uint64_t) {
    XrDoubleFrame frame;
    frame.hands[1].trigger = 1.0F;
    frame.hands[0].flags = 0;
    frame.hands[0].tipsApart_m = 0.0F;
    return frame;
  };
  runtime_.seesHands = true;
  Headset headset(graphics_);
  EXPECT_TRUE(firstFrame(headset).hands[0].trigger);
  headset.submit(nullptr);
  runtime_.states.push_back(XR_SESSION_STATE_VISIBLE);
  headset.poll();
  const auto frame = headset.nextFrame();
  ASSERT_TRUE(frame);
  for (const HeadsetHand& hand : frame->hands) EXPECT_FALSE(hand.isTracked || hand.trigger);
  headset.submit(nullptr);
}

TEST_F(HeadsetTest, ASteadyFrameAllocatesNothing) {
  runtime_.keepsPictures = false;
  runtime_.ends.reserve(1000);
  Headset headset(graphics_);
  const Picture left(headset.pixels(), 0), right(headset.pixels(), 1);
  const std::array<unsigned, 2> pictures{left, right};
  HeadsetPacer pacer(headset, 0.0, 0);
  std::size_t allocated = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const std::size_t before = test::allocationCount();
    const FrameTimes times = pacer.next();
    headset.submit(&pictures);
    if (frame > 120)
      allocated += test::allocationCount() - before;  // what the headset lacks is said in frame 90
    EXPECT_EQ(times.number, static_cast<std::uint64_t>(frame));
  }
  EXPECT_EQ(allocated, 0U);
}

TEST_F(HeadsetTest, TheHandWhoseTriggerIsPulledTakesTheCue) {
  std::array<HeadsetHand, 2> hands;
  EXPECT_EQ(aimingHand(1, hands), 1U);
  hands[0].isTracked = true;
  EXPECT_EQ(aimingHand(1, hands), 0U) << "the other is lost";
  hands[1].isTracked = true;
  EXPECT_EQ(aimingHand(0, hands), 0U);
  hands[1].trigger = true;
  EXPECT_EQ(aimingHand(0, hands), 1U);
  hands[0].trigger = true;
  EXPECT_EQ(aimingHand(1, hands), 1U) << "who holds the cue keeps it";
}

TEST_F(HeadsetTest, WhatIsMissingIsSaid) {
  const auto saidBy = [&] {
    try {
      const Headset headset(graphics_);
      return std::string("nothing");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  runtime_.hasHeadset = false;
  EXPECT_NE(saidBy().find("no headset is connected"), std::string::npos) << saidBy();
  EXPECT_NE(aboutHeadsets().find("no headset is connected"), std::string::npos) << aboutHeadsets();
  EXPECT_NE(aboutHeadsets().find("A runtime for tests 1.2.3"), std::string::npos) << aboutHeadsets();
  runtime_.hasHeadset = true;
  EXPECT_EQ(aboutHeadsets(), "A headset of a script, by A runtime for tests 1.2.3");
  runtime_.formats = {0x881A};  // half floats alone
  EXPECT_NE(saidBy().find("no pictures of 8 bits"), std::string::npos) << saidBy();
  runtime_.formats = {0x8058};
  runtime_.size = {0, 72};
  EXPECT_NE(saidBy().find("no two displays"), std::string::npos) << saidBy();
  setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
  EXPECT_NE(saidBy().find("no OpenXR runtime is active"), std::string::npos) << saidBy();
}

TEST_F(HeadsetTest, ALostHeadsetEndsTheSession) {
  Headset headset(graphics_);
  firstFrame(headset);
  headset.submit(nullptr);
  runtime_.waitResult = XR_ERROR_SESSION_LOST;
  EXPECT_FALSE(headset.nextFrame());
  EXPECT_EQ(headset.poll(), State::ended);
}

TEST(HeadsetWalls, AnEyeSeesItsWallExactlyThroughItsDisplay) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> angle(0.2, 1.2), place(-2.0, 2.0), turn(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    HeadsetEye eye;
    eye.roomFromEye = {{place(random), place(random), place(random)},
                       glm::normalize(glm::dquat(turn(random), turn(random), turn(random), turn(random)))};
    eye.frustum = {-std::tan(angle(random)), std::tan(angle(random)), -std::tan(angle(random)),
                   std::tan(angle(random))};
    const Wall wall = wallBefore(eye, "left eye", {640, 480});
    const auto clipFromPlace = clipFromEye(wall, eye.roomFromEye.position_m);
    ASSERT_TRUE(clipFromPlace) << i;
    const auto seen = [&](double x,
                          double y) {  // a point of the room in the direction of these tangents, 3 m away
      const glm::dvec4 clip =
          *clipFromPlace * glm::dvec4(eye.roomFromEye.orientation * (3.0 * glm::dvec3(x, y, -1.0)), 1.0);
      return glm::dvec2(clip) / clip.w;
    };
    const EyeFrustum& f = eye.frustum;
    EXPECT_LT(glm::distance(seen(f.left, f.down), glm::dvec2(-1, -1)), 1e-9) << i;
    EXPECT_LT(glm::distance(seen(f.right, f.up), glm::dvec2(1, 1)), 1e-9) << i;
    EXPECT_LT(glm::distance(seen(0.5 * (f.left + f.right), 0.5 * (f.down + f.up)), glm::dvec2(0, 0)), 1e-9)
        << i;
  }
}

TEST(HeadsetWalls, TheHeadIsBetweenTheEyes) {
  std::array<HeadsetEye, 2> eyes;
  const Pose roomFromHead{{0.3, 1.6, -0.4}, glm::angleAxis(0.7, glm::normalize(glm::dvec3(0.2, 1.0, -0.1)))};
  const glm::dvec3 up(0, 1, 0);
  eyes[0].roomFromEye = roomFromHead * Pose{{-0.031, 0, 0}, glm::angleAxis(0.1, up)};  // canted outwards
  eyes[1].roomFromEye = roomFromHead * Pose{{0.031, 0, 0}, glm::angleAxis(-0.1, up)};
  const Pose head = headBetween(eyes);
  EXPECT_LT(glm::distance(head.position_m, roomFromHead.position_m), 1e-12);
  EXPECT_GT(std::abs(glm::dot(head.orientation, roomFromHead.orientation)), 1.0 - 1e-12);
}

}  // namespace
}  // namespace carom
