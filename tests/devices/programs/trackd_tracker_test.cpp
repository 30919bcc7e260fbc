// The trackd tracker against real shared memory.

#include "devices/programs/trackd_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "devices/network_peer.h"
#include "devices/trackd_writer.h"

namespace carom {
namespace {

using test::Segment;
using test::TrackdSensorsWriter;
using test::TrackdWandWriter;
using test::Watched;
using State = TrackerHealth::State;
using namespace std::chrono_literals;

constexpr double kFoot_m = 0.3048;

Transport transportOf(int key, const std::string& options = "") {
  return trackdTransport(readTrackdSource(fmt::format("shm://{}{}", key, options)), kFoot_m);
}

/// A daemon that writes sensor 1 at its own rate, on a thread of its own. Place and angles tell the same
/// count.
class DaemonThread {
 public:
  /// `torn_us`: how long it pauses in the midst of each pose. `timesFirst`: it writes the time
  /// before the pose.
  DaemonThread(const Watched& watched, std::chrono::microseconds period, std::chrono::microseconds torn_us,
               bool timesFirst, int key)
      : writer(2, key),
        timesFirst_(timesFirst),
        thread_([this, &watched, period, torn_us](const std::stop_token& stop) {
          for (; !stop.stop_requested(); ++written) {
            std::this_thread::sleep_for(period);
            write(static_cast<float>(written % 1000), 1.8e9 + watched.now_s(), torn_us);
          }
        }) {}

  TrackdSensorsWriter writer;
  std::atomic<int> written{0};

  /// Returns whether a busy machine stopped the daemon in the midst of the pose with this count.
  bool wasStopped(long count) const { return stopped_.at(static_cast<std::size_t>(count)); }

 private:
  void write(float count, double time_s, std::chrono::microseconds torn_us) {
    const std::size_t at = TrackdSensorsWriter::kHeader + TrackdSensorsWriter::kSensor;
    const auto begun = test::Clock::now();
    stopped_[static_cast<std::size_t>(count)] = true;
    if (timesFirst_) stamp(at, time_s);
    writer.segment.put(at, count);
    writer.segment.put(at + 4, count);
    if (torn_us > 0us) {  // no sleep, which takes as long as it likes
      for (const auto end = test::Clock::now() + torn_us; test::Clock::now() < end;) {
      }
    }
    writer.segment.put(at + 8, count);
    if (!timesFirst_) stamp(at, time_s);
    stopped_[static_cast<std::size_t>(count)] = test::Clock::now() - begun > torn_us + 50us;
  }
  void stamp(std::size_t at, double time_s) {
    writer.stamp(at + 24, time_s);
    writer.stamp(16, time_s);
  }

  const bool timesFirst_;
  std::array<std::atomic<bool>, 1000> stopped_{};
  std::jthread thread_;
};

bool isTorn(const TrackerSample& sample) {
  return sample.pose.position_m.x != sample.pose.position_m.y ||
         sample.pose.position_m.x != sample.pose.position_m.z;
}

TEST(TrackdTracker, DeliversPosesAtTheTimesOfTheDaemon) {
  TrackdSensorsWriter writer(3);
  Watched head(transportOf(writer.segment.key()));
  ASSERT_TRUE(head.comesTrue([&] { return head.health().connected; }));
  std::vector<double> written_s;
  for (int i = 0; i < 40; ++i) {
    std::this_thread::sleep_for(8ms);
    written_s.push_back(head.now_s());
    writer.write(2, {static_cast<float>(i), 5, 0}, {90, 0, 0}, 1.8e9 + written_s.back());
  }
  ASSERT_TRUE(head.comesTrue(
      [&] { return !head.samples.empty() && head.samples.back().pose.position_m.x > 38.5 * kFoot_m; }));
  // The first 16 are watched; on a busy machine some are overwritten before they are seen.
  ASSERT_GE(head.samples.size(), 20u);
  for (const TrackerSample& sample : head.samples) {
    const long i = std::lround(sample.pose.position_m.x / kFoot_m);
    EXPECT_EQ(sample.sensor, 2);
    EXPECT_NEAR(sample.time_s, written_s.at(static_cast<std::size_t>(i)), 0.02) << i;
    EXPECT_NEAR(sample.pose.position_m.y, 5 * kFoot_m, 1e-6);
    // An azimuth of 90 degrees turns what looks ahead, −z, to the left, −x.
    EXPECT_NEAR(glm::distance(sample.pose.orientation * glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0)), 0.0,
                1e-6);
  }
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_EQ(head.health().refused, 0u);
}

// Daemons write without a lock, and this one takes its time in the midst of every pose.
TEST(TrackdTracker, PosesAreNotOfTwoTimes) {
  for (const auto& [timesFirst, period, pause] :
       {std::tuple(false, 1000us, 100us), std::tuple(true, 4000us, 100us), std::tuple(false, 1000us, 200us),
        std::tuple(true, 4000us, 200us), std::tuple(true, 4000us, 600us),
        std::tuple(false, 8000us, 1000us)}) {
    std::optional<DaemonThread> daemon;
    Segment reserved(64);
    const int key = reserved.key();
    reserved.remove();
    reserved.detach();
    Watched head(transportOf(key));
    daemon.emplace(head, period, pause, timesFirst, key);
    ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() >= 200; })) << period.count();
    const auto torn = std::count_if(head.samples.begin(), head.samples.end(), [&](const auto& sample) {
      return isTorn(sample) && !daemon->wasStopped(std::lround(sample.pose.position_m.x / kFoot_m));
    });
    EXPECT_LE(torn * 50, static_cast<long>(head.samples.size()))
        << "a pose every " << period.count() << " us, pauses of " << pause.count() << " us, times first "
        << timesFirst;
  }
}

// Such a daemon gives its sensors no time; the header has one.
TEST(TrackdTracker, ADaemonWithoutTimesOfSensorsIsReadByItsHeader) {
  TrackdSensorsWriter writer(2);
  Watched head(transportOf(writer.segment.key()));
  ASSERT_TRUE(head.comesTrue([&] { return head.health().connected; }));
  std::vector<double> written_s;
  for (int i = 0; i < 40; ++i) {
    std::this_thread::sleep_for(8ms);
    written_s.push_back(head.now_s());
    writer.writeUnstamped(1, {static_cast<float>(i + 1), 0, 0}, 1.8e9 + written_s.back());
  }
  ASSERT_TRUE(head.comesTrue(
      [&] { return !head.samples.empty() && head.samples.back().pose.position_m.x > 39.5 * kFoot_m; }));
  for (const TrackerSample& sample : head.samples) {
    const long i = std::lround(sample.pose.position_m.x / kFoot_m);
    if (i == 0) continue;  // sensor 0 rests at the origin
    EXPECT_NEAR(sample.time_s, written_s.at(static_cast<std::size_t>(i - 1)), 0.02) << i;
  }
  // At rest, its header alone moves.
  head.samples.clear();
  ASSERT_TRUE(head.comesTrue([&] {
    writer.writeUnstamped(1, {40, 0, 0}, 1.8e9 + head.now_s());
    return head.samples.size() >= 4;
  }));
}

TEST(TrackdTracker, DeliversTheWand) {
  TrackdSensorsWriter writer(1);
  TrackdWandWriter wand(3, 2);
  Watched head(transportOf(writer.segment.key(), fmt::format("?wand={}", wand.segment.key())));
  ASSERT_TRUE(head.comesTrue([&] { return head.inputs.size() >= 5; }));
  head.inputs.clear();
  wand.press(1, true);
  ASSERT_TRUE(head.comesTrue([&] { return !head.inputs.empty(); }));
  wand.push(1, -0.5f);
  ASSERT_TRUE(head.comesTrue([&] { return head.inputs.size() >= 2; }));
  EXPECT_EQ(head.inputs[0].kind, Reading::Kind::button);
  EXPECT_EQ(head.inputs[0].sensor, kTrackdWand);
  EXPECT_EQ(head.inputs[0].index, 1);
  EXPECT_EQ(head.inputs[0].value, 1.0);
  EXPECT_EQ(head.inputs[1].kind, Reading::Kind::axis);
  EXPECT_EQ(head.inputs[1].value, -0.5);
  std::this_thread::sleep_for(50ms);
  head.poll();
  EXPECT_EQ(head.inputs.size(), 2u) << "what does not change is not sent";
}

TEST(TrackdTracker, SaysThatThereIsNoWand) {
  TrackdSensorsWriter writer(1);
  Segment tiny(8);
  Watched head(transportOf(writer.segment.key(), fmt::format("?wand={}", tiny.key())));
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty() && head.health().connected; }));
  EXPECT_EQ(head.health().message, "the wand: it has 8 bytes, expected 32 at least");
  EXPECT_TRUE(head.comesTrue([&] {
    return writer.write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s()), !head.samples.empty();
  }));
}

TEST(TrackdTracker, ComesBackAfterTheDaemonStartedAnew) {
  auto writer = std::make_unique<TrackdSensorsWriter>(1);
  const int key = writer->segment.key();
  Watched head(transportOf(key));
  const auto delivers = [&] {
    head.samples.clear();
    return head.comesTrue([&] {
      return writer->write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s()), head.samples.size() >= 5;
    });
  };
  ASSERT_TRUE(delivers());
  writer->segment.remove();  // while it is read
  ASSERT_TRUE(head.comesTo(State::connecting));
  EXPECT_EQ(head.health().message, fmt::format("the shared memory of key {} was removed", key));
  ASSERT_TRUE(head.comesTrue([&] { return head.health().message.starts_with("there is no shared memory"); }));
  writer.reset();
  writer = std::make_unique<TrackdSensorsWriter>(1, key);
  ASSERT_TRUE(delivers());
  EXPECT_EQ(head.health().reconnections, 1u);
}

TEST(TrackdTracker, SaysThatTheDaemonHasEnded) {
  TrackdSensorsWriter writer(1);
  Watched head(transportOf(writer.segment.key()));
  ASSERT_TRUE(head.comesTrue([&] {
    return writer.write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s()), !head.samples.empty();
  }));
  writer.segment.detach();
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  EXPECT_NE(head.health().message.find("trackd has ended"), std::string::npos) << head.health().message;
  EXPECT_EQ(head.health().state, State::silent);
}

TEST(TrackdTracker, AHeaderThatIsBadForAMomentCostsAMoment) {
  TrackdSensorsWriter writer(1);
  Watched head(transportOf(writer.segment.key()));
  ASSERT_TRUE(head.comesTrue([&] {
    return writer.write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s()), !head.samples.empty();
  }));
  head.samples.clear();
  for (int i = 0; i < 50; ++i) {
    writer.segment.put(12, std::uint32_t{0});
    std::this_thread::sleep_for(3ms);
    writer.segment.put(12, std::uint32_t{40});
    writer.write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s());
    std::this_thread::sleep_for(8ms);
    head.poll();
  }
  EXPECT_GE(head.samples.size(), 40u);
  EXPECT_EQ(head.health().reconnections, 0u);
}

TEST(TrackdTracker, ASegmentThatIsNotTrackdsIsNamed) {
  Segment tiny(8);
  Watched first(transportOf(tiny.key()));
  ASSERT_TRUE(first.comesTrue([&] { return !first.health().message.empty(); }));
  EXPECT_EQ(first.health().message,
            fmt::format("the shared memory of key {} is not trackd's: it has 8 bytes, expected 28 at least",
                        tiny.key()));
  // A header that goes bad while it is read, and good again.
  TrackdSensorsWriter writer(1);
  Watched head(transportOf(writer.segment.key()));
  const auto delivers = [&] {
    head.samples.clear();
    return head.comesTrue([&] {
      return writer.write(0, {1, 2, 3}, {}, 1.8e9 + head.now_s()), head.samples.size() >= 5;
    });
  };
  ASSERT_TRUE(delivers());
  for (const std::uint32_t size : {0U, 0x80000000U}) {
    writer.segment.put(12, size);
    ASSERT_TRUE(head.comesTrue([&] {
      return head.health().message.find(fmt::format("its sensors have {} bytes", size)) != std::string::npos;
    }));
    writer.segment.put(12, std::uint32_t{40});
    ASSERT_TRUE(delivers());
  }
}

TEST(TrackdSource, IsReadOrExplained) {
  EXPECT_EQ(readTrackdSource("shm://4126").sensors, 4126);
  EXPECT_FALSE(readTrackdSource("shm://4126").wand);
  EXPECT_EQ(readTrackdSource("shm://0x101e?wand=4127").sensors, 4126);
  EXPECT_EQ(readTrackdSource("shm://4126?wand=4127").wand, 4127);
  for (const char* wrong : {"", "4126", "shm://", "shm://a", "shm://0", "shm://-1", "shm://4126:1",
                            "shm://99999999999", "shm://4126?wand=", "shm://4126?hand=4127"}) {
    try {
      readTrackdSource(wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace carom
