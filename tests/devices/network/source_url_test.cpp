#include "devices/network/source_url.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace carom {
namespace {

constexpr std::array<std::string_view, 2> kKeys{"local", "group"};
constexpr std::string_view kExample = "dtrack://192.168.1.5";

SourceUrl read(std::string_view text) { return readSourceUrl(text, "dtrack", 5000, kKeys, kExample); }

std::string faultOf(std::string_view text) {
  try {
    read(text);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "none";
}

TEST(SourceUrl, ReadsHostPortAndOptions) {
  const SourceUrl plain = read("dtrack://controller");
  EXPECT_EQ(plain.endpoint.host, "controller");
  EXPECT_EQ(plain.endpoint.port, 5000);
  EXPECT_TRUE(plain.options.empty());
  const SourceUrl full = read("dtrack://10.0.0.7:50105?local=192.168.1.20&group=224.0.1.0");
  EXPECT_EQ(full.endpoint.port, 50105);
  EXPECT_EQ(full.address("local"), (192u << 24) | (168u << 16) | (1u << 8) | 20u);
  EXPECT_EQ(full.address("absent"), 0u);
  EXPECT_EQ(full.local().address, (10u << 24) | 7u);
  EXPECT_TRUE((Ipv4{full.address("group"), 0}).isGroup());
}

TEST(SourceUrl, SaysWhatIsWrongAndWhatWasExpected) {
  EXPECT_EQ(faultOf("vrpn://a"), "source is 'vrpn://a', expected one such as 'dtrack://192.168.1.5'");
  EXPECT_EQ(faultOf("dtrack://"), "'' names no machine, expected a name or an IPv4 address");
  EXPECT_EQ(faultOf("dtrack://a b"), "'a b' names no machine, expected a name or an IPv4 address");
  for (const std::string_view port : {"", "0", "65536", "-1", "12x", "1 "})
    EXPECT_EQ(faultOf("dtrack://a:" + std::string(port)),
              "the port is '" + std::string(port) + "', expected a number from 1 to 65535");
  EXPECT_EQ(faultOf("dtrack://a?locl=1"), "unknown option 'locl' in the source, expected 'local' or 'group'");
  EXPECT_THROW(read("dtrack://a?local=here").address("local"), std::invalid_argument);
  EXPECT_THROW(read("dtrack://a").local(), std::invalid_argument);
}

TEST(SourceUrl, AnEndpointStandsForItself) {
  EXPECT_EQ(readEndpoint("tracker-pc.local:3883", 1).port, 3883);
  EXPECT_EQ(readEndpoint("tracker_pc", 7).port, 7);
  EXPECT_THROW(readEndpoint("", 7), std::invalid_argument);
  EXPECT_THROW(readEndpoint(":7", 7), std::invalid_argument);
}

}  // namespace
}  // namespace carom
