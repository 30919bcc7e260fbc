#include "devices/protocol/qtm_packets.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "devices/qtm_sender.h"

namespace carom {
namespace {

using test::QtmSender;
using Bytes = QtmSender::Bytes;

TEST(QtmPackets, AreFoundHoweverTheyAreCut) {
  Bytes all;
  for (int i = 0; i < 50; ++i) {
    const Bytes packet = QtmSender::text(1, std::string(static_cast<std::size_t>(i), 'x'));
    all.insert(all.end(), packet.begin(), packet.end());
  }
  std::mt19937_64 random(1);
  QtmPackets packets;
  std::size_t count = 0;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t size = std::min<std::size_t>(1 + random() % 40, all.size() - at);
    packets.add(std::span(all).subspan(at, size));
    at += size;
    while (const auto packet = packets.next()) {
      EXPECT_EQ(packet->type, QtmPacket::Type::command);
      EXPECT_EQ(packet->text().size(), count++);
    }
  }
  EXPECT_EQ(count, 50u);
}

TEST(QtmPackets, SizesThatCannotBeAreNamed) {
  for (const std::uint32_t size : {0U, 4U, 7U, (4U << 20U) + 1U, 0xffffffffU}) {
    QtmPackets packets;
    Bytes bytes;
    QtmSender::put(bytes, size);
    QtmSender::put(bytes, std::uint32_t{3});
    packets.add(bytes);
    try {
      packets.next();
      ADD_FAILURE() << size;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()),
                "a packet says that it has " + std::to_string(size) + " bytes, expected from 8 to 4194304");
    }
  }
}

TEST(QtmPackets, ACommandIsAPacket) {
  QtmPackets packets;
  packets.add(qtmCommand("Version 1.19"));
  EXPECT_EQ(qtmCommand("Version 1.19"), QtmSender::text(1, "Version 1.19"));
  EXPECT_EQ(packets.next()->text(), "Version 1.19");
  EXPECT_FALSE(packets.next());
}

}  // namespace
}  // namespace carom
