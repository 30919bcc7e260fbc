// The keeper of a room, against computers that are made up: time passes only where they let it.

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <deque>
#include <map>
#include <random>

#include "app/nodes/room_keeper.h"
#include "engine/text/log.h"

namespace carom {
namespace {

using End = RoomRun::End;
using Hosts = std::vector<std::string>;

/// A room whose runs end as a script says; with the time and an account of what the keeper did.
class MadeUpNodes : public RoomNodes {
 public:
  struct Scripted {
    End end = End::cutOff;
    double starts_s = 3.0;  // until its first frame, or until it ends without one
    double plays_s = 0.0;
    int status = 1;
  };
  std::deque<Scripted> script;
  std::map<std::string, std::pair<double, double>> silent;  // from and until when a host does not answer
  std::map<std::string, bool> unfit;
  Hosts needed{"first"};
  double asking_s = 0.1, asksEnd_s = 1e9;
  std::vector<std::string> did;

  double now_s() override { return now_s_; }
  bool isAskedToEnd() override { return now_s_ >= asksEnd_s; }
  bool wait(double duration_s, const std::string& why) override {
    EXPECT_FALSE(why.empty());
    did.push_back(fmt::format("waits {:.0f}", duration_s));
    now_s_ += duration_s;
    return !isAskedToEnd();
  }
  std::vector<HostFault> ask(const Hosts& hosts) override {
    now_s_ += asking_s;
    return faultsOf(hosts);
  }
  std::optional<std::vector<HostFault>> poll(const Hosts& hosts) override {
    ++questions;
    return faultsOf(hosts);
  }
  bool canPlayWithout(const Hosts& hosts) override {
    return std::none_of(hosts.begin(), hosts.end(), [&](const std::string& host) {
      return std::find(needed.begin(), needed.end(), host) != needed.end();
    });
  }
  std::string wallsOf(const Hosts& hosts) override { return fmt::format("{}", fmt::join(hosts, ", ")); }
  RoomRun run(const Hosts& without, const std::function<bool()>& isToEnd) override {
    const double from_s = now_s_;
    const Scripted scripted = script.empty() ? Scripted{End::finished, 3.0, 1.0, 0} : script.front();
    if (!script.empty()) script.pop_front();
    std::string line = without.empty() ? "all" : fmt::format("without {}", fmt::join(without, ", "));
    End end = scripted.end;
    while (now_s_ < from_s + scripted.starts_s + scripted.plays_s) {
      now_s_ += 1.0;
      if (isToEnd()) end = End::broughtBack;
      if (isAskedToEnd()) end = End::askedToEnd;
      if (end != scripted.end) break;
    }
    did.push_back(line);
    began_s.push_back(from_s);
    return {end, scripted.status, scripted.plays_s > 0.0 ? now_s_ - from_s - scripted.starts_s : 0.0};
  }
  int questions = 0;
  std::vector<double> began_s;

 private:
  std::vector<HostFault> faultsOf(const Hosts& hosts) {
    std::vector<HostFault> faults;
    for (const std::string& host : hosts) {
      const auto times = silent.find(host);
      if (times != silent.end() && now_s_ >= times->second.first && now_s_ < times->second.second)
        faults.push_back({host, host + " does not answer", true});
      if (unfit[host]) faults.push_back({host, host + " has another version", false});
    }
    return faults;
  }
  double now_s_ = 1000.0;
};

/// Collects the log's lines while it lives.
struct Said {
  Said() {
    before =
        log::replaceSink([this](log::Level, std::string_view line) { lines += std::string(line) + "\n"; });
  }
  ~Said() { log::replaceSink(before); }
  std::string lines;
  log::Sink before;
};

constexpr double kLong_s = 3600.0;
using Did = std::vector<std::string>;

TEST(RoomKeeper, GoesOnAtOnceAfterPlayingAndLaterAndLaterIfItDoesNotPlay) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, 100.0}, {End::cutOff}, {End::cutOff}, {End::cutOff}, {End::cutOff},
                  {End::cutOff, 3.0, 100.0}};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
  EXPECT_EQ(nodes.did, (Did{"all", "all", "waits 5", "all", "waits 15", "all", "waits 60", "all", "waits 60",
                            "all", "all"}));
  EXPECT_NE(said.lines.find("started again in 15 s"), std::string::npos) << said.lines;
}

TEST(RoomKeeper, StartsAgainWhenTheVeryFirstStartIsCutOff) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff}, {End::cutOff, 3.0, 1.0}, {End::cutOff, 3.0, 1.0}};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first"}, {}).keep(), 0);
  EXPECT_EQ(nodes.did, (Did{"all", "waits 5", "all", "all", "waits 15", "all"}));
}

TEST(RoomKeeper, GivesUpOnlyOnASessionThatNeverBegan) {
  MadeUpNodes wrong;
  wrong.script = {{End::refused, 3.0, 0.0, 1}};
  const Said said;
  EXPECT_EQ(RoomKeeper(wrong, {"first"}, {}).keep(), 1);
  EXPECT_EQ(wrong.did, Did{"all"});
  MadeUpNodes later;  // as while an X display is not back yet
  later.script = {{End::cutOff, 3.0, 60.0}, {End::refused}, {End::refused}};
  EXPECT_EQ(RoomKeeper(later, {"first"}, {}).keep(), 0);
  EXPECT_EQ(later.did, (Did{"all", "all", "waits 5", "all", "waits 15", "all"}));
  EXPECT_NE(said.lines.find(kNoFirstFrame), std::string::npos) << said.lines;
  MadeUpNodes old;
  old.unfit["left"] = true;
  EXPECT_EQ(RoomKeeper(old, {"first", "left"}, {}).keep(), 1);
  EXPECT_TRUE(old.did.empty());
}

TEST(RoomKeeper, WaitsForAHostThatComesBackWithinAMinute) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, 200.0}};
  nodes.silent["left"] = {1100.0, 1230.0};  // cut off at 1203
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
  EXPECT_EQ(nodes.did, (Did{"all", "waits 5", "waits 15", "waits 40", "all"}));
}

TEST(RoomKeeper, LeavesOutAHostAfterAMinuteAndTakesItBack) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, 200.0}, {End::cutOff, 3.0, kLong_s}};
  nodes.silent["left"] = {1100.0, 1400.0};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left", "right"}, {}).keep(), 0);
  EXPECT_EQ(nodes.did, (Did{"all", "waits 5", "waits 15", "waits 40", "without left", "all"}));
  EXPECT_NEAR(nodes.began_s[1], 1203.0 + 60.0, 2.0);
  EXPECT_GT(nodes.began_s[2], 1400.0 + 14.0) << "one answer is not enough";
  EXPECT_LT(nodes.began_s[2], 1400.0 + 32.0);
  EXPECT_NE(said.lines.find("host left is left out: its walls (left) stay dark"), std::string::npos);
}

TEST(RoomKeeper, LeavesOutAHostWhoseLoginHangsAsSoon) {
  MadeUpNodes nodes;
  nodes.asking_s = 15.0;
  nodes.script = {{End::cutOff, 3.0, 200.0}};
  nodes.silent["left"] = {1100.0, 9000.0};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
  EXPECT_LT(nodes.began_s.at(1), 1218.0 + 60.0 + 2 * 15.0 + 2.0)
      << "a minute, the question then, and one to the rest";
}

TEST(RoomKeeper, NeverLeavesOutTheHostOfNodeZero) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, 200.0}};
  nodes.silent["first"] = nodes.silent["left"] = {1100.0, 1600.0};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
  EXPECT_GT(nodes.began_s.at(1), 1600.0);
  EXPECT_EQ(nodes.did[nodes.did.size() - 2], "waits 60");
}

TEST(RoomKeeper, AHostThatComesBackInVainStaysOutLongerAndLonger) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, 200.0}, {End::cutOff, 3.0, kLong_s}};  // … without left
  for (int i = 0; i < 3; ++i) {
    nodes.script.push_back({End::cutOff});  // with it: it answers and cannot draw
    nodes.script.push_back({End::cutOff});
    nodes.script.push_back({End::cutOff, 3.0, kLong_s});  // without
  }
  nodes.asksEnd_s = 5000.0;
  nodes.silent["left"] = {1100.0, 1400.0};
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
  std::vector<double> without_s;
  for (std::size_t i = 0, run = 0; i < nodes.did.size(); ++i) {
    if (nodes.did[i].starts_with("waits")) continue;
    if (nodes.did[i] == "without left") without_s.push_back(nodes.began_s[run]);
    ++run;
  }
  ASSERT_GE(without_s.size(), 4u);
  EXPECT_GT(without_s[2] - without_s[1], 60.0);
  EXPECT_GT(without_s[3] - without_s[2], 180.0);
}

TEST(RoomKeeper, AHostThatIsLeftOutByHandIsNeverAsked) {
  MadeUpNodes nodes;
  nodes.script = {{End::cutOff, 3.0, kLong_s}};
  nodes.unfit["left"] = true;
  const Said said;
  EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {"left"}).keep(), 0);
  EXPECT_EQ(nodes.did, (Did{"without left", "without left"}));
  EXPECT_EQ(nodes.questions, 0);
}

TEST(RoomKeeper, EndsWhenItIsAskedToAtAnyMoment) {
  for (double at_s = 1000.0; at_s < 1100.0; at_s += 1.0) {
    MadeUpNodes nodes;
    for (int i = 0; i < 50; ++i) nodes.script.push_back({End::cutOff, 3.0, i % 2 ? 4.0 : 0.0});
    nodes.silent["left"] = {1020.0, 1050.0};
    nodes.asksEnd_s = at_s;
    const Said said;
    EXPECT_EQ(RoomKeeper(nodes, {"first", "left"}, {}).keep(), 0);
    EXPECT_LT(nodes.now_s(), std::max(at_s, 1000.0) + 61.0);
  }
}

/// After any faults the room plays again, with all hosts that answer.
TEST(RoomKeeper, PlaysAgainWhateverFails) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    MadeUpNodes nodes;
    for (int i = 0; i < 12; ++i)
      nodes.script.push_back({End::cutOff, between(1, 30), random() % 3 ? between(1, 90) : 0.0});
    nodes.script.push_back({End::cutOff, 3.0, 1e5});
    nodes.script.push_back({End::cutOff, 3.0, 1e5});
    for (const char* host : {"left", "right"}) {
      const double from_s = 1000.0 + between(0, 600);
      nodes.silent[host] = {from_s, from_s + between(0, 400)};
    }
    nodes.asksEnd_s = 12000.0;
    const Said said;
    EXPECT_EQ(RoomKeeper(nodes, {"first", "left", "right"}, {}).keep(), 0);
    EXPECT_EQ(nodes.did.back(), "all") << fmt::format("{}", fmt::join(nodes.did, "; "));
  }
}

}  // namespace
}  // namespace carom
