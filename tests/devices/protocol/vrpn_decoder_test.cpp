#include "devices/protocol/vrpn_decoder.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "devices/vrpn_sender.h"

namespace carom {
namespace {

using test::VrpnSender;
using Bytes = VrpnSender::Bytes;
using Kind = Reading::Kind;

constexpr double kExact = 1e-15;
constexpr double kStamp_s = 1e-6;  // VRPN counts microseconds, and so fine are doubles at 1.8e9 s

Bytes conversation(const std::vector<Bytes>& records, const std::string& sender = "Head") {
  Bytes bytes = VrpnSender::cookie();
  VrpnSender::add(bytes, VrpnSender::names(sender));
  for (const Bytes& record : records) VrpnSender::add(bytes, record);
  return bytes;
}

std::vector<Reading> decoded(const Bytes& bytes, std::size_t portion = VrpnDecoder::kMostBytes) {
  VrpnDecoder decoder("Head");
  std::vector<Reading> readings;
  std::span<const std::uint8_t> rest(bytes);
  while (!rest.empty()) {
    const std::size_t count = std::min(portion, rest.size());
    decoder.decode(rest.first(count), readings);
    rest = rest.subspan(count);
  }
  return readings;
}

// A record that a VRPN server sent: its length is 88 and its payload 64 bytes.
TEST(VrpnDecoder, ReadsARecordedHeader) {
  Bytes record{0x00, 0x00, 0x00, 0x58, 0x6b, 0x01, 0x47, 0x97, 0x00, 0x0a, 0xc8, 0x2f,
               0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x19};
  const Bytes whole = VrpnSender::pose(0, 0.0, 0.0, 0.0);
  record.insert(record.end(), whole.begin() + 24, whole.end());
  ASSERT_EQ(record.size(), 88u);
  const auto readings = decoded(conversation({record}));
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_NEAR(readings[0].device_s, 0x6b014797 + 0x0ac82f * 1e-6, kStamp_s);
  EXPECT_EQ(readings[0].sensor, 0);
}

TEST(VrpnDecoder, ReadsPoses) {
  const auto readings = decoded(conversation({VrpnSender::pose(3, -0.5, 0.4, 1.8e9 + 0.25)}));
  ASSERT_EQ(readings.size(), 1u);
  const Reading& reading = readings[0];
  EXPECT_EQ(reading.kind, Kind::pose);
  EXPECT_EQ(reading.sensor, 3);
  EXPECT_TRUE(reading.hasOrientation);
  EXPECT_EQ(reading.pose.position_m, glm::dvec3(-0.5, 1.7, -0.25));
  EXPECT_NEAR(reading.pose.orientation.y, std::sin(0.2), kExact);
  EXPECT_NEAR(reading.pose.orientation.w, std::cos(0.2), kExact);
  EXPECT_NEAR(reading.device_s, 1.8e9 + 0.25, kStamp_s);
}

TEST(VrpnDecoder, ReadsVelocitiesAsRates) {
  // A turn of 0.3 rad in 0.1 s, written with either sign of the quaternion.
  for (const double angle_rad : {0.3, 0.3 + 2 * M_PI}) {
    const auto readings = decoded(conversation({VrpnSender::velocity(1, 0.75, angle_rad, 0.1, 5.0)}));
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_EQ(readings[0].kind, Kind::velocity);
    EXPECT_EQ(readings[0].velocity_m_s, glm::dvec3(0.75, 0.0, 0.0));
    EXPECT_NEAR(readings[0].angularVelocity_rad_s.y, 3.0, 1e-12);
    EXPECT_EQ(readings[0].angularVelocity_rad_s.x, 0.0);
  }
}

TEST(VrpnDecoder, ReadsButtonsAndChannels) {
  const auto readings =
      decoded(conversation({VrpnSender::button(7, true, 1.0), VrpnSender::buttons({false, true}, 2.0),
                            VrpnSender::channels({0.25, -3.0, std::nan("")}, 3.0)}));
  ASSERT_EQ(readings.size(), 5u);
  const auto expectInput = [&](std::size_t at, Kind kind, int index, double value) {
    EXPECT_EQ(readings[at].kind, kind) << at;
    EXPECT_EQ(readings[at].index, index) << at;
    EXPECT_EQ(readings[at].value, value) << at;
  };
  expectInput(0, Kind::button, 7, 1.0);
  expectInput(1, Kind::button, 0, 0.0);
  expectInput(2, Kind::button, 1, 1.0);
  expectInput(3, Kind::axis, 0, 0.25);
  expectInput(4, Kind::axis, 1, -1.0);  // clamped; the third is no number and left out
}

TEST(VrpnDecoder, TakesBytesInAnyPortions) {
  std::vector<Bytes> records;
  for (int i = 0; i < 20; ++i) records.push_back(VrpnSender::pose(i, i * 0.1, 0.0, i));
  records.push_back(VrpnSender::buttons({true, false, true}, 50.0));  // 16 bytes, padded
  const Bytes bytes = conversation(records);
  for (const std::size_t portion :
       {std::size_t{1}, std::size_t{7}, std::size_t{24}, std::size_t{89}, bytes.size()}) {
    const auto readings = decoded(bytes, portion);
    ASSERT_EQ(readings.size(), 23u) << "in portions of " << portion;
    for (int i = 0; i < 20; ++i) EXPECT_EQ(readings[i].sensor, i);
  }
}

TEST(VrpnDecoder, ListensToItsSenderAlone) {
  EXPECT_TRUE(decoded(conversation({VrpnSender::pose(0, 0.0, 0.0, 1.0, 0)})).empty());
  const Bytes others = conversation({VrpnSender::pose(0, 0.0, 0.0, 1.0)}, "Tracker0");
  VrpnDecoder decoder("Head");
  std::vector<Reading> readings;
  decoder.decode(others, readings);
  EXPECT_TRUE(readings.empty());
  EXPECT_FALSE(decoder.senderNamed());
  EXPECT_FALSE(decoder.senderHeard());
  ASSERT_EQ(decoder.namedSenders().size(), 1u);
  EXPECT_EQ(decoder.namedSenders()[0].name, "Tracker0");
  EXPECT_TRUE(decoder.namedSenders()[0].heard) << "a pose came from it";
  EXPECT_EQ(decoder.refused(), 0u);
}

// What a client names, its server names back: such a name tells nothing, and yet its sender is read.
TEST(VrpnDecoder, NamesThatAreIgnoredAreNoSenders) {
  VrpnDecoder decoder("Head");
  std::vector<Reading> readings;
  decoder.decode(conversation({}, "Tracker0"), readings);
  decoder.ignoreNames();
  decoder.decode(VrpnSender::name(2, VrpnSender::kSenderName, "Head"), readings);
  EXPECT_FALSE(decoder.senderNamed());
  EXPECT_FALSE(decoder.senderHeard());
  ASSERT_EQ(decoder.namedSenders().size(), 1u);
  EXPECT_EQ(decoder.namedSenders()[0].name, "Tracker0");
  EXPECT_FALSE(decoder.namedSenders()[0].heard);
  decoder.decode(VrpnSender::pose(0, 0.0, 0.0, 1.0, 2), readings);
  EXPECT_TRUE(decoder.senderHeard());
  EXPECT_EQ(readings.size(), 1u);
}

TEST(VrpnDecoder, ListsSomeNamesOfMany) {
  VrpnDecoder decoder("Head");
  std::vector<Reading> readings;
  decoder.decode(VrpnSender::cookie(), readings);
  EXPECT_FALSE(decoder.spoke());
  for (int i = 0; i < 100; ++i)
    decoder.decode(VrpnSender::name(i, VrpnSender::kSenderName, "Tracker" + std::to_string(i)), readings);
  EXPECT_TRUE(decoder.spoke());
  ASSERT_EQ(decoder.namedSenders().size(), VrpnDecoder::kMostNamed);
  EXPECT_EQ(decoder.namedSenders().back().name, "Tracker63");
}

TEST(VrpnDecoder, CountsPings) {
  VrpnDecoder decoder("Head");
  std::vector<Reading> readings;
  decoder.decode(conversation({VrpnSender::ping(1.0), VrpnSender::ping(2.0)}), readings);
  EXPECT_EQ(decoder.takePings(), 2);
  EXPECT_EQ(decoder.takePings(), 0);
}

TEST(VrpnDecoder, RefusesWhatMakesNoSense) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  Bytes zeroQuaternion = VrpnSender::pose(0, 0.0, 0.0, 1.0);
  std::fill(zeroQuaternion.begin() + 24 + 32, zeroQuaternion.end(), std::uint8_t{0});
  Bytes shortPose = VrpnSender::record(1, 1, Bytes(63), 1.0);
  for (const Bytes& record :
       {VrpnSender::pose(0, nan, 0.0, 1.0), VrpnSender::pose(0, infinity, 0.0, 1.0),
        VrpnSender::pose(0, 1e300, 0.0, 1.0), VrpnSender::pose(0, 0.0, nan, 1.0),
        VrpnSender::pose(-1, 0.0, 0.0, 1.0), zeroQuaternion, shortPose,
        VrpnSender::velocity(0, nan, 0.0, 0.1, 1.0), VrpnSender::velocity(0, 0.0, 0.1, 0.0, 1.0),
        VrpnSender::button(-1, true, 1.0), VrpnSender::button(256, true, 1.0),
        VrpnSender::record(1, 3, {0x7f, 0xff, 0xff, 0xff}, 1.0),
        VrpnSender::record(1, 4, Bytes(8, 0xff), 1.0)}) {
    VrpnDecoder decoder("Head");
    std::vector<Reading> readings;
    decoder.decode(conversation({record, VrpnSender::pose(5, 0.0, 0.0, 2.0)}), readings);
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_EQ(readings[0].sensor, 5) << "what follows is read";
    EXPECT_EQ(decoder.refused(), 1u);
  }
}

TEST(VrpnDecoder, HangsUpOnWhatCannotBeFollowed) {
  const auto fault = [](Bytes bytes) -> std::string {
    VrpnDecoder decoder("Head");
    std::vector<Reading> readings;
    try {
      decoder.decode(bytes, readings);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault(VrpnSender::cookie("06.00")).find("expected 'vrpn: ver. 07."), std::string::npos);
  EXPECT_NE(fault(Bytes(24, 'x')).find("xxx"), std::string::npos);
  EXPECT_EQ(fault(VrpnSender::cookie("07.38")), "");
  for (const std::uint32_t length : {0u, 23u, 65537u, 0xffffffffu}) {
    Bytes bytes = conversation({});
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(length >> shift));
    bytes.resize(bytes.size() + 20);
    EXPECT_NE(fault(bytes).find(std::to_string(length) + " bytes"), std::string::npos) << length;
  }
}

// What a server reads of us: checked against the layout byte by byte.
TEST(VrpnDecoder, SpeaksAsAClient) {
  const Bytes greeting = vrpnGreeting(), described = vrpnDescription("Head");
  ASSERT_EQ(greeting.size(), 24u);
  ASSERT_EQ(described.size() % 8, 0u);
  EXPECT_EQ(std::string(greeting.begin(), greeting.begin() + 19), "vrpn: ver. 07.38  0");
  const Bytes name(described.begin(), described.begin() + 40);
  EXPECT_EQ(name, (Bytes{0, 0, 0, 33, 0, 0, 0, 0, 0,   0,   0,   0,   0, 0, 0, 0, 0xff, 0xff, 0xff, 0xff,
                         0, 0, 0, 0,  0, 0, 0, 5, 'H', 'e', 'a', 'd', 0, 0, 0, 0, 0,    0,    0,    0}));
  const Bytes pong = vrpnPong();
  EXPECT_EQ(pong, (Bytes{0, 0, 0, 24, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace carom
