// What the objects of a HEVS configuration inherit from others.
#include "app/cave_formats/hevs_inheritance.h"

#include <gtest/gtest.h>

#include <string>

#include "app/cave_formats/hevs_rooms.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

using test::allFindings;
using test::roomOf;
using test::wallOf;
using test::hevs::kRooms;

TEST(HevsFile, PlatformsInheritPartByPart) {
  const Room room = roomOf("room.json", kRooms, "Mono");
  ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
  EXPECT_EQ(wallOf(room, "left").wall.stereo, StereoMode::mono);
  EXPECT_TRUE(wallOf(room, "left").wall.eyes.empty());
  EXPECT_EQ(room.eyeSeparation_m, 0.063);
}

Part json(const std::string& text) {
  const test::TemporaryFolder folder;
  return partOf(readJson(folder.file("a.json", text)));
}

// The members of an object win over those that it inherits, and these over what they inherit in their turn.
TEST(HevsInheritance, LaterMembersWin) {
  const Part all = json(R"({"a": {"x": 1, "y": 1, "z": 1}, "b": {"inherit": "a", "y": 2, "z": 2},
    "c": {"inherit": "b", "z": 3}})");
  Room room;
  HevsInheritance inheritance(all, room);
  const Part c = inheritance.of(*all.find("c"));
  EXPECT_EQ(c.textOf("x"), "1");
  EXPECT_EQ(c.textOf("y"), "2");
  EXPECT_EQ(c.textOf("z"), "3");
  EXPECT_EQ(allFindings(room), "");
}

TEST(HevsInheritance, NothingAndItselfAreRefused) {
  const Part all = json(R"({"a": {"inherit": "b"},
 "b": {"inherit": "a"},
 "c": {"inherit": "none"}})");
  for (const char* name : {"a", "c"}) {
    Room room;
    HevsInheritance(all, room).of(*all.find(name));
    EXPECT_TRUE(room.hasErrors()) << name;
    EXPECT_EQ(room.findings.size(), 1u) << name << "\n" << allFindings(room);
  }
}

}  // namespace
}  // namespace carom
