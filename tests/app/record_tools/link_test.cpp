// `carom link`: keys that only their owner may read, and lines that cannot be measured.
#include "app/record_tools/link.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/link/link_key.h"
#include "app/program.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

TEST(LinkTools, ANewKeyIsItsOwnersAloneAndIsShown) {
  const TemporaryFolder folder;
  const auto file = folder / "room.key";
  const auto made = runCarom(folder, {"link", "--new-key", file});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  const LinkKey key = LinkKey::read(file);
  EXPECT_EQ(made.out, file.string() + ": the key " + key.fingerprint() +
                          " is for both rooms; nobody else may read it\n");
  EXPECT_EQ(made.out.find(key.letters()), std::string::npos) << "its letters are shown on demand only";
  EXPECT_EQ(runCarom(folder, {"link", "--show", file}).out,
            key.letters() + "\nfingerprint " + key.fingerprint() + "\n");
  ASSERT_EQ(runCarom(folder, {"link", "--new-key", folder / "other.key"}).status, 0);
  EXPECT_NE(LinkKey::read(folder / "other.key").letters(), key.letters());
}

TEST(LinkTools, WhatCannotBeDoneIsSaid) {
  const TemporaryFolder folder;
  const auto file = folder / "room.key";
  ASSERT_EQ(runCarom(folder, {"link", "--new-key", file}).status, 0);
  EXPECT_EQ(runCarom(folder, {"link"}).status, 2);
  EXPECT_EQ(runCarom(folder, {"link", "--test", "lyon.example.org"}).status, 2) << "without a key";
  EXPECT_EQ(runCarom(folder, {"link", "--show", file, "--test", "x", "--key", file}).status, 2)
      << "both at once";
  const auto listens = runCarom(folder, {"link", "--test", "listen:7314", "--key", file});
  EXPECT_EQ(listens.status, 1);
  EXPECT_NE(listens.err.find("--test: expected HOST or HOST:PORT"), std::string::npos) << listens.err;
  EXPECT_EQ(runCarom(folder, {"link", "--show", folder / "none.key"}).status, 1);
}

}  // namespace
}  // namespace carom
