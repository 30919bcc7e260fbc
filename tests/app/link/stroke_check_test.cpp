#include "app/link/stroke_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/three_pucks.h"

namespace carom {
namespace {

TEST(StrokeCheck, KnowsWhatAHandCanDo) {
  const BilliardSetup setup = test::threePucks();
  const auto fault = [&](const Stroke& stroke) {
    return strokeFault(stroke, setup.pucks, setup.lightSpeed_m_s);
  };
  const double most_kg_m_s = kStrongestU * 0.2 * 1.42;
  Stroke stroke{2, 1.0, Vec3(0.0), {most_kg_m_s, 0.0}, 0.03};
  EXPECT_EQ(fault(stroke), "");
  stroke.momentum_kg_m_s.y = 0.1 * most_kg_m_s;
  EXPECT_EQ(fault(stroke), "a stroke harder than a hand can make");
  stroke.momentum_kg_m_s.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault(stroke), "a stroke harder than a hand can make");
  stroke.momentum_kg_m_s = {0.1, 0.0};
  stroke.offset_m = -0.0305;
  EXPECT_EQ(fault(stroke), "a stroke beside the puck");
  stroke.puck = 3;
  EXPECT_EQ(fault(stroke), "a stroke on no puck");
}

}  // namespace
}  // namespace carom
