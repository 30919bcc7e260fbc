#include "devices/monitor/tracker_alarm.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <utility>

namespace carom {
namespace {

using State = TrackerHealth::State;

/// What is said while a tracker lives through `stateAt`; samples of `sensor` come while it delivers.
std::vector<std::pair<double, std::string>> said(const std::function<TrackerHealth(double)>& healthAt,
                                                 int sensor, double until_s) {
  TrackerAlarm watch("cap", 3);
  std::vector<std::pair<double, std::string>> lines;
  for (int frame = 0; frame < static_cast<int>(until_s * 60); ++frame) {
    const double now_s = frame / 60.0;
    const TrackerHealth health = healthAt(now_s);
    TrackerSample sample;
    sample.sensor = sensor;
    sample.time_s = now_s;
    watch.see(now_s, {&sample, health.state == State::delivering ? 1u : 0u});
    if (!watch.isDue(now_s)) continue;
    if (const auto line = watch.look(now_s, health)) lines.emplace_back(now_s, *line);
  }
  return lines;
}

TrackerHealth healthOf(State state, std::string message = {}) {
  TrackerHealth health;
  health.state = state;
  health.message = std::move(message);
  return health;
}

TEST(TrackerAlarm, SaysNothingWhileAllIsWell) {
  const auto brief = [](double now_s) {  // silent for three seconds
    return healthOf(now_s > 4 && now_s < 7 ? State::silent : State::delivering);
  };
  EXPECT_TRUE(said(brief, 3, 20.0).empty());
}

TEST(TrackerAlarm, TellsOnceOfSilenceAndOnceOfItsEnd) {
  const auto lines =
      said([](double now_s) { return healthOf(now_s > 2 && now_s < 12 ? State::silent : State::delivering); },
           3, 30.0);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].second, "Tracker cap: silent since second 2.0 of the session; the head is held");
  EXPECT_NEAR(lines[0].first, 7.0, 0.5);  // it is looked at every quarter of a second
  EXPECT_NEAR(lines[1].first, 12.0, 0.5);
  double away_s = 0.0;
  ASSERT_EQ(std::sscanf(lines[1].second.c_str(), "Tracker cap: delivers again, after %lf s", &away_s), 1)
      << lines[1].second;
  EXPECT_NEAR(away_s, lines[1].first - 2.0, 0.1);
}

// A frame that comes late sees poses late: what is told are the poses' own times.
TEST(TrackerAlarm, TellsTheTimesOfThePosesNotOfTheFrames) {
  TrackerAlarm watch("cap", 3);
  TrackerSample sample;
  sample.sensor = 3;
  sample.time_s = 2.0;
  watch.see(3.5, {&sample, 1});
  EXPECT_EQ(watch.look(3.5, healthOf(State::delivering)), std::nullopt);
  EXPECT_EQ(watch.look(9.0, healthOf(State::silent)),
            "Tracker cap: silent since second 2.0 of the session; the head is held");
  sample.time_s = 12.0;
  watch.see(13.5, {&sample, 1});
  EXPECT_EQ(watch.look(13.5, healthOf(State::delivering)), "Tracker cap: delivers again, after 10.0 s");
}

// The second silence is told with its own beginning.
TEST(TrackerAlarm, TellsOfEverySilence) {
  const auto lines = said(
      [](double now_s) {
        const bool away = (now_s > 2 && now_s < 12) || (now_s > 20 && now_s < 28);
        return healthOf(away ? State::silent : State::delivering);
      },
      3, 40.0);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[2].second, "Tracker cap: silent since second 20.0 of the session; the head is held");
  EXPECT_TRUE(lines[3].second.starts_with("Tracker cap: delivers again, after 8.")) << lines[3].second;
}

TEST(TrackerAlarm, OneThatComesLateHasNotComeAgain) {
  const auto lines = said(
      [](double now_s) { return healthOf(now_s < 10 ? State::connecting : State::delivering); }, 3, 20.0);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].second, "Tracker cap: delivers");
}

TEST(TrackerAlarm, NamesTheSensorsThatThereAre) {
  const auto lines = said([](double) { return healthOf(State::delivering); }, 1, 20.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].second, "Tracker cap: sensor 3 never came; this tracker has sent sensors 1");
}

TEST(TrackerAlarm, PassesOnWhatNeedsHelpAtOnce) {
  const auto lines = said(
      [](double now_s) {
        return now_s < 1 ? healthOf(State::failed, "needs firmware") : healthOf(State::delivering);
      },
      3, 10.0);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].second, "Tracker cap: needs firmware");
  EXPECT_EQ(lines[0].first, 0.0);
}

TEST(TrackerAlarm, TellsThatAConnectionIsTriedAgain) {
  const auto lines =
      said([](double) { return healthOf(State::connecting, "no connection to 10.0.0.1:3883"); }, 3, 60.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].second, "Tracker cap: no connection to 10.0.0.1:3883; it is tried again");
  EXPECT_NEAR(lines[0].first, 2.0, 0.5);
}

// A server is there at once, and says a second later that it has no such device.
TEST(TrackerAlarm, TellsWhatBecomesKnownLater) {
  const auto lines = said(
      [](double now_s) {
        TrackerHealth health =
            healthOf(State::connecting, now_s < 4 ? "" : "the server has no 'Head', it has: A");
        health.connected = true;
        return health;
      },
      3, 60.0);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].second, "Tracker cap: nothing has come yet; it is waited for");
  EXPECT_EQ(lines[1].second, "Tracker cap: the server has no 'Head', it has: A; it is waited for");
  EXPECT_NEAR(lines[1].first, 4.0, 0.5);
}

TEST(TrackerAlarm, ManyWaysToFailAreNotToldForEver) {
  const auto lines = said(
      [](double now_s) {
        return healthOf(State::connecting, "way " + std::to_string(static_cast<int>(now_s)));
      },
      3, 60.0);
  EXPECT_GE(lines.size(), 2u);
  EXPECT_LE(lines.size(), 4u);
}

TEST(TrackerAlarm, PassesOnARemarkOfOneThatDeliversOnce) {
  const auto lines = said(
      [](double now_s) { return healthOf(State::delivering, now_s < 3 ? "" : "its clock stands"); }, 3, 60.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].second, "Tracker cap: its clock stands");
}

TEST(TrackerAlarm, OfButtonsNobodyExpectsPoses) {
  TrackerAlarm watch("box", std::nullopt, "the hand has no buttons");
  EXPECT_FALSE(watch.look(60.0, healthOf(State::delivering)));
  EXPECT_FALSE(watch.look(61.0, healthOf(State::silent)));
  EXPECT_EQ(watch.look(66.0, healthOf(State::connecting, "it hung up")).value_or(""),
            "Tracker box: it hung up; it is tried again");
  EXPECT_EQ(watch.look(67.0, healthOf(State::delivering)).value_or(""), "Tracker box: delivers");
}

}  // namespace
}  // namespace carom
