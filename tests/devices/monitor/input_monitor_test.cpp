#include "devices/monitor/input_monitor.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

Reading input(Reading::Kind kind, int index, double value) {
  Reading reading;
  reading.kind = kind;
  reading.index = index;
  reading.value = value;
  return reading;
}

TEST(InputMonitor, SaysWhereAxesAndButtonsStand) {
  using Kind = Reading::Kind;
  InputMonitor monitor;
  EXPECT_EQ(monitor.text(), "");
  monitor.add(input(Kind::pose, 0, 1.0));
  EXPECT_EQ(monitor.text(), "");
  monitor.add(input(Kind::axis, 2, -0.25));
  EXPECT_EQ(monitor.text(), "axes - - -0.25");
  monitor.add(input(Kind::axis, 0, 1.0));
  monitor.add(input(Kind::button, 7, 1.0));
  monitor.add(input(Kind::button, 3, 1.0));
  EXPECT_EQ(monitor.text(), "axes +1.00 - -0.25, buttons 3 7");
  monitor.add(input(Kind::axis, 2, -0.001));
  monitor.add(input(Kind::button, 3, 0.0));
  EXPECT_EQ(monitor.text(), "axes +1.00 - +0.00, buttons 7");
  monitor.add(input(Kind::button, 7, 0.0));
  EXPECT_EQ(monitor.text(), "axes +1.00 - +0.00, no button");
}

TEST(InputMonitor, ButtonsAlone) {
  InputMonitor monitor;
  monitor.add(input(Reading::Kind::button, 0, 0.0));
  EXPECT_EQ(monitor.text(), "no button");
}

}  // namespace
}  // namespace carom
