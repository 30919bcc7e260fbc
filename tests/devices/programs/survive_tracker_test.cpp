// The Lighthouse tracker against programs of our own in the place of survive-cli, and a server of its lines.

#include "devices/programs/survive_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "devices/network_peer.h"
#include "resident_bytes.h"

namespace carom {
namespace {

using test::PeerSocket;
using test::Watched;
using State = TrackerHealth::State;

/// A folder with a shell script called survive-cli; PATH begins with it while this lives.
class FakeProgram {
 public:
  explicit FakeProgram(const std::string& script) {
    std::string pattern = (std::filesystem::temp_directory_path() / "survive-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write(script);
    setenv("PATH", (folder_.string() + ':' + before_).c_str(), 1);
  }
  FakeProgram(const FakeProgram&) = delete;
  FakeProgram& operator=(const FakeProgram&) = delete;
  ~FakeProgram() {
    setenv("PATH", before_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }

  void write(const std::string& script) const {
    const std::filesystem::path file = folder_ / "survive-cli.new";
    std::ofstream(file) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    std::filesystem::rename(file, folder_ / "survive-cli");
  }
  std::string read(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::filesystem::path folder() const { return folder_; }

 private:
  std::string before_ = std::getenv("PATH");
  std::filesystem::path folder_;
};

/// A shell's loop that sends poses of the device for ever. Its times are counts of milliseconds.
std::string posesOf(const std::string& device) {
  return "i=1000; while :; do i=$((i+1)); echo \"${i%???}.${i#${i%???}} " + device +
         " POSE 0.5 0 1.75 1 0 0 0\"; sleep 0.002; done\n";
}

bool delivers(Watched& head) {
  head.samples.clear();
  return head.comesTrue([&] { return head.samples.size() >= 5; });
}

TEST(SurviveTracker, StartsTheProgramAndEndsIt) {
  const FakeProgram program("echo $$ > $(dirname $0)/process; echo $# $* > $(dirname $0)/arguments\n" +
                            posesOf("T20"));
  pid_t process = 0;
  {
    Watched head(surviveTransport({}, {"T20"}));
    ASSERT_TRUE(delivers(head));
    EXPECT_EQ(head.samples[0].pose.position_m, glm::dvec3(0.5, 0.0, 1.75));
    EXPECT_EQ(head.health().state, State::delivering);
    EXPECT_EQ(head.health().names, "devices: T20");
    process = std::stoi(program.read("process"));
    EXPECT_EQ(kill(process, 0), 0);
  }
  EXPECT_NE(kill(process, 0), 0) << "it has ended, and been waited for";
  EXPECT_EQ(program.read("arguments"),
            "7 --record-stdout --record-rawlight 0 --record-imu 0 --record-angle 0\n");
}

// One that writes into a pipe keeps what it writes until there is much of it; here each line comes at once.
TEST(SurviveTracker, LinesComeAtOnce) {
  const FakeProgram program("if [ -t 1 ]; then echo '1 T20 POSE 0 0 1 1 0 0 0'; fi; exec sleep 60\n");
  Watched head(surviveTransport({}, {}));
  EXPECT_TRUE(head.comesTrue([&] { return head.samples.size() == 1; }));
}

TEST(SurviveTracker, AProgramThatIgnoresTheWishToEndIsEnded) {
  const FakeProgram program("echo $$ > $(dirname $0)/process; trap '' TERM\n" + posesOf("T20"));
  pid_t process = 0;
  const auto ends = [&] {
    Watched head(surviveTransport({}, {}));
    EXPECT_TRUE(delivers(head));
    process = std::stoi(program.read("process"));
    return test::Clock::now();
  }();
  EXPECT_NE(kill(process, 0), 0);
  EXPECT_LT(test::Clock::now() - ends, std::chrono::seconds(5));
}

TEST(SurviveTracker, AMissingProgramNeedsHelp) {
  const FakeProgram program("");
  std::filesystem::remove(program.folder() / "survive-cli");
  setenv("PATH", program.folder().c_str(), 1);
  Watched head(surviveTransport({}, {}));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_EQ(head.health().message, "PATH has no program 'survive-cli', install it or name it there");
}

TEST(SurviveTracker, AProgramThatDiesIsStartedAgain) {
  const FakeProgram program("echo '1 T20 POSE 0 0 1 1 0 0 0'; echo 'no base station' >&2; exit 3\n");
  Watched head(surviveTransport({}, {}));
  ASSERT_TRUE(head.comesTrue([&] { return head.health().message.find("ended") != std::string::npos; }));
  EXPECT_EQ(head.health().message, "survive-cli ended with status 3: no base station");
  EXPECT_EQ(head.health().state, State::connecting);
  EXPECT_EQ(head.samples.size(), 1u) << "what it wrote before is kept";
  program.write("kill -SEGV $$\n");
  ASSERT_TRUE(head.comesTrue([&] { return head.health().message.find("signal 11") != std::string::npos; }));
  program.write(posesOf("T20"));
  EXPECT_TRUE(delivers(head));
  EXPECT_GE(head.health().reconnections, 1u);
}

TEST(SurviveTracker, ALineOfAMegabyteIsNamedAndGoodOnesAreKept) {
  const FakeProgram program(
      "echo '1.0 T20 POSE 0 0 1 1 0 0 0'; i=0; while [ $i -lt 4 ]; do i=$((i+1))\n"
      "head -c 1000000 /dev/zero | tr '\\0' x; echo; echo \"2.$((i+100)) T20 POSE 0 0 2 1 0 0 0\"; done\n"
      "exec sleep 60\n");
  Watched head(surviveTransport({}, {}));
  const std::size_t before = test::residentBytes();
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() >= 5; }));
  EXPECT_EQ(head.health().refused, 4u);
  EXPECT_TRUE(head.comesTrue([&] { return head.health().message.rfind("a line has over ", 0) == 0; }))
      << head.health().message << ": the reason stays for somebody to read, though good lines came since";
  EXPECT_LT(test::residentBytes(), before + (8U << 20U));
}

TEST(SurviveTracker, NamesTheDevicesThatThereAre) {
  const FakeProgram program(posesOf("SM0"));
  Watched head(surviveTransport({}, {"T20"}));
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty() && head.health().connected; }));
  EXPECT_EQ(head.health().message, "no 'T20' has sent a pose; these have: SM0");
}

TEST(SurviveTracker, ReadsTheSameLinesFromAServer) {
  const PeerSocket listener(SOCK_STREAM);
  ::listen(listener.descriptor(), 1);
  Watched head(
      surviveTransport(readSurviveServer(fmt::format("tcp://127.0.0.1:{}", listener.port())), {"T20"}));
  for (int i = 0; i < 2; ++i) {
    const PeerSocket client = PeerSocket::acceptedBy(listener);
    head.samples.clear();
    ASSERT_TRUE(head.comesTrue([&] {
      client.send(test::bytesOf(fmt::format("{} T20 POSE 0 0 1 1 0 0 0\r\n", 1.0 + head.now_s())));
      return head.samples.size() >= 5;
    }));
  }
  EXPECT_EQ(head.health().reconnections, 1u);
}

TEST(SurviveServer, IsReadOrExplained) {
  EXPECT_EQ(readSurviveServer("tcp://h:7001").port, 7001);
  for (const char* wrong : {"", "tcp://h", "h:7001", "tcp://h:7001?a=b", "survive-cli --simulator"}) {
    EXPECT_THROW(readSurviveServer(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace carom
