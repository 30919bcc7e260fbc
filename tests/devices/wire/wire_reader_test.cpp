#include "devices/wire/wire_reader.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(WireReader, ReadsNumbersOfBothOrders) {
  const Bytes bytes{0x12, 0x34, 0x56, 0x78, 0x40, 0x09, 0x21, 0xfb, 0x54, 0x44, 0x2d, 0x18, 0xff};
  WireReader big(bytes, std::endian::big);
  EXPECT_EQ(big.read<std::uint32_t>(), 0x12345678u);
  EXPECT_DOUBLE_EQ(big.read<double>(), 3.14159265358979312);
  EXPECT_EQ(big.read<std::int8_t>(), -1);
  EXPECT_TRUE(big.ok());
  EXPECT_TRUE(big.rest().empty());
  WireReader little(bytes, std::endian::little);
  EXPECT_EQ(little.read<std::uint16_t>(), 0x3412u);
  EXPECT_EQ(little.rest().size(), 11u);
}

TEST(WireReader, BeyondTheEndAllIsZeroAndNotOk) {
  const Bytes bytes{1, 2, 3};
  WireReader reader(bytes, std::endian::big);
  EXPECT_EQ(reader.read<std::uint32_t>(), 0u);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.read<std::uint8_t>(), 0u) << "also what had been there";
  EXPECT_TRUE(reader.take(1).empty());
}

TEST(WireReader, SkipsItemsWhoseSizeOverflows) {
  const Bytes bytes(100, 7);
  WireReader reader(bytes, std::endian::big);
  reader.skip(10, 4);
  EXPECT_EQ(reader.rest().size(), 60u);
  reader.skip(std::size_t{1} << 62, 4);  // 2⁶⁴ bytes: 0 by the processor
  EXPECT_FALSE(reader.ok());
  EXPECT_TRUE(reader.rest().empty());
  WireReader other(bytes, std::endian::big);
  other.skip(5, 0);
  EXPECT_TRUE(other.ok());
}

TEST(WireReader, ATextEndsWithItsZero) {
  const Bytes bytes{'a', 'b', 0, 0, 'c'};
  WireReader reader(bytes, std::endian::big);
  EXPECT_EQ(reader.text(), "ab");
  EXPECT_EQ(reader.text(), "");
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.text(), "") << "without an end";
  EXPECT_FALSE(reader.ok());
}

// Whatever is asked of it, it stays within the packet: AddressSanitizer watches.
TEST(WireReader, NeverLeavesAPacket) {
  test::Random random(71);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    Bytes bytes(static_cast<std::size_t>(random.in(0.0, 30.0)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.in(0.0, 3.0));
    WireReader reader(bytes, std::endian::little);
    std::size_t left = bytes.size();
    while (reader.ok()) {
      const double choice = random.in(0.0, 4.0);
      if (choice < 1.0)
        reader.read<std::uint16_t>();
      else if (choice < 2.0)
        reader.text();
      else if (choice < 3.0)
        reader.skip(static_cast<std::size_t>(random.in(0.0, 5.0)), 3);
      else
        reader.take(1);
      EXPECT_LE(reader.rest().size(), left);
      left = reader.rest().size();
      if (left == 0 && choice >= 2.0) break;
    }
  }
}

}  // namespace
}  // namespace carom
