// The viewports of SGCT: the parts of their windows, and projections that show no wall.
#include "app/room_import/sgct_viewport.h"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <cmath>
#include <cstddef>
#include <string>

#include "app/room_import/sgct_text.h"

namespace carom {
namespace {

namespace sgct = test::sgct;
using test::sgct::changed;
using test::sgct::projected;

TEST(SgctFile, ViewportsShareTheirWindow) {
  // Two halves, the lower for the left eye; SGCT counts from the lower left.
  std::string text = changed(R"("viewports": [{)", R"("viewports": [{ "pos": { "x": 0, "y": 0.5 },
      "size": { "x": 1, "y": 0.5 }, "eye": "right",)");
  const std::size_t begin = text.find("{ \"pos\": { \"x\": 0, \"y\": 0.5"), end = text.find("}]\n  }] }]");
  std::string second = text.substr(begin, end + 1 - begin);
  second.replace(second.find("0.5"), 3, "0.0").replace(second.find("right"), 5, "left");
  text.insert(end + 1, ", " + second);
  const Room room = sgct::read(text);
  EXPECT_TRUE(room.findings.empty()) << room.findings[0].text;
  ASSERT_EQ(room.walls.size(), 2u);
  ASSERT_TRUE(room.oneWindow);
  EXPECT_EQ(room.oneWindow->position_px, glm::ivec2(50, 60));
  EXPECT_EQ(room.walls[0].wall.window.position_px, glm::ivec2(0, 0));
  EXPECT_EQ(room.walls[0].wall.stereo, StereoMode::right);
  EXPECT_EQ(room.walls[1].wall.window.position_px, glm::ivec2(0, 360));
  EXPECT_EQ(room.walls[1].wall.window.size_px, glm::ivec2(1280, 360));
  EXPECT_EQ(room.walls[1].wall.stereo, StereoMode::left);
  EXPECT_EQ(room.walls[1].wall.name, "front-2");
}

TEST(SgctFile, SaysWhichProjectionsItCannotUse) {
  const Room room = sgct::read(projected(R"("type": "CubemapProjection", "quality": "1k")"));
  ASSERT_EQ(room.findings.size(), 2u);
  EXPECT_EQ(room.findings[0].at.line, 7);
  EXPECT_NE(room.findings[0].text.find("'CubemapProjection' shows no wall"), std::string::npos);
  EXPECT_TRUE(room.hasErrors()) << "no wall is left";
}

// Parts of a window that meet there meet in pixels, too, whatever its size, and none reaches out.
TEST(SgctFile, SplitWindowsOfOddSizesFit) {
  const auto viewport = [](double x, double y, double width, double height) {
    std::string text = sgct::kGood.substr(sgct::kGood.find("{\n      \"projection\""));
    text = text.substr(0, text.find("}]\n  }] }]") + 1);
    return text.insert(1, fmt::format(R"("pos": {{ "x": {}, "y": {} }}, "size": {{ "x": {}, "y": {} }},)", x,
                                      y, width, height));
  };
  const std::size_t begin = sgct::kGood.find("{\n      \"projection\""),
                    end = sgct::kGood.find("}]\n  }] }]") + 1;
  for (const int height : {1, 2, 3, 525, 1079, 1080, 1081}) {
    for (const int parts : {2, 3, 7}) {
      if (height < parts) continue;
      std::string viewports;
      for (int i = 0; i < parts; ++i) {
        const double low = std::round(1e6 * i / parts) / 1e6, high = std::round(1e6 * (i + 1) / parts) / 1e6;
        viewports += (i == 0 ? "" : ", ") + viewport(0, low, 1, high - low);
      }
      std::string text = sgct::kGood;
      text.replace(begin, end - begin, viewports);
      text.replace(text.find("\"y\": 720"), 8, fmt::format("\"y\": {}", height));
      const Room room = sgct::read(text);
      ASSERT_FALSE(room.hasErrors()) << height << ", " << parts << ": " << room.findings[0].text;
      ASSERT_EQ(room.walls.size(), static_cast<std::size_t>(parts));
      int edge = height;  // from the bottom up
      for (const RoomWall& wall : room.walls) {
        const WindowPlacement& place = wall.wall.window;
        EXPECT_EQ(place.position_px.y + place.size_px.y, edge) << height << " in " << parts;
        EXPECT_EQ(wall.wall.pixels.y, place.size_px.y);
        edge = place.position_px.y;
      }
      EXPECT_EQ(edge, 0) << height << " in " << parts;
    }
  }
  std::string text = sgct::kGood;
  text.replace(begin, end - begin, viewport(0, 0.6, 1, 0.5));
  const Room room = sgct::read(text);
  ASSERT_TRUE(room.hasErrors());
  EXPECT_NE(room.findings[0].text.find("reaches to (1, 1.1) of its window"), std::string::npos)
      << room.findings[0].text;
}

}  // namespace
}  // namespace carom
