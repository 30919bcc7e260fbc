// Which game follows by itself.
#include "app/session/programme.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom {
namespace {

/// Runs a programme for so many seconds, ten frames each; `acts` are the seconds at which somebody does
/// something. Returns what follows, as "SECOND FILE", with "visitor" for the next visitor and "attract" where
/// nobody is there.
std::vector<std::string> played(Programme& programme, std::string playing, int seconds,
                                const std::vector<int>& acts) {
  std::vector<std::string> followed;
  for (int tenth = 0; tenth < 10 * seconds; ++tenth) {
    bool acted = false;
    for (const int second : acts) acted = acted || tenth == 10 * second;
    const NextGame next = programme.look({0.1 * tenth, acted, false, Vec3(0.0)}, playing);
    if (next.file.empty()) continue;
    playing = next.file;
    programme.begin();
    followed.push_back(std::to_string(tenth / 10) + " " + std::filesystem::path(next.file).stem().string() +
                       (next.isForNextVisitor ? " visitor" : "") + (next.attracts ? " attract" : ""));
  }
  return followed;
}

using Lines = std::vector<std::string>;

/// Returns "SECOND COUNT" where the countdown changes, and "SECOND gone", for a visitor who acts at 0 s
/// alone; `discussedUntil_s`: a question stands until then, from the beginning.
Lines countedDown(double patience_s, double discussedUntil_s) {
  Programme programme("first.toml", nullptr, patience_s);
  Lines lines;
  std::optional<int> before;
  for (int tenth = 0; tenth < 5000; ++tenth) {
    const double now_s = 0.1 * tenth;
    const NextGame next =
        programme.look({now_s, tenth == 0, false, Vec3(0.0), now_s < discussedUntil_s}, "lesson.toml");
    const std::optional<int> left = programme.countdown(now_s);
    if (left && left != before) lines.push_back(std::to_string(tenth / 10) + " " + std::to_string(*left));
    before = left;
    if (!next.isForNextVisitor) continue;
    lines.push_back(std::to_string(tenth / 10) + " gone");
    break;
  }
  return lines;
}

TEST(Programme, CountsDownBeforeItSendsAVisitorAway) {
  EXPECT_EQ(countedDown(60.0, 0.0), (Lines{"50 10", "51 9", "52 8", "53 7", "54 6", "55 5", "56 4", "57 3",
                                           "58 2", "59 1", "60 gone"}));
  EXPECT_EQ(countedDown(6.0, 0.0), (Lines{"3 3", "4 2", "5 1", "6 gone"})) << "half of a short patience";
}

TEST(Programme, WaitsFiveTimesAsLongWhileAQuestionStands) {
  const Lines whole = countedDown(15.0, 1000.0);
  ASSERT_FALSE(whole.empty());
  EXPECT_EQ(whole.front(), "67 8");
  EXPECT_EQ(whole.back(), "75 gone");
  EXPECT_EQ(countedDown(15.0, 40.0).back(), "55 gone")
      << "the patience of a game begins when the question goes";
}

TEST(Programme, ASignOfLifeEndsTheCountdown) {
  Programme programme("first.toml", nullptr, 20.0);
  for (int second = 0; second <= 15; ++second)
    programme.look({1.0 * second, second == 0, false, Vec3(0.0)}, "a");
  EXPECT_EQ(programme.countdown(15.0), 5);
  programme.look({16.0, false, false, Vec3(0.1, 0.0, 0.0)}, "a");
  EXPECT_FALSE(programme.countdown(16.0));
  programme.look({16.1, true, false, Vec3(0.1, 0.0, 0.0)}, "a");
  EXPECT_FALSE(programme.countdown(16.1));
}

PlaylistGame game(const std::string& name, std::optional<double> for_s = {}, bool attracts = false) {
  PlaylistGame game;
  game.scenario = name + ".toml";
  game.for_s = for_s;
  game.attracts = attracts;
  return game;
}

TEST(Programme, NothingFollowsByItselfWithoutPatienceOrPlaylist) {
  Programme programme("first.toml", nullptr, {});
  EXPECT_EQ(played(programme, "first.toml", 1000, {100}), Lines{});
}

TEST(Programme, ShowAndFirstGameAttractByTurnsUntilSomebodyComes) {
  Programme programme("first.toml", nullptr, 60.0);
  EXPECT_EQ(played(programme, "first.toml", 300, {250}),
            (Lines{"60 show-me attract", "135 first attract", "210 show-me attract", "250 first visitor"}));
}

TEST(Programme, WhenAVisitorHasGoneTheFirstGameBeginsAndThenTheGamesThatAttract) {
  Programme programme("first.toml", nullptr, 60.0);
  EXPECT_EQ(played(programme, "first.toml", 200, {10, 40, 55}),
            (Lines{"115 first visitor", "175 show-me attract"}));
}

TEST(Programme, ThePlaylistsGamesFollowAfterTheirTimes) {
  const auto playlist = std::make_shared<const Playlist>(
      Playlist{"", {game("one", 30.0), game("two", 20.0), game("three"), game("four")}});
  Programme programme("one.toml", playlist, {});
  EXPECT_EQ(played(programme, "one.toml", 300, {1, 2, 3}), (Lines{"30 two", "50 three"}));
  EXPECT_EQ(played(programme, "elsewhere.toml", 300, {}), Lines{}) << "a game of the operator's";
  programme.begin();
  ASSERT_EQ(programme.look({1000.0, true, false, Vec3(0.0)}, "two.toml").file, "");
  const auto following = programme.following(1005.0, "two.toml");
  ASSERT_TRUE(following);
  EXPECT_EQ(following->game->scenario, "three.toml");
  EXPECT_NEAR(following->in_s, 15.0, 1e-9);
  EXPECT_FALSE(programme.following(1005.0, "three.toml"));
}

TEST(Programme, OnlyWhatThePlaylistSaysAttracts) {
  const auto none = std::make_shared<const Playlist>(Playlist{"", {game("one"), game("two")}});
  Programme quiet("one.toml", none, 60.0);
  EXPECT_EQ(played(quiet, "one.toml", 500, {}), Lines{});
  const auto one = std::make_shared<const Playlist>(Playlist{"", {game("one"), game("two", 40.0, true)}});
  Programme programme("one.toml", one, 60.0);
  EXPECT_EQ(played(programme, "one.toml", 150, {120}),
            (Lines{"60 two attract", "100 two attract", "120 one visitor"}));
}

}  // namespace
}  // namespace carom
