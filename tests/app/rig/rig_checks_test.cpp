// Checks of a rig that involve several of its values.
#include "app/rig/rig_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::changed;
using test::expectNear;
using test::Fault;
using test::kGood;
using test::read;
using test::RigFaults;
using test::withSecond;

// 60 Hz: a frame is 16.7 ms. What is left after whole frames is at most half of one.
TEST(Rig, FastWallsWaitForTheSlowest) {
  const auto held = [](double first_ms, double second_ms) {
    const Rig rig = read(withSecond("display_latency_ms = " + std::to_string(first_ms) + "\n",
                                    "display_latency_ms = " + std::to_string(second_ms) + "\n"));
    EXPECT_NEAR(rig.displayLatency_s, std::max(first_ms, second_ms) * 1e-3, 1e-9);
    return std::pair(rig.walls[0].heldFrames, rig.walls[1].heldFrames);
  };
  using Held = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(held(20.0, 20.0), Held(0, 0));
  EXPECT_EQ(held(20.0, 12.0), Held(0, 0));
  EXPECT_EQ(held(20.0, 11.0), Held(0, 1));
  EXPECT_EQ(held(5.0, 40.0), Held(2, 0));
}

TEST(Rig, WallsMayMissARectangleByTwoMillimetres) {
  EXPECT_NO_THROW(read(changed("[-1500, 2000, -1500]", "[-1498.1, 2000, -1500]")));
  EXPECT_THROW(read(changed("[-1500, 2000, -1500]", "[-1497.9, 2000, -1500]")), InputErrors);
  EXPECT_NO_THROW(read(kGood + "upper_right = [1500, 2001.9, -1500]\n"));
  EXPECT_THROW(read(kGood + "upper_right = [1500, 2002.1, -1500]\n"), InputErrors);
}

TEST(Rig, HasTheBoxAroundItsStandingWalls) {
  const std::optional<RoomBox> box = boxOf(read(kGood));
  ASSERT_TRUE(box);
  expectNear(box->low_m, {-1.5, 0.0, -1.5});
  expectNear(box->high_m, {1.5, 2.0, -1.5});
  EXPECT_FALSE(boxOf(Rig{})) << "nothing stands in the room";
}

// People stand up to 1.5 m about the origin, also where the walls are all on one side of it.
TEST(Rig, WarnsOfSpacetimeOutsideTheRoom) {
  const Rig rig = read(kGood);
  const auto warned = [&](const Vec3& place_m) {
    SpacetimeSetup setup;
    setup.place_m = place_m;
    return warningOf(setup, rig);
  };
  EXPECT_FALSE(warningOf(SpacetimeSetup{}, rig)) << "it stands where it usually does";
  EXPECT_FALSE(warned({1.5, 2.0, -1.5}));
  EXPECT_FALSE(warned({-1.5, -1.5, 1.5}));
  const std::optional<std::string> above = warned({0.0, 2.001, 0.0});
  ASSERT_TRUE(above);
  EXPECT_NE(above->find("expected a place between [-1.5, -1.5, -1.5] and [1.5, 2, 1.5] m"), std::string::npos)
      << *above;
  EXPECT_TRUE(warned({1.501, 0.0, 0.0}));
  EXPECT_TRUE(warned({0.0, 0.0, -1.501}));
}

INSTANTIATE_TEST_SUITE_P(
    Checks, RigFaults,
    ::testing::Values(
        Fault{"no width", changed("[1500, 0, -1500]", "[-1500, 0, -1500]"), 12, 15, "no width"},
        Fault{"no height", changed("[-1500, 2000, -1500]", "[-1500, 0, -1500]"), 13, 14, "no height"},
        Fault{"line", changed("[-1500, 2000, -1500]", "[0, 0, -1500]"), 13, 14, "one line"},
        Fault{"skew", changed("[-1500, 2000, -1500]", "[-1450, 2000, -1500]"), 13, 14, "by 50.0 mm"},
        Fault{"fourth corner", kGood + "upper_right = [1500, 2030, -1500]\n", 15, 15, "30.0 mm"},
        Fault{"wall name", changed("'front'", "'../front'"), 10, 8, "letters"},
        Fault{"same wall", kGood + kGood.substr(kGood.find("[[wall]]")), 16, 8, "taken in line 10"},
        Fault{
            "place outside",
            changed("[head]", "[one_window]\nsize = [100, 100]\n[head]") + "window = { size = [101, 100] }\n",
            17, 10, "reaches out"},
        Fault{"viewport outside",
              kGood + "window = { size = [100, 100], viewport = { size = [101, 100] } }\n", 15, 10,
              "reaches out of its window"},
        Fault{"viewports on each other",
              withSecond(
                  "window = { size = [100, 100], viewport = { size = [60, 100] } }\n",
                  "window = { size = [100, 100], viewport = { position = [50, 0], size = [50, 100] } }\n"),
              22, 10, "overlap in their window"},
        Fault{"walls too different", withSecond("display_latency_ms = 5\n", "display_latency_ms = 200\n"), 15,
              22, "is 195.0 ms faster than the slowest"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
