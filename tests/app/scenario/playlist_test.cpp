// Playlist files: what they may name, and what is said of those that are wrong.
#include "app/scenario/playlist.h"

#include <gtest/gtest.h>

#include <string>

#include "app/rig/rig.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"
#include "places.h"

namespace carom {
namespace {

/// Returns all faults of a playlist with this text, one a line.
std::string faultsOf(const test::TemporaryFolder& folder, const std::string& text) {
  try {
    readPlaylist(folder.file("list.toml", text));
  } catch (const InputErrors& errors) {
    std::string all;
    for (const InputError& fault : errors.faults())
      all += std::string(fault.what()).substr((folder / "").string().size()) + "\n";
    return all;
  }
  return {};
}

TEST(Playlist, TheShippedOneNamesGamesThatCanBePlayed) {
  const Playlist playlist = readPlaylist(CAROM_CONFIG_DIR "/playlists/open-day.toml");
  EXPECT_GE(playlist.games.size(), 5U);
  EXPECT_EQ(playlist.games.front().scenario.stem(), "welcome");
  bool hasLesson = false;
  for (const PlaylistGame& game : playlist.games) hasLesson = hasLesson || game.isLesson;
  EXPECT_TRUE(hasLesson);
}

TEST(Playlist, ReadsGamesOfItsFolderAndShippedOnes) {
  const test::TemporaryFolder folder;
  folder.file("own.toml", "title = \"Mine\"\nlight_speed_m_s = 2\n");
  const Playlist playlist =
      readPlaylist(folder.file("list.toml",
                               "[[game]]\nscenario = \"own.toml\"\nfor_s = 30\nnote = \"Say this\"\n"
                               "[[game]]\nscenario = \"twins\"\nattract = true\n"));
  ASSERT_EQ(playlist.games.size(), 2U);
  EXPECT_EQ(playlist.title, "list");
  EXPECT_EQ(playlist.games[0].title, "Mine");
  EXPECT_EQ(playlist.games[0].for_s, 30.0);
  EXPECT_EQ(playlist.games[0].note, "Say this");
  EXPECT_FALSE(playlist.games[0].isLesson);
  EXPECT_FALSE(playlist.games[0].attracts);
  EXPECT_TRUE(playlist.games[1].isLesson);
  EXPECT_TRUE(playlist.games[1].attracts);
  EXPECT_EQ(numberOf(playlist, folder / "own.toml"), 0U);
  EXPECT_EQ(numberOf(playlist, CAROM_CONFIG_DIR "/scenarios/twins.toml"), 1U);
  EXPECT_EQ(numberOf(playlist, "other.toml"), 2U);
}

TEST(Playlist, AGameThatIsNotThereIsSaidWithItsPlaceAndTheNearestName) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(
      faultsOf(folder, "[[game]]\nscenario = \"twinz\"\n[[game]]\nscenario = \"gone.toml\"\n"),
      "list.toml:2:12: there is no game 'twinz', expected a file or a name that carom list tells, such "
      "as 'twins'?\n"
      "list.toml:4:12: there is no game 'gone.toml', expected a file or a name that carom list tells\n");
}

TEST(Playlist, AGameThatCannotBePlayedIsSaid) {
  const test::TemporaryFolder folder;
  folder.file("own.toml", "light_speed_m_s = -1\n");
  const std::string said = faultsOf(folder, "[[game]]\nscenario = \"own.toml\"\n");
  EXPECT_EQ(said.find("list.toml:2:12: this game cannot be played: "), 0U) << said;
  EXPECT_NE(said.find("own.toml:1:19:"), std::string::npos) << said;
}

TEST(Playlist, RefusesWhatIsWrong) {
  const test::TemporaryFolder folder;
  const std::string welcome = "[[game]]\nscenario = \"welcome\"\n";
  EXPECT_NE(faultsOf(folder, "title = \"none\"\n").find("expected one [[game]]"), std::string::npos);
  EXPECT_NE(faultsOf(folder, welcome + welcome).find("twice"), std::string::npos);
  for (const std::string& wrong :
       {welcome + "for_s = 1", welcome + "for_s = nan", welcome + "for_s = 1e9", welcome + "attract = 1",
        welcome + "note = \"" + std::string(401, 'x') + "\"", welcome + "nots = \"x\"",
        std::string("[[game]]\nscenario = 3"), std::string("game = 3"), std::string("[[game]]"),
        std::string("[[game]]\nscenario = \"../../../etc/passwd\"")})
    EXPECT_FALSE(faultsOf(folder, wrong).empty()) << wrong;
  std::string many;
  for (int i = 0; i < 101; ++i) many += "[[game]]\nscenario = \"welcome\"\n";
  EXPECT_NE(faultsOf(folder, many).find("at most 100"), std::string::npos);
}

TEST(Playlist, ARigNamesOneBesideItOrAShippedOne) {
  const test::TemporaryFolder folder;
  const std::string rig = test::contentOf(CAROM_CONFIG_DIR "/rigs/play.toml");
  const auto playlistOf = [&](const std::string& name) {
    return readRig(folder.file("rig.toml", "playlist = \"" + name + "\"\n" + rig)).playlist;
  };
  EXPECT_EQ(playlistOf("open-day"), CAROM_CONFIG_DIR "/playlists/open-day.toml");
  EXPECT_EQ(playlistOf("mine.toml"), folder / "mine.toml");
  EXPECT_EQ(readRig(CAROM_CONFIG_DIR "/rigs/play.toml").playlist, "");
}

}  // namespace
}  // namespace carom
