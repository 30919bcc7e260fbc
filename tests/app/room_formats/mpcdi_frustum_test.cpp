// Where the flat pictures of MPCDI rooms are: by angles, and as parts of a whole.
#include "app/room_formats/mpcdi_frustum.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/room_formats/read_room.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

using test::allFindings;

Part xml(const std::string& text) { return partOf(parseXml("a.xml", text, Doctype::none).root); }

std::string tag(const std::string& name, double value) {
  return "<" + name + ">" + std::to_string(value) + "</" + name + ">";
}

Part region(double yaw, double pitch, double roll, const std::string& frame = "") {
  return xml("<region id='r'><frustum>" + tag("leftAngle", -45) + tag("rightAngle", 0) + tag("downAngle", 0) +
             tag("upAngle", 45) + tag("yaw", yaw) + tag("pitch", pitch) + tag("roll", roll) + "</frustum>" +
             frame + "</region>");
}

void expectNear(const glm::dvec3& found_m, const glm::dvec3& expected_m) {
  EXPECT_LT(glm::distance(found_m, expected_m), 1e-9) << found_m.x << ' ' << found_m.y << ' ' << found_m.z;
}

// The tangents of 45 and 0 degrees put the corners 3 m and 0 m beside the point that is 3 m ahead.
TEST(MpcdiFrustum, AnglesGiveAWallThreeMetresAway) {
  Room room;
  const auto ahead = cornersByAngles(region(0, 0, 0), room);
  ASSERT_TRUE(ahead);
  expectNear(ahead->lowerLeft_m, {-3, 0, -3});
  expectNear(ahead->lowerRight_m, {0, 0, -3});
  expectNear(ahead->upperLeft_m, {-3, 3, -3});
  ASSERT_EQ(room.viewers.size(), 1u);
  const auto right = cornersByAngles(region(90, 0, 0), room);
  ASSERT_TRUE(right);
  expectNear(right->lowerLeft_m, {3, 0, -3});
  expectNear(right->lowerRight_m, {3, 0, 0});
  const auto up = cornersByAngles(region(0, 90, 0), room);
  ASSERT_TRUE(up);
  expectNear(up->lowerRight_m, {0, 3, 0});
  expectNear(up->upperLeft_m, {-3, 3, 3});
  const auto rolled = cornersByAngles(region(0, 0, 90), room);
  ASSERT_TRUE(rolled);
  expectNear(rolled->lowerLeft_m, {0, 3, -3});
  EXPECT_EQ(room.viewers.size(), 1u) << "the first viewer counts";
  EXPECT_EQ(allFindings(room), "");
}

// A frame with its yaw axis down, its pitch axis to the right and its roll axis ahead is the room's.
TEST(MpcdiFrustum, AFrameMovesThePoint) {
  const auto frame = [](const std::string& roll) {
    return "<coordinateFrame>" + tag("posx", 1) + tag("posy", 2) + tag("posz", 3) + tag("yawx", 0) +
           tag("yawy", -1) + tag("yawz", 0) + tag("pitchx", 1) + tag("pitchy", 0) + tag("pitchz", 0) +
           tag("rollx", 0) + tag("rolly", 0) + roll + "</coordinateFrame>";
  };
  Room room;
  const auto corners = cornersByAngles(region(0, 0, 0, frame(tag("rollz", -1))), room);
  ASSERT_TRUE(corners);
  expectNear(corners->lowerLeft_m, {-2, 2, 0});
  expectNear(room.viewers.at(0).eyes_m, {1, 2, 3});
  EXPECT_EQ(allFindings(room), "");
  EXPECT_FALSE(cornersByAngles(region(0, 0, 0, frame(tag("rollz", 1))), room)) << "mirrored";
  EXPECT_FALSE(cornersByAngles(region(0, 0, 0, frame("")), room));
  const std::string said = allFindings(room);
  EXPECT_NE(said.find("the axes of coordinateFrame are no rotation"), std::string::npos) << said;
  EXPECT_NE(said.find("rollz is missing in coordinateFrame"), std::string::npos) << said;
}

TEST(MpcdiFrustum, APartOfAPictureIsAheadAtTheHeightOfTheEyes) {
  const Part buffer = xml("<buffer xResolution='800' yResolution='400'/>");
  Room room;
  const auto corners = cornersByShare(xml("<region x='0.5' y='0' xsize='0.5' ysize='0.5'/>"), buffer, room);
  ASSERT_TRUE(corners);
  expectNear(corners->lowerLeft_m, {0, kStandingEyes_m - 1.0, -3});
  expectNear(corners->lowerRight_m, {2, kStandingEyes_m - 1.0, -3});
  expectNear(corners->upperLeft_m, {0, kStandingEyes_m, -3});
  EXPECT_FALSE(cornersByShare(xml("<region/>"), xml("<buffer/>"), room));
  EXPECT_EQ(room.findings.size(), 1u) << allFindings(room);
  Room second;
  EXPECT_FALSE(cornersByShare(xml("<region xsize='0'/>"), buffer, second));
  EXPECT_TRUE(second.hasErrors()) << "a part without a size is told, too";
}

TEST(MpcdiFrustum, PixelsGoByEitherName) {
  Room room;
  EXPECT_EQ(mpcdiPixels(xml("<region xResolution='800' yResolution='400'/>"), room), glm::ivec2(800, 400));
  EXPECT_EQ(mpcdiPixels(xml("<region Xresolution='80' Yresolution='40'/>"), room), glm::ivec2(80, 40));
  EXPECT_EQ(allFindings(room), "");
  EXPECT_FALSE(mpcdiPixels(xml("<region xResolution='800'/>"), room));
  EXPECT_TRUE(room.hasErrors());
}

}  // namespace
}  // namespace carom
