#include "devices/osc/osc_decoder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/osc_sender.h"

namespace carom {
namespace {

using test::OscSender;
using Bytes = OscSender::Bytes;
using Kind = Reading::Kind;

OscMapping mapping() {
  return {.pose = OscPattern("/head/{sensor}", false),
          .values = readOscValues("x y z qx qy qz qw"),
          .unit_m = 1.0,
          .buttons = OscPattern("/wand/{sensor}/button/{n}", true),
          .axes = OscPattern("/wand/{sensor}/axis/{n}", true)};
}

std::vector<Reading> readingsOf(const Bytes& datagram, OscDecoder& decoder) {
  std::vector<Reading> readings;
  decoder.decode(datagram, readings);
  return readings;
}

const std::vector<float> kTurned{0.5f, 1.75f, -0.25f, 0.0f, 0.6f, 0.0f, 0.8f};

TEST(OscDecoder, ReadsAPose) {
  OscDecoder decoder(mapping());
  const auto readings = readingsOf(OscSender::message("/head/3", kTurned), decoder);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[0].sensor, 3);
  EXPECT_EQ(readings[0].pose.position_m, glm::dvec3(0.5, 1.75, -0.25));
  ASSERT_TRUE(readings[0].hasOrientation);
  EXPECT_NEAR(readings[0].pose.orientation.y, 0.6, 1e-7);  // floats
  EXPECT_NEAR(readings[0].pose.orientation.w, 0.8, 1e-7);
  EXPECT_TRUE(std::isnan(readings[0].device_s)) << "a message alone has no time";
}

TEST(OscDecoder, ReadsArgumentsInTheOrderAndUnitOfTheRig) {
  OscMapping other;
  other.pose = OscPattern("/vive", false);
  other.values = readOscValues("- qw qx qy qz  z y x");
  other.unit_m = 0.01;
  OscDecoder decoder(other);
  Bytes arguments;
  OscSender::text(arguments, "a name");
  for (const std::uint32_t bits : {0x3f4ccccdU, 0U, 0x3f19999aU, 0U}) OscSender::big(arguments, bits, 4);
  OscSender::big(arguments, static_cast<std::uint32_t>(-25), 4);
  OscSender::big(arguments, 175, 8);
  OscSender::big(arguments, 0x4049000000000000ULL, 8);  // 50
  const auto readings = readingsOf(OscSender::message("/vive", ",sffffihd", arguments), decoder);
  ASSERT_EQ(readings.size(), 1u) << decoder.whyRefused();
  EXPECT_EQ(readings[0].sensor, 0);
  EXPECT_NEAR(glm::distance(readings[0].pose.position_m, glm::dvec3(0.5, 1.75, -0.25)), 0.0, 1e-12);
  EXPECT_NEAR(readings[0].pose.orientation.y, 0.6, 1e-7);
}

TEST(OscDecoder, APlaceWithoutAQuaternionHasNoOrientation) {
  OscMapping places = mapping();
  places.values = readOscValues("x y z");
  OscDecoder decoder(places);
  const auto readings = readingsOf(OscSender::message("/head/0", {1, 2, 3}), decoder);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_FALSE(readings[0].hasOrientation);
}

TEST(OscDecoder, ReadsButtonsAndAxes) {
  OscDecoder decoder(mapping());
  const auto readings = readingsOf(OscSender::bundle({OscSender::message("/wand/100/button/2", {1.0f}),
                                                      OscSender::message("/wand/100/button/0", ",F", {}),
                                                      OscSender::message("/wand/100/axis/1", {-7.0f})}),
                                   decoder);
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[0].kind, Kind::button);
  EXPECT_EQ(readings[0].sensor, 100);
  EXPECT_EQ(readings[0].index, 2);
  EXPECT_EQ(readings[0].value, 1.0);
  EXPECT_EQ(readings[1].value, 0.0);
  EXPECT_EQ(readings[2].kind, Kind::axis);
  EXPECT_EQ(readings[2].value, -1.0);
}

TEST(OscDecoder, TheInnermostBundleGivesTheTime) {
  OscDecoder decoder(mapping());
  const Bytes pose = OscSender::message("/head/0", kTurned);
  const auto readings =
      readingsOf(OscSender::bundle({OscSender::bundle({pose}, 3.9e9 + 0.25), pose}, 3.9e9), decoder);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].device_s, 3.9e9 + 0.25);
  EXPECT_EQ(readings[1].device_s, 3.9e9);
  EXPECT_TRUE(std::isnan(readingsOf(OscSender::bundle({pose}), decoder).at(0).device_s));
}

TEST(OscDecoder, KeepsWhatIsGoodBesideWhatIsNot) {
  OscDecoder decoder(mapping());
  const Bytes pose = OscSender::message("/head/0", kTurned);
  std::vector<Reading> readings;
  EXPECT_FALSE(decoder.decode(OscSender::bundle({OscSender::message("/head/1", {1, 2}), pose}), readings));
  EXPECT_EQ(readings.size(), 1u);
  EXPECT_EQ(decoder.whyRefused(), "'/head/1' came with 2 arguments, expected 7, those that 'values' names");
}

TEST(OscDecoder, SaysWhatItRefuses) {
  OscDecoder decoder(mapping());
  std::vector<Reading> readings;
  const float nothing = std::nanf("");
  const std::vector<std::pair<Bytes, std::string>> faults{
      {{}, "is no message of OSC"},
      {{'x', 0, 0, 0}, "is no message of OSC"},
      {{'#', 'b', 'o', 0}, "begins with '#'"},
      {OscSender::message("/head/0", {nothing, 0, 0, 0, 0, 0, 1}), "are no pose"},
      {OscSender::message("/head/0", {0, 0, 0, 0, 0, 0, 0}), "are no pose"},
      {OscSender::message("/head/0", ",fffffff", {0, 0, 0, 0}), "cannot be read"},
      {OscSender::message("/head/0", ",?", {}), "cannot be read"},
      {OscSender::message("/head/0", "", {}), "without the types"},
      {OscSender::message("/wand/1/axis/0", {nothing}), "without a number"},
      {OscSender::message("/wand/1/axis/0", {}), "without a number"},
  };
  for (const auto& [datagram, words] : faults) {
    EXPECT_FALSE(decoder.decode(datagram, readings));
    EXPECT_NE(decoder.whyRefused().find(words), std::string::npos) << decoder.whyRefused();
  }
  EXPECT_TRUE(readings.empty());
}

TEST(OscDecoder, BundlesAreReadEightDeep) {
  OscDecoder decoder(mapping());
  const Bytes pose = OscSender::message("/head/0", kTurned);
  EXPECT_EQ(readingsOf(OscSender::nested(8, pose), decoder).size(), 1u);
  for (const int depth : {9, 1000}) {
    EXPECT_TRUE(readingsOf(OscSender::nested(depth, pose), decoder).empty()) << depth;
    EXPECT_NE(decoder.whyRefused().find("8 deep"), std::string::npos) << decoder.whyRefused();
  }
}

TEST(OscDecoder, EveryCutIsRefused) {
  OscDecoder decoder(mapping());
  const Bytes whole = OscSender::bundle({OscSender::message("/head/0", kTurned)});
  std::vector<Reading> readings;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    // A bundle without any message is one.
    EXPECT_EQ(decoder.decode(cut, readings), size == 16) << size;
  }
  EXPECT_TRUE(readings.empty());
}

TEST(OscDecoder, NamesOtherAddressesAndOnlySomeOfThem) {
  OscDecoder decoder(mapping());
  for (int i = 0; i < 1000; ++i)
    readingsOf(OscSender::message("/other/" + std::to_string(i), {1.0f}), decoder);
  ASSERT_EQ(decoder.otherAddresses().size(), OscDecoder::kMostOthers);
  EXPECT_EQ(decoder.otherAddresses()[0], "'/other/0'");
}

}  // namespace
}  // namespace carom
