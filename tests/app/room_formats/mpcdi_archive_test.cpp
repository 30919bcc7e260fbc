// The files of MPCDI rooms, in archives and beside descriptions; neither may lead elsewhere.
#include "app/room_formats/mpcdi_archive.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "app/room_formats/read_room.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::kArc;
using test::TemporaryFolder;

constexpr std::size_t kMost = 1'000'000;

/// Returns what a refusal says; empty if there is none.
std::string refusalOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::exception& refused) {
    return refused.what();
  }
  return {};
}

TEST(MpcdiArchive, GivesTheFilesOfAnArchive) {
  const MpcdiArchive archive(kArc);
  EXPECT_NE(archive.description().find("<MPCDI profile=\"a3\""), std::string::npos);
  const std::string warp = archive.contentOf("GeometryWarpFile-proj1.pfm", kMost);
  EXPECT_EQ(warp.size(), 38431u);
  EXPECT_TRUE(warp.starts_with("PF\n"));
  EXPECT_EQ(refusalOf([&] { archive.contentOf("GeometryWarpFile-proj1.pfm", 38430); }),
            "'GeometryWarpFile-proj1.pfm' has 38431 bytes, expected at most 38430");
  EXPECT_EQ(refusalOf([&] { archive.contentOf("geometrywarpfile-proj1.pfm", kMost); }),
            "the archive has no 'geometrywarpfile-proj1.pfm', expected it")
      << "capitals count";
}

TEST(MpcdiArchive, GivesTheFilesBesideADescription) {
  const TemporaryFolder folder;
  folder.file("a.pfm", "12345");
  const MpcdiArchive beside(folder.file("room.mpcdi.xml", "<MPCDI/>"));
  EXPECT_EQ(beside.description(), "<MPCDI/>");
  EXPECT_EQ(beside.contentOf("a.pfm", 5), "12345");
  EXPECT_EQ(refusalOf([&] { beside.contentOf("a.pfm", 4); }), "'a.pfm' has over 4 bytes, expected fewer");
  EXPECT_NE(refusalOf([&] { beside.contentOf("gone.pfm", kMost); }), "");
}

TEST(MpcdiArchive, NoNameLeadsOut) {
  const TemporaryFolder folder;
  const TemporaryFolder* outside = &folder;
  outside->file("secret", "x");
  std::filesystem::create_directory(folder / "inside");
  std::filesystem::create_symlink(folder / "secret", folder / "inside" / "link");
  folder.file("inside/room.mpcdi.xml", "<MPCDI/>");
  const MpcdiArchive beside(folder / "inside/room.mpcdi.xml"), archive(kArc);
  for (const std::string name :
       {"", "../secret", "a/../../secret", "/etc/passwd", "..\\secret", "C:secret"}) {
    EXPECT_NE(refusalOf([&] { beside.contentOf(name, kMost); }).find("leads out of the folder"),
              std::string::npos)
        << name;
    EXPECT_NE(refusalOf([&] { archive.contentOf(name, kMost); }).find("leads out of the archive"),
              std::string::npos)
        << name;
  }
  EXPECT_NE(refusalOf([&] { beside.contentOf("link", kMost); }), "") << "a link out of the folder";
}

TEST(MpcdiArchive, BrokenArchivesAreRefused) {
  const TemporaryFolder folder;
  const std::string whole = test::contentOf(kArc);
  ASSERT_GT(whole.size(), 1000u);
  EXPECT_NE(refusalOf([&] {
              MpcdiArchive(folder.file("a.mpcdi", whole.substr(0, whole.size() / 2)));
            }).find("this is no zip archive, or a broken one"),
            std::string::npos);
  std::string spoilt = whole;  // in the middle of the packed places of the screen
  for (std::size_t i = 500; i < 600; ++i) spoilt[i] = static_cast<char>(spoilt[i] ^ 0x55);
  const MpcdiArchive archive(folder.file("b.mpcdi", spoilt));
  EXPECT_EQ(refusalOf([&] { archive.contentOf("GeometryWarpFile-proj1.pfm", kMost); }),
            "'GeometryWarpFile-proj1.pfm' is broken in the archive, expected it whole");
}

}  // namespace
}  // namespace carom
