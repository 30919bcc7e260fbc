// A force device that the kernel itself keeps: made by uinput, where that may be opened.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/uinput.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "devices/usb/evdev_force.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

/// A stick of two axes with a constant force, whose driver is this test.
class Stick {
 public:
  explicit Stick(int descriptor) : descriptor_(descriptor) {
    for (const auto& [request, bit] : {std::pair<unsigned long, int>{UI_SET_EVBIT, EV_FF},
                                       {UI_SET_EVBIT, EV_ABS},
                                       {UI_SET_FFBIT, FF_CONSTANT}})
      ::ioctl(descriptor_, request, bit);
    for (const int axis : {ABS_X, ABS_Y}) {
      uinput_abs_setup setup{};
      setup.code = static_cast<std::uint16_t>(axis);
      setup.absinfo.maximum = 255;
      ::ioctl(descriptor_, UI_ABS_SETUP, &setup);
    }
    uinput_setup setup{};
    std::strcpy(setup.name, "Stick of a test");
    setup.ff_effects_max = 4;
    ::ioctl(descriptor_, UI_DEV_SETUP, &setup);
    ::ioctl(descriptor_, UI_DEV_CREATE);
    driver_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }
  ~Stick() {
    driver_ = {};
    ::ioctl(descriptor_, UI_DEV_DESTROY);
    ::close(descriptor_);
  }
  Stick(const Stick&) = delete;
  Stick& operator=(const Stick&) = delete;

  std::atomic<int> level{0}, uploads{0}, erased{0};
  std::atomic<bool> isPlaying{false};

 private:
  /// An upload waits until its driver has taken it.
  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      input_event event{};
      if (::read(descriptor_, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) {
        std::this_thread::sleep_for(1ms);
        continue;
      }
      if (event.type == EV_FF) isPlaying = event.value != 0;
      if (event.type == EV_UINPUT && event.code == UI_FF_UPLOAD) {
        uinput_ff_upload upload{};
        upload.request_id = static_cast<std::uint32_t>(event.value);
        ::ioctl(descriptor_, UI_BEGIN_FF_UPLOAD, &upload);
        level = upload.effect.u.constant.level;
        ++uploads;
        upload.retval = 0;
        ::ioctl(descriptor_, UI_END_FF_UPLOAD, &upload);
      }
      if (event.type == EV_UINPUT && event.code == UI_FF_ERASE) {
        uinput_ff_erase erase{};
        erase.request_id = static_cast<std::uint32_t>(event.value);
        ::ioctl(descriptor_, UI_BEGIN_FF_ERASE, &erase);
        ++erased;
        erase.retval = 0;
        ::ioctl(descriptor_, UI_END_FF_ERASE, &erase);
      }
    }
  }

  int descriptor_;
  std::jthread driver_;
};

TEST(UinputForce, TheKernelTakesTheEffects) {
  const int descriptor = ::open("/dev/uinput", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) GTEST_SKIP() << "/dev/uinput cannot be opened: " << std::strerror(errno);
  Stick stick(descriptor);
  const auto comesTrue = [](const auto& condition) {
    for (int i = 0; i < 2000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  };
  std::string node;
  const bool isThere = comesTrue([&] {
    for (const EvdevForceFacts& facts : listEvdevForces()) {
      if (facts.name == "Stick of a test") node = facts.node;
    }
    return !node.empty();
  });
  if (!isThere) GTEST_SKIP() << "no node of /dev/input appears for a device of uinput";
  {
    const auto device = openEvdevForce(node, 4.0, {});
    ForceCommand command;
    command.force_n = {2.0, 0.0, 0.0};
    device->write(command);
    EXPECT_TRUE(comesTrue([&] { return stick.level == 16384 && stick.isPlaying; }));
    command.force_n = {4.0, 0.0, 0.0};
    device->write(command);
    EXPECT_TRUE(comesTrue([&] { return stick.level == 32767; }));
    EXPECT_EQ(stick.uploads, 2);
  }
  EXPECT_TRUE(comesTrue([&] { return stick.erased > 0; })) << "at its end";
}

}  // namespace
}  // namespace carom
