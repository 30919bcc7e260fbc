// `carom track`: what it shows, and recordings that are whole however it ends.

#include "app/tools/track.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "app/program.h"
#include "devices/monitor/loss_counter.h"
#include "devices/tracker/trace.h"
#include "places.h"

namespace carom {
namespace {

using test::contentOf;
using test::runCarom;
using test::TemporaryFolder;

/// One wall, and a tracker that walks about.
std::string rigText(const std::string& tracker) {
  return "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"cap\"\nsensor = "
         "0\n\n[[tracker]]\nname = \"cap\"\n" +
         tracker +
         "\n[[wall]]\nname = \"front\"\nlower_left = [-1.5, 0.0, -1.5]\nlower_right = [1.5, 0.0, -1.5]\n"
         "upper_left = [-1.5, 3.0, -1.5]\npixels = [192, 192]\n";
}

TEST(Track, ShowsAndRecordsASimulatedPerson) {
  const TemporaryFolder folder;
  const auto rig = folder.file("rig.toml", rigText("kind = \"simulated\"\n"));
  const auto trace = folder / "walk.csv";
  const auto result = runCarom(folder, {"track", "--rig", rig, "--seconds", "1.3", "--record", trace});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* part : {"rate Hz", "age ms", "jitter ms", "rest mm", "dropouts", "cap", "delivering"}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part << " in\n" << result.out;
  }
  EXPECT_EQ(result.out.find('\033'), std::string::npos);  // no terminal, no control characters
  const auto samples = readTrace(trace);
  EXPECT_GE(samples.size(), 78u);  // 60 Hz
  EXPECT_TRUE(samples[0].hasOrientation);
  EXPECT_EQ(runCarom(folder, {"filter", trace}).status, 0);
}

// A recording of a recording is the recording.
TEST(Track, RecordsWhatCame) {
  const TemporaryFolder folder;
  std::string text = "time_s,x_m,y_m,z_m\n";
  for (int i = 0; i < 40; ++i)
    text += std::to_string(0.01 * i) + ",0." + std::to_string(100 + i) + ",1.7,0.25\n";
  folder.file("given.csv", text);
  const auto rig = folder.file("rig.toml", rigText("kind = \"recorded\"\nsource = \"given.csv\"\n"));
  const auto result =
      runCarom(folder, {"track", "--rig", rig, "--seconds", "0.7", "--record", folder / "again.csv"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto given = readTrace(folder / "given.csv"), again = readTrace(folder / "again.csv");
  ASSERT_GE(again.size(), given.size());  // it goes on standing at its end
  EXPECT_FALSE(again[0].hasOrientation);
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_EQ(again[i].time_s, given[i].time_s);
    EXPECT_EQ(again[i].pose.position_m, given[i].pose.position_m);
  }
}

/// A sensor that is seen (s) or said to be lost (l) at 60 Hz, polled every `perPoll` frames; the count.
std::size_t lossesOf(const std::string& frames, std::size_t perPoll) {
  LossCounter counter(2);
  for (std::size_t first = 0; first < frames.size(); first += perPoll) {
    std::vector<TrackerSample> samples;
    std::vector<Reading> inputs;
    for (std::size_t i = first; i < std::min(first + perPoll, frames.size()); ++i) {
      const double time_s = static_cast<double>(i) / 60.0;
      Reading lost;
      lost.kind = Reading::Kind::lost;
      lost.device_s = time_s;
      lost.sensor = 5;  // which nobody listens to, and is never seen
      inputs.push_back(lost);
      lost.sensor = 2;
      if (frames[i] == 'l') inputs.push_back(lost);
      if (frames[i] == 's') samples.push_back({time_s, 2, {}, true});
    }
    counter.see(samples, inputs);
  }
  return counter.count();
}

TEST(Track, CountsLossesNotTheFramesTheyLast) {
  for (const std::size_t perPoll : {1, 2, 3, 7, 100}) {
    EXPECT_EQ(lossesOf("llllllll", perPoll), 0u) << "never seen, never lost; polls of " << perPoll;
    EXPECT_EQ(lossesOf("ssssllll", perPoll), 1u) << perPoll;
    EXPECT_EQ(lossesOf("llsslllllsslll", perPoll), 2u) << perPoll;
    EXPECT_EQ(lossesOf("slslslsl", perPoll), 4u) << perPoll;
    EXPECT_EQ(lossesOf("ss....ss", perPoll), 0u) << "what does not come has not been said to be lost";
  }
}

class TrackEnds : public testing::TestWithParam<int> {};

TEST_P(TrackEnds, WithAWholeRecording) {
  const TemporaryFolder folder;
  const auto rig = folder.file("rig.toml", rigText("kind = \"simulated\"\n")), trace = folder / "walk.csv";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (!std::freopen((folder / "out.txt").c_str(), "w", stdout)) ::_exit(9);
    if (!std::freopen((folder / "err.txt").c_str(), "w", stderr)) ::_exit(9);
    ::execl(CAROM_PROGRAM, "carom", "track", "--rig", rig.c_str(), "--record", trace.c_str(), nullptr);
    ::_exit(9);
  }
  // It has begun once the table is there.
  const auto giveUp = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (contentOf(folder / "out.txt").empty() && std::chrono::steady_clock::now() < giveUp) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_FALSE(std::filesystem::exists(trace));  // not before its end
  ::kill(child, GetParam());
  int ended = 0;
  ASSERT_EQ(::waitpid(child, &ended, 0), child);
  EXPECT_TRUE(WIFEXITED(ended));
  EXPECT_EQ(WEXITSTATUS(ended), 0) << contentOf(folder / "err.txt");
  EXPECT_GT(readTrace(trace).size(), 10u);
  EXPECT_EQ(folder.entries(), 4);  // rig, trace, and the two it printed to: no parts
}

INSTANTIATE_TEST_SUITE_P(Signals, TrackEnds, testing::Values(SIGINT, SIGTERM));

TEST(Track, SaysWhatIsWrongBeforeItBegins) {
  const TemporaryFolder folder;
  const auto rig = folder.file("rig.toml", rigText("kind = \"simulated\"\n"));
  const auto unwritable = runCarom(folder, {"track", "--rig", rig, "--record", folder / "no/such/walk.csv"});
  EXPECT_EQ(unwritable.status, 1);
  EXPECT_NE(unwritable.err.find("walk.csv"), std::string::npos) << unwritable.err;
  const auto missing = runCarom(folder, {"track", "--rig", folder / "none.toml"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.toml:1:1: "), std::string::npos) << missing.err;
  EXPECT_EQ(runCarom(folder, {"track", "--seconds", "0"}).status, 2);
}

// A tracker that is not there is no fault of the rig: it is shown as such, and nothing is recorded.
TEST(Track, ShowsATrackerThatIsNotThere) {
  const TemporaryFolder folder;
  const auto rig = folder.file(
      "rig.toml", rigText("kind = \"vrpn\"\nsource = \"Head@tcp://127.0.0.1:9\"\n"));  // nobody listens there
  const auto result =
      runCarom(folder, {"track", "--rig", rig, "--seconds", "0.4", "--record", folder / "walk.csv"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("cap (vrpn): connecting"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find("nothing came"), std::string::npos) << result.err;
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Track, ListsWhatIsPluggedIn) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"track", "--list"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_FALSE(result.out.empty());
}

}  // namespace
}  // namespace carom
