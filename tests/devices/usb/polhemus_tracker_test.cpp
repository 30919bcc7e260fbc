// The Polhemus transport with the real libusb, on a mocked kernel.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "devices/polhemus_box.h"
#include "devices/tracker/device_tracker.h"
#include "devices/usb/device_list.h"
#include "devices/usb/polhemus_tracker.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using State = TrackerHealth::State;
using test::MockedKernel;
using test::PolhemusBox;
using test::PolhemusBoxModel;

/// A tracker on the bench, polled as a frame loop does.
class Bench {
 public:
  explicit Bench(std::uint16_t product)
      : start_(Clock::now()), tracker_(polhemusTransport({0x0f44, product, {}}), start_) {}

  double now_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  TrackerHealth health() const { return tracker_.health(now_s()); }

  void poll() {
    tracker_.poll(now_s(), samples);
    tracker_.takeInputs(inputs);
  }

  /// Polls until so, at most ten seconds (a busy machine takes one or two).
  bool until(const std::function<bool()>& so) {
    for (const Clock::time_point end = Clock::now() + 10s; Clock::now() < end;
         std::this_thread::sleep_for(2ms)) {
      poll();
      if (so()) return true;
    }
    return false;
  }

  bool untilSamples(std::size_t count) {
    return until([&] { return samples.size() >= count; });
  }

  std::vector<TrackerSample> samples;
  std::vector<Reading> inputs;

 private:
  Clock::time_point start_;
  DeviceTracker tracker_;
};

void expectOnTheirCircle(const std::vector<TrackerSample>& samples) {
  for (const TrackerSample& sample : samples) {
    // Single precision at 60 cm, in metres.
    const glm::dvec3 p = sample.pose.position_m;
    EXPECT_NEAR(std::hypot(p.x - 0.5, p.y), 0.1, 1e-6);
    EXPECT_NEAR(p.z, -0.2 * (sample.sensor + 1), 1e-6);
    // Turned about z by the angle at which it stands on the circle.
    const double angle_rad = std::atan2(p.y, p.x - 0.5);
    const glm::dvec3 ahead = sample.pose.orientation * glm::dvec3(1, 0, 0);
    EXPECT_NEAR(ahead.x, std::cos(angle_rad), 1e-5);
    EXPECT_NEAR(ahead.y, std::sin(angle_rad), 1e-5);
  }
}

PolhemusBoxModel patriot() { return {.mark = "PA", .product = 0xef12}; }
PolhemusBoxModel libertyHs() {
  return {.product = 0xff20, .out = 0x04, .in = 0x88, .data = 0x88, .stations = 4};
}
PolhemusBoxModel fastrak() {
  return {
      .fastrak = true, .mark = {}, .product = 0x0002, .out = 0x02, .in = 0x82, .data = 0x84, .stations = 3};
}

class EveryModel : public testing::TestWithParam<PolhemusBoxModel> {};

TEST_P(EveryModel, IsSetUpRunsAndIsLeftQuiet) {
  MockedKernel kernel;
  PolhemusBox box(GetParam());
  kernel.plugIn(PolhemusBox::description(GetParam()));
  kernel.attach(PolhemusBox::kNode, box);
  {
    Bench bench(GetParam().product);
    ASSERT_TRUE(bench.untilSamples(200)) << bench.health().message;
    EXPECT_EQ(bench.health().state, State::delivering);
    EXPECT_EQ(bench.health().refused, 0u);
    EXPECT_EQ(bench.health().gaps, 0u);
    expectOnTheirCircle(bench.samples);
    int most = 0;
    for (const TrackerSample& sample : bench.samples) most = std::max(most, sample.sensor);
    EXPECT_EQ(most, GetParam().stations - 1);
    EXPECT_GE(box.mostPending(), 4u);  // the device always finds a transfer waiting
  }
  EXPECT_FALSE(box.continuous());
  EXPECT_TRUE(box.binary());
}

INSTANTIATE_TEST_SUITE_P(Polhemus, EveryModel,
                         testing::Values(PolhemusBoxModel{}, patriot(), libertyHs(), fastrak()));

TEST(PolhemusUsb, SamplesAreOnTheDevicesClockThoughItWraps) {
  MockedKernel kernel;
  PolhemusBox box({.stations = 1});
  kernel.plugIn(PolhemusBox::description({.stations = 1}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(1200));  // the clock wraps after 4.1 s of them
  // The person's angle tells when the device made a sample: between any two, our times and theirs agree to
  // the device's millisecond (rounded: half of one at each end), and 0.3 ms for the rate that is still being
  // fitted.
  const auto angle = [&](std::size_t i) {
    const glm::dvec3 p = bench.samples[i].pose.position_m;
    return std::atan2(p.y, p.x - 0.5);
  };
  double device_s = 0.0, ours_s = 0.0;
  for (std::size_t i = 201; i < bench.samples.size(); ++i) {
    device_s += std::remainder(angle(i) - angle(i - 1), 2 * std::numbers::pi) / (0.5 * std::numbers::pi);
    ours_s += bench.samples[i].time_s - bench.samples[i - 1].time_s;
    ASSERT_NEAR(ours_s, device_s, 1.3e-3) << "sample " << i;
  }
}

TEST(PolhemusUsb, FindsTheRecordsAgainAfterLostBytes) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));
  for (const std::size_t lost : {1u, 7u, 47u, 100u}) {
    const TrackerHealth before = bench.health();
    box.loseBytes(lost);
    ASSERT_TRUE(bench.until([&] { return bench.health().gaps > before.gaps; })) << lost;
    EXPECT_GT(bench.health().refused, before.refused) << lost;
    ASSERT_TRUE(bench.untilSamples(bench.samples.size() + 50)) << lost;
  }
  expectOnTheirCircle(bench.samples);
  EXPECT_EQ(bench.health().reconnections, 0u);
}

TEST(PolhemusUsb, CountsFramesThatNeverCame) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));
  box.skipFrames(5);
  ASSERT_TRUE(bench.until([&] { return bench.health().gaps > 0; }));
  ASSERT_TRUE(bench.untilSamples(bench.samples.size() + 10));
  EXPECT_EQ(bench.health().gaps, 10u);  // of two stations
}

TEST(PolhemusUsb, AFlaggedStationIsLostTheOtherIsNot) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));
  box.flagStation(2);
  ASSERT_TRUE(bench.until([&] { return bench.inputs.size() >= 20; }));
  for (const Reading& input : bench.inputs) {
    EXPECT_EQ(input.kind, Reading::Kind::lost);
    EXPECT_EQ(input.sensor, 1);
  }
  bench.samples.clear();
  ASSERT_TRUE(bench.untilSamples(20));
  for (const TrackerSample& sample : bench.samples) EXPECT_EQ(sample.sensor, 0);
}

TEST(PolhemusUsb, OutlivesFailedTransfers) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));
  box.breakNextTransfers(3);
  ASSERT_TRUE(bench.until([&] { return bench.health().refused >= 3; }));
  ASSERT_TRUE(bench.untilSamples(bench.samples.size() + 50));
  EXPECT_EQ(bench.health().reconnections, 0u);
  box.breakNextTransfers(8);  // in a row: it is set up anew
  ASSERT_TRUE(bench.until([&] { return bench.health().reconnections == 1; })) << bench.health().message;
  ASSERT_TRUE(bench.untilSamples(bench.samples.size() + 50));
  expectOnTheirCircle(bench.samples);
}

TEST(PolhemusUsb, ASilentDeviceIsSetUpAgain) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));
  box.freeze(true);
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::silent; }));
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::connecting; }));
  EXPECT_NE(bench.health().message.find("nothing for two seconds"), std::string::npos)
      << bench.health().message;
  box.freeze(false);
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::delivering; }));
  EXPECT_GE(bench.health().reconnections, 1u);
}

TEST(PolhemusUsb, ComesBackAfterBeingUnplugged) {
  MockedKernel kernel;
  PolhemusBox box({}), back({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.untilSamples(50));

  box.pull();
  kernel.unplug(PolhemusBox::kSystemPath);
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::connecting; }));
  ASSERT_TRUE(bench.until([&] {
    return bench.health().message.find("is not plugged in") != std::string::npos;
  })) << bench.health().message;
  kernel.detach(PolhemusBox::kNode);

  bench.samples.clear();
  kernel.attach(PolhemusBox::kNode, back);
  kernel.plugIn(PolhemusBox::description({}));
  ASSERT_TRUE(bench.untilSamples(50)) << bench.health().message;
  EXPECT_EQ(bench.health().reconnections, 1u);
  expectOnTheirCircle(bench.samples);
}

TEST(PolhemusUsb, ABareChipNeedsFirmware) {
  MockedKernel kernel;
  kernel.plugIn(PolhemusBox::description({.product = 0xff11}));
  Bench bench(0xff12);
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::failed; }));
  EXPECT_NE(bench.health().message.find("needs firmware"), std::string::npos) << bench.health().message;
  const std::vector<ListedDevice> devices = listDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(devices[0].name, "Polhemus LIBERTY");
  EXPECT_EQ(devices[0].source, "0f44:ff12");
  EXPECT_NE(devices[0].problem.find("needs firmware"), std::string::npos);
}

TEST(PolhemusUsb, SaysWhatToDoWhereItMayNotBeOpened) {
  MockedKernel kernel;
  kernel.plugIn(PolhemusBox::description({}));
  const test::Unprivileged someone(kernel, PolhemusBox::kNode);
  Bench bench(0xff12);
  ASSERT_TRUE(bench.until([&] { return bench.health().state == State::failed; }));
  EXPECT_NE(bench.health().message.find("may not be opened by this user"), std::string::npos);
  const std::vector<ListedDevice> devices = listDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_NE(devices[0].problem.find("70-carom.rules"), std::string::npos);
}

TEST(PolhemusUsb, WithoutOneThereIsNothing) {
  MockedKernel kernel;
  Bench bench(0xff12);
  ASSERT_TRUE(bench.until([&] { return !bench.health().message.empty(); }));
  EXPECT_EQ(bench.health().state, State::connecting);
  EXPECT_EQ(bench.health().message, "Polhemus LIBERTY (0f44:ff12) is not plugged in");
  EXPECT_TRUE(listDevices().empty());
}

TEST(PolhemusUsb, IsListed) {
  MockedKernel kernel;
  PolhemusBox box(fastrak());
  kernel.plugIn(PolhemusBox::description(fastrak()));
  kernel.attach(PolhemusBox::kNode, box);
  const std::vector<ListedDevice> devices = listDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(devices[0].name, "Polhemus FASTRAK");
  EXPECT_EQ(devices[0].kind, "polhemus-usb");
  EXPECT_EQ(devices[0].source, "0f44:0002");
  EXPECT_EQ(devices[0].place, "USB 1-3, /dev/bus/usb/001/003");
  EXPECT_EQ(devices[0].problem, "");
}

TEST(PolhemusUsb, EndsSoonWhateverItIsDoing) {
  MockedKernel kernel;
  PolhemusBox box({});
  kernel.plugIn(PolhemusBox::description({}));
  kernel.attach(PolhemusBox::kNode, box);
  for (const auto wait : {0ms, 30ms, 150ms, 400ms, 1000ms}) {
    auto bench = std::make_unique<Bench>(std::uint16_t{0xff12});
    std::this_thread::sleep_for(wait);
    const Clock::time_point asked = Clock::now();
    bench.reset();
    // 0.3 s is promised; as much again for a machine with other things to do.
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - asked).count(), 0.6) << wait.count() << " ms in";
  }
}

TEST(PolhemusUsb, OtherAddressesAreRefused) {
  EXPECT_THROW(polhemusTransport({0x0f44, 0x1234, {}}), std::invalid_argument);
  EXPECT_THROW(polhemusTransport({0x1234, 0xff12, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace carom
