// A whole session with a headset, which a runtime of OpenXR of the test's own stands in for
// (tests/cave/xr_double.h): a head that walks and turns, strokes by hand, frames that are late, not shown,
// untracked, a headset taken off, centred anew, and at last ended by its system.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <openxr/openxr.h>

#include "app/journal/session_file.h"
#include "app/play/sculpture_hands.h"
#include "app/program.h"
#include "app/scenario/starting_histories.h"
#include "app/stage/scenario_scene.h"
#include "cave/display/display_walls.h"
#include "cave/pictures/image.h"
#include "cave/scene/kept_light.h"
#include "places.h"

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
  float stick = 0.0F;
  const char* event = "";
};

bool is(const Scripted& frame, const char* event) { return std::strcmp(frame.event, event) == 0; }

/// The hand points 45° down to the yellow puck at (0.49, 0.29) and draws the cue back from frame 30 to 60.
/// From frame 80 on the head walks to and fro beside the table, nods and turns.
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
    out << fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", f.step_ns, f.isShown, f.flags,
                       f.head_m.x, f.head_m.y, f.head_m.z, f.attitude.w, f.attitude.x, f.attitude.y,
                       f.attitude.z, f.trigger, f.hand_m.x, f.hand_m.y, f.hand_m.z, f.stick, f.event);
}

/// What the runtime was given.
struct Submitted {
  std::int64_t display_ns = 0, layers = 0, vibration = 0, ours_ns = 0, allocated = 0, isWhole = 0;
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
    get(frame.vibration);
    get(frame.ours_ns);
    get(frame.allocated);
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
    unsetenv("CAROM_XR_HABITS");
    unsetenv("LD_LIBRARY_PATH");
    unsetenv("LD_PRELOAD");
  }
  test::ProgramResult play(const std::vector<Scripted>& script, std::vector<std::string> arguments) {
    write(script, folder_ / "script");
    std::filesystem::remove(folder_ / "seen");
    arguments.insert(arguments.end(), {"--no-window", "--silent"});
    const test::ProgramResult result = test::runCarom(folder_, arguments);
    EXPECT_EQ(result.err.find("xr_double"), std::string::npos) << result.err;
    return result;
  }
  test::ProgramResult begin(const std::vector<Scripted>& script, const std::vector<std::string>& more = {},
                            const std::string& rig = "headset") {
    std::filesystem::remove(database());
    std::vector<std::string> arguments{"cave",        "--rig",     rig,       "--scenario",
                                       "three-pucks", "--session", database()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return play(script, arguments);
  }
  std::string database() const { return (folder_ / "game.db").string(); }

  test::TemporaryFolder folder_;
};

HeadsetEye eyeOf(const XrPosef& pose, const XrFovf& fov) {
  const auto tangent = [](float angle) { return std::tan(double{angle}); };
  const XrQuaternionf& q = pose.orientation;
  return {
      {{pose.position.x, pose.position.y, pose.position.z}, glm::normalize(glm::dquat(q.w, q.x, q.y, q.z))},
      {tangent(fov.angleLeft), tangent(fov.angleRight), tangent(fov.angleDown), tangent(fov.angleUp)}};
}

/// Draws two walls where an eye's display is, by the runtime's own numbers.
class ReferenceRig {
 public:
  ReferenceRig() : rig_(readRig(CAROM_CONFIG_DIR "/rigs/headset.toml")) {
    for (Wall& wall : rig_.walls) wall.pixels = kEye_px;
    scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
    scene_ = sceneOf(scenario_, tessellationFor(rig_, graphics_.inSoftware()));
    lightScene(scene_, folderOfLight());
    world_ = {reachingTo(startingHistories(scenario_), scene_.reach_m), {}};
    hung_ = wallsOf(rig_.walls);
  }

  void take(const FrameState& state) { applyFrame(state, world_); }

  /// Returns the pictures of both eyes. Walls that stand there, of a room, are made anew for each frame,
  /// which takes its time; else the same two walls are moved there.
  std::array<std::vector<std::uint8_t>, 2> draw(FrameRecord record, const Submitted& submitted, bool stand) {
    std::vector<Wall> walls = rig_.walls;
    for (std::size_t eye = 0; eye < 2; ++eye) {
      record.headset.eyes[eye] = eyeOf(submitted.eyes[eye], submitted.fov[eye]);
      place(walls[eye], submitted.eyes[eye], submitted.fov[eye]);
      Wall moved = rig_.walls[eye];
      hang(moved, record.headset.eyes[eye]);
      EXPECT_TRUE(standSame(moved, walls[eye])) << "the corners of eye " << eye;
    }
    if (!stand) return drawnOn(*hung_, record);
    record.headset = {};
    return drawnOn(*wallsOf(walls), record);
  }

 private:
  std::unique_ptr<DisplayWalls> wallsOf(const std::vector<Wall>& walls) {
    auto shown = std::make_unique<DisplayWalls>(graphics_, scene_, scenario_.billiard.lightSpeed_m_s, walls,
                                                std::nullopt, false);
    shown->setRoom(roomGeometryOf(rig_));
    shown->overlays().setOffers(offersOf(scenario_));
    return shown;
  }

  std::array<std::vector<std::uint8_t>, 2> drawnOn(DisplayWalls& walls, const FrameRecord& record) {
    walls.draw(record, world_);
    return {readBack(*walls.pictureOf(rig_.walls[0].name)).rgb,
            readBack(*walls.pictureOf(rig_.walls[1].name)).rgb};
  }

  static void place(Wall& wall, const XrPosef& pose, const XrFovf& fov) {
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
  std::unique_ptr<DisplayWalls> hung_;
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
    EXPECT_NEAR(now.viewers[0].observer.properTime_s - before.viewers[0].observer.properTime_s, steps_s[i],
                1e-12)
        << i;
    const Event from = before.viewers[0].observer.middle.observation,
                to = now.viewers[0].observer.middle.observation;
    const double dt_s = to.t_s - from.t_s, way_m = glm::distance(to.r_m, from.r_m);
    if (i == 1) continue;
    const bool isTimelike = steps_s[i] > 0.0 ? way_m < 1.42 * dt_s : way_m == 0.0 && dt_s == 0.0;
    EXPECT_TRUE(isTimelike) << i << ": " << way_m << " m in " << dt_s << " s";
  }
}

/// A table with a puck that rests.
constexpr const char* kStill =
    "title = 'Still'\nlight_speed_m_s = 1.42\n[board]\nlength_m = 2.84\nwidth_m = 1.42\n"
    "[observer]\nposition_m = [0.0, -1.6, -0.75]\nfacing_deg = 90.0\n"
    "[[puck]]\nname = 'white'\nradius_m = 0.0305\nheight_m = 0.02\nmass_kg = 0.2\nposition_m = [0.3, "
    "0.0]\nbeta = [0.0, 0.0]\n";

/// A walk with everything that a headset goes through: frames that are late, not shown, or without the head's
/// place or direction; taken off; centred anew; without the focus; and at last lost.
std::vector<Scripted> eventfulWalk() {
  std::vector<Scripted> script = walk(600);
  script[100].step_ns = 2 * kUsual_ns;  // dropped
  script[110].step_ns = 150'000'000;    // late
  script[120].step_ns = 2'000'000'000;  // the computer slept
  for (std::size_t i = 130; i < 140; ++i) script[i].isShown = 0;
  for (std::size_t i = 150; i < 154; ++i) script[i].flags = 0;
  for (std::size_t i = 160; i < 164; ++i) script[i].flags = XR_VIEW_STATE_ORIENTATION_VALID_BIT;
  script[170].event = "off";
  script[200].event = "recentre";
  for (std::size_t i = 201; i < script.size(); ++i) script[i].head_m.x += 1.0F;
  script[230].event = "unfocused";
  script[250].event = "focused";
  script[598].event = "lost";
  return script;
}

/// Returns how long the wearer has lived since the frame before, for each frame of the session, by the script
/// alone. While nobody wears it there are three frames; the last one ends the session.
std::vector<double> livedIn(const std::vector<Scripted>& script) {
  std::vector<double> steps_s{0.0};
  for (std::size_t i = 1; i < script.size(); ++i) {
    const bool isAfterPause = is(script[i - 1], "off"), isRecentred = is(script[i - 1], "recentre");
    const double step_s = 1e-9 * static_cast<double>(script[i].step_ns);
    if (isAfterPause) steps_s.insert(steps_s.end(), 3, 0.0);
    steps_s.push_back(isAfterPause || isRecentred || step_s > 0.25 ? 0.0 : step_s);
  }
  steps_s.push_back(0.0);
  return steps_s;
}

/// Compares every picture that the runtime was given with those of a rig with the same walls and eyes.
void expectSameAsRig(const std::vector<Scripted>& script, const std::vector<FrameState>& frames,
                     const std::vector<Submitted>& seen) {
  ReferenceRig reference;
  std::size_t frame = 0, compared = 0;
  for (std::size_t i = 0; i < seen.size(); ++i, ++frame) {
    if (i > 0 && is(script[i - 1], "off")) {
      for (int still = 0; still < 3; ++still) reference.take(frames[frame++]);
    }
    reference.take(frames[frame]);
    const FrameRecord& record = frames[frame].record;
    EXPECT_EQ(record.headset.isWorn, 1) << i;
    if (script[i].flags == 15) {
      EXPECT_LT(glm::distance(record.viewers[0].observer.middle.positionInRoom_m, Vec3(script[i].head_m)),
                1e-6)
          << i;
    }
    ASSERT_EQ(seen[i].layers, script[i].isShown) << i;
    if (!seen[i].isWhole) continue;
    const auto drawn = reference.draw(record, seen[i], i % 60 == 59);
    for (std::size_t eye = 0; eye < 2; ++eye)
      ASSERT_EQ(drawn[eye], withoutAlpha(seen[i].rgba[eye])) << i << ", eye " << eye;
    ASSERT_NE(drawn[0], drawn[1]) << i;
    ++compared;
  }
  EXPECT_EQ(compared, 589U) << "all but those that are not shown, and the lost one";
}

/// A session leaves out pictures that come faster than a busy machine writes them; a replay waits for its
/// disk.
void expectSamePictures(const std::filesystem::path& live, const std::filesystem::path& again) {
  std::ptrdiff_t pictures = 0;
  for (const auto& picture : std::filesystem::directory_iterator(live)) {
    ++pictures;
    ASSERT_EQ(test::contentOf(picture.path()), test::contentOf(again / picture.path().filename()))
        << picture.path();
  }
  EXPECT_GT(pictures, 0);
  EXPECT_LE(pictures, std::distance(std::filesystem::directory_iterator(again), {}));
}

TEST_F(HeadsetSession, EveryFrameIsWhatARigWithTheSameWallsAndEyesShows) {
  std::vector<Scripted> script = eventfulWalk();
  const std::string live = (folder_ / "live").string();
  const test::ProgramResult played = begin(script, {"--capture", live});
  ASSERT_EQ(played.status, 0) << played.err;
  for (const char* words :
       {"A headset of a script", "a frame came 150 ms after the one before, expected one every 11",
        "is taken off: time stands still", "is worn again", "the headset is lost"})
    EXPECT_NE(played.err.find(words), std::string::npos) << words << ": " << played.err;
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  std::vector<FrameState> frames = framesIn(database());
  script.pop_back();  // in which it is lost
  ASSERT_EQ(seen.size(), script.size());
  expectSameAsRig(script, frames, seen);
  std::vector<double> steps_s = livedIn(script);
  expectLived(frames, steps_s);
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  const std::vector<Stroke> strokes = SessionFile(database()).strokes(scenario.billiard.pucks);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(scenario.billiard.pucks[strokes[0].puck].name, "yellow");
  EXPECT_GT(strokes[0].momentum_kg_m_s.y, 0.0) << "away from whoever drew back";

  const test::ProgramResult resumed =
      play(walk(50), {"cave", "--session", database(), "--resume", "--capture", live});
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("has ended the session"), std::string::npos) << resumed.err;
  const std::vector<double> after_s = livedIn(walk(50));
  steps_s.insert(steps_s.end(), after_s.begin(), after_s.end());
  frames = framesIn(database());
  expectLived(frames, steps_s);
  EXPECT_NEAR(frames.back().record.viewers[0].observer.properTime_s,
              std::accumulate(steps_s.begin(), steps_s.end(), 0.0), 1e-9);

  const std::string again = (folder_ / "again").string();
  const test::ProgramResult replayed = play({}, {"replay", database(), "--capture", again});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  expectSamePictures(live, again);
}

TEST_F(HeadsetSession, SoftPucksAreSeenAndReplayed) {
  const std::string live = (folder_ / "live").string(), again = (folder_ / "again").string();
  const test::ProgramResult played =
      play(walk(80), {"cave", "--rig", "headset", "--scenario", "jellies", "--session", database(),
                      "--capture", live, "--view", "my-now", "--view", "strain"});
  ASSERT_EQ(played.status, 0) << played.err;
  const test::ProgramResult replayed = play({}, {"replay", database(), "--capture", again});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  expectSamePictures(live, again);
}

TEST_F(HeadsetSession, WhatARuntimeLacksOrDoesWrongIsSaidAndTheSessionGoesOn) {
  std::vector<Scripted> script = walk(96);
  for (Scripted& frame : script) frame.flags = XR_VIEW_STATE_ORIENTATION_VALID_BIT;
  script[93].step_ns = 150'000'000;
  setenv("CAROM_XR_HABITS", "no-srgb no-velocity no-hands", 1);
  ASSERT_EQ(begin(script).status, 0);
  const std::vector<Submitted> polite = submittedIn(folder_ / "seen");
  setenv("CAROM_XR_HABITS", "no-srgb no-velocity no-hands rude", 1);
  const test::ProgramResult played = begin(script);
  ASSERT_EQ(played.status, 0) << played.err;
  for (const char* words : {"takes no sRGB pictures", "knows directions and no places", "No hand is followed",
                            "gives no velocity", "a frame came 150 ms after"})
    EXPECT_NE(played.err.find(words), std::string::npos) << words << ": " << played.err;
  const std::vector<Submitted> rude = submittedIn(folder_ / "seen");
  ASSERT_EQ(rude.size(), polite.size());
  for (std::size_t i = 0; i < rude.size(); ++i)
    ASSERT_EQ(rude[i].rgba, polite[i].rgba) << i << ": a context taken away, and errors left behind";
  const std::vector<FrameState> frames = framesIn(database());
  expectLived(frames, livedIn(script));
  EXPECT_EQ(frames.back().record.headset.velocityKnown, 0);
  for (const FrameState& frame : frames)
    EXPECT_NEAR(frame.record.viewers[0].observer.middle.positionInRoom_m.y, 1.7, 1e-6) << frame.record.number;
}

TEST_F(HeadsetSession, BareHandsStrikeAsControllersDo) {
  const std::vector<Puck> pucks = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml").billiard.pucks;
  std::vector<Stroke> strokes;
  for (const char* habits : {"", "bare-hands"}) {
    setenv("CAROM_XR_HABITS", habits, 1);
    const test::ProgramResult played = begin(walk(65));
    ASSERT_EQ(played.status, 0) << played.err;
    const std::vector<Stroke> ofOne = SessionFile(database()).strokes(pucks);
    ASSERT_EQ(ofOne.size(), 1U) << habits;
    strokes.push_back(ofOne.front());
    const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
    EXPECT_EQ(seen[25].vibration, 0) << "before the cue is held";
    EXPECT_GT(seen[55].vibration, 0) << "it trembles as it is drawn back";
    EXPECT_LT(seen[55].vibration, 500);
    EXPECT_EQ(seen[61].vibration, 1000) << "the stroke";
  }
  EXPECT_EQ(strokes[0].puck, strokes[1].puck);
  EXPECT_EQ(strokes[0].momentum_kg_m_s, strokes[1].momentum_kg_m_s);
}

/// A hand that points 45° down at `at_m` from frame 10 on, presses from 20 to 60 and moves by `pull_m`
/// meanwhile.
std::vector<Scripted> pulling(const glm::vec3& at_m, const glm::vec3& pull_m, std::size_t frames) {
  std::vector<Scripted> script = walk(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    const bool isPressed = i >= 20 && i < 60;
    const float share = isPressed ? static_cast<float>(i - 20) / 40.0F : i < 20 ? 0.0F : 1.0F;
    script[i].trigger = isPressed ? 1.0F : 0.0F;
    script[i].hand_m = at_m + glm::vec3(0.0F, 0.5F, 0.5F) + share * pull_m;
  }
  return script;
}

TEST_F(HeadsetSession, AHandBoostsAndMovesSpacetime) {
  ASSERT_EQ(begin(walk(4), {"--view", "spacetime"}).status, 0);
  const SculpturePlace place = framesIn(database()).back().record.sculpture.place;
  const double present_m = place.scale * 1.42 * place.past_s;
  const auto inRoom_m = [&](const Vec3& ownPlace_m) { return glm::vec3(place.roomFromFoot * ownPlace_m); };
  const glm::vec3 ring_m = inRoom_m({kSculptureRing_m * place.scale, 0.0, present_m});

  const std::vector<Scripted> script = pulling(ring_m, {0.2F, 0.0F, 0.0F}, 70);
  const test::ProgramResult boosted = begin(script, {"--view", "spacetime"});
  ASSERT_EQ(boosted.status, 0) << boosted.err;
  EXPECT_NE(boosted.err.find("The glass is shown as somebody at 0."), std::string::npos) << boosted.err;
  const std::vector<FrameState> frames = framesIn(database());
  EXPECT_EQ(frames[15].record.sculpture.place.beta, Vec3(0.0));
  EXPECT_EQ(frames[40].record.sculpture.held, 1);
  EXPECT_EQ(frames.back().record.sculpture.held, 0);
  const Vec3 beta = frames.back().record.sculpture.place.beta;
  const double pulled_m = 0.2 * 39.0 / 40.0;
  EXPECT_NEAR(glm::length(beta), std::tanh(pulled_m / SculptureHands::kRapidity_m), 0.02);
  EXPECT_EQ(SessionFile(database())
                .strokes(readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml").billiard.pucks)
                .size(),
            0U)
      << "the hand is the sculpture's";

  // Every picture is that of a rig with the same walls and eyes.
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  ASSERT_EQ(seen.size(), script.size());
  ReferenceRig reference;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    reference.take(frames[i]);
    const auto drawn = reference.draw(frames[i].record, seen[i], false);
    for (std::size_t eye = 0; eye < 2; ++eye)
      ASSERT_EQ(drawn[eye], withoutAlpha(seen[i].rgba[eye])) << i << ", eye " << eye;
  }

  // Pulled further than it can be boosted, that is said; a hand at its foot moves it.
  const test::ProgramResult limited = begin(pulling(ring_m, {3.0F, 0.0F, 0.0F}, 70), {"--view", "spacetime"});
  EXPECT_NE(limited.err.find("The glass is shown up to 0.95 c, and no faster"), std::string::npos)
      << limited.err;
  EXPECT_NEAR(glm::length(framesIn(database()).back().record.sculpture.place.beta), kMostSculptureBeta, 1e-9);
  ASSERT_EQ(
      begin(pulling(inRoom_m({0.0, 0.0, 0.03}), {0.0F, 0.0F, -0.3F}, 70), {"--view", "spacetime"}).status, 0);
  const Vec3 moved_m = framesIn(database()).back().record.sculpture.place.roomFromFoot.position_m -
                       place.roomFromFoot.position_m;
  EXPECT_LT(glm::length(moved_m - Vec3(0.0, 0.0, -0.3 * 39.0 / 40.0)), 0.02) << moved_m.x << ' ' << moved_m.z;
}

/// Returns the pixel of an eye's picture, as a fraction of its size from below, that shows a place of the
/// room.
glm::dvec2 shownAt(const Submitted& frame, std::size_t eye, const glm::dvec3& place_m) {
  const XrPosef& pose = frame.eyes[eye];
  const glm::dquat q(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  const glm::dvec3 seen_m =
      glm::conjugate(q) * (place_m - glm::dvec3(pose.position.x, pose.position.y, pose.position.z));
  const auto share = [&](double along_m, float from, float to) {
    const double least = std::tan(double{from}), most = std::tan(double{to});
    return (along_m / -seen_m.z - least) / (most - least);
  };
  return {share(seen_m.x, frame.fov[eye].angleLeft, frame.fov[eye].angleRight),
          share(seen_m.y, frame.fov[eye].angleDown, frame.fov[eye].angleUp)};
}

/// Expects that two pictures differ, but only between these corners.
void expectDifferBetween(const Submitted& a, const Submitted& b, std::size_t eye,
                         const glm::dvec3& lowerLeft_m, const glm::dvec3& upperRight_m) {
  const glm::dvec2 least = shownAt(a, eye, lowerLeft_m), most = shownAt(a, eye, upperRight_m);
  constexpr double kPixel = 1.0 / 60.0;
  std::size_t inside = 0;
  for (int y = 0; y < kEye_px.y; ++y) {
    for (int x = 0; x < kEye_px.x; ++x) {
      const auto at = static_cast<std::size_t>(4 * (y * kEye_px.x + x));
      if (std::equal(&a.rgba[eye][at], &a.rgba[eye][at + 4], &b.rgba[eye][at])) continue;
      const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) / glm::dvec2(kEye_px);
      EXPECT_TRUE(glm::all(glm::greaterThan(place, least - kPixel)) &&
                  glm::all(glm::lessThan(place, most + kPixel)))
          << "eye " << eye << ": " << x << ", " << y;
      ++inside;
    }
  }
  EXPECT_GT(inside, 50U) << "eye " << eye;
}

TEST_F(HeadsetSession, TheWordsOfALessonStandOnTheBoardForBothEyes) {
  const std::string there = test::contentOf(CAROM_CONFIG_DIR "/rigs/headset.toml");
  std::vector<Scripted> script = walk(12);
  for (Scripted& frame : script) frame.attitude = {1, 0, 0, 0};
  std::vector<Submitted> seen;
  for (const double lower_m : {1.2, 101.2}) {  // the second one is out of sight
    std::string text = there;
    const std::size_t at = text.find("board = {");
    text.replace(at, text.find('\n', at) - at,
                 fmt::format("board = {{ lower_left = [-1.2, {0}, -2.4], lower_right = [1.2, {0}, -2.4], "
                             "upper_left = [-1.2, {1}, -2.4] }}",
                             lower_m, lower_m + 1.5));
    const auto rig = folder_.file("rig.toml", text);
    const test::ProgramResult played =
        play(script, {"cave", "--rig", rig.string(), "--scenario", "angles", "--lesson", "asks"});
    ASSERT_EQ(played.status, 0) << played.err;
    seen.push_back(submittedIn(folder_ / "seen").back());
  }
  for (std::size_t eye = 0; eye < 2; ++eye)
    expectDifferBetween(seen[0], seen[1], eye, {-1.2, 1.2, -2.4}, {1.2, 2.7, -2.4});
}

TEST_F(HeadsetSession, TheEdgesOfSightDarkenWhileTheRoomIsDriven) {
  std::vector<Scripted> script = walk(60);
  for (std::size_t i = 0; i < script.size(); ++i) {
    script[i].trigger = 0.0F;
    script[i].stick = i < 10 ? 0.0F : 1.0F;
  }
  std::vector<std::vector<Submitted>> seen;
  std::string text = test::contentOf(CAROM_CONFIG_DIR "/rigs/headset.toml");
  for (const char* aids : {"true", "false"}) {
    const std::size_t at = text.find("aids = ");
    text.replace(at, text.find('\n', at) - at, std::string("aids = ") + aids);
    const test::ProgramResult played = begin(script, {}, folder_.file("rig.toml", text).string());
    ASSERT_EQ(played.status, 0) << played.err;
    seen.push_back(submittedIn(folder_ / "seen"));
  }
  const auto brightness = [](const Submitted& frame, glm::ivec2 from, glm::ivec2 to) {
    double sum = 0.0;
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x)
        sum += frame.rgba[0][static_cast<std::size_t>(4 * (y * kEye_px.x + x) + 1)];
    }
    return sum;
  };
  EXPECT_EQ(seen[0][9].rgba, seen[1][9].rgba) << "at rest";
  const glm::ivec2 corner(8), middle = kEye_px / 2;
  EXPECT_LT(brightness(seen[0].back(), {0, 0}, corner), 0.7 * brightness(seen[1].back(), {0, 0}, corner));
  EXPECT_EQ(brightness(seen[0].back(), middle - 4, middle + 4),
            brightness(seen[1].back(), middle - 4, middle + 4));
}

// Lists grow as more comes into sight than ever before. On the way back the head sees again what it has seen.
TEST_F(HeadsetSession, ASteadyFrameAllocatesNothing) {
  std::vector<Scripted> script = walk(150);
  for (Scripted& frame : script) frame.trigger = 0.0F;
  script.insert(script.end(), script.rbegin(), script.rbegin() + 60);
  setenv("LD_PRELOAD", CAROM_COUNTED_NEW, 1);
  const test::ProgramResult played =
      play(script, {"cave", "--rig", "headset", "--scenario", folder_.file("still.toml", kStill).string()});
  unsetenv("LD_PRELOAD");
  ASSERT_EQ(played.status, 0) << played.err;
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  ASSERT_EQ(seen.size(), script.size());
  EXPECT_GT(seen[0].allocated, 10'000) << "nobody counts";
  for (std::size_t i = 155; i < seen.size(); ++i) EXPECT_EQ(seen[i].allocated, 0) << i;
}

std::vector<std::uint8_t> bytesIn(const std::filesystem::path& picture) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture.c_str());
  reader->Update();
  vtkDataArray* pixels = reader->GetOutput()->GetPointData()->GetScalars();
  std::vector<std::uint8_t> bytes;
  for (vtkIdType i = 0; pixels && i < pixels->GetNumberOfValues(); ++i)
    bytes.push_back(static_cast<std::uint8_t>(pixels->GetVariantValue(i).ToInt()));
  return bytes;
}

/// Returns by how much the bytes of two pictures differ, of 255.
double meanDifference(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::vector<std::uint8_t> one = bytesIn(a), other = bytesIn(b);
  if (one.empty() || one.size() != other.size()) return 255.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) sum += std::abs(int{one[i]} - int{other[i]});
  return sum / static_cast<double>(one.size());
}

TEST_F(HeadsetSession, OthersWalkInARecordedGame) {
  ASSERT_EQ(begin(walk(60), {"--capture", (folder_ / "live").string()}).status, 0);
  const test::ProgramResult played = play(walk(30), {"replay", database(), "--rig", "headset"});
  ASSERT_EQ(played.status, 0) << played.err;
  const std::vector<Submitted> seen = submittedIn(folder_ / "seen");
  ASSERT_EQ(seen.size(), 30U);
  const auto& rgba = seen[29].rgba[0];
  EXPECT_NE(std::count(rgba.begin(), rgba.end(), rgba[0]), static_cast<std::ptrdiff_t>(rgba.size()))
      << "no picture";

  // Whoever stands where the wearer stood and looks the same way sees the same, without a headset.
  std::string trace = "time_s,x_m,y_m,z_m,qx,qy,qz,qw\n";
  const glm::quat q = walk(1)[0].attitude;
  const glm::vec3 head_m = walk(1)[0].head_m;
  for (int i = 0; i <= 30; ++i)
    trace +=
        fmt::format("{},{},{},{},{},{},{},{}\n", i / 60.0, head_m.x, head_m.y, head_m.z, q.x, q.y, q.z, q.w);
  const std::string pictures = (folder_ / "observed").string();
  const test::ProgramResult observed =
      play({}, {"replay", database(), "--observer", folder_.file("stands.csv", trace).string(), "--capture",
                pictures});
  ASSERT_EQ(observed.status, 0) << observed.err;
  // A busy machine leaves pictures of the live session out.
  const auto isThere = [&](int frame) {
    return std::filesystem::exists(folder_ / "live" / fmt::format("headset-right-{:06}.png", frame));
  };
  int frame = 29;
  while (frame > 0 && !isThere(frame)) --frame;
  ASSERT_GT(frame, 0) << "every picture was left out";
  for (const std::string& name :
       {fmt::format("headset-left-{:06}.png", frame), fmt::format("headset-right-{:06}.png", frame)})
    EXPECT_LT(meanDifference(folder_ / "observed" / name, folder_ / "live" / name), 1.0) << name;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "seen")) << "a headset was asked for";
}

TEST_F(HeadsetSession, WhatIsMissingIsSaidInALine) {
  const auto says = [&](const char* words) {
    const test::ProgramResult played = begin(walk(1));
    EXPECT_NE(played.status, 0);
    EXPECT_EQ(played.err.find(std::string("error: ") + words), 0U) << played.err;
    EXPECT_EQ(std::count(played.err.begin(), played.err.end(), '\n'), 1) << played.err;
  };
  const auto doctorSays = [&](const char* words) {
    const test::ProgramResult doctor = test::runCarom(folder_, {"doctor"});
    EXPECT_NE(doctor.out.find(std::string("\nheadset    ") + words), std::string::npos) << doctor.out;
  };
  setenv("CAROM_XR_HABITS", "no-headset", 1);
  says("no headset is connected");
  setenv("CAROM_XR_HABITS", "no-opengl", 1);
  says("the headset's runtime lacks XR_KHR_opengl_enable");
  setenv("CAROM_XR_HABITS", "no-8-bits", 1);
  says("the headset's runtime takes no pictures of 8 bits");
  doctorSays("A headset of a script, by A runtime for tests 1.2.3");
  setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
  says("no OpenXR runtime is active");
  folder_.file("libopenxr_loader.so.1", "not a library");
  setenv("LD_LIBRARY_PATH", (folder_ / "").c_str(), 1);
  says("there is no OpenXR loader");
  doctorSays("there is no OpenXR loader, expected the package libopenxr-loader1");
}

}  // namespace
}  // namespace carom
