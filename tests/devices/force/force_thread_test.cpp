// The thread of a force device: however a session ends, the last thing that its device is told is 0 N; a
// device that fails is opened again.

#include "devices/force/force_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <glm/geometric.hpp>

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// What devices were told.
struct Told {
  std::atomic<int> opened{0}, zeroed{0};
  std::atomic<double> force_n{0.0};
  std::atomic<bool> fails{false};
};

/// A device that is pressed and drawn away from where it was, a little each tick, again and again.
class DrawnDevice : public ForceDevice {
 public:
  explicit DrawnDevice(Told& told) : told_(told) { ++told_.opened; }
  ~DrawnDevice() override { zero(); }
  ForceDeviceState read(double now_s) override {
    if (told_.fails) throw std::runtime_error("it was pulled out");
    ForceDeviceState state;
    const int tick = ticks_++ % 500;  // a late tick makes the force fall: it is pressed again
    state.position_m.x = -2e-4 * tick;
    state.time_s = now_s;
    state.pressed = tick > 0;
    return state;
  }
  void write(const ForceCommand& command) override { told_.force_n = glm::length(command.force_n); }
  void zero() noexcept override {
    told_.force_n = 0.0;
    ++told_.zeroed;
  }

 private:
  Told& told_;
  int ticks_ = 0;
};

/// A session with such a device.
class Session {
 public:
  explicit Session(Told& told)
      : told_(told),
        thread_(
            "arm", [&told](const std::stop_token&) { return std::make_unique<DrawnDevice>(told); }, limits(),
            Clock::now()) {
    law_.kind = ForceLaw::Kind::cue;
    law_.cue = {0.403, 0.08, 1.0};
  }
  static ForceLimits limits() {
    ForceLimits limits;
    limits.leastRate_hz = 20.0;  // of a busy machine
    return limits;
  }
  /// Plays until the condition holds.
  template <typename Condition>
  bool playUntil(const Condition& condition) {
    for (int i = 0; i < 20000; ++i) {
      law_.posted_s = thread_.now_s(0.0);
      thread_.post(law_);
      if (condition()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  bool pushes() {
    return playUntil([&] { return told_.force_n > 1.0; });
  }
  ForceThread& thread() { return thread_; }

 private:
  Told& told_;
  ForceThread thread_;
  ForceLaw law_;
};

TEST(ForceThread, LeavesTheDeviceAtZero) {
  Told told;
  {
    Session session(told);
    ASSERT_TRUE(session.pushes());
  }
  EXPECT_EQ(told.force_n, 0.0);
  EXPECT_GE(told.zeroed, 1);
}

TEST(ForceThread, LeavesItAtZeroWhereTheSessionThrows) {
  Told told;
  EXPECT_THROW(
      {
        Session session(told);
        if (session.pushes()) throw std::runtime_error("a fault of the session");
      },
      std::runtime_error);
  EXPECT_EQ(told.force_n, 0.0);
}

TEST(ForceThread, EndsFromAnotherThread) {
  Told told;
  Session session(told);
  ASSERT_TRUE(session.pushes());
  std::jthread([&] { session.thread().end(); }).join();
  EXPECT_EQ(told.force_n, 0.0);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(told.force_n, 0.0) << "nothing follows";
}

TEST(ForceThread, ADeviceThatFailsIsAtZeroIsSaidAndOpenedAgain) {
  Told told;
  Session session(told);
  ASSERT_TRUE(session.pushes());
  told.fails = true;
  ASSERT_TRUE(session.playUntil([&] { return session.thread().report().fall == ForceFall::unplugged; }));
  EXPECT_EQ(told.force_n, 0.0);
  EXPECT_EQ(session.thread().report().force_n, glm::dvec3(0.0));
  told.fails = false;
  ASSERT_TRUE(session.playUntil([&] { return told.opened >= 2; }));
  const auto news = session.thread().takeNews();
  ASSERT_GE(news.size(), 2u);
  EXPECT_EQ(news[0], "arm is there");
  EXPECT_EQ(news[1], "arm: it was pulled out; there is no force in the hand");
}

}  // namespace
}  // namespace carom
