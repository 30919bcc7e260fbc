// Commands of other programs: what they say, and that none lasts longer than it may.
#include "app/nodes/timed_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "app/nodes/timed.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::kGoOn;
using test::secondsOf;
using test::TemporaryFolder;

TEST(TimedCommand, SaysWhatACommandSaid) {
  const CommandResult said = runTimed({"sh", "-c", "echo out; echo err >&2; exit 3"}, 60.0, kGoOn);
  EXPECT_EQ(said.text, "out\nerr");
  EXPECT_EQ(said.status, 3);
  EXPECT_FALSE(said.isTooLate);
  EXPECT_EQ(runTimed({"/no/such/program"}, 60.0, kGoOn).status, -1);
  EXPECT_EQ(runTimed({"sh", "-c", "yes | head -c 1000000"}, 60.0, kGoOn).text.size(), 65535u);
  EXPECT_EQ(runTimed({"cat"}, 60.0, kGoOn).status, 0) << "its input is empty";
}

TEST(TimedCommand, EndsACommandThatHangsAndAllThatItStarted) {
  const TemporaryFolder folder;
  const std::string file = folder / "process";
  CommandResult said;
  const double took_s = secondsOf([&] {
    said = runTimed({"sh", "-c", "sleep 1000 & echo $! > " + file + "; wait"}, 0.5, kGoOn);
  });
  EXPECT_TRUE(said.isTooLate);
  EXPECT_LT(took_s, 20.0);
  const pid_t left = std::stoi(test::contentOf(file));
  for (int i = 0; i < 100 && std::filesystem::exists("/proc/" + std::to_string(left)); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  // Where nothing collects orphans, a zombie stays.
  const std::string state = test::contentOf("/proc/" + std::to_string(left) + "/stat");
  EXPECT_TRUE(state.empty() || state.find(") Z ") != std::string::npos) << state;
}

TEST(TimedCommand, DoesNotWaitForAProcessThatKeepsItsOutputOpen) {
  CommandResult said;
  const double took_s = secondsOf([&] {
    said = runTimed({"sh", "-c", "sleep 30 & echo well"}, 60.0, kGoOn);
  });
  EXPECT_EQ(said.text, "well");
  EXPECT_EQ(said.status, 0);
  EXPECT_LT(took_s, 20.0);
}

}  // namespace
}  // namespace carom
