// The viewers of a rig file and the eyes that its walls show.
#include "app/rig/rig_viewers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"
#include "cave/room/wall_eyes.h"
#include "places.h"

namespace carom {
namespace {

using test::changed;
using test::read;

/// A room for two: kGood without its head, with two viewers and a wall for each.
std::string roomForTwo() {
  const auto viewer = [](const std::string& name, int sensor) {
    return "[[viewer]]\nname = '" + name + "'\ntracker = 'cap'\nsensor = " + std::to_string(sensor) + "\n";
  };
  std::string text =
      changed("[head]\ntracker = 'cap'\neye_separation = 62\n", viewer("anna", 0) + viewer("ben", 1));
  const std::string wall = text.substr(text.find("[[wall]]"));
  std::string second = wall;
  second.replace(second.find("'front'"), 7, "'front-ben'");
  return text + "stereo = 'side-by-side'\nviewer = 'anna'\n" + second +
         "stereo = 'side-by-side'\nviewer = 'ben'\n";
}

std::string changedForTwo(const std::string& from, const std::string& to) {
  std::string text = roomForTwo();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Rig, HasAViewerForEachPersonInTheRoom) {
  const Rig rig = read(roomForTwo());
  EXPECT_EQ(namesOf(rig.viewers), (std::vector<std::string>{"anna", "ben"}));
  EXPECT_EQ(rig.viewers[1].head.sensor, (SensorChoice{0, 1}));
  EXPECT_EQ(eyesOf(rig.walls[1]), (std::vector<ViewerEye>{{1, Eye::left}, {1, Eye::right}}));
  EXPECT_EQ(sightsOf(rig, 1), (std::vector<std::string>{"sees front-ben (left), front-ben (right)"}));

  const Rig bens = rigFor(rig, "ben");
  EXPECT_EQ(namesOf(bens.viewers), (std::vector<std::string>{"ben", "anna"}));
  ASSERT_EQ(bens.walls.size(), 1u);
  EXPECT_EQ(bens.walls[0].name, "front-ben");
  EXPECT_EQ(bens.walls[0].viewer, 0u);
}

TEST(Rig, AWallMayShowEyesOfTwoPeople) {
  std::string text = changedForTwo("viewer = 'anna'", "eyes = ['anna.left', 'ben.left']");
  text.replace(text.find("viewer = 'ben'"), 14, "eyes = ['anna.right', 'ben.right']");
  const Rig rig = read(text);
  EXPECT_EQ(rig.walls[0].eyes, (std::vector<ViewerEye>{{0, Eye::left}, {1, Eye::left}}));
  EXPECT_EQ(rig.walls[0].pictureNames, (std::vector<std::string>{"front-anna", "front-ben"}));
  const Rig bens = rigFor(rig, "ben");
  ASSERT_EQ(bens.walls.size(), 2u);
  EXPECT_EQ(bens.walls[0].stereo, StereoMode::left);
  EXPECT_EQ(bens.walls[1].stereo, StereoMode::right);
  EXPECT_EQ(bens.walls[0].pictureNames, (std::vector<std::string>{"front-ben"}));
  const Rig swapped = read(changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['right', 'left']"));
  EXPECT_EQ(swapped.walls[0].eyes, (std::vector<ViewerEye>{{0, Eye::right}, {0, Eye::left}}));
}

TEST(Rig, AWallMayShowOnePictureToBothEyesOfEach) {
  const Rig eve = readRig(CAROM_CONFIG_DIR "/rigs/eve.toml");
  EXPECT_EQ(eve.walls.back().eyes, (std::vector<ViewerEye>{{1, Eye::middle}, {0, Eye::middle}}));
  EXPECT_EQ(sightsOf(eve, 1).back(), "sees floor (both eyes)");
  const Rig alone = rigFor(eve, "second");
  EXPECT_EQ(alone.walls.back().name, "floor");
  EXPECT_EQ(alone.walls.back().stereo, StereoMode::mono);
}

TEST(Rig, RefusesViewersWhoDoNotFitTheirWalls) {
  const std::string third = "[[viewer]]\nname = 'cleo'\ntracker = 'cap'\nsensor = 2\n";
  std::string five = roomForTwo();
  for (const char* name : {"c", "d", "e"})
    five += std::string("[[viewer]]\nname = '") + name +
            "'\ntracker = 'cap'\nsensor = " + std::to_string(name[0]) + "\n";
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {changedForTwo("sensor = 1", "sensor = 0"),
            ":10:10: viewers 'anna' and 'ben' have one sensor of tracker 'cap', expected one each"},
           {changedForTwo("name = 'ben'", "name = 'anna'"),
            "the name 'anna' is taken in line 4, expected another"},
           {changedForTwo("viewer = 'anna'\n", ""),
            "wall 'front' does not say whose eyes it shows, expected viewer = 'anna' or 'ben'"},
           {changedForTwo("viewer = 'ben'\n", "viewer = 'bob'\n"),
            "there is no viewer 'bob', expected 'anna' or 'ben'"},
           {changedForTwo("viewer = 'ben'\n", "viewer = 'anna'\n"),
            "wall 'front-ben' shows anna.left on the screen of wall 'front', which shows this eye already, "
            "expected "
            "each eye once on a screen"},
           {roomForTwo() + third,
            "no wall shows the eyes of viewer 'cleo', expected one [[wall]] at least with viewer "
            "= 'cleo'"},
           {changedForTwo("stereo = 'side-by-side'\nviewer = 'ben'", "stereo = 'left'\nviewer = 'ben'"),
            "viewer 'ben' sees the screen of wall 'front-ben' with the left eye only, expected both"},
           {changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['left']"),
            "eyes has 1 name, expected one for each of the 2 channels of 'side-by-side'"},
           {changedForTwo("viewer = 'anna'", "viewer = 'anna'\neyes = ['left', 'up']"),
            "eyes has 'up', expected 'left', 'right', 'middle' or a viewer's, such as 'anna.left'"},
           {changedForTwo("viewer = 'anna'", "eyes = ['anna.left', 'bob.left']"),
            "eyes has 'bob.left', expected"},
           {five, "expected at most 4 in a room"},
           {roomForTwo() + "[head]\ntracker = 'cap'\n",
            "is the head of the one viewer of a room without [[viewer]], expected none"}}) {
    SCOPED_TRACE(words);
    try {
      read(text);
      ADD_FAILURE() << "was read";
    } catch (const InputErrors& error) {
      std::string all;
      for (const InputError& fault : error.faults()) all += std::string(fault.what()) + "\n";
      EXPECT_NE(all.find(words), std::string::npos) << all;
      const std::size_t at = all.find("given.toml:");
      ASSERT_LT(at, all.find('\n')) << all;
      int line = 0, column = 0;
      EXPECT_EQ(std::sscanf(all.c_str() + at, "given.toml:%d:%d: ", &line, &column), 2) << all;
    }
  }
}

}  // namespace
}  // namespace carom
