// The shipped scenarios with soft pucks are played: no body has to be frozen, and no node reaches the speed
// of light between two rows. CAROM_SOFT=1 plays a minute of each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <vector>

#include "app/scenario/scenario.h"
#include "engine/billiard/billiard.h"
#include "engine/soft/soft_history.h"
#include "places.h"

namespace carom {
namespace {

TEST(SoftScenarios, AreFollowedBelowTheSpeedOfLight) {
  const double until_s = std::getenv("CAROM_SOFT") != nullptr ? 60.0 : 4.6;  // the lessons' moments are over
  int played = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    const Scenario scenario = readScenario(entry.path());
    const std::vector<Puck>& pucks = scenario.billiard.pucks;
    if (std::none_of(pucks.begin(), pucks.end(), [](const Puck& puck) { return puck.soft.has_value(); }))
      continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++played;
    Billiard billiard(scenario.billiard);
    std::vector<SoftHistory> histories(pucks.size());
    std::size_t count = 0;
    for (double t_s = 0.2; t_s < until_s; t_s += 0.2) {
      billiard.advanceTo(t_s);
      SoftRows rows;
      billiard.takeSoftRows(rows);
      std::size_t node = 0;
      for (const SoftRow& row : rows.rows) {
        ASSERT_NO_THROW(histories[row.body].append(row, std::span(rows.nodes).subspan(node, row.nodes)));
        node += row.nodes;
        ++count;
      }
      billiard.forgetBefore(t_s - 0.2);
    }
    EXPECT_GT(count, 50U);
    EXPECT_TRUE(billiard.frozen().empty());
  }
  EXPECT_GE(played, 4);
}

// The ships of the string have meshes; nothing is drawn of a body that only pushes.
TEST(SoftScenarios, ABodyThatOnlyHoldsIsNotDrawn) {
  for (const auto& [name, isDrawn] : {std::pair("solid", false), std::pair("bell-string", true)}) {
    const Scenario scenario = readScenario(std::string(CAROM_CONFIG_DIR "/scenarios/") + name + ".toml");
    ASSERT_EQ(scenario.bodies.size(), 2U);
    for (const ScriptedBody& body : scenario.bodies) EXPECT_EQ(body.isDrawn, isDrawn) << body.name;
  }
}

}  // namespace
}  // namespace carom
