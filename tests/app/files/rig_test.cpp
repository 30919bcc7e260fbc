#include "app/files/rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <tuple>

#include "app/files/rig_viewers.h"
#include "app/files/toml_file.h"
#include "app/input_faults.h"
#include "app/temporary_folder.h"
#include "cave/room/wall_eyes.h"
#include "places.h"

namespace carom {
namespace {

using test::Fault;
using test::TemporaryFolder;

constexpr double kRounding_m = 1e-12;

const std::string kGood =
    "unit = 'mm'\n"
    "axes = 'x-right y-up z-back'\n"
    "[head]\n"
    "tracker = 'cap'\n"
    "eye_separation = 62\n"
    "[[tracker]]\n"
    "name = 'cap'\n"
    "kind = 'simulated'\n"
    "[[wall]]\n"
    "name = 'front'\n"
    "lower_left = [-1500, 0, -1500]\n"
    "lower_right = [1500, 0, -1500]\n"
    "upper_left = [-1500, 2000, -1500]\n"
    "pixels = [1920, 1280]\n";

Rig read(const std::string& text) {
  const TemporaryFolder folder;
  return readRig(folder.file("given.toml", text));
}

/// kGood with one piece of it changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(glm::distance(a, b), 0.0, kRounding_m) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Rig, ReadsLengthsInEveryUnit) {
  const std::vector<std::pair<std::string, double>> units{
      {"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& [unit, metres] : units) {
    const Rig rig =
        read("unit = '" + unit +
             "'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'a'\neyes_from_sensor = { translation = [0, "
             "1, 0] }\n"
             "[[tracker]]\nname = 'a'\nkind = 'simulated'\nroom_from_tracker = { translation = [1, 0, 0] }\n"
             "[[wall]]\nname = 'w'\nlower_left = [0, 0, 0]\nlower_right = [4, 0, 0]\nupper_left = [0, 3, 0]\n"
             "pixels = [4, 3]\n");
    expectNear(rig.walls.at(0).lowerRight_m, {4 * metres, 0, 0});
    expectNear(rig.walls.at(0).upperLeft_m, {0, 3 * metres, 0});
    expectNear(rig.viewers.front().head.eyesFromSensor.position_m, {0, metres, 0});
    expectNear(rig.trackers.at(0).roomFromTracker.position_m, {metres, 0, 0});
    EXPECT_NEAR(rig.viewers.front().head.eyeSeparation_m, 0.064, kRounding_m)
        << "the default is in metres whatever the unit";
  }
}

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

TEST(Rig, KeepsItsAxesAndNamesTheirDirections) {
  for (const char* axes : {"x-right y-up z-back", "x-right y-forward z-up"}) {
    const RoomAxes room = read(changed("x-right y-up z-back", axes)).axes;
    expectNear(glm::cross(room.right, room.forward), room.up);
  }
  expectNear(read(kGood).axes.up, {0, 1, 0});
  expectNear(read(changed("x-right y-up z-back", "x-right y-forward z-up")).axes.forward, {0, 1, 0});
}

TEST(Rig, TurnsAboutXThenYThenZ) {
  const Pose pose = read(changed("eye_separation = 62", "eyes_from_sensor = { rotation_deg = [90, 0, 90] }"))
                        .viewers.front()
                        .head.eyesFromSensor;
  expectNear(pose * glm::dvec3(0, 1, 0), {0, 0, 1});  // x takes y to z, which z leaves
  expectNear(pose * glm::dvec3(0, 0, 1), {1, 0, 0});  // x takes z to −y, z takes that to x
}

TEST(Rig, TheConsoleHasAPlace) {
  const Rig rig = read(std::string(kGood) +
                       "\n[console]\nwindow = { monitor = 1, position = [10, 20], size = [800, 600] }\n");
  const WindowPlacement expected{
      .monitor = 1, .position_px = {10, 20}, .size_px = {800, 600}, .border = true};
  EXPECT_EQ(rig.console, expected);
  EXPECT_FALSE(read(kGood).console);
}

TEST(Rig, AWindowNamesItsMonitors) {
  const auto windowOf = [](const std::string& keys) {
    return read(kGood + "window = { size = [800, 600]" + keys + " }\n").walls.at(0).window;
  };
  EXPECT_EQ(windowOf("").monitor, 0);
  EXPECT_FALSE(windowOf("").border);
  EXPECT_TRUE(windowOf(", border = true").border);
  EXPECT_EQ(windowOf(", monitor = 2").monitor, 2);
  EXPECT_EQ(windowOf(", monitor = 'DP-1'").monitorNames, std::vector<std::string>{"DP-1"});
  EXPECT_EQ(windowOf(", monitor = ['DP-1', 'DP-3']").monitorNames,
            (std::vector<std::string>{"DP-1", "DP-3"}));
  for (const char* wrong : {"[]", "[1]", "-1", "64", "true", "''", "['DP-1', '']", "1.5"})
    EXPECT_THROW(windowOf(std::string(", monitor = ") + wrong), InputErrors) << wrong;
}

TEST(Rig, LeavesOutWhatIsOptional) {
  const Rig rig = read(kGood);
  EXPECT_EQ(rig.display_hz, 60.0);
  EXPECT_NEAR(rig.viewers.front().head.eyeSeparation_m, 0.062, kRounding_m);
  EXPECT_FALSE(rig.viewers.front().hand);
  EXPECT_FALSE(rig.oneWindow);
  EXPECT_TRUE(rig.nodes.empty());
  EXPECT_EQ(rig.walls.at(0).stereo, StereoMode::mono);
  EXPECT_EQ(rig.walls[0].window.size_px, glm::ivec2(1920, 1280));
  EXPECT_EQ(rig.displayLatency_s, 0.0);
  EXPECT_EQ(rig.frameLock, FrameLock::software);
}

TEST(Rig, MayAskTheGraphicsCardsForTheFrameLock) {
  EXPECT_EQ(read("frame_lock = 'swap-group'\n" + kGood).frameLock, FrameLock::swapGroup);
  EXPECT_EQ(read("frame_lock = 'software'\n" + kGood).frameLock, FrameLock::software);
  EXPECT_THROW(read("frame_lock = 'genlock'\n" + kGood), InputErrors);
}

TEST(Rig, EveryShippedFileIsRight) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs")) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW(readRig(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(Rig, ShippedCaveIsAClosedCornerSeenFromInside) {
  for (const char* name : {"/rigs/desk.toml", "/rigs/four-walls-cluster.toml"}) {
    const Rig rig = readRig(std::string(CAROM_CONFIG_DIR) + name);
    ASSERT_EQ(rig.walls.size(), 4u);
    const glm::dvec3 person_m = 1.7 * rig.axes.up;
    for (const Wall& wall : rig.walls) {
      // right × up points from the wall to the person.
      const glm::dvec3 normal =
          glm::cross(wall.lowerRight_m - wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m);
      EXPECT_GT(glm::dot(normal, person_m - wall.lowerLeft_m), 0.0) << wall.name;
      EXPECT_EQ(wall.stereo, StereoMode::sideBySide);
    }
  }
}

TEST(Rig, CarriesWhatTheProjectorDoes) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  folder.file("blend.png", "");
  const Wall wall = readRig(folder.file("given.toml", kGood + "warp = 'warp.pfm'\nblend = 'blend.png'\n"
                                                              "black_level = 0.02\nflip = 'both'\n"
                                                              "display_latency_ms = 12.5\n"))
                        .walls.at(0);
  EXPECT_EQ(wall.warp, folder / "warp.pfm");
  EXPECT_EQ(wall.blend, folder / "blend.png");
  EXPECT_EQ(wall.blackLevel, 0.02);
  EXPECT_EQ(wall.flip, Flip::both);
  EXPECT_NEAR(wall.displayLatency_s, 0.0125, 1e-15);
}

TEST(Rig, CarriesTheColoursOfTheProjector) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  const std::string meshes = "warp_red = 'warp.pfm'\nwarp_green = 'warp.pfm'\nwarp_blue = 'warp.pfm'\n";
  const Wall wall =
      readRig(folder.file("given.toml", kGood + "gain = [1, 0.9, 0.8]\ngamma = [2.2, 2.3, 2.4]\n" + meshes))
          .walls.at(0);
  EXPECT_EQ(wall.gain, glm::dvec3(1.0, 0.9, 0.8));
  EXPECT_EQ(wall.gamma, glm::dvec3(2.2, 2.3, 2.4));
  for (const auto& warp : wall.colourWarps) EXPECT_EQ(warp, folder / "warp.pfm");
  const Wall plain = read(kGood).walls.at(0);
  EXPECT_EQ(plain.gain, glm::dvec3(1.0));
  EXPECT_FALSE(plain.gamma);
}

TEST(Rig, NamesWhatIsWrongInAWarpAtItsOwnLine) {
  const TemporaryFolder folder;
  const auto warp = folder.file("warp.obj", "v 0 0 0\nv nan 0 0\n");
  try {
    readRig(folder.file("given.toml", kGood + "warp = 'warp.obj'\n"));
    FAIL() << "the warp is broken";
  } catch (const InputError& error) {
    EXPECT_EQ(std::pair(error.line(), error.column()), std::pair(15, 8));
    EXPECT_TRUE(error.message().starts_with(warp.string() + ":2:3: 'nan' is wrong")) << error.what();
  }
}

TEST(Rig, EyesMayShareAWindow) {
  // A projector for each eye: two walls with equal corners, side by side in the one window.
  std::string second = kGood.substr(kGood.find("[[wall]]"));
  second.replace(second.find("front"), 5, "front-right");
  const std::string text = changed("[head]", "[one_window]\nsize = [200, 100]\n[head]") +
                           "window = { size = [100, 100] }\nstereo = 'left'\n" + second +
                           "window = { size = [100, 100], position = [100, 0] }\nstereo = 'right'\n";
  EXPECT_EQ(read(text).walls.size(), 2u);
}

/// A second wall on the place of kGood's, named `second`, with these lines instead of a window and stereo.
std::string withSecond(const std::string& firstsLines, const std::string& secondsLines) {
  std::string second = kGood.substr(kGood.find("[[wall]]"));
  second.replace(second.find("front"), 5, "second");
  return kGood + firstsLines + second + secondsLines;
}

TEST(Rig, WallsOfANodeShareAWindowByViewports) {
  const std::string window = "window = { size = [200, 100], viewport = { size = [100, 100]";
  const Rig rig = read(withSecond(window + " } }\n", window + ", position = [100, 0] } }\n"));
  ASSERT_TRUE(rig.walls[0].viewport && rig.walls[1].viewport);
  EXPECT_TRUE(rig.walls[0].window == rig.walls[1].window);
  EXPECT_EQ(rig.walls[1].viewport->position_px, glm::ivec2(100, 0));
  EXPECT_EQ(rig.walls[1].viewport->size_px, glm::ivec2(100, 100));
  EXPECT_NO_THROW(read(withSecond(window + " } }\n", window + " } }\nnode = 1\n"))) << "windows of two nodes";
}

TEST(Rig, EachNodeHasItsOneWindow) {
  const std::string text =
      withSecond("window = { size = [100, 100] }\n", "window = { size = [100, 100] }\nnode = 1\n");
  std::string one = text;
  one.replace(one.find("[head]"), 6, "[one_window]\nsize = [100, 100]\n[head]");
  EXPECT_EQ(read(one).walls.size(), 2u);
}

// 60 Hz: a frame is 16.7 ms. What is left after whole frames is at most half of one.
TEST(Rig, FastWallsWaitForTheSlowest) {
  const auto held = [](double first_ms, double second_ms) {
    const Rig rig = read(withSecond("display_latency_ms = " + std::to_string(first_ms) + "\n",
                                    "display_latency_ms = " + std::to_string(second_ms) + "\n"));
    EXPECT_NEAR(rig.displayLatency_s, std::max(first_ms, second_ms) * 1e-3, 1e-9);
    return std::pair(rig.walls[0].heldFrames, rig.walls[1].heldFrames);
  };
  using Held = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(held(20.0, 20.0), Held(0, 0));
  EXPECT_EQ(held(20.0, 12.0), Held(0, 0));
  EXPECT_EQ(held(20.0, 11.0), Held(0, 1));
  EXPECT_EQ(held(5.0, 40.0), Held(2, 0));
}

// A screen that a projector distorts is drawn for the rectangle around it.
TEST(Rig, MayHaveASkewedScreen) {
  const std::string four =
      "lower_left = [-1500, 0, -1500]\nlower_right = [1480, 10, -1500]\nupper_left = [-1460, 1990, -1500]\n"
      "upper_right = [1500, 2000, -1500]\nskewed = true\n";
  const std::string three =
      "lower_left = [-1500, 0, -1500]\nlower_right = [1500, 0, -1500]\nupper_left = [-1500, 2000, -1500]\n";
  const Wall wall = read(changed(three, four)).walls.at(0);
  ASSERT_TRUE(wall.skewed);
  expectNear(wall.skewed->corners_m[3], {1.5, 2.0, -1.5});
  EXPECT_NEAR(wall.skewed->offPlane_m, 0.0, kRounding_m);
  // The edges of the rectangle touch the screen: along each side lies one corner at least, none beyond.
  glm::dvec2 least(1.0), most(0.0);
  for (const glm::dvec2& corner : wall.skewed->inPicture) {
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  EXPECT_EQ(least, glm::dvec2(0.0));
  EXPECT_EQ(most, glm::dvec2(1.0));
  const std::string unsaid = changed(three, four.substr(0, four.find("skewed")));
  EXPECT_THROW(read(unsaid), InputErrors);  // a slip of the tape is not taken for a skewed screen
}

TEST(Rig, OneThingAloneSaysWhereThePictureGoes) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  const std::string colours = "warp_red = 'warp.pfm'\nwarp_green = 'warp.pfm'\nwarp_blue = 'warp.pfm'\n";
  const std::string skewed = "skewed = true\nupper_right = [1500, 1900, -1500]\n";
  const auto faultsOf = [&](const std::string& text) {
    try {
      readRig(folder.file("given.toml", kGood + text));
    } catch (const InputErrors& error) {
      std::string all;
      for (const InputError& fault : error.faults()) all += fault.message() + "\n";
      return all;
    }
    return std::string();
  };
  EXPECT_EQ(faultsOf(skewed), "");
  EXPECT_EQ(faultsOf(colours), "");
  EXPECT_NE(faultsOf(skewed + "warp = 'warp.pfm'\n").find("as the corners of a skewed wall do"),
            std::string::npos);
  EXPECT_NE(faultsOf(skewed + colours).find("as the corners of a skewed wall do"), std::string::npos);
  EXPECT_NE(faultsOf(colours + "warp = 'warp.pfm'\n").find("expected no warp for all of them"),
            std::string::npos);
  EXPECT_NE(faultsOf("warp_red = 'warp.pfm'\n").find("warp_green is missing"), std::string::npos);
}

TEST(Rig, WallsMayMissARectangleByTwoMillimetres) {
  EXPECT_NO_THROW(read(changed("[-1500, 2000, -1500]", "[-1498.1, 2000, -1500]")));
  EXPECT_THROW(read(changed("[-1500, 2000, -1500]", "[-1497.9, 2000, -1500]")), InputErrors);
  EXPECT_NO_THROW(read(kGood + "upper_right = [1500, 2001.9, -1500]\n"));
  EXPECT_THROW(read(kGood + "upper_right = [1500, 2002.1, -1500]\n"), InputErrors);
}

class RigFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(RigFaults, ArePlacedAndExplained) { test::expectExplained(GetParam(), read); }

INSTANTIATE_TEST_SUITE_P(
    All, RigFaults,
    ::testing::Values(
        Fault{"unit", changed("'mm'", "'furlong'"), 1, 8, "'mm' or 'cm'"},
        Fault{"axes", changed("z-back", "z-front"), 2, 8, "x-right y-forward z-up"},
        Fault{"number with junk", changed("[1500, 0, -1500]", "[1500, 0/05, -1500]"), 12, 23,
              "expected digit"},
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
        Fault{"latency", changed("'simulated'", "'simulated'\nlatency_ms = -1"), 9, 14, "from 0"},
        Fault{"no walls", kGood.substr(0, kGood.find("[[wall]]")), 1, 1, "[[wall]]"},
        Fault{"no width", changed("[1500, 0, -1500]", "[-1500, 0, -1500]"), 12, 15, "no width"},
        Fault{"no height", changed("[-1500, 2000, -1500]", "[-1500, 0, -1500]"), 13, 14, "no height"},
        Fault{"line", changed("[-1500, 2000, -1500]", "[0, 0, -1500]"), 13, 14, "one line"},
        Fault{"skew", changed("[-1500, 2000, -1500]", "[-1450, 2000, -1500]"), 13, 14, "by 50.0 mm"},
        Fault{"fourth corner", kGood + "upper_right = [1500, 2030, -1500]\n", 15, 15, "30.0 mm"},
        Fault{"no pixels", changed("[1920, 1280]", "[1920, 0]"), 14, 17, "from 1"},
        Fault{"half a pixel", changed("[1920, 1280]", "[1920, 0.5]"), 14, 17, "whole number"},
        Fault{"stereo", kGood + "stereo = 'both'\n", 15, 10, "'side-by-side'"},
        Fault{"no such warp", kGood + "warp = 'no.pfm'\n", 15, 8, "'no.pfm' is no file"},
        Fault{"warp of another kind", kGood + "warp = 'rigs/desk.toml'\n", 15, 8, "ending in .pfm or .obj"},
        Fault{"blend of another kind", kGood + "blend = 'rigs/desk.toml'\n", 15, 9, "ending in .png"},
        Fault{"black level", kGood + "black_level = 1.1\n", 15, 15, "from 0 to 1"},
        Fault{"flip", kGood + "flip = true\n", 15, 8, "'none' or 'horizontal'"},
        Fault{"gain", kGood + "gain = [1, 1, 1.1]\n", 15, 15, "above 0 up to 1"},
        Fault{"two gains", kGood + "gain = [1, 1]\n", 15, 8, "3 numbers"},
        Fault{"white below black", kGood + "gain = [1, 0.1, 1]\nblack_level = 0.2\n", 15, 8,
              "white above black"},
        Fault{"gamma", kGood + "gamma = [0.5, 2, 2]\n", 15, 10, "from 1 to 4"},
        Fault{"skewed of three corners", kGood + "skewed = true\n", 15, 10, "needs all four corners"},
        Fault{"bent", kGood + "skewed = true\nupper_right = [1500, 2000, -1400]\n", 16, 15, "off one plane"},
        Fault{"crossed", kGood + "skewed = true\nupper_right = [-1600, 2000, -1500]\n", 16, 15, "degrees"},
        Fault{"latency of a wall", kGood + "display_latency_ms = -1\n", 15, 22, "from 0"},
        Fault{"wall name", changed("'front'", "'../front'"), 10, 8, "letters"},
        Fault{"same wall", kGood + kGood.substr(kGood.find("[[wall]]")), 16, 8, "taken in line 10"},
        Fault{"window", kGood + "window = { position = [0, 0] }\n", 15, 10, "size is missing"},
        Fault{
            "place outside",
            changed("[head]", "[one_window]\nsize = [100, 100]\n[head]") + "window = { size = [101, 100] }\n",
            17, 10, "reaches out"},
        Fault{"viewport outside",
              kGood + "window = { size = [100, 100], viewport = { size = [101, 100] } }\n", 15, 10,
              "reaches out of its window"},
        Fault{"viewport inside the one window",
              changed("[head]", "[one_window]\nsize = [100, 100]\n[head]") +
                  "window = { size = [100, 100], viewport = { size = [50, 50] } }\n",
              17, 42, "expected none"},
        Fault{"viewports on each other",
              withSecond(
                  "window = { size = [100, 100], viewport = { size = [60, 100] } }\n",
                  "window = { size = [100, 100], viewport = { position = [50, 0], size = [50, 100] } }\n"),
              22, 10, "overlap in their window"},
        Fault{"walls too different", withSecond("display_latency_ms = 5\n", "display_latency_ms = 200\n"), 15,
              22, "is 195.0 ms faster than the slowest"},
        Fault{"place not given", changed("[head]", "[one_window]\nsize = [100, 100]\n[head]"), 11, 1,
              "window is missing"},
        Fault{"same rank",
              changed("[head]",
                      "[[node]]\nrank = 0\ndisplay = ':0'\n[[node]]\nrank = 0\ndisplay = ':1'\n[head]"),
              7, 8, "taken in line 4"}),
    [](const auto& tested) {
      std::string name = tested.param.what;
      std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
      return name;
    });

/// A room for two: kGood without its head, with two viewers and a wall for each.
std::string roomForTwo() {
  const auto viewer = [](const std::string& name, int sensor) {
    return "[[viewer]]\nname = '" + name + "'\ntracker = 'cap'\nsensor = " + std::to_string(sensor) + "\n";
  };
  std::string text =
      changed("[head]\ntracker = 'cap'\neye_separation = 62\n", viewer("anna", 0) + viewer("ben", 1));
  const std::string wall = text.substr(text.find("[[wall]]"));
  std::string second = wall;
  second.replace(second.find("'front'"), 7, "'front-ben'");
  return text + "stereo = 'side-by-side'\nviewer = 'anna'\n" + second +
         "stereo = 'side-by-side'\nviewer = 'ben'\n";
}

std::string changedForTwo(const std::string& from, const std::string& to) {
  std::string text = roomForTwo();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The rig of a headset, with one piece of it changed.
std::string headset(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "unit = 'cm'\n"
      "axes = 'x-right y-up z-back'\n"
      "[headset]\n"
      "board = { lower_left = [-120, 120, -240], lower_right = [120, 120, -240], upper_left = [-120, 270, "
      "-240] }\n";
  if (from.empty()) return text;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Rig, OfAHeadsetHasTwoWallsOnTheHeadAndABoardInTheRoom) {
  const Rig rig = read(headset());
  ASSERT_TRUE(isHeadset(rig));
  ASSERT_EQ(rig.walls.size(), 2U);
  for (const Wall& wall : rig.walls) EXPECT_TRUE(wall.onHead) << wall.name;
  EXPECT_EQ(rig.walls[0].stereo, StereoMode::left);
  EXPECT_EQ(rig.walls[1].stereo, StereoMode::right);
  EXPECT_TRUE(standingWalls(rig).empty());
  expectNear(rig.board->upperLeft_m, {-1.2, 2.7, -2.4});
  EXPECT_EQ(rig.board->pixels, glm::ivec2(1280, 800));
  ASSERT_EQ(rig.trackers.size(), 1U);
  EXPECT_EQ(rig.trackers[0].kind, TrackerKind::headset);
  EXPECT_EQ(rig.viewers.front().hand->sensor, 1);
  EXPECT_EQ(read(headset("270, -240]", "270, -240], pixels = [640, 400]")).board->pixels,
            glm::ivec2(640, 400));
}

INSTANTIATE_TEST_SUITE_P(
    Headset, RigFaults,
    ::testing::Values(
        Fault{"other axes", headset("'x-right y-up z-back'", "'x-right y-forward z-up'"), 2, 8,
              "a headset measures along 'x-right y-up z-back'"},
        Fault{"a wall", headset() + kGood.substr(kGood.find("[[wall]]")), 5, 1,
              "has no meaning in the rig of a headset"},
        Fault{"a tracker", headset() + "[[tracker]]\nname = 'cap'\nkind = 'simulated'\n", 5, 1,
              "has no meaning in the rig of a headset"},
        Fault{"no board", headset("board", "bored"), 4, 1, "unknown key 'bored'"},
        Fault{"a board seen from behind",
              headset("lower_left = [-120, 120, -240], lower_right = [120, 120, -240], upper_left = [-120",
                      "lower_left = [120, 120, -240], lower_right = [-120, 120, -240], upper_left = [120"),
              4, 9, "the board does not face somebody who looks forward"},
        Fault{"a board to the left",
              headset("lower_right = [120, 120, -240]", "lower_right = [-120, 120, -480]"), 4, 9,
              "the board does not face somebody who looks forward"},
        Fault{"a board that is no rectangle", headset("120, 120, -240], upper", "120, 150, -240], upper"), 4,
              88, "misses the right angle"},
        Fault{"a board of too many pixels", headset("270, -240]", "270, -240], pixels = [640, 5000]"), 4, 122,
              "expected a whole number from 1 to 4096"}));

TEST(Rig, HasAViewerForEachPersonInTheRoom) {
  const Rig rig = read(roomForTwo());
  EXPECT_EQ(namesOf(rig.viewers), (std::vector<std::string>{"anna", "ben"}));
  EXPECT_EQ(rig.viewers[1].head.sensor, (SensorChoice{0, 1}));
  EXPECT_EQ(eyesOf(rig.walls[1]), (std::vector<ViewerEye>{{1, Eye::left}, {1, Eye::right}}));
  EXPECT_EQ(sightsOf(rig, 1), (std::vector<std::string>{"sees front-ben (left), front-ben (right)"}));

  const Rig bens = rigFor(rig, "ben");
  EXPECT_EQ(namesOf(bens.viewers), (std::vector<std::string>{"ben", "anna"}));
  ASSERT_EQ(bens.walls.size(), 1u);
  EXPECT_EQ(bens.walls[0].name, "front-ben");
  EXPECT_EQ(bens.walls[0].viewer, 0u);
}

TEST(Rig, AWallMayShowEyesOfTwoPeople) {
  std::string text = changedForTwo("viewer = 'anna'", "eyes = ['anna.left', 'ben.left']");
  text.replace(text.find("viewer = 'ben'"), 14, "eyes = ['anna.right', 'ben.right']");
  const Rig rig = read(text);
  EXPECT_EQ(rig.walls[0].eyes, (std::vector<ViewerEye>{{0, Eye::left}, {1, Eye::left}}));
  EXPECT_EQ(rig.walls[0].pictureNames, (std::vector<std::string>{"front-anna", "front-ben"}));
  const Rig bens = rigFor(rig, "ben");
  ASSERT_EQ(bens.walls.size(), 2u);
  EXPECT_EQ(bens.walls[0].stereo, StereoMode::left);
  EXPECT_EQ(bens.walls[1].stereo, StereoMode::right);
  EXPECT_EQ(bens.walls[0].pictureNames, (std::vector<std::string>{"front-ben"}));
  const Rig swapped = read(changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['right', 'left']"));
  EXPECT_EQ(swapped.walls[0].eyes, (std::vector<ViewerEye>{{0, Eye::right}, {0, Eye::left}}));
}

TEST(Rig, AWallMayShowOnePictureToBothEyesOfEach) {
  const Rig eve = readRig(CAROM_CONFIG_DIR "/rigs/eve.toml");
  EXPECT_EQ(eve.walls.back().eyes, (std::vector<ViewerEye>{{1, Eye::middle}, {0, Eye::middle}}));
  EXPECT_EQ(sightsOf(eve, 1).back(), "sees floor (both eyes)");
  const Rig alone = rigFor(eve, "second");
  EXPECT_EQ(alone.walls.back().name, "floor");
  EXPECT_EQ(alone.walls.back().stereo, StereoMode::mono);
}

TEST(Rig, RefusesViewersWhoDoNotFitTheirWalls) {
  const std::string third = "[[viewer]]\nname = 'cleo'\ntracker = 'cap'\nsensor = 2\n";
  std::string five = roomForTwo();
  for (const char* name : {"c", "d", "e"})
    five += std::string("[[viewer]]\nname = '") + name +
            "'\ntracker = 'cap'\nsensor = " + std::to_string(name[0]) + "\n";
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {changedForTwo("sensor = 1", "sensor = 0"),
            ":10:10: viewers 'anna' and 'ben' have one sensor of tracker 'cap', expected one each"},
           {changedForTwo("name = 'ben'", "name = 'anna'"),
            "the name 'anna' is taken in line 4, expected another"},
           {changedForTwo("viewer = 'anna'\n", ""),
            "wall 'front' does not say whose eyes it shows, expected viewer = 'anna' or 'ben'"},
           {changedForTwo("viewer = 'ben'\n", "viewer = 'bob'\n"),
            "there is no viewer 'bob', expected 'anna' or 'ben'"},
           {changedForTwo("viewer = 'ben'\n", "viewer = 'anna'\n"),
            "wall 'front-ben' shows anna.left on the screen of wall 'front', which shows this eye already, "
            "expected "
            "each eye once on a screen"},
           {roomForTwo() + third,
            "no wall shows the eyes of viewer 'cleo', expected one [[wall]] at least with viewer "
            "= 'cleo'"},
           {changedForTwo("stereo = 'side-by-side'\nviewer = 'ben'", "stereo = 'left'\nviewer = 'ben'"),
            "viewer 'ben' sees the screen of wall 'front-ben' with the left eye only, expected both"},
           {changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['left']"),
            "eyes has 1 name, expected one for each of the 2 channels of 'side-by-side'"},
           {changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['left', 'up']"),
            "eyes has 'up', expected 'left', 'right', 'middle' or a viewer's, such as 'anna.left'"},
           {changedForTwo("viewer = 'anna'", "eyes = ['anna.left', 'bob.left']"),
            "eyes has 'bob.left', expected"},
           {five, "expected at most 4 in a room"},
           {roomForTwo() + "[head]\ntracker = 'cap'\n",
            "is the head of the one viewer of a room without [[viewer]], expected none"}}) {
    SCOPED_TRACE(words);
    try {
      read(text);
      ADD_FAILURE() << "was read";
    } catch (const InputErrors& error) {
      std::string all;
      for (const InputError& fault : error.faults()) all += std::string(fault.what()) + "\n";
      EXPECT_NE(all.find(words), std::string::npos) << all;
      const std::size_t at = all.find("given.toml:");
      ASSERT_LT(at, all.find('\n')) << all;
      int line = 0, column = 0;
      EXPECT_EQ(std::sscanf(all.c_str() + at, "given.toml:%d:%d: ", &line, &column), 2) << all;
    }
  }
}

}  // namespace
}  // namespace carom
