// The trackers of a rig file and how heads and hands use them.
#include "app/rig/rig_trackers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

using test::changed;
using test::expectNear;
using test::Fault;
using test::kGood;
using test::read;
using test::RigFaults;

TEST(Rig, ReadsEveryKindOfTracker) {
  const std::vector<std::tuple<const char*, TrackerKind, const char*>> kinds{
      {"vrpn", TrackerKind::vrpn, "Head@tcp://host:3883"},
      {"dtrack", TrackerKind::dtrack, "udp://224.0.1.0:5000?interface=192.168.1.5"},
      {"natnet", TrackerKind::natnet, "udp://192.168.1.10?group=239.255.42.99"},
      {"qtm", TrackerKind::qtm, "tcp://192.168.1.10:22223"},
      {"trackd", TrackerKind::trackd, "shm://4126?wand=4127"},
      {"survive", TrackerKind::survive, "tcp://192.168.1.10:7001"},
      {"polhemus-usb", TrackerKind::polhemusUsb, "0f44:ff12"},
      {"hid-imu", TrackerKind::hidImu, "2833:0001"}};
  for (const auto& [name, kind, source] : kinds) {
    const Rig rig = read(changed("'simulated'", std::string("'") + name + "'\nsource = '" + source + "'"));
    EXPECT_EQ(rig.trackers.at(0).kind, kind);
    EXPECT_EQ(rig.trackers[0].source, source);
    EXPECT_EQ(toString(kind), name);
  }
  for (const TrackerRow& row : trackerRows()) {
    const auto isThis = [&](const auto& kind) { return std::get<1>(kind) == row.kind; };
    const bool isRead = row.kind == TrackerKind::osc || row.kind == TrackerKind::spaceMouse ||  // below
                        std::ranges::any_of(kinds, isThis);
    EXPECT_TRUE(isRead || row.source == SourceUse::none || row.source == SourceUse::trace) << row.name;
  }
}

TEST(Rig, SaysWhichMessagesOfOscAreWhat) {
  const std::string kind = "'osc'\nsource = 'udp://0.0.0.0:9000'\n";
  const Rig rig =
      read(changed("'simulated'", kind + "osc = { pose = '/cap/{sensor}', values = 'x y z', unit = 'cm', "
                                         "buttons = '/b/{n}', axes = '/a/{sensor}/{n}' }"));
  const OscMapping& mapping = rig.trackers.at(0).osc;
  EXPECT_EQ(rig.trackers[0].kind, TrackerKind::osc);
  EXPECT_EQ(toString(TrackerKind::osc), "osc");
  EXPECT_EQ(mapping.pose->match("/cap/7")->sensor, 7);
  EXPECT_EQ(mapping.values.size(), 3u);
  EXPECT_EQ(mapping.unit_m, 0.01);
  EXPECT_EQ(mapping.buttons->match("/b/2")->index, 2);
  EXPECT_EQ(mapping.axes->match("/a/1/3")->index, 3);
  const Rig usual = read(changed("'simulated'", kind + "osc = { pose = '/cap' }"));
  EXPECT_EQ(usual.trackers[0].osc.values.size(), 7u);
  EXPECT_EQ(usual.trackers[0].osc.unit_m, 1.0);
  EXPECT_FALSE(usual.trackers[0].osc.buttons);
}

TEST(Rig, NamesTheSensorsOfQtmAndSurvive) {
  const Rig qtm = read(changed("'simulated'", "'qtm'\nsource = 'tcp://h'\nnames = ['Head', 'Wand']"));
  EXPECT_EQ(qtm.trackers.at(0).names, (std::vector<std::string>{"Head", "Wand"}));
  const Rig survive = read(changed("'simulated'", "'survive'\nnames = ['T20']"));
  EXPECT_EQ(survive.trackers.at(0).names, std::vector<std::string>{"T20"});
  EXPECT_EQ(survive.trackers[0].source, "") << "it is started";
}

TEST(Rig, SaysTheUnitOfTrackd) {
  const std::string trackd = "'trackd'\nsource = 'shm://4126'";
  EXPECT_EQ(read(changed("'simulated'", trackd)).trackers.at(0).unit_m, 0.3048) << "feet, if left out";
  EXPECT_EQ(read(changed("'simulated'", trackd + "\nunit = 'cm'")).trackers.at(0).unit_m, 0.01);
}

TEST(Rig, MaySayThatDtrackIsStarted) {
  const Rig rig =
      read(changed("'simulated'", "'dtrack'\nsource = 'udp://0.0.0.0:5000?controller=art'\nstart = true"));
  EXPECT_TRUE(rig.trackers.at(0).start);
  EXPECT_FALSE(read(changed("'simulated'", "'dtrack'\nsource = 'udp://0.0.0.0:5000'")).trackers.at(0).start);
}

TEST(Rig, MayHaveASpaceMouse) {
  const std::string mouse = kGood + "[[tracker]]\nname = 'mouse'\nkind = 'spacemouse'\n";
  const Rig first = read(mouse);
  const Rig addressed = read(mouse + "source = '046d:c626:S1'\n[hand]\ntracker = 'mouse'\n");
  ASSERT_EQ(first.trackers.size(), 2u);
  EXPECT_EQ(first.trackers[1].kind, TrackerKind::spaceMouse);
  EXPECT_EQ(first.trackers[1].source, "");
  EXPECT_EQ(addressed.trackers[1].source, "046d:c626:S1");
  EXPECT_EQ(addressed.viewers.front().hand->tracker, 1u);
  EXPECT_EQ(toString(TrackerKind::spaceMouse), "spacemouse");
}

TEST(Rig, MaySayHowAHandHoldsItsSensor) {
  const std::string hand = "[hand]\ntracker = 'cap'\nsensor = 2\n";
  EXPECT_EQ(read(kGood + hand).viewers.front().hand->handFromSensor.position_m, glm::dvec3(0.0));
  const Rig held =
      read(kGood + hand + "hand_from_sensor = { translation = [0, 30, 0], rotation_deg = [0, 90, 0] }\n");
  ASSERT_TRUE(held.viewers.front().hand);
  EXPECT_EQ(held.viewers.front().hand->sensor, 2);
  expectNear(held.viewers.front().hand->handFromSensor.position_m, {0, 0.03, 0});
  expectNear(held.viewers.front().hand->handFromSensor.orientation * glm::dvec3(0, 0, -1), {-1, 0, 0});
}

TEST(Rig, AHandMayHaveItsButtonsFromAnotherTracker) {
  const std::string box = "[[tracker]]\nname = 'box'\nkind = 'vrpn'\nsource = 'Button0@tcp://host'\n";
  const auto hand = [](const std::string& tracker, const std::string& buttons) {
    return "[hand]\ntracker = '" + tracker + "'\nsensor = 2\nbuttons = '" + buttons + "'\n";
  };
  const Rig rig = read(kGood + box + hand("cap", "box"));
  EXPECT_EQ(rig.viewers.front().hand->tracker, 0u);
  EXPECT_EQ(rig.viewers.front().hand->buttons, std::optional<std::size_t>(1));
  EXPECT_TRUE(rig.trackers[1].buttonsAlone);
  EXPECT_FALSE(rig.trackers[0].buttonsAlone);
  EXPECT_FALSE(read(kGood + box + hand("box", "box")).viewers.front().hand->buttons) << "its own";
  const Rig ofTheHead = read(kGood + box + hand("box", "cap"));
  EXPECT_EQ(ofTheHead.viewers.front().hand->buttons, std::optional<std::size_t>(0));
  EXPECT_FALSE(ofTheHead.trackers[0].buttonsAlone) << "the head's poses come from it, too";
  const std::string mouse = "[[tracker]]\nname = 'mouse'\nkind = 'spacemouse'\n";
  for (const auto& [text, words] :
       {std::pair{box + hand("cap", "bix"), ":22:11: there is no tracker 'bix', expected 'cap' or 'box'"},
        {mouse + hand("cap", "mouse"), ":21:11: a spacemouse steers and holds no cue"},
        {mouse + hand("mouse", "cap"), ":21:11: a hand on a spacemouse has no place"},
        {box + "[hand]\ntracker = 'cap'\nbuttons = 3\n", ":21:11: buttons is a whole number, expected"}}) {
    try {
      read(kGood + text);
      ADD_FAILURE() << text;
    } catch (const InputErrors& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Trackers, RigFaults,
    ::testing::Values(
        Fault{"head without tracker", changed("tracker = 'cap'\n", ""), 3, 1, "tracker is missing"},
        Fault{"unknown tracker", changed("tracker = 'cap'", "tracker = 'hat'"), 4, 11, "'cap'"},
        Fault{"tracker kind", changed("'simulated'", "'psychic'"), 8, 8, "'simulated' or 'recorded'"},
        Fault{"VRPN address", changed("'simulated'", "'vrpn'\nsource = 'tcp://host:3883'"), 9, 10,
              "expected one such as 'Head@tcp://host:3883'"},
        Fault{"DTRACK address", changed("'simulated'", "'dtrack'\nsource = 'udp://0.0.0.0:99999'"), 9, 10,
              "expected a number from 1 to 65535"},
        Fault{"DTRACK without controller",
              changed("'simulated'", "'dtrack'\nsource = 'udp://0.0.0.0:5000'\nstart = true"), 10, 9,
              "does not say which controller"},
        Fault{"start of another kind", changed("'simulated'", "'simulated'\nstart = true"), 9, 9,
              "dtrack alone"},
        Fault{"OSC without its messages", changed("'simulated'", "'osc'\nsource = 'udp://0.0.0.0:9000'"), 6,
              1, "osc is missing"},
        Fault{"OSC without a message",
              changed("'simulated'", "'osc'\nsource = 'udp://0.0.0.0:9000'\nosc = { unit = 'm' }"), 10, 7,
              "expected pose, buttons or axes"},
        Fault{"OSC address",
              changed("'simulated'", "'osc'\nsource = 'udp://0.0.0.0:9000'\nosc = { pose = '/cap/{n}' }"), 10,
              16, "has {n}, expected {sensor}"},
        Fault{"OSC values",
              changed("'simulated'",
                      "'osc'\nsource = 'udp://0.0.0.0:9000'\nosc = { pose = '/cap', values = 'x y' }"),
              10, 33, "'z' is missing"},
        Fault{"OSC of another kind", changed("'simulated'", "'simulated'\nosc = { pose = '/cap' }"), 9, 7,
              "has a meaning for osc alone"},
        Fault{"a command as a source",
              changed("'simulated'", "'survive'\nsource = 'survive-cli --simulator'"), 9, 10,
              "expected one such as 'tcp://"},
        Fault{"key of shared memory", changed("'simulated'", "'trackd'\nsource = 'shm://4126?wand=x'"), 9, 10,
              "expected a number from 1 to 2147483647"},
        Fault{"names that are equal", changed("'simulated'", "'survive'\nnames = ['T20', 'T20']"), 9, 17,
              "'T20' is there twice"},
        Fault{"an empty name", changed("'simulated'", "'survive'\nnames = ['']"), 9, 10, "names[0] is empty"},
        Fault{"names of another kind", changed("'simulated'", "'simulated'\nnames = ['T20']"), 9, 9,
              "has a meaning for qtm and survive alone"},
        Fault{"unit of another kind", changed("'simulated'", "'simulated'\nunit = 'ft'"), 9, 8,
              "has a meaning for trackd alone"},
        Fault{"NatNet group", changed("'simulated'", "'natnet'\nsource = 'udp://h?group=10.0.0.1'"), 9, 10,
              "expected a multicast address"},
        Fault{"USB address", changed("'simulated'", "'polhemus-usb'\nsource = 'FASTRAK'"), 9, 10,
              "expected vid:pid or vid:pid:serial"},
        Fault{"device without source", changed("'simulated'", "'hid-imu'"), 6, 1, "source"},
        Fault{"no SpaceMouse", kGood + "[[tracker]]\nname = 'm'\nkind = 'spacemouse'\nsource = '2833:0001'\n",
              18, 10, "is no SpaceMouse"},
        Fault{"SpaceMouse as head", changed("'simulated'", "'spacemouse'"), 4, 11, "sends no poses"},
        Fault{"trace is missing", changed("'simulated'", "'recorded'\nsource = 'no.csv'"), 9, 10, "no.csv"},
        Fault{"trace is not given", changed("'simulated'", "'recorded'"), 6, 1, "source is missing"},
        Fault{"latency", changed("'simulated'", "'simulated'\nlatency_ms = -1"), 9, 14, "from 0"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
