// Words and numbers of mesh files, and where they stand.
#include "cave/mesh_input/mesh_words.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace carom {
namespace {

template <typename Read>
std::string complaint(const Read& read) {
  try {
    read();
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "nothing is wrong";
}

TEST(MeshWords, AreReadOverLinesOrInOne) {
  const std::string content = "  one\ttwo \r\n\nthree four";
  Words words("a.obj", content);
  EXPECT_EQ(words.nextInLine().text, "one");
  EXPECT_EQ(words.nextInLine().text, "two");
  EXPECT_EQ(words.nextInLine().text, "");
  EXPECT_FALSE(words.atEnd());
  const Word three = words.next();
  EXPECT_EQ(three.text, "three");
  EXPECT_EQ(three.at, content.find("three"));
  EXPECT_EQ(words.left(), std::string(" four").size());
  words.skipLine();
  EXPECT_TRUE(words.atEnd());
  EXPECT_EQ(words.next().text, "");
}

TEST(MeshWords, FaultsHaveTheirPlace) {
  const std::string content = "v 1 2\nv +0.5 nan 1e999 7x\n\nend";
  Words words("a.obj", content);
  const auto number = [&] { return complaint([&] { words.number(words.next()); }); };
  EXPECT_EQ(number(), "a.obj:1:1: 'v' is wrong, expected a finite number");
  words.skipLine();
  words.next();
  EXPECT_EQ(words.number(words.next()), 0.5);
  EXPECT_EQ(number(), "a.obj:2:8: 'nan' is wrong, expected a finite number");
  EXPECT_EQ(number(), "a.obj:2:12: '1e999' is wrong, expected a finite number");
  EXPECT_EQ(number(), "a.obj:2:18: '7x' is wrong, expected a finite number");
  EXPECT_EQ(number(), "a.obj:4:1: 'end' is wrong, expected a finite number");
  EXPECT_EQ(number(), "a.obj:4:4: something is missing here, expected a finite number");
}

TEST(MeshWords, WholeNumbersAreWithinTheirLimits) {
  const std::string content = "-3 5 6 2.5 20 21";  // 16 bytes
  Words words("a.obj", content);
  const auto integer = [&] { return complaint([&] { words.integer(words.next(), -3, 5, "an index"); }); };
  EXPECT_EQ(integer(), "nothing is wrong");
  EXPECT_EQ(integer(), "nothing is wrong");
  EXPECT_EQ(integer(), "a.obj:1:6: '6' is wrong, expected an index from -3 to 5");
  EXPECT_EQ(integer(), "a.obj:1:8: '2.5' is wrong, expected an index from -3 to 5");
  EXPECT_TRUE(complaint([&] { words.count(words.next()); }).starts_with("a.obj:1:12: '20' is wrong"))
      << "a file has no room for more items than bytes";
  EXPECT_EQ(words.count({"16", 0}), content.size());
}

TEST(MeshWords, BytesAreNumbersInBothOrders) {
  const std::string bytes("\x00\x01\x02\x03\x04", 5);
  EXPECT_EQ(numberAt<std::uint32_t>(bytes, 1), 0x04030201U);
  EXPECT_EQ(numberAt<std::uint32_t>(bytes, 1, true), 0x01020304U);
  EXPECT_EQ(numberAt<std::int16_t>(std::string("\xff\xfe"), 0, true), -2);
  EXPECT_EQ(shown("a\n\xc3\xa9" + std::string(50, 'x')), "a???" + std::string(36, 'x'));
}

}  // namespace
}  // namespace carom
