// The catalogue of texts: each stands at its number, with its English.
#include "cave/texts/texts.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "cave/texts/format.h"
#include "cave/texts/language.h"

namespace carom::texts {
namespace {

TEST(Catalogue, ATextStandsAtItsNumber) {
  ASSERT_GT(catalogue().size(), 600U);
  std::set<std::string> names;
  for (std::size_t i = 0; i < catalogue().size(); ++i) {
    EXPECT_EQ(catalogue()[i].text.index(), i);
    EXPECT_TRUE(names.insert(catalogue()[i].name).second) << catalogue()[i].name;
  }
  // The constants are numbered by another macro than the table.
  for (const auto& [name, text] : {std::pair{"tile.kBestShot", tile::kBestShot},
                                   {"message.kDeviceLost 3", message::kDeviceLost[2]},
                                   {"message.kStroke", message::kStroke},
                                   {"latency.kWallColumns 3", latency::kWallColumns[2]},
                                   {"console.kPucksAndLight", console::kPucksAndLight},
                                   {"page.liveHeld", page::liveHeld}}) {
    EXPECT_EQ(textNamed(name), text) << name;
    EXPECT_STREQ(catalogue()[text.index()].text.english(), text.english());
    EXPECT_EQ(catalogue()[text.index()].name, name);
  }
  EXPECT_FALSE(textNamed("message.kNone"));
  EXPECT_FALSE(Text());
}

TEST(Catalogue, EnglishIsWhatStandsThere) {
  EXPECT_STREQ(message::kNoFlight.words(), "This game has no round trip.");
  EXPECT_EQ(languageCode(), "en");
  EXPECT_EQ(other("red"), "red");
  EXPECT_EQ(format(console::kPucksAndLight, 1, 1.42), "1 puck, light at 1.42 m/s");
  EXPECT_EQ(format(console::kPucksAndLight, std::size_t{2}, 1.42), "2 pucks, light at 1.42 m/s");
}

}  // namespace
}  // namespace carom::texts
