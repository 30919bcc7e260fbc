#include "engine/text/outside_file.h"

#include <gtest/gtest.h>

#include "app/bad_files.h"
#include "app/temporary_folder.h"
#include "engine/text/input_error.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

using test::TemporaryFolder;

TEST(OutsideFile, OnlyARegularFileOfItsSizeIsOpened) {
  for (const InputKind kind :
       {InputKind::toml, InputKind::json, InputKind::xml, InputKind::trace, InputKind::mesh,
        InputKind::meshPart, InputKind::warp, InputKind::blend, InputKind::session, InputKind::screenMesh,
        InputKind::screenGrid, InputKind::mpcdi}) {
    const TemporaryFolder folder;
    for (const test::BadThing& bad : test::badThings(kind)) {
      const auto path = folder / bad.name;
      bad.make(path);
      const std::string refusal = refusalOf(path, kind);
      EXPECT_EQ(refusal.find(bad.said), 0u) << bad.name << ": " << refusal;
      try {
        contentOf(path, kind);
        ADD_FAILURE() << bad.name << " was read";
      } catch (const InputError& error) {
        EXPECT_EQ(error.what(), path.string() + ":1:1: " + refusal);
      }
    }
    const auto file = folder.file("whole", "text");
    EXPECT_EQ(refusalOf(file, kind), "");
    EXPECT_EQ(contentOf(file, kind), "text");
    EXPECT_EQ(beginningOf(file, kind, 2), "te");
  }
}

TEST(OutsideFile, NoMoreIsReadOfAFileThatHidesItsLength) {
  // Says that it has no byte, and has as many as anybody reads.
  EXPECT_THROW(contentOf("/proc/self/mem", InputKind::toml), InputError);
  EXPECT_FALSE(contentOf("/proc/self/status", InputKind::toml).empty());
}

TEST(OutsideFile, AFolderHoldsWhatLiesBelowItAndNoLinksOutOfIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "games/meshes");
  std::filesystem::create_directories(folder / "games-of-others");
  const auto inside = folder.file("games/meshes/rod.stl", "");
  const auto outside = folder.file("games-of-others/rod.stl", "");
  const auto games = folder / "games";
  EXPECT_TRUE(liesBelow(inside, games));
  EXPECT_TRUE(liesBelow(games / "../games/meshes/rod.stl", games));
  EXPECT_FALSE(liesBelow(outside, games));
  EXPECT_FALSE(liesBelow(games / "../games-of-others/rod.stl", games));
  std::filesystem::create_symlink(outside, games / "link.stl");
  EXPECT_FALSE(liesBelow(games / "link.stl", games));
  std::filesystem::create_directory_symlink(games, folder / "same");
  EXPECT_TRUE(liesBelow(inside, folder / "same"));
  EXPECT_FALSE(liesBelow(games / "absent.stl", games));
}

TEST(Printable, LeavesNothingThatMovesACursor) {
  EXPECT_EQ(printable("a\x1b[31mb\tc\nd\x7f"), "a?[31mb?c?d?");
  EXPECT_EQ(printable("a\tb\nc", "\n\t"), "a\tb\nc");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m µ ∞"),
            "?31m µ ∞")
      << "U+009B begins an escape sequence";
}

}  // namespace
}  // namespace carom
