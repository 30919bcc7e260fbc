// Questions to other computers: an ssh of the test's own answers, refuses, or waits for ever.
#include "app/nodes/host_question.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/nodes/timed.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::kGoOn;
using test::secondsOf;
using test::TemporaryFolder;

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

}  // namespace
}  // namespace carom
