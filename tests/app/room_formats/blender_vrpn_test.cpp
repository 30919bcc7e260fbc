// The trackers of rooms of BlenderCAVE.
#include "app/room_formats/blender_vrpn.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/room_formats/blender_room.h"
#include "app/room_formats/read_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

using test::allFindings;
using test::findingWith;
using test::roomOf;
using test::blender::kCave;

TEST(BlenderFile, TransformationsOfTrackerAndSensorFollowTheProgram) {
  const Room room = roomOf("room.xml", kCave);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "DTrack@tcp://tracker-pc");
  // A third of a turn about the diagonal takes x to z, y to x and z to y: the tracker's z is up.
  const Pose& tracker = room.trackers[0].roomFromTracker;
  EXPECT_LT(glm::distance(tracker * glm::dvec3(1, 2, 3), {2, 1.4, 1}), 1e-9);
  const Person& b = room.people[1];
  EXPECT_TRUE(b.isTracked);
  EXPECT_EQ(b.setup.head.sensor.sensor, 4);
  EXPECT_FALSE(room.people[0].isTracked);
}

// The first sensor that places a user is their head's; what else there is is named.
TEST(BlenderVrpn, ASensorPlacesTheUserWhomItNames) {
  Room room = roomOfFormat("a.xml", "a room", "m", 1.0);
  addPerson("Zoe", 0.06, {}, {1, 1}, "Zoe", room);
  addPerson("Abe", 0.06, {}, {1, 1}, "Abe", room);
  const Part vrpn = partOf(parseXml("a.xml",
                                    "<vrpn>\n<tracker name='T' host='h' scale='2'>\n"
                                    "<sensor id='3' processor_method='user_position' users='Abe'/>\n"
                                    "<sensor id='4' processor_method='user_position' users='Abe'/>\n"
                                    "<sensor id='5' processor_method='wand' users='Zoe'/>\n</tracker>\n"
                                    "<analog name='A' host='h'/>\n</vrpn>",
                                    Doctype::none)
                               .root);
  readBlenderVrpn(vrpn, {{"Zoe", 0}, {"Abe", 1}}, room);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "T@tcp://h");
  EXPECT_FALSE(room.people[0].isTracked);
  EXPECT_TRUE(room.people[1].isTracked);
  EXPECT_EQ(room.people[1].setup.head.sensor.sensor, 3);
  EXPECT_EQ(findingWith(room, "the tracker's scale is left out").at.line, 2);
  EXPECT_EQ(findingWith(room, "sensor 4 of tracker 'T' is left out").at.line, 4);
  EXPECT_EQ(findingWith(room, "sensor 5 of tracker 'T' is left out").at.line, 5);
  EXPECT_EQ(findingWith(room, "the analog 'A' is left out").at.line, 7);
  EXPECT_EQ(room.findings.size(), 4u) << allFindings(room);
}

}  // namespace
}  // namespace carom
