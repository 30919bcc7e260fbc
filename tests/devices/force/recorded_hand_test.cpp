// Recorded hands: what is right is read, what is not is named with its place.
#include "devices/force/recorded_hand.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/text/input_error.h"

namespace carom {
namespace {

const std::string kHeader = "time_s,x_m,y_m,z_m,pressed\n";

TEST(RecordedHand, RowsAreReadBehindCommentsAndTheMarkOfUtf8) {
  const std::string text =
      "\xef\xbb\xbf# a hand\n#\n" + kHeader + "0.5,1,-2,0.25,0\r\n 1.5 , 3,2, 1.25,1\n\n";
  const std::vector<HandRow> rows = readHandRows(text, "hand.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].time_s, 0.5);
  EXPECT_EQ(rows[0].place_m, glm::dvec3(1.0, -2.0, 0.25));
  EXPECT_FALSE(rows[0].pressed);
  EXPECT_EQ(rows[1].time_s, 1.5);
  EXPECT_EQ(rows[1].place_m, glm::dvec3(3.0, 2.0, 1.25));
  EXPECT_TRUE(rows[1].pressed);
}

TEST(RecordedHand, BetweenRowsItIsOnItsLineAndBesideThemAtTheirEnds) {
  const std::vector<HandRow> rows{
      {1.0, {0.0, 0.0, 0.0}, false}, {2.0, {4.0, -8.0, 2.0}, true}, {4.0, {0.0, 0.0, 0.0}, false}};
  for (const auto& [time_s, share, pressed] :
       std::vector<std::tuple<double, double, bool>>{{0.0, 0.0, false},
                                                     {1.0, 0.0, false},
                                                     {1.25, 0.25, false},
                                                     {2.0, 1.0, true},
                                                     {3.0, 0.5, true},
                                                     {3.5, 0.25, true},
                                                     {4.0, 0.0, false},
                                                     {9.0, 0.0, false}}) {
    const HandRow hand = handAt(rows, time_s);
    EXPECT_LT(glm::distance(hand.place_m, share * glm::dvec3(4.0, -8.0, 2.0)), 1e-15) << time_s;
    EXPECT_EQ(hand.pressed, pressed) << time_s;
  }
}

TEST(RecordedHand, FaultsHaveTheirPlace) {
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {"", "hand.csv:1:1: there are no rows"},
           {kHeader, "hand.csv:1:1: there are no rows"},
           {"# a\ntime,x\n", "hand.csv:2:1: this is no header, expected 'time_s,x_m,y_m,z_m,pressed'"},
           {kHeader + "0,0,0,0\n", "hand.csv:2:1: the row has 4 columns, expected 5"},
           {kHeader + "0,0,0,0,0\n0,0,0,0,0\n", "hand.csv:3:1: time_s does not increase"},
           {kHeader + "0,0,nan,0,0\n", "hand.csv:2:1: y_m is 'nan', expected a number from -1000 to 1000"},
           {kHeader + "0,1001,0,0,0\n", "hand.csv:2:1: x_m is '1001', expected a number from -1000 to 1000"},
           {kHeader + "0,0,0,1\x01,0\n", "hand.csv:2:1: z_m is '1?', expected a number"},
           {kHeader + "0,0,0,0,2\n", "hand.csv:2:1: pressed is neither 0 nor 1"},
           {kHeader + "0,0,0,0,0\n\n1,0,0,0,0\n", "hand.csv:3:1: the row has 1 columns, expected 5"}}) {
    try {
      readHandRows(text, "hand.csv");
      ADD_FAILURE() << text;
    } catch (const InputError& fault) {
      EXPECT_TRUE(std::string(fault.what()).starts_with(said)) << fault.what() << "\nof " << text;
    }
  }
}

}  // namespace
}  // namespace carom
