// SpaceMouse and headset with the real hidapi, on a mocked kernel.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

#include "devices/hidraw_node.h"
#include "devices/network_peer.h"
#include "devices/rift_report.h"
#include "devices/tracker/device_tracker.h"
#include "devices/usb/device_list.h"
#include "devices/usb/hid_imu_tracker.h"
#include "devices/usb/spacemouse.h"
#include "devices/witness.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using test::Bytes;
using test::HidrawNode;
using test::MockedKernel;
using test::Watched;
using test::Witness;

double axisValue(const std::vector<Reading>& readings, int index) {
  double value = 0.0;
  for (const Reading& reading : readings) {
    if (reading.kind == Reading::Kind::axis && reading.index == index) value = reading.value;
  }
  return value;
}

constexpr double kNeverSilent_s = std::numeric_limits<double>::infinity();

struct SpaceMouseOnDesk {
  MockedKernel kernel;
  HidrawNode node{0x046d, 0xc626, "3Dconnexion SpaceNavigator", 1, 8};
  Witness witness{spaceMouseTransport({})};
  bool plugged = false;

  void plugIn() {
    node.plugInto(kernel);
    ASSERT_TRUE(witness.until([&] { return witness.told("connected"); }));
  }
};

TEST(SpaceMouseHid, EachReportIsReadByItself) {
  SpaceMouseOnDesk desk;
  desk.plugIn();
  for (int i = 0; i < 20; ++i) {  // all at once: joined, they would be misread
    desk.node.send({1, 0x5e, 1, 0, 0, 0, 0});
    desk.node.send({2, 0, 0, 0xa2, 0xfe, 0, 0});
    desk.node.send({3, static_cast<std::uint8_t>(i % 2), 0});
  }
  ASSERT_TRUE(desk.witness.untilReadings(20 * 6 + 19));
  const auto readings = desk.witness.readings();
  EXPECT_EQ(axisValue({readings.begin(), readings.begin() + 3}, 0), 1.0);
  int presses = 0;
  for (const Reading& reading : readings)
    presses += reading.kind == Reading::Kind::button && reading.value == 1.0;
  EXPECT_EQ(presses, 10);
  EXPECT_FALSE(desk.witness.told("refused"));
}

/// Fifteen reports 8 ms apart, as the device sends them, then silence. Returns what is wrong with what is
/// heard of it; empty: nothing.
std::string faultInSilence() {
  SpaceMouseOnDesk desk;
  desk.plugIn();
  for (int i = 0; i < 15; ++i) {
    desk.node.send({1, 100, 0, 0, 0, 0, 0});
    std::this_thread::sleep_for(8ms);
  }
  if (!desk.witness.untilReadings(15 * 3 + 1)) return "silence is not told";
  const auto readings = desk.witness.readings();
  const auto arrivals = desk.witness.arrivals();
  if (readings.size() != 15u * 3 + 1)
    return "reports 8 ms apart are taken for silence";  // one axis was off centre
  if (readings.back().index != 0 || readings.back().value != 0.0) return "silence is not zero";
  const double silence_s =
      std::chrono::duration<double>(arrivals.back() - arrivals[arrivals.size() - 2]).count();
  if (silence_s >= 0.050 && silence_s < 0.150) return "";  // a tick of 10 ms later
  return "told after " + std::to_string(silence_s) + " s";
}

// A machine that does other things may halt the sender, or the one who hears it, for so long: then it is
// tried again.
TEST(SpaceMouseHid, SilenceIsZeroAfterFiftyMilliseconds) {
  constexpr int kTries = 50;
  std::string fault = faultInSilence();
  for (int i = 1; i < kTries && !fault.empty(); ++i) fault = faultInSilence();
  EXPECT_EQ(fault, "");
}

TEST(SpaceMouseHid, PulledOutItStandsStillAndItComesBack) {
  MockedKernel kernel;
  HidrawNode node(0x256f, 0xc635, "SpaceMouse Compact", 1, 8),
      back(0x256f, 0xc635, "SpaceMouse Compact", 1, 8);
  Witness witness(spaceMouseTransport({}));
  ASSERT_TRUE(witness.until([&] { return witness.told("disconnected: SpaceMouse is not plugged in"); }));
  node.plugInto(kernel);
  node.send({3, 2});
  node.send({1, 0x5e, 1, 0, 0, 0, 0});
  ASSERT_TRUE(witness.untilReadings(4));
  node.unplugFrom(kernel);
  ASSERT_TRUE(witness.until([&] { return witness.told("disconnected: SpaceMouse was unplugged"); }));
  const auto readings = witness.readings();
  ASSERT_EQ(readings.size(), 6u);
  EXPECT_EQ(axisValue(readings, 0), 0.0);
  EXPECT_EQ(readings.back().kind, Reading::Kind::button);
  EXPECT_EQ(readings.back().index, 1);
  EXPECT_EQ(readings.back().value, 0.0);
  kernel.detach(HidrawNode::kNode);

  back.plugInto(kernel);
  back.send({1, 0, 0, 0, 0, 0x5e, 1, 0xaf, 0, 0, 0, 0, 0});  // the long shape
  ASSERT_TRUE(witness.untilReadings(readings.size() + 6));
  EXPECT_EQ(axisValue(witness.readings(), 1), -1.0);
  EXPECT_EQ(axisValue(witness.readings(), 3), 0.5);
}

TEST(SpaceMouseHid, IsWellWhileNobodyTouchesItAndHandsOverItsInputs) {
  using State = TrackerHealth::State;
  MockedKernel kernel;
  HidrawNode node(0x046d, 0xc626, "SpaceNavigator", 1, 8), back(0x046d, 0xc626, "SpaceNavigator", 1, 8);
  Watched mouse(spaceMouseTransport({}), kNeverSilent_s);
  ASSERT_TRUE(mouse.comesTrue([&] { return !mouse.health().message.empty(); }));
  EXPECT_EQ(mouse.health().state, State::connecting);
  EXPECT_EQ(mouse.health().message, "SpaceMouse is not plugged in");
  node.plugInto(kernel);
  ASSERT_TRUE(mouse.comesTo(State::untouched));
  EXPECT_EQ(mouse.health().message, "");
  EXPECT_TRUE(mouse.inputs.empty());
  node.send({1, 0x5e, 1, 0, 0, 0, 0});
  node.send({3, 2});
  ASSERT_TRUE(mouse.comesTrue([&] { return mouse.inputs.size() >= 5; }));  // three axes, one back, a button
  EXPECT_EQ(axisValue({mouse.inputs.begin(), mouse.inputs.begin() + 3}, 0), 1.0);
  EXPECT_TRUE(std::any_of(mouse.inputs.begin(), mouse.inputs.end(), [](const Reading& reading) {
    return reading.kind == Reading::Kind::button && reading.index == 1 && reading.value == 1.0;
  }));
  EXPECT_EQ(mouse.health().state, State::delivering);
  EXPECT_TRUE(mouse.samples.empty());
  node.unplugFrom(kernel);
  ASSERT_TRUE(mouse.comesTo(State::connecting));
  kernel.detach(HidrawNode::kNode);
  back.plugInto(kernel);
  ASSERT_TRUE(mouse.comesTo(State::delivering));
  EXPECT_EQ(mouse.health().reconnections, 1u);
}

TEST(SpaceMouseHid, OneOfSeveralIsChosenByItsAddress) {
  MockedKernel kernel;
  HidrawNode node(0x046d, 0xc626, "SpaceNavigator", 1, 8);
  node.plugInto(kernel);
  const Witness other(spaceMouseTransport(UsbAddress{0x046d, 0xc626, "S2"})),
      model(spaceMouseTransport(UsbAddress{0x256f, 0xc635, {}})),
      this_(spaceMouseTransport(UsbAddress{0x046d, 0xc626, "S1"}));
  EXPECT_TRUE(this_.until([&] { return this_.told("connected"); }));
  EXPECT_TRUE(other.until([&] { return other.told("disconnected: SpaceMouse (046d:c626:S2) is not"); }));
  EXPECT_TRUE(model.until([&] { return model.told("disconnected: SpaceMouse (256f:c635) is not"); }));
  EXPECT_FALSE(other.told("connected") || model.told("connected"));
  EXPECT_THROW(spaceMouseTransport(UsbAddress{0x2833, 0x0001, {}}), std::invalid_argument);
}

TEST(SpaceMouseHid, HostileLengthsAreRefusedOrHarmless) {
  SpaceMouseOnDesk desk;
  desk.plugIn();
  for (const std::size_t size : {1u, 2u, 3u, 6u, 7u, 12u, 13u, 64u, 256u, 4000u}) {
    for (const int id : {0, 1, 2, 3, 23, 255}) {
      Bytes report(size, 0xff);
      report[0] = static_cast<std::uint8_t>(id);
      desk.node.send(report);
    }
  }
  ASSERT_TRUE(desk.witness.until([&] { return desk.node.unread() == 0; }));
  EXPECT_TRUE(desk.witness.told("refused"));
  EXPECT_FALSE(desk.witness.told("disconnected: SpaceMouse was"));
  for (const Reading& reading : desk.witness.readings()) {
    EXPECT_LE(std::abs(reading.value), 1.0);
    EXPECT_GE(reading.index, 0);
    EXPECT_LT(reading.index, 48);
  }
}

TEST(SpaceMouseHid, MiceAndKeyboardsOfTheSameMakersAreNotOne) {
  MockedKernel kernel;
  HidrawNode cadMouse(0x256f, 0xc650, "CadMouse", 1, 2);
  Witness witness(spaceMouseTransport({}));
  cadMouse.plugInto(kernel);
  std::this_thread::sleep_for(700ms);  // it looks every 0.5 s
  EXPECT_FALSE(witness.told("connected"));
  EXPECT_TRUE(listDevices().empty());
}

TEST(HidList, NamesWhatIsPluggedIn) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0021, "Rift DK2", 3, 5);
  node.plugInto(kernel);
  std::vector<ListedDevice> devices = listDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(devices[0].name, "Oculus Rift DK2");
  EXPECT_EQ(devices[0].kind, "hid-imu");
  EXPECT_EQ(devices[0].source, "2833:0021");
  EXPECT_EQ(devices[0].serial, "S1");
  EXPECT_EQ(devices[0].place, "/dev/hidraw0");
  EXPECT_EQ(devices[0].problem, "");
}

TEST(HidList, SaysWhatToDoWhereItMayNotBeOpened) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0021, "Rift DK2", 3, 5);
  kernel.plugIn(node.description());
  const test::Unprivileged someone(kernel, HidrawNode::kNode);
  const std::vector<ListedDevice> devices = listDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_NE(devices[0].problem.find("70-carom.rules"), std::string::npos);
  const Witness witness(hidImuTransport({0x2833, 0x0021, {}}, {0.0, 1.7, 0.0}));
  EXPECT_TRUE(witness.until([&] {
    return witness.told("failed: Oculus Rift DK2 (2833:0021): /dev/hidraw0 may not be opened by this user");
  }));
}

/// A headset that is level and turns to the left at 1 rad/s.
Bytes turningDk1(std::uint16_t time_ms) {
  return test::dk1Report(time_ms, {{{0.0, 9.80665, 0.0}, {0.0, 1.0, 0.0}}});
}

TEST(HeadsetHid, TurnsWithItsGyroscopeOnItsOwnClock) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0001, "Tracker DK", 3, 5);
  node.plugInto(kernel);
  const Clock::time_point start = Clock::now();
  DeviceTracker tracker(hidImuTransport({0x2833, 1, {}}, {0.0, 1.7, 0.0}), start);
  std::vector<TrackerSample> samples;
  for (int i = 0; i < 60000 && node.features().empty(); ++i) std::this_thread::sleep_for(1ms);  // it is open
  // Half a second of its clock, which wraps on the way and runs as ours does; sent in lumps, as a busy
  // machine would read it.
  std::uint16_t time_ms = 65300;
  const Clock::time_point begun = Clock::now();
  for (int sent = 0; sent < 500;) {
    std::this_thread::sleep_for(10ms);
    const auto due = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun).count();
    for (; sent < std::min<long>(due, 500); ++sent) node.send(turningDk1(time_ms++));
  }
  const auto yaw = [](const TrackerSample& sample) {
    const glm::dquat& q = sample.pose.orientation;
    return 2.0 * std::atan2(q.y, q.w);
  };
  // Each sample turns it by 1 mrad; the first one levels it.
  const auto done = [&] { return !samples.empty() && yaw(samples.back()) > 0.4985; };
  for (const Clock::time_point end = Clock::now() + 5s; !done() && Clock::now() < end;) {
    std::this_thread::sleep_for(2ms);
    tracker.poll(std::chrono::duration<double>(Clock::now() - start).count(), samples);
  }
  ASSERT_TRUE(done());
  const TrackerSample& last = samples.back();
  EXPECT_EQ(last.pose.position_m, glm::dvec3(0.0, 1.7, 0.0));
  EXPECT_NEAR(yaw(last), 0.499, 1e-6);
  EXPECT_NEAR(last.pose.orientation.x, 0.0, 1e-9);
  EXPECT_NEAR(last.pose.orientation.z, 0.0, 1e-9);
  // The lumps came as late as the machine pleased; samples keep to the device's times, within a lump or two
  // by which the first arrivals were late.
  EXPECT_GT(samples.size(), 450u);
  for (const TrackerSample& sample : samples) {
    if (yaw(sample) < 0.1) continue;
    EXPECT_NEAR(last.time_s - sample.time_s, 0.499 - yaw(sample), 0.02);
  }
}

TEST(HeadsetHid, IsKeptAwake) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0021, "Rift DK2", 3, 5);
  node.plugInto(kernel);
  const Witness witness(hidImuTransport({0x2833, 0x0021, {}}, {0.0, 1.7, 0.0}));
  ASSERT_TRUE(witness.until([&] { return node.features().size() >= 2; }));  // every 3 s
  EXPECT_EQ(node.features()[0], (Bytes{8, 0, 0, 0x10, 0x27}));
  EXPECT_EQ(node.features()[1], (Bytes{8, 0, 0, 0x10, 0x27}));
}

TEST(HeadsetHid, SilenceUnpluggingAndItsReturn) {
  using State = TrackerHealth::State;
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0001, "Tracker DK", 3, 5), back(0x2833, 0x0001, "Tracker DK", 3, 5);
  Watched head(hidImuTransport({0x2833, 1, {}}, {0.0, 1.7, 0.0}));
  node.plugInto(kernel);
  std::uint16_t time_ms = 100;
  const auto turnsIn = [&](HidrawNode& headset) {
    head.samples.clear();
    return head.comesTrue([&] {
      for (int i = 0; i < 2; ++i) headset.send(turningDk1(time_ms++));
      return head.samples.size() >= 20;
    });
  };
  ASSERT_TRUE(turnsIn(node));
  EXPECT_EQ(head.health().state, State::delivering);
  ASSERT_TRUE(head.comesTo(State::silent));
  ASSERT_TRUE(turnsIn(node));
  EXPECT_EQ(head.health().reconnections, 0u);
  node.unplugFrom(kernel);
  ASSERT_TRUE(head.comesTo(State::connecting));
  EXPECT_EQ(head.health().message, "Oculus Rift DK1 (2833:0001) was unplugged");
  kernel.detach(HidrawNode::kNode);
  time_ms = 7;  // its clock starts anew
  back.plugInto(kernel);
  ASSERT_TRUE(turnsIn(back));
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_EQ(head.health().reconnections, 1u);
}

TEST(HeadsetHid, CountsWhatTheDeviceCouldNotSendAndWhatIsTooShort) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0001, "Tracker DK", 3, 5);
  node.plugInto(kernel);
  const Witness witness(hidImuTransport({0x2833, 1, {}}, {0.0, 1.7, 0.0}));
  Bytes report = turningDk1(100);
  report[1] = 5;  // five were made, three are in it
  node.send(report);
  node.send(Bytes(61, 1));
  ASSERT_TRUE(witness.until([&] { return witness.told("missed 2") && witness.told("refused"); }));
  EXPECT_EQ(witness.readings().size(), 3u * 2);
}

TEST(HeadsetHid, OneOfSeveralIsChosenByItsSerialNumber) {
  MockedKernel kernel;
  HidrawNode node(0x2833, 0x0001, "Tracker DK", 3, 5);
  node.plugInto(kernel);
  const Witness other(hidImuTransport({0x2833, 1, "S2"}, {0.0, 1.7, 0.0}));
  const Witness this_(hidImuTransport({0x2833, 1, "S1"}, {0.0, 1.7, 0.0}));
  EXPECT_TRUE(this_.until([&] { return this_.told("connected"); }));
  EXPECT_TRUE(other.until([&] { return other.told("disconnected: Oculus Rift DK1 (2833:0001:S2) is not"); }));
  EXPECT_FALSE(other.told("connected"));
}

TEST(HeadsetHid, OtherAddressesAreRefused) {
  EXPECT_THROW(hidImuTransport({0x2833, 0x1234, {}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace carom
