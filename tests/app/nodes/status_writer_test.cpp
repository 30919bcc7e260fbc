// The status file of a session: it is written as a whole, every second, and read again.
#include "app/nodes/status_writer.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include <nlohmann/json.hpp>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::TemporaryFolder;

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

pid_t endedProcess() {
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  waitpid(gone, nullptr, 0);
  return gone;
}

TEST(StatusWriter, AStatusIsReadAsItWasWritten) {
  const TemporaryFolder folder;
  auto status = statusOf("playing");
  const auto file = folder.file("status.json", linesOf(status));
  EXPECT_EQ(readStatus(file).state, "playing");
  EXPECT_EQ(readStatus(file).process, getpid());
  EXPECT_EQ(readStatus(file).frame, std::nullopt);
  status["frame"] = std::uint64_t{1} << 40;
  status["room"] = "a\xff";  // no UTF-8
  folder.file("status.json", linesOf(status));
  EXPECT_EQ(readStatus(file).frame, std::uint64_t{1} << 40);
  for (const char* broken : {"", "{", "[]", R"({"state": 3, "process": 1})", R"({"state": "playing"})"}) {
    SCOPED_TRACE(broken);
    folder.file("status.json", broken);
    EXPECT_EQ(readStatus(file).state, "");
    EXPECT_EQ(withNewTime(file), "");
  }
  EXPECT_EQ(readStatus(folder / "none.json").state, "");
}

TEST(StatusWriter, LastWordsAreThoseOfAProcessThatHasEnded) {
  const TemporaryFolder folder;
  auto status = statusOf("playing");
  status["written"] = "2000-01-01T00:00:00Z";
  const auto file = folder.file("status.json", linesOf(status));
  EXPECT_EQ(withNewTime(file), "") << "this process lives";
  status["process"] = endedProcess();
  folder.file("status.json", linesOf(status));
  const auto last = nlohmann::ordered_json::parse(withNewTime(file));
  EXPECT_GT(last.at("written").get<std::string>(), "2026-01-01T00:00:00Z");
  auto as = last;
  as["written"] = status["written"];
  EXPECT_EQ(as, status) << "nothing else has changed";
}

}  // namespace
}  // namespace carom
