// A game as it is seen in the windows of curved screens and in pictures by direction, against the same moment
// on flat walls all round the eye: each pixel of a window shows what a flat wall shows in the direction of
// the pixel's own point of the true surface, within three quarters of a pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "app/rig/rig.h"
#include "app/room_formats/mpcdi_file.h"
#include "app/scenario/scenario.h"
#include "app/stage/scenario_scene.h"
#include "app/temporary_folder.h"
#include "cave/display/wall_pictures.h"
#include "cave/frame/bodies.h"
#include "cave/gl/graphics.h"
#include "cave/mesh_files/measured_bytes.h"
#include "cave/pictures/image.h"
#include "cave/screen/sky_screen.h"
#include "cave/screen/true_screens.h"
#include "engine/billiard/billiard.h"
#include "places.h"

namespace carom {
namespace {

using namespace test;

constexpr double kShift_px = 0.75;
constexpr int kReference_px = 1500;  // of a flat wall of 90 degrees: about three of a window's pixel

/// A wall that is not flat, and the direction that each place of its window shows to an eye; zero: none.
struct Bent {
  std::string name;
  Wall wall;
  std::function<glm::dvec3(const glm::dvec2& inWindow, const glm::dvec3& eye_m)> direction;
};

Bent bent(const TrueScreen& screen, StereoMode stereo) {
  Bent result{screen.name, {}, {}};
  result.wall.name = "bent";
  result.wall.pixels = screen.window_px;
  result.wall.stereo = stereo;
  result.wall.screen = std::make_shared<CurvedScreen>(curved(screen));
  result.direction = [screen](const glm::dvec2& place, const glm::dvec3& eye_m) {
    return screen.isScreen(place) ? screen.placeOn_m(place) - eye_m : glm::dvec3(0.0);
  };
  return result;
}

Bent bent(SkyKind kind, const glm::ivec2& picture_px) {
  const Sky sky{kind, std::numbers::pi, {0, 1, 0}, {0, 0, -1}, {0.0, 1.7, 0.0}};
  Bent result{std::string(kSkyKinds[static_cast<std::size_t>(kind)]), {}, {}};
  result.wall.name = "bent";
  result.wall.pixels = picture_px;
  result.wall.screen = std::make_shared<CurvedScreen>(screenOf(sky, picture_px, 1.25));
  result.wall.sky = SkyEyes{{}, {1, 0, 0}};
  result.direction = [sky, picture_px](const glm::dvec2& place, const glm::dvec3&) {
    if (sky.kind == SkyKind::fisheye && glm::length(2.0 * place - 1.0) > 0.99) return glm::dvec3(0.0);
    return directionOf(sky, place, picture_px);
  };
  return result;
}

/// Right, up and away of six flat walls round an eye, a metre away.
struct Facing {
  glm::dvec3 right, up, away;
};
const std::array<Facing, 6> kFacings{{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                                      {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
                                      {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                      {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
                                      {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                      {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}}};

std::vector<Wall> flatWallsAround(const glm::dvec3& eye_m, StereoMode stereo) {
  std::vector<Wall> walls;
  for (const Facing& facing : kFacings) {
    Wall& wall = walls.emplace_back();
    wall.name = "flat" + std::to_string(walls.size());
    wall.lowerLeft_m = eye_m + facing.away - facing.right - facing.up;
    wall.lowerRight_m = eye_m + facing.away + facing.right - facing.up;
    wall.upperLeft_m = eye_m + facing.away - facing.right + facing.up;
    wall.pixels = glm::ivec2(kReference_px);
    wall.stereo = stereo;
  }
  return walls;
}

/// sRGB, IEC 61966-2-1.
double lightOf(int code) {
  const double c = code / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// The least and the most of each colour that the flat walls show about a direction.
struct Range {
  std::array<int, 3> least{255, 255, 255}, most{0, 0, 0};

  void include(const std::vector<Image>& flat, const glm::dvec3& along) {
    std::size_t face = 0;
    for (std::size_t i = 1; i < kFacings.size(); ++i)
      if (glm::dot(along, kFacings[i].away) > glm::dot(along, kFacings[face].away)) face = i;
    const Facing& facing = kFacings[face];
    const glm::dvec3 onWall = along / glm::dot(along, facing.away);
    const glm::dvec2 at =
        static_cast<double>(kReference_px) *
        (0.5 + 0.5 * glm::dvec2(glm::dot(onWall, facing.right), glm::dot(onWall, facing.up)));
    for (int y = static_cast<int>(at.y) - 1; y <= static_cast<int>(at.y) + 1; ++y) {
      for (int x = static_cast<int>(at.x) - 1; x <= static_cast<int>(at.x) + 1; ++x) {
        if (x < 0 || y < 0 || x >= kReference_px || y >= kReference_px) continue;
        const std::uint8_t* pixel =
            &flat[face].rgb[3 * (static_cast<std::size_t>(y) * kReference_px + static_cast<std::size_t>(x))];
        for (std::size_t i = 0; i < 3; ++i) {
          least[i] = std::min<int>(least[i], pixel[i]);
          most[i] = std::max<int>(most[i], pixel[i]);
        }
      }
    }
  }
  /// Returns whether a pixel is within the range, but for a shade of light and for what the cubic filter
  /// swings over an edge: a twelfth of the edge's light each way.
  bool holds(const std::uint8_t* pixel) const {
    constexpr double kSwing = 2.0 / 12.0;
    constexpr int kCodes = 8;
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = lightOf(least[i]), high = lightOf(most[i]), light = lightOf(pixel[i]);
      const double swing = kSwing * (high - low);
      const bool isBright = light >= low - swing || pixel[i] >= least[i] - kCodes;
      const bool isDark = light <= high + swing || pixel[i] <= most[i] + kCodes;
      if (!isBright || !isDark) return false;
    }
    return true;
  }
};

class SeenOnScreens : public ::testing::Test {
 protected:
  SeenOnScreens()
      : scenario_(readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml")),
        scene_(sceneOf(scenario_, {0.001, 1000})) {
    Billiard billiard(scenario_.billiard);
    billiard.advanceTo(6.0);
    std::vector<WorldLine> lines;
    for (const SeenBody& body : seenBodies(scenario_, billiard.worldLines())) lines.push_back(body.worldLine);
    world_.histories = reachingTo(lines, scene_.reach_m);
  }

  /// A frame of a room that moves along the table by this part of c, with its floor's origin beside it.
  FrameRecord frame(double beta, const glm::dvec3& head_m) const {
    const double c_m_s = scenario_.billiard.lightSpeed_m_s;
    FrameRecord record;
    record.lightSpeed_m_s = c_m_s;
    ObserverStart start = scenario_.observer;
    start.beta = {beta, 0.0, 0.0};
    record.boardFromRoom = startingRoom(start, {}, c_m_s);
    const EyeView head{Event{3.0, start.position_m} + record.boardFromRoom * Displacement{0.0, head_m},
                       head_m, head_m};
    record.viewers[0].observer = viewOfEyes(record.boardFromRoom.inverse(), head, {0.032, 0.0, 0.0}, 3.0);
    return record;
  }

  std::vector<Image> shown(std::vector<Wall> walls, const FrameRecord& record) {
    WallPictures pictures(graphics_, scene_, record.lightSpeed_m_s, std::move(walls));
    const SeenFrame seen(record);
    pictures.drawSession(seen, world_);
    pictures.drawScreens(seen);
    std::vector<Image> images;
    for (const WallPictures::WallEye& eye : pictures.eyes()) images.push_back(readBack(eye.pictures.drawn()));
    return images;
  }

  /// Expects that the columns of a window from `from` to `to`, of 1, show what flat walls show of `record`.
  void expectSeen(const Bent& screen, const Image& window, const FrameRecord& record, double from,
                  double to) {
    const StereoMode stereo = screen.wall.stereo;
    const Eye eye = stereo == StereoMode::left    ? Eye::left
                    : stereo == StereoMode::right ? Eye::right
                                                  : Eye::middle;
    const glm::dvec3 eye_m = record.viewers[0].observer.of(eye).positionInRoom_m;
    const std::vector<Image> flat = shown(flatWallsAround(eye_m, screen.wall.stereo), record);
    const glm::dvec2 size(screen.wall.pixels);
    int pixels = 0, wrong = 0, colours = 0;
    for (int y = 1; y + 1 < screen.wall.pixels.y; ++y) {
      for (int x = static_cast<int>(from * size.x) + 3; x + 3 < static_cast<int>(to * size.x); ++x) {
        Range range;
        bool isScreen = true;
        for (const glm::dvec2& off : {glm::dvec2(0, 0),
                                      {1, 0},
                                      {-1, 0},
                                      {0, 1},
                                      {0, -1},
                                      {0.7, 0.7},
                                      {-0.7, 0.7},
                                      {0.7, -0.7},
                                      {-0.7, -0.7}}) {
          const glm::dvec3 along =
              screen.direction((glm::dvec2(x + 0.5, y + 0.5) + kShift_px * off) / size, eye_m);
          isScreen = isScreen && glm::length(along) > 0.0;
          if (isScreen) range.include(flat, along);
        }
        if (!isScreen) continue;
        const std::uint8_t* pixel =
            &window.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(screen.wall.pixels.x) +
                             static_cast<std::size_t>(x))];
        ++pixels;
        if (range.most[1] - range.least[1] > 40) ++colours;
        if (!range.holds(pixel)) ++wrong;
      }
    }
    std::printf("%s: %d of %d pixels are elsewhere by more than %.2f pixels; %d are at edges\n",
                screen.name.c_str(), wrong, pixels, kShift_px, colours);
    EXPECT_GT(colours, pixels / 200) << "it shows nothing by which a place could be told";
    EXPECT_LE(wrong, pixels / 1000) << screen.name;  // details finer than its pixels
  }

  Graphics graphics_;
  Scenario scenario_;
  Scene scene_;
  World world_;
};

TEST_F(SeenOnScreens, EachPixelShowsWhatIsInItsDirection) {
  const std::vector<std::pair<Bent, glm::dvec3>> all{
      {bent(cylinder(3.0, -70.0, 50.0, {900, 400}), StereoMode::left), {1.1, 1.6, 0.9}},
      {bent(dome(5.0, 20.0, 180.0), StereoMode::mono), {-1.2, 1.5, 0.7}},
      {bent(SkyKind::fisheye, {700, 700}), {0.9, 1.5, -0.6}},
      {bent(SkyKind::equirectangular, {1200, 600}), {0.0, 1.7, 0.0}},
      {bent(SkyKind::cubemap, {1800, 300}), {-0.5, 1.4, 0.3}}};
  for (const auto& [screen, head_m] : all) {
    for (const double beta : {0.0, 0.6}) {
      if (screen.wall.sky && beta == 0.0) continue;
      const FrameRecord record = frame(beta, head_m);
      expectSeen(screen, shown({screen.wall}, record).front(), record, 0.0, 1.0);
    }
  }
}

// The screen is known at some points of the true surface alone.
TEST_F(SeenOnScreens, EachPixelOfAMeasuredScreenShowsWhatIsInItsDirection) {
  const TrueScreen arc = cylinder(3.0, -70.0, 50.0, {900, 400});
  TrueScreen bowl = measured(dome(5.0, 20.0, 180.0), 65, 65);
  bowl.isScreen = [](const glm::dvec2& at) { return glm::length(2.0 * at - 1.0) < 0.95; };  // whole cells
  const std::vector<std::pair<Bent, glm::dvec3>> all{
      {bent(measured(arc, 33, 33), StereoMode::left), {1.1, 1.6, 0.9}},
      {bent(measured(arc, 33, 33), StereoMode::right), {-1.2, 1.5, 0.8}},
      {bent(bowl, StereoMode::left), {0.9, 1.6, -1.1}},
      {bent(ofCells(arc, 100, 20), StereoMode::left), {1.0, 1.7, 1.0}},
      {bent(ofCells(arc, 100, 20), StereoMode::right), {-1.3, 1.6, -0.4}}};
  for (const auto& [screen, head_m] : all) {
    for (const double beta : {0.0, 0.6}) {
      const FrameRecord record = frame(beta, head_m);
      expectSeen(screen, shown({screen.wall}, record).front(), record, 0.0, 1.0);
    }
  }
}

/// Returns the share of the window's pixels in a part of it that are black.
double blackShare(const Image& window, const glm::dvec2& from, const glm::dvec2& to) {
  int pixels = 0, black = 0;
  const glm::ivec2 low(from * glm::dvec2(window.size_px)), high(to * glm::dvec2(window.size_px));
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      const std::uint8_t* rgb =
          &window.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(window.size_px.x) +
                           static_cast<std::size_t>(x))];
      ++pixels;
      if (rgb[0] + rgb[1] + rgb[2] == 0) ++black;
    }
  }
  return static_cast<double>(black) / pixels;
}

// The same cylinder from an MPCDI file, and from a file that is written by the table of the .vwf format.
TEST_F(SeenOnScreens, ACylinderFromFilesIsSeenWhereItIs) {
  TrueScreen truth = cylinder(3.0, -60.0, 60.0, {970, 330}, 0.0, 2.4);
  // Cells with a corner that is none are dark: the upper left 4 × 4 points of 97 × 33.
  truth.isScreen = [](const glm::dvec2& at) { return at.x > 4.6 / 97 || at.y < 1.0 - 4.6 / 33; };
  const Room room = readMpcdi(CAROM_TESTS_DIR "/data/rooms/cylinder_a3.mpcdi");
  ASSERT_EQ(room.walls.size(), 1U);
  const test::TemporaryFolder folder;
  const auto place = [&](const glm::dvec2& at) {
    return at.x > 4.0 / 97 || at.y < 1.0 - 4.0 / 33 ? truth.placeOn_m(at) : glm::dvec3(std::nan(""));
  };
  folder.file("arc.vwf", test::vwfBytes(97, 33, place));
  const Rig rig = readRig(folder.file(
      "arc.toml",
      "unit = 'm'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'cap'\n[[tracker]]\nname = 'cap'\nkind = "
      "'simulated'\n[[wall]]\nname = 'arc'\npixels = [970, 330]\nscreen = { shape = 'grid', file = "
      "'arc.vwf', unit "
      "= 'mm' }\n"));
  const FrameRecord record = frame(0.6, {1.0, 1.6, 0.8});
  for (const auto& [name, wall] :
       {std::pair("cylinder_a3.mpcdi", room.walls[0].wall), {"arc.vwf", rig.walls.at(0)}}) {
    Bent screen = bent(truth, StereoMode::left);
    screen.name = name;
    screen.wall.screen = wall.screen;
    const Image window = shown({screen.wall}, record).front();
    expectSeen(screen, window, record, 0.0, 1.0);
    EXPECT_EQ(blackShare(window, {0.0, 29.5 / 33 + 0.01}, {3.5 / 97, 1.0}), 1.0) << name;
    EXPECT_LT(blackShare(window, {0.1, 0.1}, {0.9, 0.9}), 0.9) << name;
  }
}

class SplitOnScreens : public SeenOnScreens, public ::testing::WithParamInterface<bool> {};

INSTANTIATE_TEST_SUITE_P(FormulaAndGrid, SplitOnScreens, ::testing::Bool());

TEST_P(SplitOnScreens, SplitAndFrozenViewsAreAsOnFlatWalls) {
  const TrueScreen arc = cylinder(3.0, -70.0, 50.0, {900, 400});
  const Bent screen = bent(GetParam() ? measured(arc, 33, 33) : arc, StereoMode::mono);
  FrameRecord record = frame(0.6, {-0.8, 1.6, 0.5});
  EyeView& middle = record.viewers[0].observer.middle;
  middle.seenFromInRoom_m += glm::dvec3(0.3, 0.0, 0.2);  // somebody has walked round what has been frozen
  record.views.split = 1;
  const Image window = shown({screen.wall}, record).front();
  record.views.split = 0;
  expectSeen(screen, window, record, 0.0, 0.5);
  record.switches = record.views.beside;
  expectSeen(screen, window, record, 0.5, 1.0);
}

// The picture of a place that rests in the room is the one that a viewer there would have, wherever the
// viewer of the session walks.
TEST_F(SeenOnScreens, APictureFromAPlaceIsThatOfSomebodyThere) {
  const glm::dvec3 there_m(0.4, 1.5, -0.2);
  Bent fixed = bent(SkyKind::fisheye, {400, 400}), ofHead = fixed;
  fixed.wall.sky->from_m = there_m;
  const FrameRecord elsewhere = frame(0.6, {-1.0, 1.7, 0.9});
  FrameRecord there = elsewhere;
  there.viewers[0].observer =
      viewAtRest(elsewhere.viewers[0].observer, elsewhere.boardFromRoom, 0.0, there_m, {0.032, 0.0, 0.0});
  EXPECT_EQ(shown({fixed.wall}, elsewhere).front().rgb, shown({ofHead.wall}, there).front().rgb);
  EXPECT_NE(shown({ofHead.wall}, elsewhere).front().rgb, shown({ofHead.wall}, there).front().rgb);
}

}  // namespace
}  // namespace carom
