// Values of the command line: numbers in their range, names of shipped files, and names that stand for
// numbers.
#include "app/tools/option_values.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "places.h"

namespace carom {
namespace {

/// Returns the refusal of a value; empty if it is taken. `becomes`: the value that the command gets.
std::string saidOf(const CLI::Validator& validator, const std::string& value,
                   std::string* becomes = nullptr) {
  std::string text = value;
  const std::string said = validator(text);
  if (becomes) *becomes = text;
  return said;
}

TEST(OptionValues, ANumberIsOneWithinItsRange) {
  Range range;
  range.least = 0.0;
  range.most = 2.5;
  for (const bool above : {false, true}) {
    SCOPED_TRACE(above);
    range.above = above;
    const CLI::Validator validator = numberIn(range, "0 to 2.5");
    for (const char* right : {"2.5", "+1", "1e-3", "0.5"}) EXPECT_EQ(saidOf(validator, right), "") << right;
    for (const std::string wrong :
         {"2.6", "-0.1", "1,5", "1 ", " 1", "", "+-1", "-+1", "++1", "one", "nan", "inf", "1e999"})
      EXPECT_EQ(saidOf(validator, wrong), "'" + wrong + "' is wrong, expected 0 to 2.5");
    EXPECT_EQ(saidOf(validator, "0").empty(), !above) << "the least itself";
  }
}

TEST(OptionValues, ABareNameIsAShippedFile) {
  const CLI::Validator rigs = shipped({"rigs"}), both = shipped({"rigs", "scenarios"});
  std::string file;
  EXPECT_EQ(saidOf(rigs, "desk", &file), "");
  EXPECT_TRUE(std::filesystem::equivalent(file, CAROM_CONFIG_DIR "/rigs/desk.toml")) << file;
  EXPECT_EQ(saidOf(both, "twins", &file), "");
  EXPECT_TRUE(std::filesystem::equivalent(file, CAROM_CONFIG_DIR "/scenarios/twins.toml")) << file;
  EXPECT_EQ(saidOf(rigs, "dekc"), "there is no file 'dekc', expected 'desk'?");
  const std::string said = saidOf(rigs, "xyzzyplugh");
  EXPECT_EQ(said.rfind("there is no file 'xyzzyplugh', expected a file, or one of ", 0), 0U) << said;
  EXPECT_NE(said.find("desk"), std::string::npos) << said;
  EXPECT_EQ(saidOf(rigs, "none/desk.toml", &file), "") << "whether a path is there is said by who reads it";
  EXPECT_EQ(file, "none/desk.toml");
}

TEST(OptionValues, ANameStandsForItsNumber) {
  const CLI::Validator validator = numberOf({{"left", 3}, {"right", -1}});
  std::string number;
  EXPECT_EQ(saidOf(validator, "right", &number), "");
  EXPECT_EQ(number, "-1");
  EXPECT_EQ(saidOf(validator, "Right"), "'Right' is wrong, expected one of left, right");
  EXPECT_EQ(saidOf(validator, "3"), "'3' is wrong, expected one of left, right");
}

}  // namespace
}  // namespace carom
