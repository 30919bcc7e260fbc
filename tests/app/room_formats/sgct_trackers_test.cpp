// The trackers of rooms of SGCT.
#include "app/room_formats/sgct_trackers.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/room_formats/read_room.h"
#include "app/room_formats/sgct_xml_room.h"

namespace carom {
namespace {

using test::allFindings;
using test::findingWith;
using test::roomOf;
using test::with;
using test::sgct::kRoom;

TEST(SgctXml, TrackersOfTheFirstUserComeOver) {
  const Room room = roomOf(
      "room.xml",
      with(kRoom, "<User eyeSeparation='0.067'>",
           "<Tracker name='Art'><Offset x='1' y='0' z='0'/><Device name='Glasses'><Sensor "
           "vrpnAddress='T@host' "
           "id='3'/><Offset x='0' y='0.1' z='0'/></Device>\n<Device name='Phone'><Sensor "
           "vrpnAddress='P@host' id='0'/>"
           "</Device></Tracker><User eyeSeparation='0.067'><Tracking tracker='Art' device='Glasses'/>"));
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].source, "T@tcp://host");
  EXPECT_EQ(room.trackers[0].roomFromTracker.position_m, glm::dvec3(1, 0, 0));
  ASSERT_TRUE(room.people.at(0).isTracked);
  EXPECT_EQ(room.people[0].setup.head.sensor.sensor, 3);
  EXPECT_EQ(room.people[0].setup.head.eyesFromSensor.position_m, glm::dvec3(0, -0.1, 0));
  EXPECT_EQ(findingWith(room, "device 'Phone'").at.line, 8);
}

TEST(SgctTrackers, AWandIsTheHandsAndWithoutAUserNothingIsTheHeads) {
  const test::TemporaryFolder folder;
  const JsonNode root = readJson(folder.file("a.json", R"({"trackers": [{"name": "Art",
    "orientation": {"yaw": 90, "pitch": 0, "roll": 0}, "devices": [
    {"name": "Wand", "sensors": [{"vrpnaddress": "W@host", "identifier": 5}], "offset": {"x": 0, "y": 0, "z": 0.2}},
    {"name": "Glasses", "sensors": [{"vrpnaddress": "G@host", "identifier": 0}]}]}]})"));
  Room room;
  room.viewers.push_back({});
  addSgctTrackers(root, room);
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].source, "W@tcp://host");
  // Yaw turns to the right: -z, which is ahead, goes to x.
  const glm::dvec3 ahead = room.trackers[0].roomFromTracker.orientation * glm::dvec3(0, 0, -1);
  EXPECT_LT(glm::distance(ahead, {1, 0, 0}), 1e-12);
  ASSERT_EQ(room.people.size(), 1u);
  EXPECT_FALSE(room.people[0].isTracked);
  ASSERT_TRUE(room.people[0].setup.hand);
  EXPECT_EQ(room.people[0].setup.hand->sensor, 5);
  EXPECT_EQ(room.people[0].setup.hand->handFromSensor.position_m, glm::dvec3(0, 0, -0.2));
  EXPECT_NE(findingWith(room, "device 'Glasses' of tracker 'Art' is left out").at.line, 0)
      << allFindings(room);
}

}  // namespace
}  // namespace carom
