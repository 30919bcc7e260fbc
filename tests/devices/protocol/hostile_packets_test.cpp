// A million spoilt packets for each decoder of network trackers: none ends the program, holds over a megabyte
// or makes a pose that is none.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <stdexcept>

#include "counted_new.h"
#include "devices/natnet_sender.h"
#include "devices/osc/osc_decoder.h"
#include "devices/osc_sender.h"
#include "devices/protocol/dtrack_decoder.h"
#include "devices/protocol/natnet_decoder.h"
#include "devices/protocol/qtm_bodies.h"
#include "devices/protocol/qtm_frame.h"
#include "devices/protocol/survive_decoder.h"
#include "devices/protocol/trackd_segment.h"
#include "devices/protocol/vrpn_decoder.h"
#include "devices/qtm_sender.h"
#include "devices/vrpn_sender.h"
#include "fuzz/expect.h"
#include "mutate.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::Bytes;
using test::NatnetSender;
using test::OscSender;
using test::QtmSender;
using test::VrpnSender;

constexpr int kPackets = test::casesOf(1'000'000);
constexpr std::size_t kMostHeld = 1'000'000;

using Decode = std::function<void(const Bytes&, std::vector<Reading>&)>;

/// Every packet a mutation of one of `packets`, seeded.
void expectSurvival(const std::vector<Bytes>& packets, const Decode& decode) {
  std::mt19937_64 random(20260101);
  std::vector<Reading> readings;
  const std::size_t before = test::bytesHeld();
  std::size_t most = 0, poses = 0;
  for (int i = 0; i < kPackets; ++i) {
    const Bytes packet =
        test::mutated(packets[random() % packets.size()], packets[random() % packets.size()], random);
    readings.clear();
    decode(packet, readings);
    test::expectSound(readings);
    poses += readings.size();
    most = std::max(most, test::bytesHeld());
  }
  EXPECT_LT(most - before, kMostHeld);
  EXPECT_GT(poses, static_cast<std::size_t>(kPackets) / 20) << "many get through, or this would show little";
}

TEST(HostilePackets, Vrpn) {
  Bytes greeting = VrpnSender::cookie();
  VrpnSender::add(greeting, VrpnSender::names("Head"));
  const std::vector<Bytes> records{
      VrpnSender::pose(3, -0.5, 0.4, 1.8e9),    VrpnSender::velocity(1, 0.75, 0.3, 0.1, 1.8e9),
      VrpnSender::button(7, true, 1.8e9),       VrpnSender::buttons({true, false, true}, 1.8e9),
      VrpnSender::channels({0.5, -2.0}, 1.8e9), VrpnSender::names("Head")};
  VrpnDecoder greeted("Head");
  std::vector<Reading> none;
  greeted.decode(greeting, none);
  expectSurvival(records, [&](const Bytes& bytes, std::vector<Reading>& readings) {
    VrpnDecoder decoder = greeted;
    try {
      decoder.decode(bytes, readings);
    } catch (const std::runtime_error&) {  // it hangs up
    }
  });
}

TEST(HostilePackets, Dtrack) {
  std::vector<Bytes> packets;
  for (const std::string text :
       {"fr 1\r\nts 39596.02\r\n6dcal 3\r\n6d 2 [0 1.000][326.8 -187.2 109.5][1 0 0 0 1 0 0 0 1][1 1.000][1 "
        "2 3][0 1 0 "
        "-1 0 0 0 0 1]\r\n",
        "fr 2\r\nts2 1800000000 125000 6120\r\n6df2 2 2 [0 1.000 6 2][261 116 41][1 0 0 0 1 0 0 0 1][5 0.25 "
        "-1.00][1 -1.000 4 0][0 0 0][0 0 0 0 0 0 0 0 0][0]\r\n",
        "fr 3\r\n6df 1 [0 1.000 163][261 116 41][1 0 0 0 1 0 0 0 1]\r\n6di 1 [0 2 0.5][1 2 3][1 0 0 0 1 0 0 "
        "0 1]\r\n"}) {
    packets.emplace_back(text.begin(), text.end());
  }
  DtrackDecoder decoder;
  expectSurvival(
      packets, [&](const Bytes& bytes, std::vector<Reading>& readings) { decoder.decode(bytes, readings); });
}

TEST(HostilePackets, Natnet) {
  const std::vector<NatnetSender::Body> bodies{{1, 0.5f, 1.75f, -0.25f, 0.0f, 0.6f, 0.0f, 0.8f},
                                               {2, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, false}};
  NatnetDecoder old, recent;
  std::vector<Reading> none;
  std::vector<Bytes> packets;
  for (auto [decoder, sender] : {std::pair{&old, NatnetSender(3, 0)}, {&recent, NatnetSender(4, 1)}}) {
    decoder->decode(sender.serverInfo(), none);
    packets.push_back(sender.frame(7, bodies, 500.0, 0.012));
  }
  bool turn = false;
  expectSurvival(packets, [&](const Bytes& bytes, std::vector<Reading>& readings) {
    (turn ? old : recent).decode(bytes, readings);
    turn = !turn;
  });
}

TEST(HostilePackets, Osc) {
  const Bytes pose = OscSender::message("/head/1", {0.5f, 1.75f, -0.25f, 0.0f, 0.6f, 0.0f, 0.8f});
  const std::vector<Bytes> packets{pose, OscSender::bundle({pose, OscSender::message("/b/1/2", {1.0f})}),
                                   OscSender::nested(20, pose)};
  OscMapping mapping;
  mapping.pose = OscPattern("/head/{sensor}", false);
  mapping.values = readOscValues("x y z qx qy qz qw");
  mapping.buttons = OscPattern("/b/{sensor}/{n}", true);
  OscDecoder decoder(mapping);
  expectSurvival(
      packets, [&](const Bytes& bytes, std::vector<Reading>& readings) { decoder.decode(bytes, readings); });
}

TEST(HostilePackets, Qtm) {
  const std::vector<Bytes> packets{
      QtmSender::frameContent(7, 500.0, {QtmSender::turned(500, 1750, -250, 0.4), QtmSender::lost()}),
      QtmSender::frameContent(8, 500.1, {QtmSender::turned(1, 2, 3, 0.1)}, false)};
  expectSurvival(packets,
                 [](const Bytes& bytes, std::vector<Reading>& readings) { readQtmFrame(bytes, readings); });
}

TEST(HostilePackets, QtmNames) {
  const std::string xml = QtmSender::xml({"Head", "Wand &amp; cue"});
  const Bytes whole(xml.begin(), xml.end());
  std::mt19937_64 random(3);
  const std::size_t before = test::bytesHeld();
  for (int i = 0; i < kPackets / 20; ++i) {
    const Bytes bytes = test::mutated(whole, whole, random);
    const auto names = readQtmBodies({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    for (const std::string& name : names.value_or(std::vector<std::string>{})) EXPECT_LE(name.size(), 100u);
  }
  EXPECT_LT(test::bytesHeld() - before, kMostHeld);
}

TEST(HostilePackets, Survive) {
  std::vector<Bytes> packets;
  for (const std::string text :
       {"12.345678 T20 POSE 0.500000 -0.250000 1.750000 0.800000 0.000000 0.600000 0.000000 \r\n",
        "13.0 WM0 BUTTON 3 0\r\n13.1 WM0 BUTTON 2 0\r\n14 T20 DISCONNECT\r\n"}) {
    packets.emplace_back(text.begin(), text.end());
  }
  SurviveDecoder decoder({});
  expectSurvival(
      packets, [&](const Bytes& bytes, std::vector<Reading>& readings) { decoder.decode(bytes, readings); });
}

TEST(HostilePackets, Trackd) {
  Bytes segment(28 + 2 * 40);
  const std::uint32_t header[]{1, 2, 28, 40, 1800000000, 5, 0};
  const float sensor[]{1, 2, 3, 90, 10, -5};
  std::memcpy(segment.data(), header, sizeof header);
  std::memcpy(segment.data() + 28, sensor, sizeof sensor);
  expectSurvival({segment}, [](const Bytes& bytes, std::vector<Reading>& readings) {
    try {
      const TrackdSensors sensors = readTrackdSensors(bytes);
      for (std::size_t i = 0; i < sensors.count; ++i) {
        const auto read = readTrackdSensor(copyTrackdSensor(bytes, sensors, i), 0.3048);
        if (read) readings.emplace_back().pose = read->pose;
      }
    } catch (const std::runtime_error&) {  // it is not trackd's
    }
  });
}

}  // namespace
}  // namespace carom
