// The shipped files and their short names.
#include "app/toml/config_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::TemporaryFolder;

TEST(ConfigFolder, ABareNameIsThatOfAShippedFile) {
  EXPECT_EQ(shippedFile("three-pucks", "scenarios"), configFolder() / "scenarios/three-pucks.toml");
  EXPECT_EQ(shippedFile("three-pucks", "rigs"), "three-pucks") << "of another kind";
  EXPECT_EQ(shippedFile("three-pucks.toml", "scenarios"), "three-pucks.toml");
  EXPECT_EQ(shippedFile("./three-pucks", "scenarios"), "./three-pucks");
  EXPECT_EQ(shippedFile("no-such-game", "scenarios"), "no-such-game");
  EXPECT_EQ(shippedFile("three-pucks", "no-such-kind"), "three-pucks");
}

TEST(ConfigFolder, EveryShortNameLeadsToItsFile) {
  for (const char* kind : {"scenarios", "rigs", "playlists"}) {
    const std::vector<std::string> names = shippedNames(kind);
    EXPECT_FALSE(names.empty()) << kind;
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end())) << kind;
    for (const std::string& name : names) {
      const std::filesystem::path file = shippedFile(name, kind);
      EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
      EXPECT_EQ(file.stem(), name);
    }
  }
  EXPECT_TRUE(shippedNames("no-such-kind").empty());
}

TEST(ConfigFolder, LinksAreTheFileThatTheyLeadTo) {
  const TemporaryFolder folder;
  const auto a = folder.file("a", "same"), b = folder.file("b", "same");
  std::filesystem::create_symlink(a, folder / "link");
  EXPECT_TRUE(isSameFile(a, folder / "link"));
  EXPECT_TRUE(isSameFile(a, folder / "." / "a"));
  EXPECT_FALSE(isSameFile(a, b)) << "equal content alone";
  EXPECT_TRUE(isSameFile(folder / "gone", folder / "gone"));
  EXPECT_FALSE(isSameFile(a, folder / "gone"));
}

}  // namespace
}  // namespace carom
