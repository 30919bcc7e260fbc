// mpirun and its nodes as one job: it ends when it is asked to, and its status file says whether it hangs.
#include "app/nodes/room_job.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "app/nodes/timed.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::kGoOn;
using test::secondsOf;
using test::TemporaryFolder;

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

}  // namespace
}  // namespace carom
