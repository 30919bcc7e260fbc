#include "devices/protocol/qtm_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/qtm_sender.h"

namespace carom {
namespace {

using test::QtmSender;
using Bytes = QtmSender::Bytes;
using Kind = Reading::Kind;

TEST(QtmFrame, ReadsBodiesByTheColumnsOfTheirRotation) {
  constexpr double kAngle = 0.4;
  for (const bool residuals : {true, false}) {
    std::vector<Reading> readings;
    const auto frame = readQtmFrame(
        QtmSender::frameContent(7, 500.25, {QtmSender::turned(500, 1750, -250, kAngle), QtmSender::lost()},
                                residuals),
        readings);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->isWhole);
    EXPECT_EQ(frame->number, 7u);
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_EQ(readings[0].kind, Kind::pose);
    EXPECT_EQ(readings[0].sensor, 0);
    EXPECT_EQ(readings[0].device_s, 500.25);
    EXPECT_NEAR(glm::distance(readings[0].pose.position_m, glm::dvec3(0.5, 1.75, -0.25)), 0.0, 1e-12);
    // The body's x axis points to (cos, sin, 0).
    const glm::dvec3 x = readings[0].pose.orientation * glm::dvec3(1, 0, 0);
    EXPECT_NEAR(glm::distance(x, glm::dvec3(std::cos(kAngle), std::sin(kAngle), 0)), 0.0, 1e-6);  // floats
    EXPECT_EQ(readings[1].kind, Kind::lost);
    EXPECT_EQ(readings[1].sensor, 1);
  }
}

TEST(QtmFrame, ABodyThatIsNoneIsLeftOut) {
  QtmSender::Body far = QtmSender::turned(0, 0, 0, 0), flat = far, mirrored = far;
  far.x_mm = 2e6f;
  flat.axes[2] = {0, 0, 0};
  mirrored.axes[0] = {-1, 0, 0};
  std::vector<Reading> readings;
  const auto frame = readQtmFrame(
      QtmSender::frameContent(1, 1.0, {far, flat, mirrored, QtmSender::turned(1, 2, 3, 0)}), readings);
  ASSERT_TRUE(frame);
  EXPECT_FALSE(frame->isWhole);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].sensor, 3);
}

TEST(QtmFrame, EveryCutIsRefused) {
  const Bytes whole = QtmSender::frameContent(1, 1.0, {QtmSender::turned(1, 2, 3, 0.1)});
  std::vector<Reading> readings;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(readQtmFrame(std::span(whole).first(size), readings)) << size;
  }
  EXPECT_TRUE(readings.empty());
}

TEST(QtmFrame, ACountThatDoesNotFitIsRefused) {
  Bytes content = QtmSender::frameContent(1, 1.0, {QtmSender::turned(1, 2, 3, 0.1)});
  const std::size_t count = content.size() - 52 - 8;
  std::vector<Reading> readings;
  for (const int wrong : {0, 2, 255}) {
    content[count] = static_cast<std::uint8_t>(wrong);
    EXPECT_FALSE(readQtmFrame(content, readings)) << wrong;
  }
  content[count] = 1;
  EXPECT_TRUE(readQtmFrame(content, readings));
}

}  // namespace
}  // namespace carom
