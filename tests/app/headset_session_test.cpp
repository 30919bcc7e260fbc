// A whole session with a headset, which a runtime of OpenXR of the test's own stands in for (tests/cave/xr_double.h): a
// head that walks and turns, strokes by hand, frames that are late, not shown, untracked, a headset taken off, centred
// anew, and at last ended by its system.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <openxr/openxr.h>

#include "app/files/starting_histories.h"
#include "app/journal/session_file.h"
#include "app/program.h"
#include "app/stage/scenario_scene.h"
#include "cave/display/display_walls.h"
#include "cave/gl/image.h"
#include "cave/scene/kept_light.h"

namespace carom {
namespace {

constexpr std::int64_t kUsual_ns = 11'111'111;
constexpr glm::ivec2 kEye_px{64, 72};

/// A frame of the script.
struct Scripted {
  std::int64_t step_ns = kUsual_ns;
  int isShown = 1;
  XrViewStateFlags flags = 15;
  glm::vec3 head_m{0.0F};
  glm::quat attitude{1, 0, 0, 0};
  float trigger = 0.0F;
  glm::vec3 hand_m{0.0F};
  const char* event = "";
};

bool is(const Scripted& frame, const char* event) { return std::strcmp(frame.event, event) == 0; }

/// The hand points 45° down to the yellow puck at (0.49, 0.29) and draws the cue back from frame 30 to 60. From frame 80
/// on the head walks to and fro beside the table, nods and turns.
std::vector<Scripted> walk(std::size_t frames) {
  std::vector<Scripted> script(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    Scripted& frame = script[i];
    const float t_s = static_cast<float>(i < 80 ? 0 : i - 80) / 90.0F;
    frame.head_m = {0.3F * std::sin(1.3F * t_s), 1.65F + 0.02F * std::sin(5.0F * t_s),
                    0.1F * std::cos(0.9F * t_s)};
    frame.attitude = glm::angleAxis(0.4F * std::sin(0.7F * t_s), glm::vec3(0, 1, 0)) *
                     glm::angleAxis(-0.4F + 0.1F * std::sin(1.1F * t_s), glm::vec3(1, 0, 0));
    const bool isPulled = i >= 30 && i < 60;
    frame.trigger = isPulled ? 1.0F : 0.0F;
    frame.hand_m = {0.49F, 1.25F, -1.39F + (isPulled ? 0.01F * static_cast<float>(i - 30) : 0.0F)};
  }
  return script;
}

void write(const std::vector<Scripted>& script, const std::filesystem::path& file) {
  std::ofstream out(file);
  for (const Scripted& f : script)
    out << fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", f.step_ns, f.isShown, f.flags,
                       f.head_m.x, f.head_m.y, f.head_m.z, f.attitude.w, f.attitude.x, f.attitude.y,
                       f.attitude.z, f.trigger, f.hand_m.x, f.hand_m.y, f.hand_m.z, f.event);
}

/// What the runtime was given.
struct Submitted {
  std::int64_t display_ns = 0, layers = 0, isWhole = 0;
  std::array<XrPosef, 2> eyes{};
  std::array<XrFovf, 2> fov{};
  std::array<std::vector<std::uint8_t>, 2> rgba;
};

std::vector<Submitted> submittedIn(const std::filesystem::path& file) {
  std::vector<Submitted> all;
  std::ifstream in(file, std::ios::binary);
  const auto get = [&](auto& value) { return bool(in.read(reinterpret_cast<char*>(&value), sizeof value)); };
  for (Submitted frame; get(frame.display_ns);) {
    get(frame.layers);
    get(frame.isWhole);
    for (std::size_t eye = 0; eye < 2 && frame.isWhole; ++eye) {
      get(frame.eyes[eye]);
      get(frame.fov[eye]);
      frame.rgba[eye].resize(4 * kEye_px.x * kEye_px.y);
      in.read(reinterpret_cast<char*>(frame.rgba[eye].data()),
              static_cast<std::streamsize>(frame.rgba[eye].size()));
    }
    all.push_back(frame);
  }
  return all;
}

std::vector<FrameState> framesIn(const std::filesystem::path& file) {
  SessionFile session(file);
  std::vector<FrameState> frames;
  for (FrameState state; session.next(state);) frames.push_back(state);
  return frames;
}

class HeadsetSession : public ::testing::Test {
 protected:
  HeadsetSession() {
    setenv("XR_RUNTIME_JSON", CAROM_XR_MANIFEST, 1);
    setenv("CAROM_XR_SCRIPT", (folder_ / "script").c_str(), 1);
    setenv("CAROM_XR_SEEN", (folder_ / "seen").c_str(), 1);
  }
  test::ProgramResult play(const std::vector<Scripted>& script, std::vector<std::string> arguments) {
    write(script, folder_ / "script");
    std::filesystem::remove(folder_ / "seen");
    arguments.insert(arguments.end(), {"--no-window", "--silent"});
    const test::ProgramResult result = test::runCarom(folder_, arguments);
    EXPECT_EQ(result.err.find("xr_double"), std::string::npos) << result.err;
    return result;
  }
  test::ProgramResult begin(const std::vector<Scripted>& script, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"cave",        "--rig",     "headset", "--scenario",
                                       "three-pucks", "--session", database()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return play(script, arguments);
  }
  std::string database() const { return (folder_ / "game.db").string(); }

  test::TemporaryFolder folder_;
};

/// Draws two walls that stand in the room where an eye's display is, by the runtime's own numbers.
class ReferenceRig {
 public:
  ReferenceRig() : rig_(readRig(CAROM_CONFIG_DIR "/rigs/headset.toml")) {
    for (Wall& wall : rig_.walls) wall.pixels = kEye_px;
    scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
    scene_ = sceneOf(scenario_, tessellationFor(rig_, graphics_.inSoftware()));
    lightScene(scene_, folderOfLight());
    world_ = {reachingTo(startingHistories(scenario_), scene_.reach_m), {}};
  }

  void take(const FrameState& state) { applyFrame(state, world_); }

  /// Returns the pictures of both eyes.
  std::array<std::vector<std::uint8_t>, 2> draw(FrameRecord record, const Submitted& submitted) {
    std::vector<Wall> walls = rig_.walls;
    for (std::size_t eye = 0; eye < 2; ++eye) stand(walls[eye], submitted.eyes[eye], submitted.fov[eye]);
    DisplayWalls shown(graphics_, scene_, scenario_.billiard.lightSpeed_m_s, walls, {}, false);
    shown.setRoom(roomGeometryOf(rig_));
    shown.setTable(scenario_.billiard.board.has_value());
    record.headset = {};  // the walls stand
    shown.draw(record, world_);
    return {readBack(*shown.pictureOf(walls[0].name)).rgb, readBack(*shown.pictureOf(walls[1].name)).rgb};
  }

 private:
  static void stand(Wall& wall, const XrPosef& pose, const XrFovf& fov) {
    const glm::dquat q = glm::normalize(
        glm::dquat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z));
    const glm::dvec3 place_m(pose.position.x, pose.position.y, pose.position.z);
    const auto corner = [&](float x, float y) {
      return place_m + q * glm::dvec3(std::tan(double{x}), std::tan(double{y}), -1.0);
    };
    wall.lowerLeft_m = corner(fov.angleLeft, fov.angleDown);
    wall.lowerRight_m = corner(fov.angleRight, fov.angleDown);
    wall.upperLeft_m = corner(fov.angleLeft, fov.angleUp);
  }

  Graphics graphics_;
  Rig rig_;
  Scenario scenario_;
  Scene scene_;
  World world_;
};

std::vector<std::uint8_t> withoutAlpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 != 3) rgb.push_back(rgba[i]);
  }
  return rgb;
}

/// Returns what is wrong with the frames' times and ways, by the steps of the runtime's display times.
void expectLived(const std::vector<FrameState>& frames, const std::vector<double>& steps_s) {
  ASSERT_EQ(frames.size(), steps_s.size());
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const FrameRecord &before = frames[i - 1].record, &now = frames[i].record;
    EXPECT_NEAR(now.observer.properTime_s - before.observer.properTime_s, steps_s[i], 1e-12) << i;
    const Event from = before.observer.middle.observation, to = now.observer.middle.observation;
    const double dt_s = to.t_s - from.t_s, way_m = glm::distance(to.r_m, from.r_m);
    if (i == 1) continue;
    const bool isTimelike = steps_s[i] > 0.0 ? way_m < 1.42 * dt_s : way_m == 0.0 && dt_s == 0.0;
    EXPECT_TRUE(isTimelike) << i << ": " << way_m << " m in " << dt_s << " s";
  }
}

TEST_F(HeadsetSession, EveryFrameIsWhatARigWithTheSameWallsAndEyesShows) {
  const std::vector<Scripted> script = walk(600);
  const test::ProgramResult played = begin(script, {"--capture", (folder_ / "live").string()});
  ASSERT_EQ(played.status, 0) << played.err;
  EXPECT_NE(played.err.find("A headset of a script"), std::string::npos) << played.err;
  EXPECT_NE(played.err.find("has ended the session"), std::string::npos) << played.err;

  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  const std::vector<FrameState> frames = framesIn(database());
  ASSERT_EQ(seen.size(), script.size());
  ASSERT_EQ(frames.size(), script.size() + 1) << "and one that ends the session";
  ReferenceRig reference;
  for (std::size_t i = 0; i < script.size(); ++i) {
    const FrameRecord& record = frames[i].record;
    reference.take(frames[i]);
    EXPECT_EQ(record.headset.isWorn, 1) << i;
    const Vec3 head_m = record.observer.middle.positionInRoom_m;
    EXPECT_LT(glm::distance(head_m, Vec3(script[i].head_m)), 1e-6) << i;
    if (i % 120 != 119) continue;
    const auto drawn = reference.draw(record, seen[i]);
    for (std::size_t eye = 0; eye < 2; ++eye)
      EXPECT_EQ(drawn[eye], withoutAlpha(seen[i].rgba[eye])) << i << ", eye " << eye;
    EXPECT_NE(drawn[0], drawn[1]) << i;
  }
  std::vector<double> steps_s(frames.size(), 1e-9 * kUsual_ns);
  steps_s.front() = steps_s.back() = 0.0;
  expectLived(frames, steps_s);
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  const std::vector<Stroke> strokes = SessionFile(database()).strokes(scenario.billiard.pucks);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(scenario.billiard.pucks[strokes[0].puck].name, "yellow");
  EXPECT_GT(strokes[0].momentum_kg_m_s.y, 0.0) << "away from whoever drew back";

  const test::ProgramResult replayed =
      play({}, {"replay", database(), "--at", "6.5", "--capture", (folder_ / "again").string()});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  std::size_t pictures = 0;
  for (const auto& picture : std::filesystem::directory_iterator(folder_ / "again")) {
    ++pictures;
    EXPECT_EQ(test::contentOf(picture.path()), test::contentOf(folder_ / "live" / picture.path().filename()))
        << picture.path();
  }
  EXPECT_GT(pictures, 20U);
}

TEST_F(HeadsetSession, TimeIsThatOfTheDisplaysAndStandsStillForWhoeverTakesItOff) {
  std::vector<Scripted> script = walk(200);
  script[20].step_ns = 2 * kUsual_ns;  // dropped
  script[30].step_ns = 150'000'000;    // late
  script[40].step_ns = 2'000'000'000;  // the computer slept
  for (std::size_t i = 50; i < 60; ++i) script[i].isShown = 0;
  for (std::size_t i = 70; i < 74; ++i) script[i].flags = 0;
  script[90].event = "off";
  script[120].event = "recentre";
  for (std::size_t i = 121; i < script.size(); ++i) script[i].head_m.x += 1.0F;
  script[140].event = "unfocused";
  script[150].event = "focused";
  const test::ProgramResult played = begin(script);
  ASSERT_EQ(played.status, 0) << played.err;
  EXPECT_NE(played.err.find("is taken off: time stands still"), std::string::npos) << played.err;
  EXPECT_NE(played.err.find("is worn again"), std::string::npos) << played.err;

  const std::vector<FrameState> frames = framesIn(database());
  std::vector<double> steps_s{0.0};
  for (std::size_t i = 1; i < script.size(); ++i) {
    const bool isAfterPause = is(script[i - 1], "off"), isRecentred = is(script[i - 1], "recentre");
    const double step_s = 1e-9 * static_cast<double>(script[i].step_ns);
    if (isAfterPause) steps_s.insert(steps_s.end(), 3, 0.0);  // nobody wears it
    steps_s.push_back(isAfterPause || isRecentred || step_s > 0.25 ? 0.0 : step_s);
  }
  steps_s.push_back(0.0);
  expectLived(frames, steps_s);
  double sum_s = 0.0;
  for (const double step_s : steps_s) sum_s += step_s;
  EXPECT_NEAR(frames.back().record.observer.properTime_s, sum_s, 1e-9);
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  ASSERT_EQ(seen.size(), script.size());
  for (std::size_t i = 0; i < script.size(); ++i) EXPECT_EQ(seen[i].layers, script[i].isShown) << i;
}

TEST_F(HeadsetSession, ALostHeadsetEndsASessionThatGoesOnWithAnother) {
  std::vector<Scripted> script = walk(40);
  script[30].event = "lost";
  const test::ProgramResult played = begin(script);
  EXPECT_EQ(played.status, 0) << played.err;
  EXPECT_NE(played.err.find("the headset is lost"), std::string::npos) << played.err;
  const std::size_t before = framesIn(database()).size();
  EXPECT_EQ(before, 32U);
  const test::ProgramResult again = play(walk(50), {"cave", "--session", database(), "--resume"});
  ASSERT_EQ(again.status, 0) << again.err;
  const std::vector<FrameState> frames = framesIn(database());
  ASSERT_EQ(frames.size(), before + 51);
  std::vector<double> steps_s(frames.size(), 1e-9 * kUsual_ns);
  for (const std::size_t still : {std::size_t{0}, before - 1, before, frames.size() - 1})
    steps_s[still] = 0.0;
  expectLived(frames, steps_s);
}

TEST_F(HeadsetSession, WhoeverWearsItWalksInARecordedGame) {
  ASSERT_EQ(begin(walk(60)).status, 0);
  const test::ProgramResult played = play(walk(30), {"replay", database(), "--rig", "headset"});
  ASSERT_EQ(played.status, 0) << played.err;
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  ASSERT_EQ(seen.size(), 30U);
  const auto& rgba = seen[29].rgba[0];
  EXPECT_NE(std::count(rgba.begin(), rgba.end(), rgba[0]), static_cast<std::ptrdiff_t>(rgba.size()))
      << "no picture";
}

TEST_F(HeadsetSession, WhatIsMissingIsSaidInALine) {
  setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
  const test::ProgramResult played = begin(walk(1));
  EXPECT_NE(played.status, 0);
  EXPECT_EQ(played.err.find("error: no OpenXR runtime is active"), 0U) << played.err;
  EXPECT_EQ(played.err.find("Loader"), std::string::npos) << played.err;
  const test::ProgramResult doctor = test::runCarom(folder_, {"doctor"});
  EXPECT_NE(doctor.out.find("\nheadset    no OpenXR runtime is active"), std::string::npos) << doctor.out;
}

}  // namespace
}  // namespace carom
