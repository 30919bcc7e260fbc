// `carom track` on a SpaceMouse, with the real hidapi on a mocked kernel.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/temporary_folder.h"
#include "app/tools/track.h"
#include "devices/hidraw_node.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using test::HidrawNode;
using test::MockedKernel;

constexpr const char* kRig =
    "unit = 'm'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'walker'\n"
    "[[tracker]]\nname = 'walker'\nkind = 'simulated'\n"
    "[[tracker]]\nname = 'puck'\nkind = 'spacemouse'\n"
    "[[wall]]\nname = 'front'\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, -1]\n"
    "pixels = [20, 20]\n";

/// What is printed in that time.
std::string watched(double seconds) {
  const test::TemporaryFolder folder;
  TrackOptions options;
  options.rig = folder.file("rig.toml", kRig);
  options.seconds = seconds;
  testing::internal::CaptureStdout();
  EXPECT_EQ(runTrack(options), 0);
  return testing::internal::GetCapturedStdout();
}

TEST(TrackSpaceMouse, ShowsItsAxesAndButtons) {
  MockedKernel kernel;
  HidrawNode node(0x046d, 0xc626, "3Dconnexion SpaceNavigator", 1, 8);
  node.plugInto(kernel);
  node.send({3, 2});
  const std::jthread hand([&node](const std::stop_token& stop) {
    while (!stop.stop_requested()) {  // pushed to the right as far as it goes
      node.send({1, 0x5e, 1, 0, 0, 0, 0});
      std::this_thread::sleep_for(8ms);
    }
  });
  const std::string shown = watched(2.5);
  EXPECT_NE(shown.find("puck (spacemouse): delivering\n  puck sensor 0: axes +1.00 +0.00 +0.00, buttons 1\n"),
            std::string::npos)
      << shown;
}

TEST(TrackSpaceMouse, UntouchedItIsWell) {
  MockedKernel kernel;
  HidrawNode node(0x046d, 0xc626, "3Dconnexion SpaceNavigator", 1, 8);
  node.plugInto(kernel);
  const std::string shown = watched(2.5);
  EXPECT_NE(shown.find("puck (spacemouse): no presses yet\n"), std::string::npos) << shown;
}

TEST(TrackSpaceMouse, WithoutOneItSaysSo) {
  const MockedKernel kernel;
  const std::string shown = watched(1.2);
  EXPECT_NE(shown.find("puck (spacemouse): connecting. SpaceMouse is not plugged in\n"), std::string::npos)
      << shown;
}

}  // namespace
}  // namespace carom
