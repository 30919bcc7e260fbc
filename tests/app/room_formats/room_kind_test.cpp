#include "app/room_formats/room_kind.h"

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/room_formats/read_room.h"
#include "places.h"

namespace carom {
namespace {

using test::refusalOf;
using test::TemporaryFolder;

const std::filesystem::path kRooms = CAROM_TESTS_DIR "/data/rooms";

TEST(RoomKind, IsToldByContent) {
  const TemporaryFolder folder;
  const std::string xml = "<Cluster><Node><Window><Size x='9' y='9'/></Window></Node></Cluster>";
  EXPECT_EQ(readForeignRoom(folder.file("a.xml", xml)).format, "an SGCT room");
  EXPECT_EQ(readForeignRoom(folder.file("a.eqc", xml)).format, "an SGCT room");
  EXPECT_EQ(readForeignRoom(folder.file("b.xml", "<COCONFIG/>")).format, "an OpenCOVER room");
  EXPECT_EQ(readForeignRoom(folder.file("c.xml", "<configuration/>")).format, "a VR Juggler room");
  EXPECT_EQ(readForeignRoom(folder.file("d.xml", "<virtualEnvironment/>")).format, "a BlenderCAVE room");
  EXPECT_EQ(readForeignRoom(folder.file("e.json", "{\"nDisplay\": {}}")).format, "an nDisplay room");
  EXPECT_EQ(readForeignRoom(folder.file("f.txt", "# words\n[screen] id=a\n")).format, "an nDisplay room");
  EXPECT_EQ(readForeignRoom(folder.file("g.txt", "# words\nserver\n{\n}\n")).format, "an Equalizer room");
  EXPECT_EQ(readForeignRoom(folder.file("h.xml", "<pvx/>")).format, "a ParaView room");
  EXPECT_TRUE(isForeignRoom(folder.file("i", xml)));
  EXPECT_FALSE(isForeignRoom(folder.file("j", "title = 'a rig'\n")));
  EXPECT_FALSE(isForeignRoom(folder.file("k.toml", xml)));
}

TEST(RoomKind, WhatFitsNoneIsToldWhatWasLookedFor) {
  for (const auto& [name, text] : std::map<std::string, std::string>{{"a.xml", "<html/>"},
                                                                     {"b.json", "{\"a\": 1}"},
                                                                     {"c.eqc", "words\n"},
                                                                     {"d.cfg", "[other] a=1\n"}}) {
    const std::string said = refusalOf(name, text);
    EXPECT_EQ(said.rfind("1:1: ", 0), 0u) << said;
    EXPECT_NE(said.find("OpenCOVER"), std::string::npos) << said;
    EXPECT_NE(said.find("HEVS"), std::string::npos) << said;
  }
}

TEST(RoomKind, DeepXmlAndWholeEntitiesAreRefused) {
  std::string deep = "<COCONFIG>";
  for (int i = 0; i < 32; ++i) deep += "\n<a>";
  EXPECT_NE(refusalOf("a.xml", deep).find("33:1: elements are nested too deep, expected at most 32"),
            std::string::npos);
  EXPECT_NE(refusalOf("b.xml", "<!DOCTYPE a [<!ENTITY % p 'x'>]>\n<COCONFIG/>").find("defines an entity"),
            std::string::npos);
}

/// The corners of real rooms, read from their files by another program.
TEST(RoomKind, CornersOfRealRoomsAreThoseOfAnIndependentReading) {
  std::ifstream rows(kRooms / "corners.jsonl");
  std::map<std::pair<std::string, std::string>, Room> rooms;
  std::map<std::string, std::size_t> expected;
  for (std::string row; std::getline(rows, row);) {
    const auto wall = nlohmann::json::parse(row);
    const std::string file = wall["file"], name = wall["room"];
    const auto key = std::pair(file, name);
    if (!rooms.contains(key)) rooms.emplace(key, readForeignRoom(kRooms / file, name));
    ++expected[file + name];
    const auto point = [&](const char* corner) {
      return glm::dvec3(wall[corner][0], wall[corner][1], wall[corner][2]);
    };
    const bool found =
        std::any_of(rooms[key].walls.begin(), rooms[key].walls.end(), [&](const RoomWall& read) {
          constexpr double kNear_m = 1e-5;
          return glm::distance(read.wall.lowerLeft_m, point("lower_left")) < kNear_m &&
                 glm::distance(read.wall.lowerRight_m, point("lower_right")) < kNear_m &&
                 glm::distance(read.wall.upperLeft_m, point("upper_left")) < kNear_m;
        });
    EXPECT_TRUE(found) << row;
  }
  ASSERT_EQ(rooms.size(), 9u);
  for (const auto& [key, room] : rooms) {
    EXPECT_EQ(room.walls.size(), expected[key.first + key.second]) << key.first;
    EXPECT_FALSE(room.hasErrors()) << key.first;
  }
}

TEST(RoomKind, ANameIsRefusedWhereThereIsOneRoom) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/fuzz/fuzz_rooms";
  for (const char* name :
       {"room.eqc", "sgct.xml", "room.ndisplay", "room.cfg", "blender.xml", "cover_memory.xml"}) {
    try {
      readForeignRoom(rooms / name, "Other");
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("expected no --room 'Other'"), std::string::npos)
          << error.what();
    }
  }
}

TEST(RoomKind, OnlyWhatNobodyReadsIsNamedAsUnread) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/fuzz/fuzz_rooms";
  const std::map<std::string, std::vector<std::string>> unread{{"hevs_curved.json", {"warp_path 'warp.tif'"}},
                                                               {"cover.xml", {"'Old'"}}};
  for (const auto& entry : std::filesystem::directory_iterator(rooms)) {
    const auto expected = unread.find(entry.path().filename());
    std::vector<std::string> named;
    for (const Finding& finding : readForeignRoom(entry.path()).findings) {
      const std::size_t end = finding.text.find(" is left out: nothing here does the like");
      if (end != std::string::npos) named.push_back(finding.text.substr(0, end));
    }
    EXPECT_EQ(named, expected == unread.end() ? std::vector<std::string>() : expected->second)
        << entry.path();
  }
}

TEST(RoomKind, AnUnknownWordInAnyPartIsNamed) {
  // In the formats of brackets: after each opening one.
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/fuzz/fuzz_rooms";
  for (const auto& [name, word, parts] :
       {std::tuple("hevs.json", "\"zzz\": 1, ",
                   std::vector<std::string>{"\"Cave\": {", "\"Glasses\": {", "\"half\": {", "\"front\": {",
                                            "\"stereo\": {"}),
        std::tuple("room.ndisplay", "\"zzz\": 1, ",
                   std::vector<std::string>{"\"scene\": {", "\"s_left\": {", "\"L\": {", "\"v_left\": {",
                                            "\"a\": {"}),
        std::tuple("cover.xml", " zzz=\"1\"",
                   std::vector<std::string>{"<Stereo", "<FloorHeight", "<Window name=\"0\"", "<Head"}),
        std::tuple("blender.xml", " zzz=\"1\"", std::vector<std::string>{"<user", "<tracker", "<sensor"}),
        std::tuple("room.jconf", "<zzz>1</zzz>",
                   std::vector<std::string>{"</display_window", "</vrpn", "</user>"})}) {
    std::ifstream file(rooms / name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const std::string& part : parts) {
      std::string more = text;
      const std::size_t at = more.find(part);
      ASSERT_NE(at, std::string::npos) << name << part;
      more.insert(part[1] == '/' ? at : at + part.size(), word);
      const Room room = test::roomOf(name, more);
      EXPECT_NE(test::findingWith(room, "zzz '1' is left out").at.line, 0)
          << name << part << test::allFindings(room);
    }
  }
}

}  // namespace
}  // namespace carom
