// What a device's thread asks of the system, against what the kernel says of it afterwards.

#include "devices/tracker/realtime_thread.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <thread>

#include "devices/tracker/device_tracker.h"

namespace carom {
namespace {

void onAThread(const std::function<void()>& act) { std::jthread(act).join(); }

int policy() { return sched_getscheduler(0) & ~SCHED_RESET_ON_FORK; }
int niceness() { return getpriority(PRIO_PROCESS, 0); }

/// As the kernel has it.
Promptness witnessed() {
  if (policy() == SCHED_RR) return Promptness::realTime;
  return niceness() <= -10 ? Promptness::nicer : Promptness::usual;
}

TEST(RealtimeThread, IsGrantedWhatItIsTold) {
  onAThread([] {
    const Promptness granted = askForPromptness();
    EXPECT_EQ(granted, witnessed());
  });
  EXPECT_EQ(policy(), SCHED_OTHER) << "other threads keep what they had";
}

TEST(RealtimeThread, IsTheLastOfTheRealTimeThreads) {
  onAThread([] {
    if (askForPromptness() != Promptness::realTime) GTEST_SKIP() << "real-time is refused here";
    sched_param priority{};
    sched_getparam(0, &priority);
    EXPECT_EQ(priority.sched_priority, sched_get_priority_min(SCHED_RR));
  });
}

TEST(RealtimeThread, DoesNotHandItOn) {
  const int before = niceness();
  onAThread([&] {
    askForPromptness();
    onAThread([&] {
      EXPECT_EQ(policy(), SCHED_OTHER);
      EXPECT_GE(niceness(), std::min(before, 0));
    });
  });
}

TEST(RealtimeThread, LeavesARealTimeThreadAlone) {
  onAThread([] {
    const sched_param high{sched_get_priority_min(SCHED_FIFO) + 7};
    if (sched_setscheduler(0, SCHED_FIFO, &high) != 0) GTEST_SKIP() << "real-time is refused here";
    EXPECT_EQ(askForPromptness(), Promptness::realTime);
    EXPECT_EQ(policy(), SCHED_FIFO);
    sched_param after{};
    sched_getparam(0, &after);
    EXPECT_EQ(after.sched_priority, high.sched_priority);
  });
}

/// Gives up every right to a better place, for good.
void becomeNobody() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_RTPRIO, &none);
  setrlimit(RLIMIT_NICE, &none);
  constexpr uid_t kNobody = 65534;
  if (getuid() == 0 && setuid(kNobody) != 0) _exit(3);
}

/// Whether a sample comes through a device's thread.
bool delivers(Promptness& seen) {
  std::atomic<bool> looked = false;
  DeviceTracker tracker(
      [&](const std::stop_token&, DeviceSink& sink) {
        seen = witnessed();
        looked = true;
        const Reading reading;
        sink.deliver({&reading, 1}, std::chrono::steady_clock::now());
      },
      std::chrono::steady_clock::now());
  std::vector<TrackerSample> samples;
  for (int i = 0; i < 60000 && samples.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    tracker.poll(std::numeric_limits<double>::max(), samples);
  }
  return looked && samples.size() == 1;
}

TEST(RealtimeThread, DevicesHaveOne) {
  Promptness seen{}, granted{};
  ASSERT_TRUE(delivers(seen));
  onAThread([&] { granted = askForPromptness(); });
  EXPECT_EQ(seen, granted);
}

/// 0 where it is refused all, and a tracker delivers all the same.
int deliversAsNobody() {
  becomeNobody();
  Promptness granted{}, seen{};
  onAThread([&] { granted = askForPromptness(); });
  const bool delivered = delivers(seen);
  return delivered && granted == Promptness::usual && seen == Promptness::usual ? 0 : 1;
}

TEST(RealtimeThreadDeathTest, GoesOnWhereItIsRefused) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(_exit(deliversAsNobody()), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace carom
