#include "app/stage/window_memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "app/temporary_folder.h"
#include "log_lines.h"

namespace carom {
namespace {

const RememberedWindow kConsole{"console", "DP-1", {10, 34}, {1280, 860}};
const RememberedWindow kWall{"wall \"a\\b\" 1280x720+0+0", "DP-1", {0, 0}, {640, 360}};

TEST(WindowMemory, WhatIsWrittenIsRead) {
  const test::TemporaryFolder folder;
  const auto file = folder / "new" / "windows.toml";
  EXPECT_TRUE(readWindowMemory(file).empty());
  writeWindowMemory(file, {kConsole, kWall});
  EXPECT_EQ(readWindowMemory(file), (std::vector{kConsole, kWall}));
}

TEST(WindowMemory, WindowsOfOtherSessionsStay) {
  const test::TemporaryFolder folder;
  const auto file = folder / "windows.toml";
  writeWindowMemory(file, {kConsole, kWall});
  RememberedWindow moved = kConsole;
  moved.position = {200, 300};
  writeWindowMemory(file, {moved});
  EXPECT_EQ(readWindowMemory(file), (std::vector{moved, kWall}));
}

TEST(WindowMemory, TheFileDoesNotGrow) {
  const test::TemporaryFolder folder;
  const auto file = folder / "windows.toml";
  for (int i = 0; i < 100; ++i) {
    RememberedWindow window = kConsole;
    window.name = "wall " + std::to_string(i);
    writeWindowMemory(file, {window});
  }
  const auto windows = readWindowMemory(file);
  EXPECT_EQ(windows.size(), 32U);
  EXPECT_EQ(windows.front().name, "wall 99");
}

TEST(WindowMemory, AFileThatIsWrongIsSaidAndNotUsed) {
  const test::TemporaryFolder folder;
  const auto file = folder / "windows.toml";
  for (const std::string text :
       {"[[window]", "window = 3", "[[window]]\nname = \"console\"", "\x01\xff\xfe",
        "[[window]]\nname = \"console\"\nmonitor = \"DP-1\"\nposition = [-1, 0]\nsize = [800, 600]",
        "[[window]]\nname = \"console\"\nmonitor = \"DP-1\"\nposition = [0, 0]\nsize = [1e300, 600]",
        "[[window]]\nname = \"console\"\nmonitor = \"DP-1\"\nposition = [0, 0]\nsize = [nan, 600]",
        "[[window]]\nname = \"console\"\nmonitor = \"DP-1\"\nposition = [0, 0]\nsize = [800, 600]\nrun = "
        "1"}) {
    std::ofstream(file) << text;
    const test::LogLines log;
    EXPECT_TRUE(readWindowMemory(file).empty()) << text;
    EXPECT_FALSE(log.said().empty()) << text;
  }
}

TEST(WindowMemory, AFolderThatCannotBeMadeIsSaidOnly) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  const test::LogLines log;
  writeWindowMemory(folder / "file" / "windows.toml", {kConsole});
  ASSERT_EQ(log.said().size(), 1U);
  EXPECT_NE(log.said().front().find("not remembered"), std::string::npos) << log.said().front();
}

}  // namespace
}  // namespace carom
