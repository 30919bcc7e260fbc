// The viewer as a model: where its parts stand in the room.
#include "cave/spectator/viewer_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/gtc/quaternion.hpp>

namespace carom {
namespace {

constexpr double kTolerance_m = 1e-6;  // meshes are in single precision

/// A room whose up, forward and floor are not the axes' and zero.
RoomGeometry turnedRoom() {
  RoomGeometry room;
  room.up = {0.0, 0.0, 1.0};
  room.forward = {1.0, 0.0, 0.0};
  return room;
}
constexpr double kFloor_m = -0.3;

glm::dvec3 at(const glm::dmat4& roomFromModel, const glm::dvec3& place_m) {
  return glm::dvec3(roomFromModel * glm::dvec4(place_m, 1.0));
}

void expectNear(const glm::dvec3& is, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(is, expected), kTolerance_m)
      << is.x << ' ' << is.y << ' ' << is.z << ", expected " << expected.x << ' ' << expected.y << ' '
      << expected.z;
}

FrameRecord recordOf(const glm::dvec3& eyes_m) {
  FrameRecord record;
  record.viewers[0].observer.middle.positionInRoom_m = eyes_m;
  return record;
}

TEST(ViewerModel, WithoutTrackersItLooksForwardAndStandsUnderItsHead) {
  const ViewerPlaces places = viewerPlaces(recordOf({0.4, 0.2, 1.4}), turnedRoom(), kFloor_m);
  expectNear(at(places.roomFromHead, {0.0, 0.0, 0.0}), {0.4, 0.2, 1.4});
  expectNear(at(places.roomFromHead, {0.0, 1.0, 0.0}), {1.4, 0.2, 1.4});   // forward
  expectNear(at(places.roomFromHead, {1.0, 0.0, 0.0}), {0.4, -0.8, 1.4});  // right
  ASSERT_TRUE(places.roomFromCoat);
  expectNear(at(*places.roomFromCoat, {0.0, 0.0, 0.0}), {0.31, 0.2, kFloor_m});
  expectNear(at(*places.roomFromCoat, {0.0, 0.0, 1.0}), {0.31, 0.2, 1.4});  // as high as the eyes
  EXPECT_FALSE(places.roomFromWand);
}

TEST(ViewerModel, ATurnedHeadTurnsTheHeadAndOnlyShiftsTheCoat) {
  FrameRecord record = recordOf({0.0, 0.0, 1.4});
  record.viewers[0].tracked.headKnown = 1;
  const glm::dquat left = glm::angleAxis(0.5 * M_PI, glm::dvec3(0.0, 0.0, 1.0));
  record.viewers[0].tracked.roomFromHeadSensor = {{9.0, 9.0, 9.0}, left};
  const ViewerPlaces places = viewerPlaces(record, turnedRoom(), kFloor_m);
  expectNear(at(places.roomFromHead, {0.0, 1.0, 0.0}), {0.0, 1.0, 1.4});
  expectNear(at(*places.roomFromCoat, {0.0, 0.0, 0.0}), {0.0, -0.09, kFloor_m});
  expectNear(at(*places.roomFromCoat, {1.0, 0.0, 0.0}), {0.0, -1.09, kFloor_m});  // still faces forward
}

TEST(ViewerModel, EyesNearTheFloorHaveNoCoat) {
  EXPECT_TRUE(viewerPlaces(recordOf({0.0, 0.0, kFloor_m + 0.51}), turnedRoom(), kFloor_m).roomFromCoat);
  EXPECT_FALSE(viewerPlaces(recordOf({0.0, 0.0, kFloor_m + 0.49}), turnedRoom(), kFloor_m).roomFromCoat);
}

TEST(ViewerModel, ATrackedHandHoldsTheWand) {
  FrameRecord record = recordOf({0.0, 0.0, 1.4});
  record.viewers[0].tracked.handKnown = 1;
  record.viewers[0].tracked.roomFromHand = {{0.3, -0.2, 1.0}, {1.0, 0.0, 0.0, 0.0}};
  const ViewerPlaces places = viewerPlaces(record, turnedRoom(), kFloor_m);
  ASSERT_TRUE(places.roomFromWand);
  expectNear(at(*places.roomFromWand, {0.0, 0.0, 0.0}), {0.3, -0.2, 1.0});
  expectNear(at(*places.roomFromWand, {0.0, 0.26, 0.0}), {0.56, -0.2, 1.0});
}

TEST(ViewerModel, IsAsLargeAsAPerson) {
  const ViewerModel model = makeViewerModel();
  const auto sizeOf = [](const ModelPart& part) {
    std::array<double, 6> b{};
    part.mesh->GetBounds(b.data());
    return glm::dvec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  };
  ASSERT_EQ(model.head.size(), 3u);
  const glm::dvec3 skull_m = sizeOf(model.head[0]), wand_m = sizeOf(model.wand),
                   coat = sizeOf(model.coats.front());
  EXPECT_NEAR(skull_m.x, 0.178, 0.005) << "with ears";
  EXPECT_NEAR(skull_m.z, 0.25, 0.005);
  EXPECT_NEAR(wand_m.y, 0.26 + 0.035, 0.005);
  EXPECT_NEAR(coat.x, 0.56, 0.02) << "from elbow to elbow";
  // From the soles to the chin, which is 0.12 m below the eyes, nothing is missing.
  std::vector<std::array<double, 6>> boxes(1);
  model.coats.front().mesh->GetBounds(boxes[0].data());
  for (const ModelPart& part : model.below) part.mesh->GetBounds(boxes.emplace_back().data());
  std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a[4] < b[4]; });
  double reached = 0.01;
  for (const auto& box : boxes) {
    EXPECT_LT(box[4], reached);
    EXPECT_NEAR(box[0], -box[1], 1e-6) << "left and right are alike";
    reached = std::max(reached, box[5]);
  }
  EXPECT_GT(reached, 1.0 - 0.12 / 1.6);
  EXPECT_LT(reached, 1.0);
}

}  // namespace
}  // namespace carom
