// The tracking devices, bodies and persons of rooms of OpenCOVER.
#include "app/cave_formats/cover_input.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/cave_formats/cover_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace cover = test::cover;
using test::allFindings;
using test::findingWith;
using test::roomOf;
using test::with;

TEST(CoverFile, TrackersBodiesAndPersonsAreTakenOver) {
  const Room room = roomOf("room.xml", cover::kCave);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "udp://0.0.0.0:5001");
  const Pose& tracker = room.trackers[0].roomFromTracker;
  EXPECT_LT(glm::distance(tracker.position_m, {0.01, 0.02, -1.5}), 1e-12);
  EXPECT_LT(glm::distance(tracker.orientation * glm::dvec3(1, 0, 0), {0, 1, 0}), 1e-12);
  const ViewerSetup& viewer = room.people.front().setup;
  EXPECT_TRUE(room.people.front().isTracked);
  EXPECT_EQ(viewer.head.sensor.sensor, 2);
  // The eyes are at the body's offset in the sensor's axes.
  EXPECT_LT(glm::length(viewer.head.eyesFromSensor * glm::dvec3(0, -0.01, -0.1)), 1e-12);
  ASSERT_TRUE(viewer.hand);
  EXPECT_EQ(viewer.hand->sensor, 101);
}

TEST(CoverFile, SharedMemoryAndNatNetAreTrackers) {
  const auto withDriver = [](const std::string& attributes) {
    return roomOf("room.xml", with(cover::kCave, "driver=\"dtrack\" port=\"5001\"", attributes));
  };
  const Room room = withDriver("driver=\"CAVELIB\" SHMID=\"7000\" unit=\"cm\"");
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].kind, TrackerKind::trackd);
  EXPECT_EQ(room.trackers[0].source, "shm://7000?wand=4127");
  EXPECT_EQ(room.trackers[0].unit_m, 0.01);
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker.position_m, {0.01, 0.02, -1.5}), 1e-12);
  EXPECT_EQ(withDriver("driver=\"cavelib\"").trackers.at(0).unit_m, 0.3048);
  EXPECT_EQ(withDriver("driver=\"cavelib\" unit=\"304.8\"").trackers.at(0).unit_m, 0.3048);
  EXPECT_EQ(findingWith(withDriver("driver=\"cavelib\" unit=\"dm\""), "none that a rig has").at.line, 27);
  EXPECT_EQ(findingWith(withDriver("driver=\"cavelib\" Yup=\"off\""), "turns about z first").at.line, 27);
  const Room natnet = withDriver("driver=\"NatNet\" server=\"10.0.0.7\"");
  ASSERT_EQ(natnet.trackers.size(), 1u) << allFindings(natnet);
  EXPECT_EQ(natnet.trackers[0].source, "udp://10.0.0.7?group=239.255.42.99");
}

// R = Rz(h) Rx(p) Ry(r), each turn by itself, then the offset in millimetres.
TEST(CoverInput, APoseTurnsAboutYThenXThenZ) {
  const auto poseOf = [](const std::string& angles) {
    Room room;
    const Pose pose = coverPose(
        partOf(parseXml("a.xml",
                        "<Body><Offset x='1000' y='0' z='-500'/><Orientation " + angles + "/></Body>",
                        Doctype::none)
                   .root),
        room);
    EXPECT_EQ(allFindings(room), "");
    return pose;
  };
  const auto expectTurned = [&](const std::string& angles, const glm::dvec3& from, const glm::dvec3& to) {
    const Pose pose = poseOf(angles);
    EXPECT_LT(glm::distance(pose.position_m, {1, 0, -0.5}), 1e-12);
    EXPECT_LT(glm::distance(pose.orientation * from, to), 1e-12) << angles;
  };
  expectTurned("h='90' p='0' r='0'", {1, 0, 0}, {0, 1, 0});
  expectTurned("h='0' p='90' r='0'", {0, 1, 0}, {0, 0, 1});
  expectTurned("h='0' p='0' r='90'", {0, 0, 1}, {1, 0, 0});
  // y goes to z by the pitch; z stays by the heading. z goes to x by the roll, and by the heading to y.
  expectTurned("h='90' p='90' r='0'", {0, 1, 0}, {0, 0, 1});
  expectTurned("h='90' p='0' r='90'", {0, 0, 1}, {0, 1, 0});
}

}  // namespace
}  // namespace carom
