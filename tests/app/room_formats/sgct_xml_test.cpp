// Rooms of SGCT in XML.
#include "app/room_formats/sgct_xml.h"

#include <gtest/gtest.h>

#include <string>

#include "app/room_formats/read_room.h"
#include "app/room_formats/sgct_xml_room.h"

namespace carom {
namespace {

using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::with;
using test::sgct::kRoom;

TEST(SgctXml, BothVersionsAreReadAsTheJson) {
  const Room room = roomOf("room.xml", kRoom);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 3u) << allFindings(room);
  EXPECT_TRUE(room.walls[2].wall.sky) << "a fisheye";
  expectCorners(room, "front", {-2, 0, -2}, {2, 0, -2}, {-2, 2, -2});
  expectCorners(room, "front-2", {0, 0, -2}, {2, 0, -2}, {0, 2, -2});
  EXPECT_EQ(room.walls[0].wall.stereo, StereoMode::sideBySide);
  EXPECT_TRUE(room.walls[0].wall.window.fullscreen);
  EXPECT_EQ(room.walls[1].wall.stereo, StereoMode::right);
  EXPECT_EQ(room.walls[1].wall.pixels, glm::ivec2(400, 400));
  EXPECT_EQ(room.walls[1].wall.node, 1);
  EXPECT_EQ(room.eyeSeparation_m, 0.067);
  EXPECT_EQ(room.viewers[0].eyes_m, glm::dvec3(0, 1.5, 3));
}

TEST(SgctXml, NamesWhatItLeavesOut) {
  const Room room = roomOf("room.xml", with(kRoom, "FisheyeProjection fov='180'", "SpoutOutputProjection"));
  EXPECT_EQ(findingWith(room, "a projection of type 'SpoutOutputProjection'").at.line, 6)
      << allFindings(room);
  ASSERT_EQ(room.walls.size(), 2u);
}

TEST(SgctXml, AnglesGiveAPlane) {
  const Room room = roomOf(
      "room.xml",
      "<Cluster><Node><Window><Size x='100' y='100'/><Viewport><PlanarProjection><FOV down='45' left='45' "
      "right='45' up='45' distance='2'/><Orientation heading='90' pitch='0' roll='0'/></PlanarProjection>"
      "</Viewport></Window></Node></Cluster>");
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  expectCorners(room, "right", {2, -2, -2}, {2, -2, 2}, {2, 2, -2});
}

TEST(SgctXml, NodesAreComputers) {
  const Room room = roomOf("room.xml", kRoom);
  ASSERT_EQ(room.nodes.size(), 2u);
  EXPECT_EQ(room.nodes[0].host, "a");
  EXPECT_EQ(room.nodes[1].host, "b");
  EXPECT_EQ(room.nodes[1].rank, 1);
  const Room second = roomOf("room.xml", with(kRoom, "masterAddress='a'", "masterAddress='b'"));
  EXPECT_EQ(findingWith(second, "the master 'b' is node 1: here the first leads").at.line, 1)
      << allFindings(second);
  const Room nobody = roomOf("room.xml", with(kRoom, "masterAddress='a'", "masterAddress='c'"));
  EXPECT_EQ(findingWith(nobody, "no node has the address of the master 'c'").at.line, 1)
      << allFindings(nobody);
  const Room here =
      roomOf("room.xml", with(with(kRoom, "ip='a'", "ip='127.0.0.1'"), "address='b'", "address='localhost'"));
  EXPECT_TRUE(here.nodes.empty());
}

TEST(SgctXml, FaultsAreNamedAtTheirPlaces) {
  EXPECT_EQ(refusalOf("room.xml", with(kRoom, "<size x='800'", "<size x='8/0'")).rfind("5:36: ", 0), 0u)
      << refusalOf("room.xml", with(kRoom, "<size x='800'", "<size x='8/0'"));
  EXPECT_NE(refusalOf("room.xml", "<Cluster/>"), "");
}

}  // namespace
}  // namespace carom
