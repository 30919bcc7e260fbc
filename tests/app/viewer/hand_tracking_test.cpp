// A wand's readings, through a tracker that a test feeds.
#include "app/viewer/hand_tracking.h"

#include <gtest/gtest.h>

#include "app/fed_tracker.h"

namespace carom {
namespace {

using namespace test;

TEST(HandTracking, TheHeadsTrackerMayFollowTheWandToo) {
  Rig rig;
  rig.trackers.resize(1);
  rig.viewers.front().hand = HandSetup{{0, 2}, {}};
  HandTracking tracking(rig, rig.viewers.front(), HandTracking::Trackers{});
  const std::vector<TrackerSample> samples{at(0, {0, 1.7, 0}), at(2, {0.3, 1.1, -0.2})};
  FedTracker head;
  head.press(0, true, 2);
  std::vector<Reading> inputs;
  head.takeInputs(inputs);
  tracking.follow(0.1, samples, inputs);
  EXPECT_TRUE(tracking.devices().wandKnown);
  EXPECT_EQ(tracking.devices().roomFromHand.position_m, glm::dvec3(0.3, 1.1, -0.2));
  EXPECT_EQ(tracking.devices().wand.down, 1u);
  tracking.follow(0.2, {}, {});
  EXPECT_TRUE(tracking.devices().wandKnown);
  tracking.follow(0.41, {}, {});
  EXPECT_FALSE(tracking.devices().wandKnown);
}

// A press that is over before the next frame, as where frames are slow, and two of them.
TEST(HandTracking, APressShorterThanAFrameIsAPress) {
  HandTracking::Trackers trackers;
  FedTracker* wand = new FedTracker;
  trackers.wand.reset(wand);
  const Rig rig = rigWith(TrackerKind::dtrack);
  HandTracking tracking(rig, rig.viewers.front(), std::move(trackers));
  wand->fed = {at(3, {0, 1, 0})};
  double now_s = 0.0;
  const auto down = [&] {
    tracking.follow(now_s += 0.1, {}, {});
    return tracking.devices().wand.down;
  };
  EXPECT_EQ(down(), 0u);
  for (int i = 0; i < 2; ++i) {
    wand->press(0, true, 3);
    wand->press(0, false, 3);
  }
  wand->press(2, true, 3);
  EXPECT_EQ(down(), 0b101u) << "another button does not wait";
  EXPECT_EQ(down(), 0b100u);
  EXPECT_EQ(down(), 0b101u);
  EXPECT_EQ(down(), 0b100u);
  EXPECT_EQ(down(), 0b100u);
}

TEST(HandTracking, ReportsRateAndAge) {
  HandTracking::Trackers trackers;
  FedTracker* wand = new FedTracker;
  trackers.wand.reset(wand);
  trackers.spaceMouse = std::make_unique<FedTracker>();
  const Rig rig = rigWith(TrackerKind::dtrack);
  HandTracking tracking(rig, rig.viewers.front(), std::move(trackers));
  const FedTracker head;
  wand->fed = {at(3, {0, 0, 0}), at(3, {0, 0, 0})};
  for (int i = 1; i <= 60; ++i) tracking.follow(0.02 * i, {}, {});
  wand->fed.clear();
  tracking.follow(1.25, {}, {});
  std::vector<TrackerReport> reports;
  tracking.report(1.25, head, reports);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].name, "wand");
  EXPECT_EQ(reports[0].use, "hand");
  EXPECT_NEAR(reports[0].rate_hz, 100.0, 2.0);
  EXPECT_NEAR(reports[0].age_s, 0.05, 1e-9);
  EXPECT_EQ(reports[1].name, "cap");
  EXPECT_EQ(reports[1].use, "steering");
}

/// A wand on tracker 1, sensor 3, whose buttons are those of tracker 3; lines that are said of it.
class TwoDevices {
 public:
  TwoDevices() : TwoDevices(3) {}
  explicit TwoDevices(std::optional<std::size_t> buttonsOf) {
    Rig rig = rigWith(TrackerKind::natnet);
    rig.trackers.resize(4);
    rig.trackers[3].name = "box";
    rig.trackers[3].kind = TrackerKind::vrpn;
    rig.viewers.front().hand->buttons = buttonsOf;
    HandTracking::Trackers trackers;
    trackers.wand.reset(wand = new FedTracker);
    if (buttonsOf == 3u) trackers.buttons.reset(box = new FedTracker);
    tracking.emplace(rig, rig.viewers.front(), std::move(trackers));
    wand->fed = {at(3, {0, 1, 0})};
    head.fares.state = TrackerHealth::State::delivering;
  }
  const ButtonState& frame(std::span<const Reading> headInputs = {}) {
    now_s += 0.02;
    tracking->follow(now_s, {}, headInputs);
    if (tracking->isDue(now_s)) {
      for (const std::string& line : tracking->look(now_s, head)) said.push_back(line);
    }
    return tracking->devices().wand;
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  FedTracker *wand = nullptr, *box = nullptr, head;
  std::optional<HandTracking> tracking;
  std::vector<std::string> said;
  double now_s = 0.0;
};

TEST(HandTracking, ButtonsMayBeAnotherTrackers) {
  TwoDevices hand;
  hand.wand->press(1, true, 3);
  EXPECT_EQ(hand.frame().down, 0u) << "the wand's own do not count";
  hand.box->press(0, true, 0);
  hand.box->push(1, -0.5, 0);
  EXPECT_EQ(hand.frame().down, 1u);
  EXPECT_EQ(hand.frame().axes[1], -0.5);
  EXPECT_TRUE(hand.tracking->devices().wandKnown);
  hand.box->press(0, false, 0);
  EXPECT_EQ(hand.frame().down, 0u);
  std::vector<TrackerReport> reports;
  hand.tracking->report(hand.now_s, hand.head, reports);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[1].name, "box");
  EXPECT_EQ(reports[1].use, "buttons");
}

// Sensors are numbered otherwise there: who has buttons is taken; of several, the one of the wand's number.
TEST(HandTracking, TheSensorThatHasButtonsIsTaken) {
  TwoDevices hand;
  hand.box->press(0, true, 100);
  EXPECT_EQ(hand.frame().down, 1u);
  hand.box->press(1, true, 101);
  EXPECT_EQ(hand.frame().down, 1u) << "the first that came";
  hand.box->press(2, true, 3);
  EXPECT_EQ(hand.frame().down, 4u) << "that of the wand's number, and what the other held is let go";
  hand.box->press(3, true, 100);
  EXPECT_EQ(hand.frame().down, 4u);
}

TEST(HandTracking, ButtonsMayBeTheHeadsTrackers) {
  TwoDevices hand(0);
  FedTracker other;
  other.press(0, true, 100);
  EXPECT_EQ(hand.frame(other.readings).down, 1u);
  hand.head.fares.state = TrackerHealth::State::silent;
  hand.frames(20);
  EXPECT_EQ(hand.tracking->devices().wand.down, 0u) << "nobody knows whether they are still held";
}

TEST(HandTracking, ButtonsOfATrackerThatIsGoneAreLetGo) {
  TwoDevices hand;
  hand.box->press(0, true);
  EXPECT_EQ(hand.frame().down, 1u);
  hand.frames(20);
  EXPECT_EQ(hand.tracking->devices().wand.down, 1u) << "it says nothing while nothing changes";
  hand.box->fares = {TrackerHealth::State::connecting, "it hung up", {}, {}};
  hand.frames(20);
  EXPECT_EQ(hand.tracking->devices().wand.down, 0u);
  hand.frames(150);
  EXPECT_EQ(hand.said, std::vector<std::string>{"Tracker box: it hung up; it is tried again"});
}

TEST(HandTracking, SaysThatNoPoseComes) {
  TwoDevices hand;
  hand.box->press(0, false);
  hand.wand->fed = {at(1, {0, 1, 0})};
  hand.frames(1000);
  ASSERT_EQ(hand.said.size(), 1u);
  EXPECT_EQ(hand.said[0], "Tracker wand: sensor 3 never came; this tracker has sent sensors 1");
  hand.wand->fed = {at(3, {0, 1, 0})};
  hand.frames(100);
  ASSERT_EQ(hand.said.size(), 2u);
  EXPECT_EQ(hand.said[1], "Tracker wand: delivers");
  hand.wand->fed.clear();
  hand.frames(500);
  ASSERT_EQ(hand.said.size(), 3u);
  EXPECT_EQ(
      hand.said[2],
      "Tracker wand: sensor 3 has not been seen since second 22.0 of the session; the wand aims at nothing");
}

TEST(HandTracking, SaysThatNoButtonCame) {
  TwoDevices two, one(std::nullopt);
  two.now_s = one.now_s = 20.0;  // loading took so long
  two.frames(200);
  EXPECT_TRUE(two.said.empty()) << two.said[0];
  two.frames(800);
  one.frames(1000);
  EXPECT_EQ(two.said,
            std::vector<std::string>{
                "Tracker box: no button or axis of the hand has come yet; without one the wand only points"});
  EXPECT_EQ(one.said,
            std::vector<std::string>{"Tracker wand: no button or axis of the hand has come yet; if it "
                                     "has none, name a tracker that has some as buttons of [hand]"});
  one.wand->press(0, true, 3);
  one.frames(100);
  ASSERT_EQ(one.said.size(), 2u);
  EXPECT_EQ(one.said[1], "Tracker wand: the hand's buttons have come");
}

}  // namespace
}  // namespace carom
