// What the console says of a tracker and of the head: lamp and words agree, however slow the frames are.
#include "devices/monitor/tracker_report.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/viewer/head_tracking.h"

namespace carom {
namespace {

/// The head's report after three seconds of frames that take so long to draw, one after another.
TrackerReport after(double drawing_s, bool still) {
  Rig rig;
  rig.trackers.resize(1);
  rig.trackers[0].name = "you";
  rig.trackers[0].person = still ? SimulatedMotion::still : SimulatedMotion::moves;
  SharedTrackers trackers(rig, std::chrono::steady_clock::now());
  HeadTracking tracking(rig, rig.viewers.front(), trackers);
  HeadEstimate head;
  FrameTimes times;
  for (double begin_s = 0.0; begin_s < 3.0 + drawing_s; begin_s += drawing_s) {
    times.begin_s = begin_s;
    times.display_s = begin_s + drawing_s + 0.004;  // as the pacer aims
    head = tracking.at(times);
    ++times.number;
  }
  return tracking.reports(head).front();
}

TEST(TrackerReport, LampAndWordsAgreeWhateverTheFramesTake) {
  for (const bool still : {true, false}) {
    for (const double drawing_s : {0.016, 0.033, 0.07, 0.09, 0.12, 0.2, 0.29, 0.35, 0.5, 0.8, 1.3, 2.0}) {
      const TrackerReport report = after(drawing_s, still);
      const std::string words = headWords(report);
      SCOPED_TRACE(fmt::format("{} s a frame: {}", drawing_s, words));
      EXPECT_GE(report.health.samples, 180u);
      EXPECT_NEAR(report.rate_hz, 60.0, 3.0);
      EXPECT_LE(report.age_s, 1.0 / 60.0 + 1e-9);
      EXPECT_NEAR(report.shownAfter_s, report.age_s + drawing_s + 0.004, 1e-9);
      EXPECT_EQ(words.find("lost"), std::string::npos) << "samples come";
      const bool known = words.starts_with("measured") || words.starts_with("predicted");
      EXPECT_EQ(known, report.shownAfter_s <= 0.1);
      EXPECT_EQ(lampOf(report), known ? TrackerLamp::well : TrackerLamp::doubtful);
      EXPECT_EQ(words.find("drawing is slow") == std::string::npos, known);
      // Where it is shown at rest no number stands for its speed.
      EXPECT_EQ(words.find("m/s") == std::string::npos, report.shownAfter_s > kTrackLost_s);
    }
  }
}

TEST(TrackerReport, OneWhoseSamplesAreOverdueIsHeldOrLost) {
  TrackerReport report;
  report.health.state = TrackerHealth::State::delivering;
  report.known = Known::lost;
  for (const double age_s : {0.5, std::numeric_limits<double>::quiet_NaN()}) {
    report.age_s = age_s;
    EXPECT_TRUE(headWords(report).starts_with("lost: no sample has come for long"));
    EXPECT_EQ(lampOf(report), TrackerLamp::doubtful);
  }
  report.age_s = 0.2;
  report.known = Known::held;
  EXPECT_TRUE(headWords(report).starts_with("held: samples are overdue"));
  EXPECT_EQ(lampOf(report), TrackerLamp::doubtful);
}

TEST(TrackerReport, TheLampShowsWhatIsToBeLookedAt) {
  TrackerReport report;
  report.health.state = TrackerHealth::State::delivering;
  EXPECT_EQ(lampOf(report), TrackerLamp::well);
  EXPECT_EQ(headWords(report), "") << "no head";
  report.health.message = "its clock stands";
  EXPECT_EQ(lampOf(report), TrackerLamp::doubtful);
  report.health = TrackerHealth();
  report.health.state = TrackerHealth::State::silent;
  EXPECT_EQ(lampOf(report), TrackerLamp::doubtful);
  report.health.state = TrackerHealth::State::failed;
  EXPECT_EQ(lampOf(report), TrackerLamp::bad);
}

}  // namespace
}  // namespace carom
