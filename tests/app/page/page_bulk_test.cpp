// The numbers of a page: read back as its script does, and letters that any tool unpacks.
#include "app/page/page_bulk.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace carom {
namespace {

/// Reads a column as pages/data.js does: plane by plane, then each number from the one before.
template <typename Number, typename Bits>
std::vector<Number> read(const std::string& bytes, const PageColumn& column) {
  std::vector<Number> numbers;
  Bits before = 0;
  for (std::size_t i = 0; i < column.count; ++i) {
    Bits change = 0;
    for (std::size_t plane = sizeof(Bits); plane-- > 0;)
      change = static_cast<Bits>(change << 8 |
                                 static_cast<unsigned char>(bytes.at(column.at + plane * column.count + i)));
    before = std::is_floating_point_v<Number> ? static_cast<Bits>(before ^ change)
                                              : static_cast<Bits>(before + change);
    numbers.push_back(std::bit_cast<Number>(before));
  }
  return numbers;
}

template <typename Number>
std::vector<Number> someOf(std::mt19937& random) {
  using Limits = std::numeric_limits<Number>;
  std::vector<Number> numbers{Limits::max(), Limits::lowest(), Number{0},
                              Limits::max(), Number{1},        Number{1}};
  for (int i = 0; i < 200; ++i)
    numbers.push_back(static_cast<Number>(static_cast<Number>(random() % 60000) / Number{7}));
  return numbers;
}

template <typename Number, typename Bits>
void expectReadBack(const char* kind) {
  SCOPED_TRACE(kind);
  std::mt19937 random(4);
  PageBulk bulk;
  const std::vector<std::uint8_t> before{1, 2, 3};
  bulk.add(std::span(before));
  const std::vector<Number> first = someOf<Number>(random), second = someOf<Number>(random);
  const PageColumn one = bulk.add(std::span(first)), none = bulk.add(std::span(first).first(0)),
                   two = bulk.add(std::span(second));
  EXPECT_EQ(std::string(one.kind), kind);
  EXPECT_EQ(one.at, 3U);
  EXPECT_EQ(one.count, first.size());
  EXPECT_EQ(none.count, 0U);
  EXPECT_EQ((read<Number, Bits>(bulk.bytes(), one)), first);
  EXPECT_EQ((read<Number, Bits>(bulk.bytes(), two)), second);
  EXPECT_EQ(bulk.bytes().size(), 3 + sizeof(Number) * (first.size() + second.size()));
}

TEST(PageBulk, EveryKindIsReadBack) {
  expectReadBack<double, std::uint64_t>("f64");
  expectReadBack<float, std::uint32_t>("f32");
  expectReadBack<std::int16_t, std::uint16_t>("i16");
  expectReadBack<std::uint32_t, std::uint32_t>("u32");
  expectReadBack<std::uint8_t, std::uint8_t>("u8");
}

TEST(PageBulk, NumbersKeepTheirBitsAndWhatStaysIsZeros) {
  const std::vector<double> numbers{-0.0,
                                    std::numeric_limits<double>::denorm_min(),
                                    std::numeric_limits<double>::infinity(),
                                    -0.0,
                                    1.0 / 3.0,
                                    1.0 / 3.0};
  PageBulk bulk;
  const PageColumn column = bulk.add(std::span(numbers));
  const auto again = read<double, std::uint64_t>(bulk.bytes(), column);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(again[i]), std::bit_cast<std::uint64_t>(numbers[i])) << i;
  PageBulk still;
  const std::vector<std::uint32_t> same(50, 0);
  still.add(std::span(same));
  EXPECT_EQ(still.bytes(), std::string(200, '\0'));
}

/// Returns the bytes of letters by RFC 4648.
std::string bytesOf(const std::string& letters) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char letter : letters) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(alphabet.find(letter));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xff);
  }
  return bytes;
}

// RFC 1950: the two bytes of the header are a multiple of 31, the method is 8 (deflate), and the last four
// bytes are Adler-32 of the unpacked bytes, the highest first.
TEST(PageBulk, LettersArePackedAsTheStandardsSay) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 4U, 5U, 1000U, 70000U}) {
    SCOPED_TRACE(size);
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i * i % 7);
    const std::string letters = lettersOf(bytes);
    EXPECT_EQ(letters.size() % 4, 0U);
    EXPECT_LT(letters.size(), 40 + size / 2) << "what repeats is packed";
    const std::string packed = bytesOf(letters);
    ASSERT_GE(packed.size(), 6U);
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(packed[i]));
    };
    EXPECT_EQ((byte(0) * 256 + byte(1)) % 31, 0U);
    EXPECT_EQ(byte(0) & 15U, 8U);
    std::uint32_t a = 1, b = 0, found = 0;
    for (const char one : bytes) {
      a = (a + static_cast<unsigned char>(one)) % 65521;
      b = (b + a) % 65521;
    }
    for (std::size_t i = packed.size() - 4; i < packed.size(); ++i) found = found << 8 | byte(i);
    EXPECT_EQ(found, b << 16 | a);
  }
}

}  // namespace
}  // namespace carom
