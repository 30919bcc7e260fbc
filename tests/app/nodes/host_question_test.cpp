// Questions to other computers: an ssh of the test's own answers, refuses, waits for ever, or leaves a
// process behind.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/nodes/host_question.h"
#include "app/nodes/mpirun_line.h"
#include "app/nodes/rig_without.h"
#include "app/nodes/room_job.h"
#include "app/nodes/status_writer.h"
#include "app/nodes/timed_command.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

const std::atomic<bool> kGoOn = false;

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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

/// An ssh of this test's in the first folder of PATH.
class HostQuestion : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto ssh = folder_.file("ssh",
                                  "#!/bin/sh\nwhile [ \"$1\" = -o ]; do shift 2; done\n"
                                  "case $1 in\nwell) echo Hello; echo '" CAROM_VERSION
                                  "';;\n"
                                  "old) echo 'carom 0.0.1';;\nbare) echo 'not found' >&2; exit 127;;\n"
                                  "hangs) sleep 1000;;\n*) echo 'No route to host' >&2; exit 255;;\nesac\n");
    std::filesystem::permissions(ssh, std::filesystem::perms::owner_all);
    before_ = std::getenv("PATH");
    setenv("PATH", (ssh.parent_path().string() + ":" + before_).c_str(), 1);
  }
  void TearDown() override { setenv("PATH", before_.c_str(), 1); }

  TemporaryFolder folder_;
  std::string before_;
};

TEST_F(HostQuestion, EveryHostIsAnsweredForInTime) {
  std::vector<HostFault> faults;
  const double took_s = secondsOf([&] {
    faults = askHosts({"localhost", "well", "old", "hangs", "bare", "gone"}, "carom", kGoOn, 2.0);
  });
  EXPECT_LT(took_s, 20.0);
  ASSERT_EQ(faults.size(), 4u);
  EXPECT_EQ(faults[0].words, "host bare does not run carom: not found, expected " CAROM_VERSION " there");
  EXPECT_FALSE(faults[0].isSilent);
  EXPECT_EQ(faults[1].words,
            "host gone does not answer: No route to host, expected to reach it by ssh without a password");
  EXPECT_TRUE(faults[1].isSilent);
  EXPECT_EQ(
      faults[2].words,
      "host hangs does not answer: ssh was not through within 2 s, expected its version; does its login "
      "wait, for example for a network folder?");
  EXPECT_TRUE(faults[2].isSilent);
  EXPECT_EQ(faults[3].words, "host old has another version, carom 0.0.1, expected " CAROM_VERSION " as here");
  EXPECT_FALSE(faults[3].isSilent);
}

TEST_F(HostQuestion, IsGivenUpWhenTheEndIsAskedFor) {
  std::atomic<bool> asked = false;
  std::thread person([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    asked = true;
  });
  const double took_s = secondsOf([&] { EXPECT_TRUE(askHosts({"hangs"}, "carom", asked, 60.0).empty()); });
  person.join();
  EXPECT_LT(took_s, 20.0);
}

TEST(RoomJob, EndsAJobThatDoesNotEndByItself) {
  const std::vector<std::string> deaf{"sh", "-c", "trap '' TERM; while :; do sleep 0.1; done"};
  JobEnd end;
  const double took_s = secondsOf([&] {
    end = runJob(
        deaf, kGoOn, [] { return true; }, 0.5);
  });
  EXPECT_TRUE(end.wasStopped);
  EXPECT_FALSE(end.wasAsked);
  EXPECT_EQ(end.status, 128 + SIGKILL);
  EXPECT_LT(took_s, 20.0);
  EXPECT_EQ(runJob({"sh", "-c", "exit 5"}, kGoOn, [] { return false; }).status, 5);
  const std::atomic<bool> asked = true;
  EXPECT_TRUE(runJob({"sleep", "1000"}, asked, [] { return false; }).wasAsked);
}

TEST(RoomJob, IsWatchedByTheStatusOfNodeZero) {
  const TemporaryFolder folder;
  const auto status = [&](pid_t process, const std::string& more) {
    folder.file("status.json", R"({"state": "playing", "process": )" + std::to_string(process) + more + "}");
  };
  JobWatch watch(folder / "status.json", 180.0, 15.0);
  EXPECT_EQ(watch.look(1.0), "") << "there is no status yet";
  status(getpid(), R"(, "frame": 7)");  // this program's own, as carom room writes it
  EXPECT_EQ(watch.look(100.0), "");
  EXPECT_EQ(watch.played_s(), 0.0);
  EXPECT_EQ(watch.look(181.0), "the nodes have shown no frame 181 s after their start");
  status(getppid(), "");
  EXPECT_EQ(watch.look(179.0), "");
  status(getppid(), R"(, "frame": 0)");
  EXPECT_EQ(watch.look(190.0), "");
  EXPECT_GT(watch.played_s(), 0.0);
  EXPECT_EQ(watch.look(200.0), "");
  EXPECT_EQ(watch.played_s(), 10.0);
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  waitpid(gone, nullptr, 0);
  status(gone, R"(, "frame": 9)");
  EXPECT_EQ(watch.look(300.0), "");
  EXPECT_EQ(watch.look(314.0), "");
  EXPECT_EQ(watch.look(316.0), "node 0 has ended and mpirun has not, 16 s later");
}

TEST(StatusWriter, WritesEverySecondWhateverTheRestDoes) {
  const TemporaryFolder folder;
  const auto file = folder / "status.json";
  std::atomic<int> times = 0;
  StatusWriter writer(file, [&] { return ++times == 3 ? std::string() : std::to_string(times); });
  EXPECT_EQ(test::contentOf(file), "1");
  for (int i = 0; i < 600 && times < 4; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_GE(times, 4) << "within 12 s";
  writer.end([] { return std::string("ended"); });
  writer.write();
  EXPECT_EQ(test::contentOf(file), "ended");
  EXPECT_THROW(StatusWriter(folder / "none" / "status.json", [] { return std::string("x"); }),
               std::exception);
}

Rig fourWalls() {
  Rig rig = readRig(std::filesystem::path(CAROM_CONFIG_DIR) / "rigs/four-walls-cluster.toml");
  rig.nodes = {{.rank = 0, .display = ":0", .host = "localhost"},
               {.rank = 1, .display = ":1", .host = "sides", .slots = 2},
               {.rank = 3, .display = ":3", .host = "floor"}};
  return rig;
}

TEST(RigWithout, LeavesOutTheWallsOfNodesAndMovesTheOthersUp) {
  const Rig whole = fourWalls();
  const Rig rig = rigWithout(whole, {2, 1});
  ASSERT_EQ(rig.walls.size(), 2u);
  EXPECT_EQ(rig.walls[0].node, 0);
  EXPECT_EQ(rig.walls[1].node, 1);
  EXPECT_EQ(rig.walls[1].name, whole.walls[3].name);
  EXPECT_EQ(hostsOf(rig), (std::vector<std::string>{"localhost", "floor"}));
  EXPECT_EQ(displayOf(rig, 1), ":3");
  ASSERT_EQ(rig.missing.size(), 1u);
  EXPECT_EQ(rig.missing[0].name, "sides");
  EXPECT_EQ(rig.missing[0].walls, (std::vector<std::string>{whole.walls[1].name, whole.walls[2].name}));
  EXPECT_EQ(hostsOf(rigWithout(whole, {})), hostsOf(whole));
  EXPECT_EQ(hostsOf(rigWithout(whole, {3})), (std::vector<std::string>{"localhost", "sides", "sides"}));
}

TEST(RigWithout, RefusesNodesThatCannotBeLeftOut) {
  EXPECT_THROW(rigWithout(fourWalls(), {0}), std::runtime_error);
  EXPECT_THROW(rigWithout(fourWalls(), {4}), std::runtime_error);
  Rig console = fourWalls();  // node 0 draws no wall
  console.walls.erase(console.walls.begin());
  EXPECT_NO_THROW(rigWithout(console, {1, 2}));
  EXPECT_THROW(rigWithout(console, {1, 2, 3}), std::runtime_error);
}

}  // namespace
}  // namespace carom
