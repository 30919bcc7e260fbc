#include "cave/display/window_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <string>

namespace carom {
namespace {

const std::array kScreen{ScreenPlace{{0, 0}, {1920, 1080}}};
constexpr glm::ivec2 kConsole{1280, 860}, kLeastConsole{800, 620}, kView{1000, 820}, kLeastView{320, 220};

FreeWindow picture() { return {{1280, 720}, {200, 120}, ScreenPlace{{6, 34}, {1280, 720}}, true}; }

bool meet(const ScreenPlace& a, const ScreenPlace& b) {
  const glm::ivec2 aEnd = a.position_px + a.size_px, bEnd = b.position_px + b.size_px;
  return a.position_px.x < bEnd.x && b.position_px.x < aEnd.x && a.position_px.y < bEnd.y &&
         b.position_px.y < aEnd.y;
}

bool isWithin(const ScreenPlace& place, const ScreenPlace& area) {
  const glm::ivec2 low = place.position_px - area.position_px, high = low + place.size_px;
  return low.x >= 0 && low.y >= 0 && high.x <= area.size_px.x && high.y <= area.size_px.y;
}

TEST(WindowLayout, OneWindowLiesWhereItWants) {
  const std::array windows{picture()};
  EXPECT_EQ(arranged(windows, {}, kScreen).front(), picture().at);
}

TEST(WindowLayout, TheConsoleOpensBesideThePictureWhichBecomesSmallerForIt) {
  const std::array windows{picture(), FreeWindow{kConsole, kLeastConsole}};
  const auto places = arranged(windows, {}, kScreen);
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_FALSE(meet(*places[0], *places[1]));
  EXPECT_GE(places[0]->size_px.x, 1000);
  EXPECT_NEAR(double(places[0]->size_px.x) / places[0]->size_px.y, 1280.0 / 720.0, 0.01);
  EXPECT_GE(places[1]->size_px.x, kLeastConsole.x);
}

TEST(WindowLayout, AFreeMonitorTakesTheConsoleWhole) {
  const std::array monitors{kScreen[0], ScreenPlace{{1920, 0}, {1920, 1080}}};
  const std::array walls{kScreen[0]};
  const std::array windows{FreeWindow{kConsole, kLeastConsole}};
  const auto places = arranged(windows, walls, monitors);
  ASSERT_TRUE(places[0]);
  EXPECT_TRUE(isWithin(*places[0], monitors[1]));
  EXPECT_EQ(places[0]->size_px, kConsole);
}

TEST(WindowLayout, ThereIsNoPlaceWhereAWallCoversTheOnlyMonitor) {
  const std::array windows{FreeWindow{kConsole, kLeastConsole}};
  EXPECT_FALSE(arranged(windows, kScreen, kScreen).front());
}

TEST(WindowLayout, APlaceOfAMonitorThatIsGoneIsNotTaken) {
  FreeWindow console{kConsole, kLeastConsole, ScreenPlace{{2500, 100}, kConsole}};
  const std::array windows{console};
  const auto places = arranged(windows, {}, kScreen);
  ASSERT_TRUE(places[0]);
  EXPECT_TRUE(isWithin(*places[0], kScreen[0]));
}

/// Checks random windows on random monitors: none meets another or leaves its monitor.
TEST(WindowLayout, NoWindowsMeetAndAllAreOnAMonitor) {
  const char* alone = std::getenv("CAROM_CASE");
  for (int number = alone ? std::atoi(alone) : 0, end = alone ? number + 1 : 200; number < end; ++number) {
    SCOPED_TRACE("CAROM_CASE=" + std::to_string(number));
    std::mt19937 random(static_cast<unsigned>(number));
    const auto between = [&](int least, int most) {
      return std::uniform_int_distribution<int>(least, most)(random);
    };
    std::vector<ScreenPlace> monitors{{{0, 0}, {between(1024, 3840), between(768, 2160)}}};
    if (between(0, 1) == 1)
      monitors.push_back({{monitors[0].size_px.x, 0}, {between(1024, 3840), between(768, 2160)}});
    std::vector<FreeWindow> windows{picture()};
    for (const glm::ivec2 wanted : {kConsole, kView, kView}) {
      windows.push_back({wanted, kLeastView});
      if (between(0, 1) == 1)
        windows.back().at = ScreenPlace{{between(-500, 4000), between(-500, 2000)}, wanted};
    }
    std::vector<ScreenPlace> shown;
    for (const auto& place : arranged(windows, {}, monitors)) {
      if (!place) continue;
      EXPECT_TRUE(std::any_of(monitors.begin(), monitors.end(),
                              [&](const ScreenPlace& area) { return isWithin(*place, area); }));
      for (const ScreenPlace& other : shown) EXPECT_FALSE(meet(*place, other));
      shown.push_back(*place);
    }
    EXPECT_EQ(shown.size(), windows.size());
  }
}

TEST(WindowLayout, APictureKeepsItsProportionsInTheMiddleOfItsWindow) {
  const auto inside = [](const glm::ivec2& window_px) {
    const Viewport part = fitted({1280, 720}, window_px);
    return std::array{part.position_px.x, part.position_px.y, part.size_px.x, part.size_px.y};
  };
  EXPECT_EQ(inside({1280, 720}), (std::array{0, 0, 1280, 720}));
  EXPECT_EQ(inside({1208, 680}), (std::array{0, 0, 1208, 680})) << "as near as pixels allow";
  EXPECT_EQ(inside({1280, 1000}), (std::array{0, 140, 1280, 720}));
  EXPECT_EQ(inside({1480, 720}), (std::array{100, 0, 1280, 720}));
  EXPECT_EQ(inside({640, 480}), (std::array{0, 60, 640, 360}));
  EXPECT_EQ(inside({1, 1}), (std::array{0, 0, 1, 1}));
}

}  // namespace
}  // namespace carom
