// Rooms of all formats with the same mistakes: cut in half, without a wall, with a name or a value twice.

#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "app/room_formats/read_room.h"
#include "places.h"

namespace carom {
namespace {

using test::allFindings;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::with;

const std::filesystem::path kFuzzRooms = CAROM_TESTS_DIR "/fuzz/fuzz_rooms";

std::string textOf(const std::string& name) {
  std::ifstream file(kFuzzRooms / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(BadRooms, HalfAFileSaysWhereItEnds) {
  for (const auto& entry : std::filesystem::directory_iterator(kFuzzRooms)) {
    const std::string name = entry.path().filename(), text = textOf(name);
    const std::string said = refusalOf(name, text.substr(0, text.size() / 2));
    // The lines of the text form of nDisplay stand alone.
    const bool isLines = entry.path().extension() == ".cfg";
    EXPECT_NE(said.find(isLines ? "this line has no closing bracket" : "the file ends within"),
              std::string::npos)
        << name << ": " << said;
  }
}

TEST(BadRooms, AnEndIsNamedByWhatIsOpen) {
  EXPECT_EQ(refusalOf("a.xml", "<COCONFIG>\n <LOCAL HOST='a'>\n  <COV"),
            "3:3: the file ends within <LOCAL> of line 2, expected </LOCAL>");
  EXPECT_EQ(refusalOf("a.json", "{\"platforms\": {\n \"A\": [1, 2"),
            "2:12: the file ends within an array 'A' of line 2, expected ']'");
  // What is wrong elsewhere is no end.
  EXPECT_NE(refusalOf("a.xml", "<COCONFIG><LOCAL></COCONFIG>").find("this is no XML (mismatched tag)"),
            std::string::npos);
  EXPECT_NE(refusalOf("a.json", "{\"platforms\": {,}}").find("this is no JSON at"), std::string::npos);
}

TEST(BadRooms, ARoomWithoutAnyWallIsRefused) {
  for (const auto& [name, text] : std::map<std::string, std::string>{
           {"cover.xml", "<COCONFIG><LOCAL HOST='a'><COVER><ScreenConfig/></COVER></LOCAL></COCONFIG>"},
           {"blender.xml", "<blender_cave><user name='a'/><computer name='b'/></blender_cave>"},
           {"blendervr.xml", "<blendervr><screens/></blendervr>"},
           {"a.ndisplay", "{\"nDisplay\": {\"scene\": {}, \"cluster\": {\"nodes\": {}}}}"},
           {"a.cfg", "[viewport] id=vp x=0 y=0 width=9 height=9\n"},
           {"a.jconf", "<configuration><elements><display_window name='a'/></elements></configuration>"},
           {"a.eqc", "server { config { appNode { pipe { window { channel { name \"a\" } } } } } }"},
           {"a.json", "{\"platforms\": {\"A\": {\"nodes\": {\"b\": {}}}}}"}}) {
    const std::string said = refusalOf(name, text);
    EXPECT_NE(said.find("no wall here"), std::string::npos) << name << ": " << said;
    EXPECT_NE(said.find("expected"), std::string::npos) << name << ": " << said;
  }
  for (const auto& [name, text] :
       {std::pair("sgct.json", "{\"nodes\": []}"),
        std::pair("sgct.xml", "<Cluster masterAddress='a'><Node address='a'/></Cluster>")})
    EXPECT_NE(refusalOf(name, text).find("no viewport here shows a wall"), std::string::npos) << name;
}

TEST(BadRooms, WallsOfOneNameAreToldApart) {
  const std::string screen =
      "<COVER><ScreenConfig><Screen name='0' comment='WALL' width='2000' height='1000'/>"
      "</ScreenConfig></COVER>";
  const std::string corners =
      "<corner name='topRightCorner'>1, 1, -1</corner><corner name='topLeftCorner'>-1, 1, -1</corner>"
      "<corner name='bottomRightCorner'>1, -1, -1</corner>";
  std::string jconf = textOf("cluster.jconf");
  const std::string viewport = "<surface_viewport name=\"hmd\"><tracked>true</tracked></surface_viewport>";
  const std::size_t first = jconf.find("<surface_viewport name=\"front\">");
  jconf = with(jconf, viewport, "\n" + jconf.substr(first, jconf.find("</surface_viewport>") + 19 - first));
  for (const auto& [name, text, line, words] :
       {std::tuple("room.xml",
                   "<COCONFIG>\n<LOCAL HOST='a'>" + screen + "</LOCAL>\n<LOCAL HOST='b'>" + screen +
                       "</LOCAL>\n</COCONFIG>",
                   3, "the name 'WALL' is that of the wall of line 2, too: this one is called 'WALL-2'"),
        std::tuple("room.xml",
                   "<blender_cave><computer name='pc'>\n<screen name='main'>" + corners +
                       "</screen>\n<screen name='main'>" + corners + "</screen></computer></blender_cave>",
                   3,
                   "the name 'pc-main' is that of the wall of line 2, too: this one is called 'pc-main-2'"),
        std::tuple("room.jconf", jconf, 15,
                   "the name 'front' is that of the wall of line 11, too: this one is called 'front-2'")}) {
    const Room room = roomOf(name, text);
    ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
    EXPECT_EQ(findingWith(room, words).at.line, line) << allFindings(room);
  }
}

TEST(BadRooms, EqualNamesThatDecideAnythingAreRefused) {
  for (const auto& [name, old, now] : {std::tuple("cover.xml", "<Screen name=\"1\"", "<Screen name=\"0\""),
                                       std::tuple("blender.xml", "name=\"user B\"", "name=\"user A\""),
                                       std::tuple("room.ndisplay", "\"s_view\": {", "\"s_floor\": {"),
                                       std::tuple("room.cfg", "[screen] id=view ", "[screen] id=front "),
                                       std::tuple("room.cfg", "[input] id=axes", "[input] id=art"),
                                       std::tuple("room.eqc", "name \"high\"", "name \"low\""),
                                       std::tuple("hevs.json", "\"spare\": {", "\"dome\": {")}) {
    const std::string said = refusalOf(name, with(textOf(name), old, now));
    EXPECT_NE(said.find("is taken in line"), std::string::npos) << name << ": " << said;
  }
}

TEST(BadRooms, AWrongCornerIsNamedAtItsPlace) {
  for (const auto& [name, old, now, words] :
       {std::tuple("cover.xml", "width=\"4000\"", "width=\"0\"", "no width"),
        std::tuple("sgct.xml", "<Pos x='2' y='2' z='-2'/></Viewplane>",
                   "<Pos x='2' y='2' z='a'/></Viewplane>", "z is the text 'a', expected a number"),
        std::tuple("blendervr.xml", "<wall><corner name=\"topRightCorner\">1, 1, -1</corner>",
                   "<wall><corner name=\"topRightCorner\">1, 1, -1.1</corner>", "mm"),
        std::tuple("room.ndisplay", "\"width\": 300, \"height\": 200", "\"width\": 300, \"height\": 0",
                   "no height"),
        std::tuple("room.cfg", " size=\"X=3,Y=2\"", "", "size is missing in screen 'front'"),
        std::tuple("room.eqc", "bottom_right [ 2 0 1 ] top_left [ 2 2 -1 ]",
                   "bottom_right [ 2 0 1 ] top_left [ 2 2 0 ]", "misses the right angle"),
        std::tuple("hevs.json", "\"lr\": [-1, 0, 2], \"monitor\"", "\"lr\": [-1, 0, true], \"monitor\"",
                   "'true', expected a number")}) {
    const std::string said = refusalOf(name, with(textOf(name), old, now));
    EXPECT_NE(said.find(words), std::string::npos) << name << ": " << said;
    EXPECT_NE(said.rfind("0:", 0), 0u) << name << ": " << said;
  }
}

TEST(BadRooms, AValueThatIsThereTwiceIsNamed) {
  const Room room = roomOf("a.eqc", with(textOf("room.eqc"), "observer { eye_base .07 }",
                                         "observer { eye_base .05\n eye_base .07 }"));
  EXPECT_EQ(room.eyeSeparation_m, 0.07);
  EXPECT_EQ(findingWith(room, "eye_base is left out: the one of line 20 counts").at.line, 19)
      << allFindings(room);
}

TEST(BadRooms, TrackersOfOneNameAreToldApart) {
  const std::string device =
      "<Device><Art driver=\"dtrack\" port=\"5000\"/><B driver=\"vrpn\" tracker=\"Art\"/></Device>"
      "<Body><Head device=\"Art\"/><Hand device=\"B\"/></Body>"
      "<Persons><Person name=\"P\" head=\"Head\" hand=\"Hand\"/></Persons>";
  const auto roomWith = [](const std::string& input) {
    return roomOf("room.xml",
                  "<COCONFIG><GLOBAL><COVER><ScreenConfig><Screen name='0'/></ScreenConfig>\n<Input>" +
                      input + "</Input></COVER></GLOBAL></COCONFIG>");
  };
  const Room room = roomWith(device);
  ASSERT_EQ(room.trackers.size(), 2u) << allFindings(room);
  // Two devices of one port are one tracker, and only one of their places can count.
  const Room same = roomWith(with(device, "<B driver=\"vrpn\" tracker=\"Art\"/>",
                                  "<B driver=\"dtrack\" port=\"5000\"><Offset x=\"9\"/></B>"));
  ASSERT_EQ(same.trackers.size(), 1u) << allFindings(same);
  EXPECT_EQ(
      findingWith(same, "tracker 'B' is the one that is called 'Art' here, whose place in the room counts")
          .at.line,
      2)
      << allFindings(same);
}

}  // namespace
}  // namespace carom
