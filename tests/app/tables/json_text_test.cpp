#include "app/tables/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

namespace carom {
namespace {

TEST(JsonText, NumbersReadBackBitForBit) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 10000; ++i) {
    const auto number = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(number)) continue;
    const std::string text = jsonText(Json{{"x", number}});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(Json::parse(text)["x"].get<double>()),
              std::bit_cast<std::uint64_t>(number))
        << text;
  }
}

TEST(JsonText, CarriesSeventeenDigits) {
  EXPECT_EQ(jsonText(Json::array({0.1})), "[\n 0.10000000000000001]\n");
}

TEST(JsonText, KeepsOrderAndEscapesNames) {
  const Json value{{"z", 1}, {"a \"quoted\"\n", Json::array({Json{{"k", true}}, Json{{"k", nullptr}}})}};
  const std::string text = jsonText(value);
  EXPECT_LT(text.find("\"z\""), text.find("quoted"));
  EXPECT_EQ(Json::parse(text), value);
}

TEST(JsonText, NeverWritesWhatIsNoNumber) {
  EXPECT_THROW(jsonText(Json{{"x", std::numeric_limits<double>::quiet_NaN()}}), std::logic_error);
  EXPECT_THROW(jsonText(Json{{"x", std::numeric_limits<double>::infinity()}}), std::logic_error);
}

}  // namespace
}  // namespace carom
