// `carom events`, as a person runs it.
#include <gtest/gtest.h>

#include <map>

#include "app/program.h"
#include "app/table_rows.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::Row;
using test::rowsOf;
using test::runCarom;
using test::TemporaryFolder;

const std::string kTwoCushions = CAROM_CONFIG_DIR "/scenarios/two-cushions.toml";

TEST(Events, TheTableSaysWhatIsFirstForWhom) {
  TemporaryFolder folder;
  const auto result =
      runCarom(folder, {"events", kTwoCushions, "--until", "2", "--velocity", "0.5", "0", "0"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("spacelike"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("white"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("lamp"), std::string::npos) << result.out;
}

TEST(Events, TheCsvHoldsAllDigitsAndOrdersThatTurnRound) {
  TemporaryFolder folder;
  std::map<double, std::vector<std::string>> order;  // of white and red, by velocity
  for (const double beta : {0.5, -0.5}) {
    const auto result =
        runCarom(folder, {"events", kTwoCushions, "--until", "2", "--velocity", std::to_string(beta), "0",
                          "0", "--place", "0", "-1.6", "0.95", "--csv", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto rows = rowsOf(result.out);
    std::vector<Row> bounces;
    for (const auto& row : rows) {
      if (row.at("kind") == "puck-cushion" && bounces.size() < 2) bounces.push_back(row);
    }
    ASSERT_EQ(bounces.size(), 2u) << result.out;
    EXPECT_EQ(bounces[0]["t_s"], bounces[1]["t_s"]);
    EXPECT_EQ(bounces[0]["order"], bounces[1]["order"]);
    EXPECT_EQ(bounces[0]["interval"], "spacelike");
    EXPECT_EQ(bounces[0]["next"], bounces[1]["number"]);
    EXPECT_EQ(std::stod(bounces[0]["beta_x"]), 0.0);
    for (const auto& row : bounces) {
      const double x = std::stod(row.at("x_m")), y = std::stod(row.at("y_m")) + 1.6,
                   z = std::stod(row.at("z_m")) - 0.95;
      EXPECT_NEAR(std::stod(row.at("place_1_t_s")),
                  std::stod(row.at("t_s")) + std::sqrt(x * x + y * y + z * z) / 1.42, 1e-15 * 4);
      if (row.at("who") == "white") order[beta].insert(order[beta].begin(), row.at("moving_order"));
      if (row.at("who") == "red") order[beta].push_back(row.at("moving_order"));
    }
  }
  ASSERT_EQ(order[0.5].size(), 2u);
  ASSERT_EQ(order[-0.5].size(), 2u);
  EXPECT_LT(std::stoi(order[0.5][0]), std::stoi(order[0.5][1])) << "white, ahead, first";
  EXPECT_GT(std::stoi(order[-0.5][0]), std::stoi(order[-0.5][1]));
}

TEST(Events, APairStandsAlone) {
  TemporaryFolder folder;
  const auto result =
      runCarom(folder, {"events", kTwoCushions, "--until", "3", "--pair", "0", "2", "--csv", "-"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = rowsOf(result.out);
  ASSERT_EQ(rows.size(), 2u) << result.out;
  EXPECT_EQ(rows[0].at("number"), "0");
  EXPECT_EQ(rows[0].at("next"), "2");
  const auto none = runCarom(folder, {"events", kTwoCushions, "--pair", "0", "999"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("--pair 0 999"), std::string::npos) << none.err;
}

TEST(Events, WrongArgumentsAreRefused) {
  TemporaryFolder folder;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"events", kTwoCushions, "--velocity", "1", "0", "0"},
        {"events", kTwoCushions, "--velocity", "0.5", "0"},
        {"events", kTwoCushions, "--velocity", "nan", "0", "0"},
        {"events", kTwoCushions, "--place", "0", "0", "inf"},
        {"events", kTwoCushions, "--until", "-1"},
        {"events", kTwoCushions, "--pair", "0"}}) {
    EXPECT_EQ(runCarom(folder, arguments).status, 2) << arguments.back();
  }
  EXPECT_EQ(runCarom(folder, {"events", (folder / "none.db").string()}).status, 1);
}

}  // namespace
}  // namespace carom
