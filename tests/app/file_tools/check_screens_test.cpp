// What `carom check` says of measured screens.
#include "app/file_tools/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/program.h"
#include "cave/mesh_files/measured_bytes.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

/// A part of a cylinder of 3 m about the origin, 0.2 to 2.6 m high, by its angles to the right of ahead.
test::PlaceOf arc(double from_deg, double to_deg, double radius_m = 3.0) {
  return [=](const glm::dvec2& at) {
    const double angle = (from_deg + at.x * (to_deg - from_deg)) * std::numbers::pi / 180.0;
    return glm::dvec3(radius_m * std::sin(angle), 0.2 + 2.4 * at.y, -radius_m * std::cos(angle));
  };
}

std::string wall(const std::string& name, const std::string& file) {
  return "[[wall]]\nname = '" + name + "'\npixels = [1200, 800]\nscreen = { shape = '" +
         (file.ends_with("obj") ? "mesh" : "grid") + "', file = '" + file + "' }\n";
}

const std::string kRigHead =
    "unit = 'm'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'cap'\n[[tracker]]\nname = 'cap'\nkind = "
    "'simulated'\n";

/// Returns what is said of a rig with these walls; `status`: what the program returns.
std::string said(const TemporaryFolder& folder, const std::string& walls, int status = 0) {
  const auto result = runCarom(folder, {"check", folder.file("rig.toml", kRigHead + walls)});
  EXPECT_EQ(result.status, status) << result.out << result.err;
  return result.out + result.err;
}

void expectHas(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}
void expectLacks(const std::string& text, const std::string& words) {
  EXPECT_EQ(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST(CheckScreens, TellsWhatAMeasuredScreenIs) {
  const TemporaryFolder folder;
  folder.file("arc.pfm", test::pfmBytes(48, 32, arc(-40.0, 40.0)));
  const std::string text = said(folder, wall("arc", "arc.pfm"));
  expectHas(
      text,
      "arc: curved, 4.189 × 2.400 m along it, turns by 79°, 309 to 309 px/m, 3.00 to 3.35 m from the eyes");
  expectLacks(text, "warning");
}

TEST(CheckScreens, WarnsOfScreensThatAreNotAsTheyShouldBe) {
  const TemporaryFolder folder;
  const auto mirrored = [](const glm::dvec2& at) { return arc(-40.0, 40.0)({1.0 - at.x, at.y}); };
  folder.file("mirrored.pfm", test::pfmBytes(48, 32, mirrored));
  const std::string asForBehind = said(folder, wall("arc", "mirrored.pfm"));
  expectHas(asForBehind, "the window of wall 'arc' runs mirrored over its screen");
  expectLacks(asForBehind, "it needs more points");  // for the eyes that it bends round
  const auto partly = [](const glm::dvec2& at) {
    return at.x < 0.3 ? glm::dvec3(std::nan("")) : arc(-40.0, 40.0)(at);
  };
  folder.file("partly.pfm", test::pfmBytes(48, 32, partly));
  expectHas(said(folder, wall("arc", "partly.pfm")),
            "% of the window of wall 'arc' show screen, expected 90 %");
  folder.file("right.pfm", test::pfmBytes(48, 32, arc(40.0, 120.0)));
  expectHas(said(folder, wall("left", "right.pfm")), "wall 'left' is on the right, against its name");
  folder.file("rough.obj", test::objText(10, 6, arc(-40.0, 40.0)));
  expectHas(said(folder, wall("arc", "rough.obj")), "it needs more points");
  const auto uneven = [](const glm::dvec2& at) { return arc(-40.0, 40.0)({at.x * at.x * at.x, at.y}); };
  folder.file("uneven.obj", test::objText(60, 24, uneven));
  expectHas(said(folder, wall("arc", "uneven.obj")), "expected that they vary by a factor of 3 at most");
}

TEST(CheckScreens, AScreenThatTurnsItsBackIsAnError) {
  const TemporaryFolder folder;
  // It bulges towards the eyes, and its left is on their right.
  const auto bulge = [](const glm::dvec2& at) {
    const double angle = (at.x - 0.5) * 80.0 * std::numbers::pi / 180.0;
    return glm::dvec3(-3.0 * std::sin(angle), 0.2 + 2.4 * at.y, -6.0 + 3.0 * std::cos(angle));
  };
  folder.file("bulge.pfm", test::pfmBytes(48, 32, bulge));
  expectHas(said(folder, wall("arc", "bulge.pfm"), 1), "is behind the whole screen of wall 'arc'");
}

TEST(CheckScreens, PicturesByDirectionHaveNoRims) {
  const TemporaryFolder folder;
  const auto sky = [](const std::string& name) {
    return "[[wall]]\nname = '" + name + "'\npixels = [400, 400]\nsky = { kind = 'fisheye' }\n";
  };
  expectLacks(said(folder, sky("one") + sky("two")), "rims");
  folder.file("arc.obj", test::objText(60, 24, arc(-40.0, 40.0)));
  expectLacks(said(folder, sky("one") + wall("two", "arc.obj")), "rims");
}

TEST(CheckScreens, NeighboursMeetAtTheirRims) {
  const TemporaryFolder folder;
  folder.file("left.obj", test::objText(60, 24, arc(-80.0, 0.0)));
  folder.file("right.obj", test::objText(60, 24, arc(0.0, 80.0)));
  folder.file("apart.obj", test::objText(60, 24, arc(0.3, 80.0)));  // 15.7 mm beside it
  folder.file("over.obj", test::objText(60, 24, arc(-5.0, 80.0)));
  const std::string left = wall("one", "left.obj"),
                    words = "the rims of walls 'one' and 'two' miss each other by ";
  expectLacks(said(folder, left + wall("two", "right.obj")), words);
  expectLacks(said(folder, left + wall("two", "over.obj")), words);
  expectHas(said(folder, left + wall("two", "apart.obj")), words + "15.7 mm");
  // A flat wall whose edge should meet the arc's, 10 mm off.
  const std::string flat =
      "[[wall]]\nname = 'two'\npixels = [600, 600]\nlower_left = [0, 0.2, -3.01]\nlower_right = [2.4, 0.2, "
      "-3.01]\nupper_left = [0, 2.6, -3.01]\n";
  expectHas(said(folder, left + flat), words + "10.0 mm");
}

}  // namespace
}  // namespace carom
