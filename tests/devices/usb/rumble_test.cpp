// A gamepad's motors with the real hidapi, on a mocked kernel.
#include "devices/usb/rumble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "devices/hidraw_node.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using test::Bytes;
using test::HidrawNode;
using test::MockedKernel;

bool comesTrue(const std::function<bool()>& so, std::chrono::milliseconds within = 5s) {
  for (const Clock::time_point end = Clock::now() + within; Clock::now() < end;
       std::this_thread::sleep_for(1ms)) {
    if (so()) return true;
  }
  return false;
}

HidEntry entryOf(std::uint16_t product) {
  HidEntry entry;
  entry.vendor = 0x054c;
  entry.product = product;
  return entry;
}

// The bytes of Linux' hid-playstation.c: report id, valid flags, right motor, left motor.
Bytes dualShock4(std::uint8_t strength) {
  Bytes report(32, 0);
  report[0] = 5;
  report[1] = 1;
  report[4] = report[5] = strength;
  return report;
}
Bytes dualSense(std::uint8_t strength) {
  Bytes report(48, 0);
  report[0] = 2;
  report[1] = 3;
  report[3] = report[4] = strength;
  return report;
}

TEST(RumbleReport, IsAsThePadTakesIt) {
  for (const int product : {0x05c4, 0x09cc})
    EXPECT_EQ(rumbleReport(entryOf(static_cast<std::uint16_t>(product)), 200), dualShock4(200));
  EXPECT_EQ(rumbleReport(entryOf(0x0ce6), 7), dualSense(7));
  EXPECT_TRUE(rumbleReport(entryOf(0x0268), 7).empty()) << "a DualShock 3";
  HidEntry other = entryOf(0x0ce6);
  other.vendor = 0x046d;
  EXPECT_TRUE(rumbleReport(other, 7).empty());
}

/// What has been written to a node, without what was only said again.
std::vector<Bytes> changes(const HidrawNode& node) {
  std::vector<Bytes> written = node.written();
  written.erase(std::unique(written.begin(), written.end()), written.end());
  return written;
}

TEST(Rumble, TheNewestWishReachesTheMotorsAndTheyStopAtTheEnd) {
  MockedKernel kernel;
  HidrawNode node(0x054c, 0x09cc, "Wireless Controller", 1, 5);
  node.plugInto(kernel);
  {
    Rumble rumble;
    std::this_thread::sleep_for(50ms);
    EXPECT_TRUE(node.written().empty()) << "nothing is wished";
    rumble.set(0.5);
    ASSERT_TRUE(comesTrue([&] { return !node.written().empty(); }));
    EXPECT_EQ(node.written().front(), dualShock4(128));
    rumble.set(1.0);
    ASSERT_TRUE(comesTrue([&] { return node.written().back() == dualShock4(0xF8); }));
    rumble.set(0.0);
    ASSERT_TRUE(comesTrue([&] { return node.written().back() == dualShock4(0); }));
    const std::size_t so = node.written().size();
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(node.written().size(), so) << "at rest nothing is said";
    rumble.set(0.25);
    ASSERT_TRUE(comesTrue([&] { return node.written().back() == dualShock4(64); }));
  }
  EXPECT_EQ(node.written().back(), dualShock4(0)) << "at its end";
}

TEST(Rumble, AKnockIsShortAndGoesBackToWhatWas) {
  MockedKernel kernel;
  HidrawNode node(0x054c, 0x0ce6, "DualSense Wireless Controller", 1, 5);
  node.plugInto(kernel);
  Rumble rumble;
  rumble.set(0.25);
  ASSERT_TRUE(comesTrue([&] { return !node.written().empty(); }));
  const Clock::time_point begun = Clock::now();
  rumble.pulse();
  ASSERT_TRUE(comesTrue([&] { return changes(node).size() >= 3; }));
  EXPECT_GE(Clock::now() - begun, 80ms);
  EXPECT_EQ(changes(node), (std::vector<Bytes>{dualSense(64), dualSense(255), dualSense(64)}));
}

TEST(Rumble, ItIsSaidAgainWhileItLasts) {
  MockedKernel kernel;
  HidrawNode node(0x054c, 0x0ce6, "DualSense Wireless Controller", 1, 5);
  node.plugInto(kernel);
  Rumble rumble;
  rumble.set(0.5);
  EXPECT_TRUE(comesTrue([&] { return node.written().size() >= 2; }, 3s));
}

TEST(Rumble, PulledOutMidwayItIsSurvivedAndItComesBack) {
  MockedKernel kernel;
  HidrawNode node(0x054c, 0x05c4, "Wireless Controller", 1, 5),
      back(0x054c, 0x05c4, "Wireless Controller", 1, 5);
  node.plugInto(kernel);
  Rumble rumble;
  rumble.set(0.5);
  ASSERT_TRUE(comesTrue([&] { return !node.written().empty(); }));
  node.unplugFrom(kernel);
  for (int i = 0; i < 40; ++i) {
    rumble.set(i % 2 ? 0.3 : 0.6);  // a hand that goes on
    std::this_thread::sleep_for(5ms);
  }
  kernel.detach(HidrawNode::kNode);
  back.plugInto(kernel);
  rumble.set(0.75);
  ASSERT_TRUE(comesTrue([&] { return !back.written().empty(); }));
  EXPECT_EQ(back.written().back(), dualShock4(184));
}

TEST(Rumble, WishesDoNotWaitForTheDevice) {
  MockedKernel kernel;
  HidrawNode node(0x054c, 0x09cc, "Wireless Controller", 1, 5);
  node.plugInto(kernel);
  node.takeLong(200ms);
  Rumble rumble;
  const Clock::time_point begun = Clock::now();
  for (int i = 0; i < 1000; ++i) rumble.set(i / 1000.0);
  EXPECT_LT(Clock::now() - begun, 100ms);
  ASSERT_TRUE(
      comesTrue([&] { return !node.written().empty() && node.written().back() == dualShock4(0xF8); }));
  EXPECT_LT(node.written().size(), 10u);
}

}  // namespace
}  // namespace carom
