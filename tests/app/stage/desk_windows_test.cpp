#include "app/stage/desk_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

#include "cave/display/window_layout.h"
#include "log_lines.h"

namespace carom {
namespace {

const std::vector<Monitor> kMonitors{{"DP-1", {0, 0}, {1920, 1080}}, {"HDMI-1", {1920, 0}, {1280, 1024}}};
const std::vector<ScreenPlace> kAreas{{{0, 0}, {1920, 1080}}, {{1920, 0}, {1280, 1024}}};

Wall wallAt(const char* name, int node, glm::ivec2 position_px, bool border) {
  Wall wall;
  wall.name = name;
  wall.node = node;
  wall.window = {.position_px = position_px, .size_px = {640, 480}, .border = border};
  return wall;
}

/// Returns whether two windows, with the titles and edges of those that have a border, have a point in
/// common.
bool meet(const WindowPlacement& a, const WindowPlacement& b) {
  const auto from = [](const WindowPlacement& w) {
    return w.position_px - (w.border ? glm::ivec2(kEdge_px, kTitle_px) : glm::ivec2(0));
  };
  const auto to = [](const WindowPlacement& w) {
    return w.position_px + w.size_px + (w.border ? glm::ivec2(kEdge_px) : glm::ivec2(0));
  };
  return glm::all(glm::lessThan(from(a), to(b))) && glm::all(glm::lessThan(from(b), to(a)));
}

/// Returns every window of the desk whose place was chosen.
std::vector<WindowPlacement> all(const Rig& rig, const DeskWindows& desk) {
  std::vector<WindowPlacement> windows;
  for (const Wall& wall : rig.walls) windows.push_back(wall.window);
  for (const auto& window : {desk.console, desk.outside, desk.diagram}) {
    if (window) windows.push_back(*window);
  }
  return windows;
}

TEST(DeskWindows, NoWindowOpensOnAnotherAndEachIsWholeOnAMonitor) {
  Rig rig;
  rig.walls = {wallAt("front", 0, {100, 100}, true), wallAt("left", 0, {300, 200}, true)};
  const test::LogLines log;
  const DeskWindows desk = placeWindows(rig, rig.walls, {true, true, true}, {}, kMonitors, kAreas);
  const std::vector<WindowPlacement> windows = all(rig, desk);
  ASSERT_EQ(windows.size(), 5U);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_TRUE(remember("window", placeOf(windows[i], kMonitors), kMonitors)) << i << " is on no monitor";
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(meet(windows[i], windows[j])) << i << " and " << j;
  }
  EXPECT_TRUE(log.said().empty());
}

TEST(DeskWindows, AWindowLiesWhereItLayLast) {
  Rig rig;
  rig.walls = {wallAt("front", 0, {10, 40}, true)};
  const RememberedWindow wall{memoryName(rig.walls[0]), "HDMI-1", {50, 60}, {700, 500}};
  const RememberedWindow outside{"outside", "DP-1", {200, 100}, {900, 600}};
  const RememberedWindow lost{"diagram", "DP-7", {0, 40}, {500, 400}};
  const DeskWindows desk =
      placeWindows(rig, rig.walls, {false, true, true}, {wall, outside, lost}, kMonitors, kAreas);
  EXPECT_EQ(placeOf(rig.walls[0].window, kMonitors), (ScreenPlace{{1970, 60}, {700, 500}}));
  ASSERT_TRUE(desk.outside && desk.diagram);
  EXPECT_FALSE(desk.console);
  EXPECT_EQ(placeOf(*desk.outside, kMonitors), (ScreenPlace{{200, 100}, {900, 600}}));
  EXPECT_TRUE(remember("diagram", placeOf(*desk.diagram, kMonitors), kMonitors)) << "its monitor is gone";
}

TEST(DeskWindows, WallsOfARoomStayWhereTheirRigHasThem) {
  Rig rig;
  rig.walls = {wallAt("front", 0, {0, 0}, false), wallAt("left", 1, {640, 0}, false)};
  const std::vector<Wall> before = rig.walls;
  const std::vector<Wall> drawnHere{rig.walls[0]};
  const DeskWindows desk = placeWindows(rig, drawnHere, {true, false, false}, {}, kMonitors, kAreas);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(rig.walls[i].window, before[i].window);
  ASSERT_TRUE(desk.console);
  for (const Wall& wall : rig.walls) EXPECT_FALSE(meet(*desk.console, wall.window)) << wall.name;
}

TEST(DeskWindows, AWallOfAnotherComputerTakesNoRoomHere) {
  Rig rig;
  rig.walls = {wallAt("front", 0, {0, 0}, false), wallAt("left", 1, {0, 0}, false)};
  rig.walls[1].window.size_px = {1920, 1080};
  rig.walls[1].window.monitorNames = {"DP-9"};
  rig.nodes = {{.rank = 0, .display = {}, .host = "here"}, {.rank = 1, .display = {}, .host = "there"}};
  const std::vector<Wall> drawnHere{rig.walls[0]};
  const test::LogLines log;
  const DeskWindows desk =
      placeWindows(rig, drawnHere, {true, false, false}, {}, {kMonitors.data(), 1}, {kAreas.data(), 1});
  ASSERT_TRUE(desk.console);
  EXPECT_FALSE(meet(*desk.console, rig.walls[0].window));
  EXPECT_TRUE(log.said().empty());
}

TEST(DeskWindows, AWindowWithoutRoomIsSaidAndOpensOverTheOthers) {
  Rig rig;
  rig.walls = {wallAt("front", 0, {0, 0}, false)};
  rig.walls[0].window.fullscreen = true;
  const test::LogLines log;
  const DeskWindows desk =
      placeWindows(rig, rig.walls, {false, true, false}, {}, {kMonitors.data(), 1}, {kAreas.data(), 1});
  ASSERT_TRUE(desk.outside);
  EXPECT_TRUE(remember("outside", placeOf(*desk.outside, kMonitors), kMonitors));
  ASSERT_EQ(log.said().size(), 1U);
  EXPECT_NE(log.said()[0].find("no room for the window \"outside\""), std::string::npos) << log.said()[0];
}

/// The desk of one wall of 1280 × 720 with a console, on a screen of this size.
std::pair<WindowPlacement, DeskWindows> deskOn(glm::ivec2 screen_px) {
  Rig rig;
  rig.walls = {wallAt("screen", 0, {6, 34}, true)};
  rig.walls[0].window.size_px = {1280, 720};
  const std::vector<Monitor> monitors{{"screen", {0, 0}, screen_px}};
  const std::vector<ScreenPlace> areas{{{0, 0}, screen_px}};
  const DeskWindows desk = placeWindows(rig, rig.walls, {true, false, false}, {}, monitors, areas);
  return {rig.walls[0].window, desk};
}

TEST(DeskWindows, TheConsoleWaitsWhereItWouldTakeTheGamesPlace) {
  const test::LogLines log;
  for (const glm::ivec2 screen_px : {glm::ivec2(1280, 720), {1366, 768}, {1024, 768}}) {
    const auto [wall, desk] = deskOn(screen_px);
    EXPECT_TRUE(desk.consoleWaits) << screen_px.x;
    ASSERT_TRUE(desk.console) << screen_px.x;
    EXPECT_GT(wall.size_px.x, 0.9 * std::min(1280, screen_px.x)) << "the game has the screen";
    const glm::ivec2 end_px = desk.console->position_px + desk.console->size_px;
    EXPECT_TRUE(glm::all(glm::lessThanEqual(end_px, screen_px))) << screen_px.x;
  }
  for (const glm::ivec2 screen_px : {glm::ivec2(1920, 1080), {1920, 1200}, {2560, 1440}}) {
    const auto [wall, desk] = deskOn(screen_px);
    EXPECT_FALSE(desk.consoleWaits) << screen_px.x;
    ASSERT_TRUE(desk.console) << screen_px.x;
    EXPECT_FALSE(meet(wall, *desk.console)) << screen_px.x;
    EXPECT_GE(wall.size_px.x, 640) << screen_px.x;
  }
  EXPECT_EQ(log.said().size(), 3U);
}

}  // namespace
}  // namespace carom
