#include "app/check.h"

#include <gtest/gtest.h>

#include "app/program.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

TEST(Check, TellsWhatARigIs) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"check", CAROM_CONFIG_DIR "/rigs/four-walls-cluster.toml"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(
      result.out.find("wall front: 3000 × 3000 mm (9.84 × 9.84 ft), 1080 × 1080 pixels an eye, 360.0 px/m"),
      std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("eyes 64.0 mm apart"), std::string::npos) << result.out;
}

TEST(Check, TellsWhatAScenarioIs) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"check", CAROM_CONFIG_DIR "/scenarios/three-pucks.toml"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("light at 1.42 m/s"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("puck white: radius 30.5 mm"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0.8 c (γ = 1.667)"), std::string::npos) << result.out;
}

TEST(Check, RefusesWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"room.pvx", "<pvx/>"}, {"room.json", "{}"}, {"other.toml", "colour = 'red'\n"}};
  for (const auto& [name, text] : files) {
    const std::string file = folder.file(name, text);
    const auto result = runCarom(folder, {"check", file});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_EQ(result.err.rfind("error: " + file + ":1:1: ", 0), 0u) << result.err;
  }
}

}  // namespace
}  // namespace carom
