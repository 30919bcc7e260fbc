// Force devices of the input system on a mocked kernel: the effects and their updates, what ends them, and
// what keeps a device from being used.

#include "devices/usb/evdev_force.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "devices/evdev_node.h"
#include "devices/force/force_thread.h"
#include "devices/tracker/retry.h"

namespace carom {
namespace {

using test::EvdevNode;
using test::MockedKernel;
using What = EvdevNode::Told::What;
using namespace std::chrono_literals;

constexpr double kMost_n = 4.0;

ForceCommand force(double x_n, double z_n, double rumble = 0.0) {
  ForceCommand command;
  command.force_n = {x_n, 0.0, z_n};
  command.rumble = rumble;
  return command;
}

TEST(EvdevForce, UploadsOneConstantForceAndChangesItWhileItPlays) {
  MockedKernel kernel;
  EvdevNode node("Wheel", {FF_CONSTANT, FF_GAIN}, 2);
  node.plugInto(kernel);
  {
    const auto device = openEvdevForce("", kMost_n, {});
    device->write(force(0.0, 0.0));
    EXPECT_EQ(node.told().size(), 1u) << "the gain alone: nothing is felt";
    device->write(force(2.0, 0.0));   // to the right: from the left
    device->write(force(2.0, 0.0));   // the same: nothing is told
    device->write(force(0.0, 4.0));   // towards the user: from above
    device->write(force(0.0, -1.0));  // away: from below
    device->write(force(-4.0, 0.0));  // to the left: from the right
    device->write(force(0.0, 0.0));
    device->write(force(1.0, 0.0));
  }
  const auto told = node.told();
  const std::vector<std::pair<What, int>> expected{{What::gain, -1},  {What::upload, -1}, {What::play, 3},
                                                   {What::upload, 3}, {What::upload, 3},  {What::upload, 3},
                                                   {What::stop, 3},   {What::upload, 3},  {What::play, 3},
                                                   {What::stop, 3},   {What::remove, 3}};
  ASSERT_EQ(told.size(), expected.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].what, expected[i].first) << i;
    EXPECT_EQ(told[i].id, expected[i].second) << i;
  }
  EXPECT_EQ(told[0].value, 0xFFFF);
  const auto isEffect = [&](std::size_t i, int direction, int level) {
    EXPECT_EQ(told[i].effect.type, FF_CONSTANT) << i;
    EXPECT_EQ(told[i].effect.direction, direction) << i;
    EXPECT_EQ(told[i].effect.u.constant.level, level) << i;
    EXPECT_EQ(told[i].effect.replay.length, 0) << "it has no end of its own";
  };
  isEffect(1, 0x4000, 16384);
  isEffect(3, 0x8000, 32767);
  isEffect(4, 0x0000, 8192);
  isEffect(5, 0xC000, 32767);
}

TEST(EvdevForce, ADeviceOfOneAxisHasASign) {
  MockedKernel kernel;
  EvdevNode node("Wheel", {FF_CONSTANT}, 1);
  node.plugInto(kernel);
  const auto device = openEvdevForce(EvdevNode::kNode, kMost_n, {});
  device->write(force(-2.0, 3.0));
  const auto told = node.told();
  ASSERT_GE(told.size(), 1u);
  EXPECT_EQ(told[0].effect.direction, 0x4000);
  EXPECT_EQ(told[0].effect.u.constant.level, -16384);
}

TEST(EvdevForce, ADeviceWithoutDirectionRumbles) {
  MockedKernel kernel;
  EvdevNode node("Pad", {FF_RUMBLE}, 2);
  node.plugInto(kernel);
  const auto device = openEvdevForce(EvdevNode::kNode, kMost_n, {});
  device->write(force(4.0, 0.0, 0.5));
  device->write(force(4.0, 0.0, 2.0));
  device->write(force(4.0, 0.0, 0.0));
  const auto told = node.told();
  ASSERT_EQ(told.size(), 4u);
  EXPECT_EQ(told[0].effect.type, FF_RUMBLE);
  EXPECT_EQ(told[0].effect.u.rumble.strong_magnitude, 32768);
  EXPECT_EQ(told[2].effect.u.rumble.strong_magnitude, 65535);
  EXPECT_EQ(told[3].what, What::stop);
}

TEST(EvdevForce, ReadsItsStickAndButtons) {
  MockedKernel kernel;
  EvdevNode node("Stick", {FF_CONSTANT}, 2);
  node.plugInto(kernel);
  const auto device = openEvdevForce(EvdevNode::kNode, kMost_n, {});
  EXPECT_NEAR(device->read(0.0).position_m.x, -kStick_m, 1e-12)
      << "as the kernel says it stands: at 0 of 255";
  node.send(EV_ABS, ABS_X, 255);
  node.send(EV_ABS, ABS_Y, 255);
  node.send(EV_KEY, BTN_TRIGGER, 1);
  ForceDeviceState state;
  for (int i = 0; i < 5; ++i) state = device->read(1.0);
  EXPECT_NEAR(state.position_m.x, kStick_m, 1e-12);
  EXPECT_NEAR(state.position_m.z, kStick_m, 1e-12) << "down is towards the user";
  EXPECT_TRUE(state.pressed);
  EXPECT_EQ(state.time_s, 1.0);
  node.send(EV_KEY, BTN_TRIGGER, 0);
  EXPECT_FALSE(device->read(2.0).pressed);
}

/// Returns why a device cannot be opened.
template <class Fault>
std::string whyNot(const std::string& node) {
  try {
    openEvdevForce(node, kMost_n, {});
    return "it could";
  } catch (const Fault& fault) {
    return fault.what();
  }
}

TEST(EvdevForce, SaysWhatKeepsADeviceFromBeingUsed) {
  MockedKernel kernel;
  EXPECT_EQ(whyNot<std::runtime_error>(""), "no input device with force is plugged in");
  EXPECT_NE(whyNot<std::runtime_error>("/dev/input/event7").find("/dev/input/event7 is not there"),
            std::string::npos);
  EvdevNode node("Plain stick", {}, 2);
  node.plugInto(kernel);
  EXPECT_EQ(whyNot<NeedsHelp>(EvdevNode::kNode),
            "/dev/input/event0 (Plain stick) has no force, expected a device with constant force or rumble");
  EXPECT_TRUE(listEvdevForces().empty());
  const test::Unprivileged user(kernel, EvdevNode::kNode);
  EXPECT_NE(whyNot<NeedsHelp>(EvdevNode::kNode).find("add the user to the group 'input'"), std::string::npos);
}

TEST(EvdevForce, IsOneSessionsAtATime) {
  MockedKernel kernel;
  EvdevNode node("Wheel", {FF_CONSTANT}, 2);
  node.plugInto(kernel);
  {
    const auto device = openEvdevForce(EvdevNode::kNode, kMost_n, {});
    EXPECT_EQ(whyNot<NeedsHelp>(EvdevNode::kNode),
              "/dev/input/event0 (Wheel) is the force device of another session");
  }
  EXPECT_NO_THROW(openEvdevForce(EvdevNode::kNode, kMost_n, {})) << "once the other one has ended";
}

TEST(EvdevForce, IsListedWithWhatItCanDo) {
  MockedKernel kernel;
  EvdevNode node("Wheel", {FF_CONSTANT, FF_RUMBLE, FF_GAIN}, 1);
  node.plugInto(kernel);
  const auto listed = listEvdevForces();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].node, EvdevNode::kNode);
  EXPECT_EQ(listed[0].name, "Wheel");
  EXPECT_TRUE(listed[0].constant && listed[0].rumble && listed[0].gain);
  EXPECT_EQ(listed[0].effects, 16);
  EXPECT_EQ(listed[0].axes, 1);
}

TEST(EvdevForce, APulledPlugIsSaidAndTheForceIsGone) {
  MockedKernel kernel;
  EvdevNode node("Wheel", {FF_CONSTANT}, 2);
  node.plugInto(kernel);
  ForceLimits limits{kMost_n, 250.0, 8e-3, 8e-3, 1.0, 20.0, 1e-4, 1};
  const auto start = std::chrono::steady_clock::now();
  ForceThread thread(
      "force device", [](const std::stop_token&) { return openEvdevForce("", kMost_n, {}); }, limits, start);
  ForceLaw law;
  law.kind = ForceLaw::Kind::cue;
  law.held = true;
  law.cue = {0.403, 0.08, 1.0};
  const auto comesTrue = [&](const auto& condition) {
    for (int i = 0; i < 6000; ++i) {
      law.posted_s = thread.now_s(0.0);
      thread.post(law);
      if (condition()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  };
  ASSERT_TRUE(comesTrue([&] { return thread.report().active; }));
  for (const int place : {40, 80, 120, 128}) node.send(EV_ABS, ABS_X, place);
  ASSERT_TRUE(comesTrue([&] { return thread.report().force_n.x < -0.1; }));
  node.unplug();
  ASSERT_TRUE(comesTrue([&] { return thread.report().fall == ForceFall::unplugged; }));
  EXPECT_EQ(thread.report().force_n, glm::dvec3(0.0));
  std::vector<std::string> news;
  ASSERT_TRUE(comesTrue([&] {
    for (const std::string& line : thread.takeNews()) news.push_back(line);
    return news.size() >= 2;
  }));
  EXPECT_EQ(news[0], "force device is there");
  EXPECT_EQ(news[1], "force device: it was pulled out; there is no force in the hand");
}

}  // namespace
}  // namespace carom
