// The users, proxies and devices of rooms of VR Juggler.
#include "app/cave_formats/jconf_input.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/cave_formats/jconf_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace jconf = test::jconf;
using test::allFindings;
using test::roomOf;
using test::with;

TEST(JconfFile, HeadsFollowAliasProxyAndDevice) {
  const Room room = roomOf("room.jconf", jconf::kCave);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "Art@tcp://host");
  // A quarter turn about y takes x to −z; then a metre up.
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker * glm::dvec3(1, 0, 0), {0, 1, -1}), 1e-9);
  EXPECT_EQ(room.people[0].setup.head.sensor.sensor, 2);
  EXPECT_LT(glm::length(room.people[0].setup.head.eyesFromSensor * glm::dvec3(0.1, 0, 0)), 1e-9);
  EXPECT_FALSE(room.people[0].setup.hand);
}

TEST(JconfFile, TrackdIsReadFromItsMemory) {
  std::string text = with(jconf::kCave, "<vrpn name='Art'><tracker_server>Art@host</tracker_server>",
                          "<trackd_sensor name='Art'>");
  text = with(text, "</vrpn>",
              "</trackd_sensor><trackd_controller "
              "name='W'><shared_memory_key>99</shared_memory_key></trackd_controller>");
  const Room room = roomOf(
      "room.jconf", with(text, "<device_units>1</device_units>", "<device_units>0.3048</device_units>"));
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].source, "shm://4126?wand=99");
  EXPECT_EQ(room.trackers[0].unit_m, 0.3048);
  EXPECT_TRUE(room.people[0].isTracked);
}

TEST(JconfInput, UsersKeepTheirOrderAndOneIsThereAtLeast) {
  Room room = roomOf("room.jconf", jconf::kCave);
  room.people.clear();
  room.viewers.clear();
  const Part two =
      partOf(parseXml("a.jconf",
                      "<elements><user name='Zoe'><interocular_distance>0.06</interocular_distance></user>"
                      "<user name='Abe'/></elements>",
                      Doctype::none)
                 .root);
  const auto users = readJconfUsers(two, room);
  ASSERT_EQ(room.people.size(), 2u);
  EXPECT_EQ(users.at("Zoe"), 0u);
  EXPECT_EQ(users.at("Abe"), 1u);
  EXPECT_EQ(room.people[0].setup.name, "Zoe");
  EXPECT_EQ(room.people[0].setup.head.eyeSeparation_m, 0.06);
  EXPECT_FALSE(room.people[1].isTracked);
  room.people.clear();
  room.viewers.clear();
  readJconfUsers(partOf(parseXml("a.jconf", "<elements/>", Doctype::none).root), room);
  EXPECT_EQ(room.people.size(), 1u);
}

}  // namespace
}  // namespace carom
