// The views of time in whole pictures: where ghosts, markers and halves are drawn, against world lines looked
// up and projected.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/display/eye_renderer.h"
#include "cave/frame/bodies.h"
#include "cave/glowing_puck.h"
#include "cave/mesh/mesh_builder.h"
#include "cave/room/off_axis.h"
#include "cave/scene/scene_builder.h"
#include "engine/light/vertex_history.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::Box;
using test::kC_m_s;

static_assert(kNamedViews.size() + sizeof(Switches) == sizeof(TimeViews), "a view of time has no row");

// A pixel is lit if a sample of it is covered: up to a pixel on either side; thin tips may cover none.
constexpr double kBeyond_px = 1.51, kShort_px = 4.0;
const glm::ivec2 kPicture_px{400, 400};

/// A head at an event of the board, its eyes `separation_m` apart along x and simultaneous for it.
ObserverView observerAt(const Event& head, const Lorentz& headFromBoard, const Vec3& inRoom_m,
                        double separation_m = 0.064) {
  const auto eyeAt = [&](double side) {
    const Vec3 offset_m(side * separation_m, 0.0, 0.0);
    const Vec3 place_m = inRoom_m + offset_m;
    return EyeView{head + headFromBoard.inverse() * Displacement{0.0, offset_m}, place_m, place_m};
  };
  return {headFromBoard, eyeAt(-0.5), eyeAt(0.5), eyeAt(0.0), 0.0};
}

class TimeViewsTest : public testing::Test {
 protected:
  Image draw(EyeRenderer& view, const FrameRecord& record, const World& world, const EyeView& eye,
             const Wall& wall) {
    graphics_.makeCurrent();
    RenderTarget picture(wall.pixels);
    const std::array<PicturedWall, 1> walls{{{&wall, &picture, nullptr, wall.pixels.x / 2}}};
    view.draw(record, world, record.viewers[0].observer, eye, walls);
    graphics_.makeCurrent();
    return readBack(picture);
  }
  Image draw(EyeRenderer& view, const FrameRecord& record, const World& world, const Wall& wall) {
    return draw(view, record, world, record.viewers[0].observer.middle, wall);
  }

  Graphics graphics_;
};

World worldOf(const WorldLine& puck) { return {{restingWorldLine(kC_m_s), puck}, {}}; }

/// Where the puck's vertices come to lie, `place(offset)` from the origin of `clip`.
template <typename Place>
Box boxOf(const Scene& scene, const glm::dmat4& clip, const Place& place) {
  Box box{1e9, -1e9, 1e9, -1e9};
  for (const ScenePart& part : scene.parts) {
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      const double* p = part.mesh->GetPoint(i);
      const glm::dvec4 at = clip * glm::dvec4(place(Vec3(p[0], p[1], p[2])), 1.0);
      test::include(box, (at.x / at.w + 1.0) * 0.5 * kPicture_px.x,
                    (at.y / at.w + 1.0) * 0.5 * kPicture_px.y);
    }
  }
  return box;
}

bool within(const Box& box) {
  return box[0] > 3 && box[1] < kPicture_px.x - 3 && box[2] > 3 && box[3] < kPicture_px.y - 3 &&
         box[1] - box[0] > 8 && box[3] - box[2] > 8;
}

void expectBox(const Box& lit, const Box& expected) {
  for (std::size_t side = 0; side < 4; ++side) {
    const double beyond = side % 2 == 0 ? expected[side] - lit[side] : lit[side] - expected[side];
    ASSERT_LT(beyond, kBeyond_px) << "side " << side << ": " << lit[side] << " for " << expected[side];
    ASSERT_GT(beyond, -kShort_px) << "side " << side << ": " << lit[side] << " for " << expected[side];
  }
}

/// The pixels in which two pictures differ.
Box differenceOf(const Image& a, const Image& b) {
  Image difference = a;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    difference.rgb[i] = static_cast<std::uint8_t>(std::abs(int{a.rgb[i]} - int{b.rgb[i]}) > 8 ? 255 : 0);
  return test::litBox(difference);
}

WorldLine randomLine(test::Random& random) {
  return randomWorldLine(random, kC_m_s, 0.2, static_cast<int>(random.in(0, 5)), 0.5, 0.85);
}

// Frozen: the eye has gone elsewhere in the room; a point seen from A at s lies at A + s, and is projected
// from where the eye is.
TEST_F(TimeViewsTest, AFrozenSightIsWalkedRound) {
  test::Random random(61);
  const Scene scene = test::glowingPuck(0.15);
  EyeRenderer view(graphics_, scene, kC_m_s);
  int drawn = 0;
  for (int i = 0; i < 120; ++i) {
    const WorldLine line = randomLine(random);
    const Event eye{random.in(0.0, line.knots().back().turn.t_s + 2.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.8), kC_m_s);
    const Vec3 from_m(0.2, -0.1, 1.6), to_m = from_m + random.inBox(0.5);
    FrameRecord record;
    record.viewers[0].observer = observerAt(eye, headFromBoard, from_m, 0.0);
    record.views.frozen = 1;
    const Vec3 centre_m = from_m + emission(line, Vec3(0.0), eye, headFromBoard)->seen.dr_m;
    const Wall wall = test::wallTowards(to_m, centre_m - to_m, kPicture_px);
    // Both eyes are frozen at one event and see one thing, each from its place.
    for (const double side : {-0.032, 0.032}) {
      EyeView& walked = side < 0.0 ? record.viewers[0].observer.left : record.viewers[0].observer.right;
      walked.positionInRoom_m = to_m + Vec3(side, 0.0, 0.0);
      const std::optional<glm::dmat4> clip = clipFromRoom(wall, walked.positionInRoom_m);
      ASSERT_TRUE(clip);
      const Box expected = boxOf(scene, *clip, [&](const Vec3& d) {
        return from_m + emission(line, d, eye, headFromBoard)->seen.dr_m;
      });
      if (!within(expected)) continue;
      ++drawn;
      SCOPED_TRACE(testing::Message() << "case " << i << ", eye " << side);
      expectBox(test::litBox(draw(view, record, worldOf(line), walked, wall)), expected);
    }
  }
  EXPECT_GT(drawn, 60);
}

// A ghost is drawn where the body is at the board's or at the head's moment; the seen puck stays as it was.
TEST_F(TimeViewsTest, GhostsAreDrawnAtTheirMoments) {
  test::Random random(62);
  Scene scene = test::glowingPuck(0.15);
  scene.reach_m = {0.0, 0.2};
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  std::array<int, 2> drawn{};
  for (int i = 0; i < 240; ++i) {
    const WorldLine line = randomLine(random);
    const Event eye{random.in(0.0, line.knots().back().turn.t_s + 1.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.8), kC_m_s);
    const Vec3 inRoom_m(0.2, -0.1, 1.6);
    const bool mine = i % 2 == 1;
    const auto placeOf = [&](const Vec3& d) {
      const auto history = vertexHistory(line, d);
      if (!mine) {
        // Light that has come straight from where it is now on the board.
        const Vec3 way_m = placeAt(pieceAt(history, eye.t_s), eye.t_s, kC_m_s) - eye.r_m;
        return (headFromBoard * Displacement{-glm::length(way_m) / kC_m_s, way_m}).dr_m;
      }
      const auto fromEye = [&](double t_s) {
        return headFromBoard * (Event{t_s, placeAt(pieceAt(history, t_s), t_s, kC_m_s)} - eye);
      };
      double early_s = eye.t_s - 100.0, late_s = eye.t_s + 100.0;
      for (int k = 0; k < 80; ++k) {
        const double middle_s = 0.5 * (early_s + late_s);
        (fromEye(middle_s).dt_s < 0.0 ? early_s : late_s) = middle_s;
      }
      return fromEye(early_s).dr_m;
    };
    const Wall wall = test::wallTowards(inRoom_m, placeOf(Vec3(0.0)), kPicture_px);
    const glm::dmat4 clip = *clipFromEye(wall, inRoom_m);
    const Box expected = boxOf(scene, clip, placeOf);
    const Box seen =
        boxOf(scene, clip, [&](const Vec3& d) { return emission(line, d, eye, headFromBoard)->seen.dr_m; });
    const bool apart =
        seen[1] < expected[0] || seen[0] > expected[1] || seen[3] < expected[2] || seen[2] > expected[3];
    if (!within(expected) || !apart) continue;
    ++drawn[mine ? 1 : 0];
    SCOPED_TRACE(testing::Message() << "case " << i << (mine ? ", my now" : ", now on the board"));
    const auto drawn_ = [&](bool ghosts) {
      std::array<std::array<BodyView, 2>, 2> views;
      const std::array<WorldLine, 2> lines{restingWorldLine(kC_m_s), line};
      for (std::size_t body = 0; body < 2; ++body) {
        viewBody(lines[body], eye, headFromBoard, views[0][body]);
        viewBody(lines[body], eye, headFromBoard, views[1][body], {},
                 mine ? ViewTime::myNow : ViewTime::boardNow);
      }
      Ghosts shown;
      if (ghosts) (mine ? shown.myNow : shown.boardNow) = views[1];
      graphics_.makeCurrent();
      RenderTarget picture(kPicture_px);
      renderer.look(headFromBoard, {eye, inRoom_m, inRoom_m}, views[0], {}, shown);
      EXPECT_TRUE(renderer.draw(wall, inRoom_m, picture));
      return readBack(picture);
    };
    expectBox(differenceOf(drawn_(true), drawn_(false)), expected);
  }
  EXPECT_GT(drawn[0], 15);
  EXPECT_GT(drawn[1], 15);
}

// What is told to rest on the board needs no ghost of its now there, what goes with the room none of the
// room's: it would lie upon it. A puck has one, however still it lies.
TEST_F(TimeViewsTest, WhatAlwaysGoesAlongHasNoGhost) {
  Scene scene = test::glowingPuck(0.25);
  scene.reach_m = {0.0, 0.3};
  EyeRenderer view(graphics_, scene, kC_m_s);
  const Vec3 u = uFromBeta({0.6, 0.0, 0.0});
  const auto lineWith = [](const Vec3& its_u) {
    return WorldLine({{0.0, {0.0, 1.0, 0.0}}, its_u, 0.0, {}, 0.0}, kC_m_s, 0.3);
  };
  FrameRecord record;
  record.boardFromRoom = Lorentz::boost(u, kC_m_s);
  record.viewers[0].observer = observerAt({0.1, Vec3(0.0)}, record.boardFromRoom.inverse(), Vec3(0.0));
  const auto hasGhost = [&](const Vec3& its_u, bool mine, std::uint64_t pucks) {
    const WorldLine line = lineWith(its_u);
    const Wall wall = test::wallTowards(Vec3(0.0), {0.0, 1.0, 0.0}, kPicture_px);
    record.pucks = pucks;
    record.views = {};
    const Image plain = draw(view, record, worldOf(line), wall);
    (mine ? record.views.myNow : record.views.boardNow) = 1;
    return draw(view, record, worldOf(line), wall).rgb != plain.rgb;
  };
  EXPECT_FALSE(hasGhost(Vec3(0.0), false, 0)) << "at rest on the board, told";
  EXPECT_TRUE(hasGhost(Vec3(0.0), false, 1)) << "a puck";
  EXPECT_TRUE(hasGhost(Vec3(0.0), true, 0)) << "in the moving room's now it is elsewhere";
  EXPECT_FALSE(hasGhost(u, true, 0)) << "it goes with the room, told";
  EXPECT_TRUE(hasGhost(u, true, 1)) << "a puck that does";
  EXPECT_TRUE(hasGhost(u, false, 0)) << "it moves on the board";
}

// While a lesson explains what ghosts show, a puck is as it would be if it reflected 0.35 as much; what rests
// is not dimmed, nor is anything without ghosts or in another phase.
TEST_F(TimeViewsTest, ThePuckThatIsSeenIsDimmedBehindTheGhostsOfAnExplanation) {
  const Vec3 seen_m(0.0, 1.0, 0.0), rests_m(0.0, 0.0, 1.0);
  const WorldLine line({{0.0, seen_m}, uFromBeta({0.0, 0.0, -0.8}), 0.0, {}, 0.0}, kC_m_s, 0.3);
  FrameRecord record;
  record.viewers[0].observer = observerAt({1.0 / kC_m_s, Vec3(0.0)}, Lorentz(kC_m_s), Vec3(0.0));
  const auto middleOf = [&](float colour, LessonPhase phase, bool ghosts, const Vec3& towards_m) {
    Scene scene = test::glowingPuck(0.1, glm::vec3(colour));
    scene.reach_m = {0.0, 0.2};
    ScenePart lies = scene.parts.front();
    lies.body = kRestingBody;
    MeshBuilder sheet;
    sheet.addPatch(2, 2, [&](double u, double v) {
      return PatchPoint{rests_m + Vec3(0.4 * u - 0.2, 0.4 * v - 0.2, 0.0), {0.0, 0.0, -1.0}};
    });
    lies.mesh = sheet.build();
    lies.coarser.clear();
    scene.parts.push_back(lies);
    EyeRenderer view(graphics_, scene, kC_m_s);
    record.lesson.phase = phase;
    record.views.boardNow = ghosts ? 1 : 0;
    const Image picture =
        draw(view, record, worldOf(line), test::wallTowards(Vec3(0.0), towards_m, kPicture_px));
    return int{
        picture.rgb[3 * (static_cast<std::size_t>(kPicture_px.y / 2) * kPicture_px.x + kPicture_px.x / 2)]};
  };
  const int bright = middleOf(1.0F, LessonPhase::shows, true, seen_m);
  EXPECT_NEAR(middleOf(1.0F, LessonPhase::explains, true, seen_m),
              middleOf(0.35F, LessonPhase::shows, true, seen_m), 2);
  EXPECT_GT(bright, middleOf(0.35F, LessonPhase::shows, true, seen_m) + 40);
  EXPECT_EQ(middleOf(1.0F, LessonPhase::explains, false, seen_m), bright) << "there are no ghosts";
  EXPECT_GT(middleOf(1.0F, LessonPhase::shows, true, rests_m), 0);
  EXPECT_EQ(middleOf(1.0F, LessonPhase::explains, true, rests_m),
            middleOf(1.0F, LessonPhase::shows, true, rests_m));
}

// For a head that moves, both eyes see the ghost "now on the board" at one moment, that of the point between
// them: the left eye's picture is the right eye's of the world moved by what is between the eyes.
TEST_F(TimeViewsTest, TheBoardsMomentIsOneForBothEyes) {
  const WorldLine line({{0.0, {0.0, 1.0, 0.0}}, uFromBeta({0.8, 0.0, 0.0}), 0.0, {}, 0.0}, kC_m_s, 0.3);
  Scene scene = test::glowingPuck(0.25);
  scene.reach_m = {0.0, 0.3};
  EyeRenderer view(graphics_, scene, kC_m_s);
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({-0.8, 0.0, 0.0}), kC_m_s);
  FrameRecord record;
  record.viewers[0].observer = observerAt({0.1, Vec3(0.0)}, headFromBoard, Vec3(0.0));
  record.views.boardNow = 1;
  const Vec3 centre_m = line.at(0.1).event.r_m;
  for (const EyeView& eye : record.viewers[0].observer.all()) {
    const Vec3 way_m = centre_m - eye.observation.r_m;
    const Vec3 seen_m = (headFromBoard * Displacement{-glm::length(way_m) / kC_m_s, way_m}).dr_m;
    const Wall wall = test::wallTowards(eye.positionInRoom_m, seen_m, kPicture_px);
    const Image with = draw(view, record, worldOf(line), eye, wall);
    FrameRecord plain = record;
    plain.views = {};
    const Box ghost = differenceOf(with, draw(view, plain, worldOf(line), eye, wall));
    const Box expected = boxOf(scene, *clipFromEye(wall, eye.positionInRoom_m), [&](const Vec3& d) {
      const Vec3 way = centre_m + Vec3(d.x * 0.6, d.y, d.z) - eye.observation.r_m;
      return (headFromBoard * Displacement{-glm::length(way) / kC_m_s, way}).dr_m;
    });
    ASSERT_TRUE(within(expected));
    // Above it stands its beacon.
    expectBox({ghost[0], ghost[1], ghost[2], expected[3]}, expected);
    EXPECT_GT(ghost[3], expected[3]);
  }
}

// Each half is the whole wall's picture under its own switches.
TEST_F(TimeViewsTest, ASplitWallShowsTwoStatesOfTheSwitches) {
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  Scene scene = buildScene(setup, {});
  const World world{{restingWorldLine(kC_m_s)}, {}};
  EyeRenderer view(graphics_, scene, kC_m_s);
  FrameRecord record;
  record.viewers[0].observer =
      observerAt({3.0, {0.0, -1.6, 0.9}}, Lorentz::boost(uFromBeta({0.5, 0.3, 0.0}), kC_m_s), {0, 0, 1.65});
  for (const int width : {320, 241}) {
    const Wall wall = test::wallTowards({0, 0, 1.65}, {0, 1, -0.3}, {width, 200});
    record.views = {};
    record.switches = {};
    const Image einstein = draw(view, record, world, wall);
    record.switches = kNoSwitches;
    const Image newton = draw(view, record, world, wall);
    record.switches = {};
    record.views.split = 1;
    const Image split = draw(view, record, world, wall);
    ASSERT_NE(einstein.rgb, newton.rgb);
    int differing = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < width; ++x) {
        if (std::abs(x - width / 2) <= EyeRenderer::kSplitLine_px) continue;
        const std::size_t at = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
        const Image& expected = x < width / 2 ? einstein : newton;
        for (std::size_t k = 0; k < 3; ++k) {
          // Rasterised from another origin, an edge's sample may fall to the other side.
          if (std::abs(int{split.rgb[at + k]} - int{expected.rgb[at + k]}) > 2) ++differing;
        }
      }
    }
    EXPECT_LT(differing, 200 * width / 50) << "of " << 3 * 200 * width;
    const std::size_t middle =
        3 * (static_cast<std::size_t>(100) * width + static_cast<std::size_t>(width / 2));
    EXPECT_EQ(split.rgb[middle], 255) << "the line between";
  }
}

}  // namespace
}  // namespace carom
