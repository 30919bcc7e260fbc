// In which languages games begin.
#include "app/session/game_settings.h"

#include <gtest/gtest.h>

#include "places.h"

namespace carom {
namespace {

TEST(GameSettings, TheNextVisitorBeginsWithTheFirstLanguageAndAnotherGameKeepsTheirs) {
  const Rig rig;
  const Scenario scenario;
  Beginning beginning;
  EXPECT_EQ(settingsOf(rig, scenario, "first.toml", beginning).languageOf,
            (std::array<std::uint8_t, kMostViewers>{}));
  beginning.languages =
      std::make_shared<const SessionLanguages>(SessionLanguages{{"fr", "en", "ja"}, {1, 2}});
  OperatorSettings settings = settingsOf(rig, scenario, "first.toml", beginning);
  EXPECT_EQ(settings.languages, beginning.languages);
  EXPECT_EQ(settings.languageOf, (std::array<std::uint8_t, kMostViewers>{1, 2}));
  settings.languageOf = {2, 0};
  for (const char* file : {"first.toml", "other.toml"}) {
    const auto next = [&](bool isForNextVisitor, bool attracts) {
      return settingsOfNext(settings, {file, isForNextVisitor, attracts}, rig, scenario, beginning)
          .languageOf;
    };
    EXPECT_EQ(next(false, false), settings.languageOf) << file;
    EXPECT_EQ(next(true, false), beginning.languages->atStart) << file;
    EXPECT_EQ(next(false, true), beginning.languages->atStart) << file;
  }
}

TEST(GameSettings, SomebodyCanWalkWhereAHeadIsFollowedOrThereAreSeveral) {
  Scenario scenario;
  scenario.billiard.lightSpeed_m_s = 1.42;
  const auto canWalk = [&](const char* name) {
    return settingsAtStart(readRig(std::string(CAROM_CONFIG_DIR "/rigs/") + name + ".toml"), scenario)
        .canWalk;
  };
  EXPECT_FALSE(canWalk("play")) << "its person stands still";
  EXPECT_TRUE(canWalk("desk")) << "its person walks";
  EXPECT_TRUE(canWalk("desk-two"));
  EXPECT_TRUE(canWalk("headset"));
}

}  // namespace
}  // namespace carom
