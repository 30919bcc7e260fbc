// What `carom list` knows of.
#include "app/file_tools/list.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/operator/visitor_choices.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

bool has(const std::vector<ListedFile>& files, const std::string& name, const std::string& title) {
  return std::any_of(files.begin(), files.end(), [&](const ListedFile& file) {
    return file.name == name && file.title == title && !file.isFaulty;
  });
}

TEST(List, NamesTheShippedFilesWithTheirTitles) {
  const test::TemporaryFolder empty;
  const ListedFiles listed = listFiles(empty / ".");
  EXPECT_TRUE(has(listed.games, "table", "A table to play on"));
  EXPECT_TRUE(has(listed.rigs, "play", "One window to play in"));
  ASSERT_EQ(listed.lessons.size(), kLessons.size());
  EXPECT_EQ(listed.lessons.front().name, "comes-and-goes");
  EXPECT_FALSE(listed.traces.empty());
  EXPECT_TRUE(has(listed.playlists, "open-day", "Open day"));
  EXPECT_TRUE(has(listed.languages, "en", "as everything is written"));
  for (const auto* files : {&listed.games, &listed.lessons, &listed.rigs}) {
    for (const ListedFile& file : *files) EXPECT_FALSE(file.isFaulty) << file.name << ": " << file.title;
  }
}

TEST(List, TakesScenariosAndRigsOfAFolderAndLeavesOtherFilesOut) {
  const test::TemporaryFolder folder;
  const std::string game = folder.file("mine.toml", "title = \"My game\"\nlight_speed_m_s = 1.0\n").string();
  folder.file("pyproject.toml", "[project]\nname = \"another program\"\n");
  folder.file("broken.toml", "light_speed_m_s = ");
  folder.file("notes.txt", "title = 1\n");
  const ListedFiles listed = listFiles(game.substr(0, game.rfind('/')));
  EXPECT_TRUE(has(listed.games, game, "My game"));
  const auto isBroken = [](const ListedFile& file) {
    return file.name.find("broken.toml") != std::string::npos;
  };
  const auto broken = std::find_if(listed.games.begin(), listed.games.end(), isBroken);
  ASSERT_NE(broken, listed.games.end());
  EXPECT_TRUE(broken->isFaulty);
  for (const auto* files : {&listed.games, &listed.lessons, &listed.rigs}) {
    for (const ListedFile& file : *files) {
      EXPECT_EQ(file.name.find("pyproject"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace carom
