// Which languages a session has, and in which of them each viewer begins.
#include "app/operator/room_languages.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace carom {
namespace {

using Names = std::vector<std::string>;

Rig roomForTwo() {
  Rig rig;
  rig.viewers.resize(2);
  rig.viewers[0].name = "anna";
  rig.viewers[1].name = "ben";
  return rig;
}

/// The languages in which anna and ben begin.
Names startsOf(const SessionLanguages& languages) { return {languages.firstOf(0), languages.firstOf(1)}; }

TEST(SessionLanguages, WithoutAnyThereIsEnglishAlone) {
  const SessionLanguages languages = languagesOf(roomForTwo(), nullptr, "");
  EXPECT_EQ(languages, SessionLanguages{});
  EXPECT_EQ(languages.all, Names{"en"});
  EXPECT_FALSE(languages.hasTile);
}

TEST(SessionLanguages, TheNearestToTheViewerCounts) {
  Rig rig = roomForTwo();
  Playlist playlist;
  playlist.languages = {"ja", "de"};
  const auto starts = [&](const char* option) { return startsOf(languagesOf(rig, &playlist, option)); };
  EXPECT_EQ(starts(""), (Names{"ja", "ja"})) << "the first of the playlist";
  rig.languages = {"it", "es"};
  EXPECT_EQ(starts(""), (Names{"ja", "ja"})) << "before the rig's";
  rig.language = "pt";
  EXPECT_EQ(starts(""), (Names{"pt", "pt"})) << "the rig's";
  rig.viewers[1].language = "fr";
  EXPECT_EQ(starts(""), (Names{"pt", "fr"})) << "the viewer's own";
  EXPECT_EQ(starts("en"), (Names{"en", "en"})) << "that of the command line";
}

TEST(SessionLanguages, TheTileGoesThroughThoseThatAreNamedAndThenTheOthers) {
  Rig rig = roomForTwo();
  rig.languages = {"fr", "en"};
  SessionLanguages languages = languagesOf(rig, nullptr, "");
  EXPECT_EQ(languages.all, (Names{"fr", "en"}));
  EXPECT_TRUE(languages.hasTile);
  rig.viewers[1].language = "ja";
  languages = languagesOf(rig, nullptr, "");
  EXPECT_EQ(languages.all, (Names{"fr", "en", "ja"}));
  EXPECT_EQ(startsOf(languages), (Names{"fr", "ja"}));
  EXPECT_TRUE(languages.hasTile);
  Playlist without;
  EXPECT_EQ(languagesOf(rig, &without, ""), languages) << "the rig's";
  rig.languages.clear();
  languages = languagesOf(rig, nullptr, "");
  EXPECT_EQ(languages.all, (Names{"en", "ja"}));
  EXPECT_FALSE(languages.hasTile) << "nobody has asked for a tile";
  rig.languages = {"fr"};
  EXPECT_FALSE(languagesOf(rig, nullptr, "fr").hasTile) << "there is one alone";
}

TEST(SessionLanguages, ThoseOfASessionThatGoesOnKeepTheirNumbers) {
  const SessionLanguages before{{"fr", "en"}, {0, 1}, true};
  const SessionLanguages now{{"en", "ja", "fr"}, {1, 0}, false};
  const SessionLanguages both = goingOnWith(before, now);
  EXPECT_EQ(both.all, (Names{"fr", "en", "ja"}));
  EXPECT_EQ(startsOf(both), (Names{"ja", "en"}));
  EXPECT_FALSE(both.hasTile);
  SessionLanguages full;
  full.all.assign(kMostLanguages, "fr");
  EXPECT_THROW(goingOnWith(full, now), std::runtime_error);
}

TEST(SessionLanguages, AReplayInOneLanguageHasItForEachNumber) {
  const SessionLanguages recorded{{"fr", "en", "ja"}, {2, 1}, false};
  EXPECT_EQ(shownIn(recorded, ""), recorded);
  EXPECT_EQ(shownIn(recorded, "de").all, (Names{"de", "de", "de"}));
  EXPECT_EQ(startsOf(shownIn(recorded, "de")), (Names{"de", "de"}));
}

TEST(SessionLanguages, KeysNameViewersWhereTheirLanguagesDiffer) {
  using Keys = std::vector<std::pair<std::string, std::string>>;
  const Names all{"fr", "ja"}, viewers{"anna", "ben"};
  const std::vector<std::uint8_t> same{1, 1}, apart{0, 1};
  EXPECT_EQ(languagesByViewer(all, same, viewers), (Keys{{"language", "ja"}}));
  EXPECT_EQ(languagesByViewer(all, apart, viewers), (Keys{{"language.anna", "fr"}, {"language.ben", "ja"}}));
  EXPECT_EQ(languagesByViewer(all, apart, Names{"viewer"}), (Keys{{"language", "fr"}}));
}

}  // namespace
}  // namespace carom
