// Checks of curved screens: where the eyes are before them, and how their rims meet.
#include "app/room_checks/curved_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "app/room_checks/judged_room.h"
#include "app/room_checks/room_check.h"
#include "app/room_checks/wall_shape.h"

namespace carom {
namespace {

using test::allOf;
using test::Edits;
using test::headAt;
using test::kRoom;
using test::roomWith;

std::string cylinder(const std::string& radius, const std::string& from, const std::string& to) {
  return "screen = { shape = 'cylinder', foot = [0, 0, 0], axis = [0, 1, 0], radius = " + radius +
         ", from_deg = " + from + ", to_deg = " + to + ", bottom = 0, top = 3.4 }";
}

/// A room of one cylinder about the person, from -60 to 60 degrees, its middle at the height of the eyes.
Edits aroundThePerson() {
  Edits edits{{11, cylinder("2", "-60", "60")}, {12, ""}, {13, ""}};
  for (std::size_t line = 17; line <= kRoom.size(); ++line) edits.push_back({line, ""});
  return edits;
}

/// A room of two cylinders, of 2 m and of such a radius, that meet ahead.
Room ofTwo(const std::string& radius) {
  Edits edits{{10, "name = 'front-a'"}, {11, cylinder("2", "-60", "0")},   {12, ""}, {13, ""},
              {18, "name = 'front-b'"}, {19, cylinder(radius, "0", "60")}, {20, ""}, {21, ""}};
  for (std::size_t line = 25; line <= kRoom.size(); ++line) edits.push_back({line, ""});
  return roomWith(edits);
}

// The arc is a third of a turn of 2 m, 4.189 m; the chords of its mesh are a little shorter.
TEST(CurvedChecks, SayTheScreenInWords) {
  const Room room = roomWith(aroundThePerson());
  EXPECT_EQ(allOf(judgeRoom(room)), "");
  const std::string words = wordsForCurved(room.walls.at(0), room);
  EXPECT_EQ(words.find("front: curved, 4.18"), 0u) << words;
  EXPECT_NE(words.find(" × 3.400 m along it, turns by 120°, "), std::string::npos) << words;
  EXPECT_NE(words.find("\n  600 × 600 pixels an eye, drawn by rank 0 on "), std::string::npos) << words;
}

TEST(CurvedChecks, ThePersonLooksAtTheScreenFromBefore) {
  const auto findings = [](const std::string& head) {
    Edits edits = aroundThePerson();
    for (const auto& edit : headAt(head)) edits.push_back(edit);
    return judgeRoom(roomWith(edits));
  };
  const auto isSaid = [](const std::vector<Finding>& all, Finding::Kind kind, const std::string& words) {
    return std::any_of(all.begin(), all.end(), [&](const Finding& finding) {
      return finding.kind == kind && finding.at.line == 10 && finding.text.find(words) != std::string::npos;
    });
  };
  const auto behind = findings("[0, 0, -5]");
  EXPECT_TRUE(isSaid(behind, Finding::Kind::error, "is behind the whole screen of wall 'front'"))
      << allOf(behind);
  // 0.1 m before the screen the middles of its triangles are 0.57 m above and below: atan(5.7) is 80 degrees.
  const auto near = findings("[0, 0, -1.9]");
  EXPECT_TRUE(isSaid(near, Finding::Kind::warning, "from its normal, expected at most 75°")) << allOf(near);
}

TEST(CurvedChecks, RimsMeet) {
  EXPECT_EQ(allOf(judgeRoom(ofTwo("2"))), "");
  const std::vector<Finding> apart = judgeRoom(ofTwo("2.02"));
  ASSERT_EQ(apart.size(), 1u) << allOf(apart);
  EXPECT_EQ(apart[0].at.line, 17);
  EXPECT_NE(apart[0].text.find("the rims of walls 'front-a' and 'front-b' miss each other by 2"),
            std::string::npos)
      << apart[0].text;
  EXPECT_EQ(allOf(judgeRoom(ofTwo("2.3"))), "") << "they are apart on purpose";
  EXPECT_TRUE(screenEndsOf(roomWith({})).empty()) << "of flat walls";
  EXPECT_EQ(screenEndsOf(ofTwo("2")).size(), 2u);
}

// The chord of a cylinder that is the same on both sides faces its axis.
TEST(CurvedChecks, AChordFacesAsItsScreenDoes) {
  const Wall chord = chordOf(roomWith(aroundThePerson()).walls.at(0).wall);
  EXPECT_FALSE(chord.screen);
  EXPECT_LT(glm::distance(normal(chord), glm::dvec3(0, 0, 1)), 1e-9);
  EXPECT_NEAR(middle(chord).x, 0.0, 1e-9);
  EXPECT_NEAR(middle(chord).y, 1.7, 1e-9);
  EXPECT_NEAR(width_m(chord), 1.0, 1e-12);
}

}  // namespace
}  // namespace carom
