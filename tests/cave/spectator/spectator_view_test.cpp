// The room from outside: its walls show their pictures where they stand.
#include "cave/spectator/spectator_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/scene/table_model.h"
#include "cave/spectator/orbit_camera.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
using Rgb = std::array<int, 3>;

Wall wallOf(const char* name, const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight,
            const glm::dvec3& upperLeft) {
  Wall wall;
  wall.name = name;
  wall.lowerLeft_m = lowerLeft;
  wall.lowerRight_m = lowerRight;
  wall.upperLeft_m = upperLeft;
  wall.pixels = {600, 600};
  return wall;
}

/// A front, a left and a right wall. Only the front one is drawn here.
RoomGeometry threeWalls() {
  RoomGeometry room;
  room.walls = {wallOf("front", {-1.5, 0.0, -1.5}, {1.5, 0.0, -1.5}, {-1.5, 3.0, -1.5}),
                wallOf("left", {-1.5, 0.0, 1.5}, {-1.5, 0.0, -1.5}, {-1.5, 3.0, 1.5}),
                wallOf("right", {1.5, 0.0, -1.5}, {1.5, 0.0, 1.5}, {1.5, 3.0, -1.5})};
  return room;
}

class Outside : public testing::Test {
 protected:
  Outside() {
    record_.viewers[0].observer.middle.positionInRoom_m = {1.2, 1.7, 1.2};  // not before what is looked at
    record_.controls.shown = Shown::calibrationPattern;
  }

  Image drawn() {
    walls_.draw(record_, world_);
    record_.boardFromRoom = Lorentz(kC_m_s);
    view_.draw(record_, world_, walls_);
    graphics_.makeCurrent();
    return readBack(view_.picture());
  }

  Rgb at(const Image& image, const glm::dvec3& place_m) const {
    const glm::dvec4 clip = OrbitCamera(room_).clipFromRoom(image.size_px) * glm::dvec4(place_m, 1.0);
    const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(image.size_px);
    const std::size_t i = 3 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(image.size_px.x) +
                               static_cast<std::size_t>(pixel.x));
    return {image.rgb.at(i), image.rgb.at(i + 1), image.rgb.at(i + 2)};
  }

  Graphics graphics_;
  RoomGeometry room_ = threeWalls();
  Scene scene_ = test::glowingPuck(0.2);
  DisplayWalls walls_{graphics_, scene_, kC_m_s, {room_.walls[0]}, std::nullopt, false};
  SpectatorView view_{graphics_, room_, scene_, {}, std::nullopt};
  FrameRecord record_;
  World world_{{WorldLine(Knot{}, kC_m_s), WorldLine({{0.0, {0.0, 50.0, 0.0}}, {}, 0.0, {}, 0.0}, kC_m_s)},
               {}};
};

// The test pattern's colour bars, whose places on the wall are known.
TEST_F(Outside, AWallShowsItsPicture) {
  const Image image = drawn();
  constexpr std::array<Rgb, 8> kBars{{{255, 255, 255},
                                      {255, 255, 0},
                                      {0, 255, 255},
                                      {0, 255, 0},
                                      {255, 0, 255},
                                      {255, 0, 0},
                                      {0, 0, 255},
                                      {0, 0, 0}}};
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const double x_m = -1.5 + 3.0 * (0.29 + 0.06 * static_cast<double>(i));
    const Rgb seen = at(image, {x_m, 3.0 * 0.18, -1.5});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], kBars[i][c], 12) << "bar " << i << " " << c;
  }
}

TEST_F(Outside, AWallOfAnotherNodeIsAnEmptyPanelAndOneSeenFromBehindHidesNothing) {
  const Image image = drawn();
  const Rgb empty = at(image, {-1.5, 1.2, 0.3}), other = at(image, {-1.5, 2.2, -0.6});
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(empty[c], other[c], 2);
  // The right wall stands between the camera and this part of the front wall's bars.
  const Rgb throughTheRightWall = at(image, {-1.5 + 3.0 * 0.29, 0.54, -1.5});
  EXPECT_GT(throughTheRightWall[0] + throughTheRightWall[1] + throughTheRightWall[2], 700);
}

TEST_F(Outside, APuckIsWhereItIsNowInTheRoom) {
  const Image without = drawn();
  const glm::dvec3 place_m(-0.4, 0.6, -0.2);
  world_.histories[1] = WorldLine({{0.0, place_m}, {}, 0.0, {}, 0.0}, kC_m_s);
  record_.viewers[0].observer.middle.seenFromInRoom_m =
      record_.viewers[0].observer.middle.observation.r_m = {1.2, 1.7, 1.2};
  const Image with = drawn();
  EXPECT_NE(at(with, place_m), at(without, place_m));
  const glm::dvec3 beside_m = place_m + glm::dvec3(0.0, 0.4, 0.0);
  EXPECT_EQ(at(with, beside_m), at(without, beside_m));
}

// A disc that is half as wide as relaxed along its way and moves at 0.3 c, by its rows: at the room's present
// it is where its rows have it now, not where it is seen, and not as the relaxed puck on its leg.
TEST_F(Outside, ASoftPuckIsAsItIsDeformedNow) {
  const SoftMesh mesh = softDisc(0.3, 4);
  constexpr double kV = 0.3, kNow = 2.0, kMiddle = -0.9 + kV * kNow;
  scene_.soft = {softModel(mesh, true, 0.02, 1, glm::vec3(1.0F))};
  view_.setScene(scene_, {});
  const Image without = drawn();
  world_.soft.resize(2);
  for (const double time : {0.0, 4.0}) {
    SoftRow row{.body = 1, .time = time, .centreX = -0.9 + kV * time, .centreY = 1.0, .velocityX = kV};
    row.reach = 0.3, row.nodes = static_cast<std::uint32_t>(mesh.places().size());
    std::vector<SoftNode> nodes;
    for (const glm::dvec2& place : mesh.places())
      nodes.push_back({static_cast<float>(0.5 * place.x),
                       static_cast<float>(place.y),
                       {static_cast<std::int16_t>(kV / SoftNode::kVelocityUnit), 0}});
    world_.soft[1].rows.append(row, nodes);
  }
  EyeView& middle = record_.viewers[0].observer.middle;
  middle.seenFromInRoom_m = middle.observation.r_m = {1.2, 1.7, 1.2};
  middle.observation.t_s = kNow / kC_m_s;
  const Image with = drawn();
  for (double x = -0.9; x < 0.6; x += 0.025) {
    const double off = std::abs(x - kMiddle);
    if (std::abs(off - 0.15) < 0.04) continue;  // its edge
    EXPECT_EQ(at(with, {x, 1.0, 0.02}) != at(without, {x, 1.0, 0.02}), off < 0.15) << x;
  }
  for (double y = 0.6; y < 1.4; y += 0.025) {
    const double off = std::abs(y - 1.0);
    if (std::abs(off - 0.3) < 0.04) continue;
    EXPECT_EQ(at(with, {kMiddle, y, 0.02}) != at(without, {kMiddle, y, 0.02}), off < 0.3) << y;
  }
}

TEST_F(Outside, TurningChangesTheCameraAndItStaysOutside) {
  OrbitCamera camera(room_);
  const glm::dvec3 before_m = camera.place_m();
  EXPECT_GT(before_m.x, 1.5) << "to the right";
  EXPECT_GT(before_m.y, 3.0) << "above";
  EXPECT_GT(before_m.z, 1.5) << "behind";
  camera.turn({100.0, 0.0});
  EXPECT_NEAR(glm::distance(camera.place_m(), {0.0, 1.5, 0.0}), glm::distance(before_m, {0.0, 1.5, 0.0}),
              1e-9);
  EXPECT_GT(glm::distance(camera.place_m(), before_m), 1.0);
  camera.zoom(1.0);
  EXPECT_LT(glm::length(camera.place_m()), glm::length(before_m));
}

}  // namespace
}  // namespace carom
