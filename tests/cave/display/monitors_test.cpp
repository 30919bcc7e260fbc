#include "cave/display/monitors.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace carom {
namespace {

const std::vector<Monitor> kMonitors{{"DP-1", {0, 0}, {1920, 1080}, 60.0},
                                     {"DP-3", {1920, 0}, {1280, 1024}, 60.0},
                                     {"HDMI-1", {0, 1080}, {800, 600}, 0.0}};

WindowPlacement on(std::vector<std::string> names) {
  return {.position_px = {10, 20}, .size_px = {640, 480}, .monitorNames = std::move(names)};
}

std::string failureOf(const WindowPlacement& placement) {
  try {
    placeOf(placement, kMonitors);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Monitors, AWindowLiesOnItsMonitor) {
  EXPECT_EQ(placeOf({.monitor = 1, .position_px = {5, 6}, .size_px = {64, 32}}, kMonitors),
            (ScreenPlace{{1925, 6}, {64, 32}}));
  EXPECT_EQ(placeOf(on({"HDMI-1"}), kMonitors), (ScreenPlace{{10, 1100}, {640, 480}}));
}

TEST(Monitors, AFullscreenWindowCoversAllOfItsMonitors) {
  WindowPlacement placement = on({"DP-1"});
  placement.fullscreen = true;
  EXPECT_EQ(placeOf(placement, kMonitors), (ScreenPlace{{0, 0}, {1920, 1080}}));
  placement.monitorNames = {"DP-3", "DP-1"};
  EXPECT_EQ(placeOf(placement, kMonitors), (ScreenPlace{{0, 0}, {3200, 1080}}));
  placement.monitorNames = {"DP-3", "HDMI-1"};
  EXPECT_EQ(placeOf(placement, kMonitors), (ScreenPlace{{0, 0}, {3200, 1680}}));
}

TEST(Monitors, AMissingOneIsNamedWithThoseThereAre) {
  const std::string present = ", expected one of 0 \"DP-1\", 1 \"DP-3\", 2 \"HDMI-1\"";
  EXPECT_EQ(failureOf({.monitor = 3}), "there is no monitor 3" + present);
  EXPECT_EQ(failureOf({.monitor = -1}), "there is no monitor -1" + present);
  EXPECT_EQ(failureOf(on({"DP-1", "DP-2"})), "there is no monitor \"DP-2\"" + present);
}

}  // namespace
}  // namespace carom
