// What a device's thread delivers, as the frame sees it.

#include "devices/tracker/device_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::steady_clock;
using State = TrackerHealth::State;

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Reading poseOf(int sensor, double device_s) {
  Reading reading;
  reading.sensor = sensor;
  reading.device_s = device_s;
  return reading;
}

/// Waits for what a thread brings about; the limit only ends a test that has failed.
template <class Condition>
bool comesTrue(const Condition& condition) {
  for (int i = 0; i < 60000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return false;
}

/// A transport that does one thing and then waits for the end.
Transport once(std::function<void(DeviceSink&)> act) {
  return [act = std::move(act)](const std::stop_token& stop, DeviceSink& sink) {
    act(sink);
    while (!stop.stop_requested()) std::this_thread::sleep_for(milliseconds(1));
  };
}

TEST(DeviceTracker, GivesDeviceTimesLessTheLatency) {
  const auto start = Clock::now() - std::chrono::seconds(100);
  DeviceTracker tracker(once([&](DeviceSink& sink) {
                          sink.connected();
                          for (int i = 0; i < 60; ++i) {
                            // Every tenth packet is 9 ms behind the others.
                            Reading reading = poseOf(0, 7000.0 + 0.01 * i);
                            reading.latency_s = 0.004;
                            const double arrival_s = 10.0 + 0.01 * i + (i % 10 == 5 ? 0.009 : 0.0);
                            sink.deliver({&reading, 1},
                                         start + std::chrono::duration_cast<Clock::duration>(
                                                     std::chrono::duration<double>(arrival_s)));
                          }
                        }),
                        start);
  ASSERT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).samples == 60; }));
  std::vector<TrackerSample> samples;
  tracker.poll(10.3, samples);
  EXPECT_LT(samples.size(), 40u) << "later ones wait for their time";
  tracker.poll(200.0, samples);
  ASSERT_EQ(samples.size(), 60u);
  for (int i = 0; i < 60; ++i) EXPECT_NEAR(samples[i].time_s, 10.0 + 0.01 * i - 0.004, 1e-6) << i;
}

TEST(DeviceTracker, StampsWithTheArrivalWhereTheDeviceHasNoClock) {
  const auto start = Clock::now() - std::chrono::seconds(10);
  DeviceTracker tracker(once([&](DeviceSink& sink) {
                          Reading reading = poseOf(0, std::nan(""));
                          sink.deliver({&reading, 1}, start + std::chrono::seconds(3));
                        }),
                        start);
  std::vector<TrackerSample> samples;
  ASSERT_TRUE(comesTrue([&] { return tracker.poll(10.0, samples), !samples.empty(); }));
  EXPECT_EQ(samples[0].time_s, 3.0);
}

TEST(DeviceTracker, DropsWhatComesAfterALaterOneOfItsSensor) {
  const auto start = Clock::now() - std::chrono::seconds(10);
  DeviceTracker tracker(
      once([&](DeviceSink& sink) {
        const Reading readings[]{poseOf(0, 1.0),  poseOf(1, 1.0),  poseOf(0, 1.1),
                                 poseOf(0, 1.09), poseOf(1, 1.09), poseOf(0, 1.1)};
        for (int i = 0; i < 6; ++i) {
          sink.deliver({&readings[i], 1}, start + milliseconds(2000 + (i < 2 ? 0 : 100 + i)));
        }
      }),
      start);
  ASSERT_TRUE(comesTrue([&] { return tracker.health(10.0).samples == 4 && tracker.health(10.0).late == 2; }));
  std::vector<TrackerSample> samples;
  tracker.poll(10.0, samples);
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(samples[3].sensor, 1);
}

/// 4 s of poses that move, at 120 Hz; pose i is stamped `stamp(i)` and seen as `place(i)`.
struct Stamped {
  std::uint64_t samples, late;
  std::string message;
  double longestGap_s;
};
template <class Stamp, class Place>
Stamped stamped(const Stamp& stamp, const Place& place, int sensors = 1) {
  constexpr int kPoses = 480;
  const auto start = Clock::now() - std::chrono::seconds(10);
  std::atomic<bool> done = false;
  DeviceTracker tracker(once([&](DeviceSink& sink) {
                          sink.connected();
                          for (int i = 0; i < kPoses; ++i) {
                            std::vector<Reading> readings;
                            for (int sensor = 0; sensor < sensors; ++sensor) {
                              readings.push_back(poseOf(sensor, stamp(i)));
                              readings.back().pose.position_m.x = place(i);
                            }
                            sink.deliver(readings,
                                         start + std::chrono::microseconds(i * 8333L + (i % 7) * 500));
                          }
                          done = true;
                        }),
                        start);
  EXPECT_TRUE(comesTrue([&] { return done.load(); }));
  std::vector<TrackerSample> samples;
  tracker.poll(10.0, samples);
  const TrackerHealth health = tracker.health(10.0);
  double newest_s = 0.0, longest_s = 0.0;
  for (const TrackerSample& sample : samples) {
    if (sample.sensor != 0) continue;
    longest_s = std::max(longest_s, sample.time_s - newest_s);
    newest_s = sample.time_s;
  }
  longest_s = std::max(longest_s, 4.0 - newest_s);
  return {health.samples, health.late, health.message, longest_s};
}

// Servers that never set the time, that play one packet again and again, or whose clock goes in coarse steps.
TEST(DeviceTracker, TakesArrivalsWhereTheDevicesClockStands) {
  const auto moves = [](int i) { return 0.001 * i; };
  const auto rests = [](int) { return 0.5; };
  const char* says =
      "its messages carry the same time again and again; each is taken to be of the moment when it came";
  for (const double time_s : {0.0, 1.8e9, -5.0}) {
    const Stamped moving = stamped([&](int) { return time_s; }, moves);
    EXPECT_GE(moving.samples, 465u) << time_s;
    EXPECT_LT(moving.longestGap_s, 0.1) << time_s;
    EXPECT_EQ(moving.message, says);
    const Stamped resting = stamped([&](int) { return time_s; }, rests);
    EXPECT_LT(resting.longestGap_s, 0.7) << "one pose again and again is doubted for half a second";
    EXPECT_EQ(resting.message, says);
  }
  const Stamped several = stamped([](int) { return 7.0; }, moves, 5);
  EXPECT_GE(several.samples, 5u * 465u);
  const Stamped coarse = stamped([](int i) { return 0.1 * (i / 12); }, moves);
  EXPECT_GE(coarse.samples, 450u);
  EXPECT_LT(coarse.longestGap_s, 0.12);
  EXPECT_EQ(coarse.message, says);
}

TEST(DeviceTracker, BelievesAClockThatGoes) {
  const auto moves = [](int i) { return 0.001 * i; };
  EXPECT_EQ(stamped([](int i) { return i / 120.0; }, moves).message, "");
  EXPECT_EQ(stamped([](int i) { return i / 120.0; }, moves, 40).message, "") << "many sensors of one time";
  const Stamped twice = stamped([](int i) { return i / 2 / 60.0; }, [](int i) { return 0.001 * (i / 2); });
  EXPECT_EQ(twice.message, "") << "each measurement is sent twice";
  EXPECT_EQ(twice.samples, 240u);
  // One that stood at first, and was then set.
  const Stamped set = stamped([](int i) { return i < 100 ? 0.0 : 500.0 + i / 120.0; }, moves);
  EXPECT_EQ(set.message, "");
  EXPECT_GE(set.samples, 460u);
}

TEST(DeviceTracker, HandsOverInputsBesideSamples) {
  const auto start = Clock::now() - std::chrono::seconds(10);
  DeviceTracker tracker(once([&](DeviceSink& sink) {
                          Reading pressed = poseOf(2, 5.0);
                          pressed.kind = Reading::Kind::button;
                          pressed.index = 3;
                          pressed.value = 1.0;
                          const Reading readings[]{poseOf(0, 5.0), pressed};
                          sink.deliver(readings, start + std::chrono::seconds(1));
                        }),
                        start);
  std::vector<TrackerSample> samples;
  std::vector<Reading> inputs;
  ASSERT_TRUE(comesTrue([&] {
    tracker.poll(10.0, samples);
    tracker.takeInputs(inputs);
    return !inputs.empty();
  }));
  ASSERT_EQ(inputs.size(), 1u);
  EXPECT_EQ(inputs[0].index, 3);
  EXPECT_EQ(inputs[0].device_s, 1.0) << "on the session's clock";
  tracker.poll(10.0, samples);
  inputs.clear();
  tracker.takeInputs(inputs);
  EXPECT_TRUE(inputs.empty()) << "each is handed over once";
}

TEST(DeviceTracker, TellsHowItFares) {
  const auto start = Clock::now();
  std::atomic<int> step = 0;
  DeviceTracker tracker(
      [&](const std::stop_token& stop, DeviceSink& sink) {
        int done = 0;
        while (!stop.stop_requested()) {
          std::this_thread::sleep_for(milliseconds(1));
          if (done == step) continue;
          ++done;
          const Reading reading = poseOf(0, std::nan(""));
          if (done == 1) sink.connected();
          if (done == 2) sink.deliver({&reading, 1}, Clock::now());
          if (done == 3) sink.disconnected("pulled out");
          if (done == 4) sink.connected();
          if (done == 5) sink.missed(7), sink.refused();
          if (done == 6) throw std::runtime_error("no such device");
        }
      },
      start, 0.2);
  const auto becomes = [&](State state) {
    return comesTrue([&] { return tracker.health(since_s(start)).state == state; });
  };
  EXPECT_TRUE(becomes(State::connecting));
  step = 1;
  EXPECT_TRUE(becomes(State::connecting)) << "nothing has come yet";
  step = 2;
  EXPECT_TRUE(becomes(State::delivering));
  EXPECT_TRUE(becomes(State::silent)) << "nothing more comes";
  step = 3;
  EXPECT_TRUE(becomes(State::connecting));
  EXPECT_EQ(tracker.health(since_s(start)).message, "pulled out");
  step = 4;
  EXPECT_TRUE(becomes(State::silent));
  EXPECT_EQ(tracker.health(since_s(start)).reconnections, 1u);
  step = 5;
  EXPECT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).refused == 1; }));
  EXPECT_EQ(tracker.health(since_s(start)).gaps, 7u);
  step = 6;
  EXPECT_TRUE(becomes(State::failed));
  EXPECT_EQ(tracker.health(since_s(start)).message, "no such device");
}

TEST(DeviceTracker, ButtonsAndAxesAreLife) {
  const auto start = Clock::now();
  for (const auto kind : {Reading::Kind::button, Reading::Kind::axis}) {
    DeviceTracker tracker(once([&](DeviceSink& sink) {
                            sink.connected();
                            Reading reading;
                            reading.kind = kind;
                            sink.deliver({&reading, 1}, Clock::now());
                          }),
                          start, 60.0);
    EXPECT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).state == State::delivering; }));
    EXPECT_EQ(tracker.health(since_s(start)).samples, 0u);
    EXPECT_EQ(tracker.health(since_s(start) + 120.0).state, State::delivering)
        << "nobody has pressed anything since";
  }
}

// A device that tells of poses, if only that it sees none, sends without end: its silence is a fault.
TEST(DeviceTracker, OneThatTellsOfPosesIsSilentWhenItSaysNothing) {
  const auto start = Clock::now();
  for (const auto kind : {Reading::Kind::pose, Reading::Kind::lost}) {
    DeviceTracker tracker(once([&](DeviceSink& sink) {
                            sink.connected();
                            Reading reading;
                            reading.kind = kind;
                            sink.deliver({&reading, 1}, Clock::now());
                          }),
                          start, 60.0);
    EXPECT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).state == State::delivering; }));
    EXPECT_EQ(tracker.health(since_s(start) + 120.0).state, State::silent);
  }
}

TEST(DeviceTracker, OneThatSpeaksOnlyWhileItIsUsedIsNeverSilent) {
  const auto start = Clock::now();
  std::atomic<bool> pulledOut = false;
  DeviceTracker tracker(
      [&](const std::stop_token& stop, DeviceSink& sink) {
        sink.connected();
        while (!stop.stop_requested() && !pulledOut) std::this_thread::sleep_for(milliseconds(1));
        sink.disconnected("pulled out");
      },
      start, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).state == State::untouched; }));
  EXPECT_EQ(tracker.health(1e6).state, State::untouched);
  pulledOut = true;
  EXPECT_TRUE(comesTrue([&] { return tracker.health(since_s(start)).state == State::connecting; }));
}

TEST(DeviceTracker, AForgottenTrackerKeepsItsBounds) {
  const auto start = Clock::now() - std::chrono::seconds(100);
  constexpr int kMany = 10000;
  std::atomic<bool> done = false;
  DeviceTracker tracker(once([&](DeviceSink& sink) {
                          for (int i = 0; i < kMany; ++i) {
                            const Reading reading = poseOf(0, 0.001 * i);
                            sink.deliver({&reading, 1}, start + milliseconds(i));
                          }
                          done = true;
                        }),
                        start);
  ASSERT_TRUE(comesTrue([&] { return done.load(); }));
  const TrackerHealth health = tracker.health(100.0);
  EXPECT_GT(health.overflowed, 0u);
  EXPECT_EQ(health.samples + health.overflowed, static_cast<std::uint64_t>(kMany));
  std::vector<TrackerSample> samples;
  tracker.poll(100.0, samples);
  EXPECT_EQ(samples.size(), health.samples);
  EXPECT_EQ(std::string(toString(State::silent)), "silent");
}

}  // namespace
}  // namespace carom
