#include "engine/text/whole_file.h"

#include <gtest/gtest.h>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::contentOf;
using test::TemporaryFolder;

TEST(WholeFile, AppearsWhenCommitted) {
  const TemporaryFolder folder;
  WholeFile file(folder / "a.json");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.json"));
  file.commit("all of it");
  EXPECT_EQ(contentOf(folder / "a.json"), "all of it");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, AppearsWithAllThatWasAdded) {
  const TemporaryFolder folder;
  WholeFile file(folder / "rows.csv");
  for (const char* part : {"a", "b", "c"}) file.add(part);
  EXPECT_FALSE(std::filesystem::exists(folder / "rows.csv"));
  file.commit("d");
  EXPECT_EQ(contentOf(folder / "rows.csv"), "abcd");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, LeavesWhatWasThereWithoutCommit) {
  const TemporaryFolder folder;
  folder.file("a.json", "old");
  { const WholeFile file(folder / "a.json"); }
  EXPECT_EQ(contentOf(folder / "a.json"), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, ReplacesWhatALinkPointsTo) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink(folder.file("a.json", "old"), folder / "link");
  WholeFile(folder / "link").commit("new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(contentOf(folder / "a.json"), "new");
}

TEST(WholeFile, WritesToDevicesDirectly) {
  WholeFile("/dev/null").commit("gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WholeFile, RefusesPlacesThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(WholeFile(folder / "no/such/folder/a.json"), std::runtime_error);
  EXPECT_THROW(WholeFile(folder / "."), std::runtime_error);
  EXPECT_THROW(WholeFile(""), std::runtime_error);
  EXPECT_THROW(WholeFile("/dev/full").commit("text"), std::runtime_error);
}

}  // namespace
}  // namespace carom
