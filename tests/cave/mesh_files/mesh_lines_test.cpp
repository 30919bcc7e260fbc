// Words and numbers of text files with meshes, and where they stand.
#include "cave/mesh_files/mesh_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;

TEST(MeshLines, WordsStandInTheirLines) {
  MeshLines lines("\n a\tbc \r\n \t\n12 -0.5 +3\nrest\n of it");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.word(), "");
  ASSERT_TRUE(lines.nextWithWords());
  EXPECT_EQ(lines.lineNumber(), 2U);
  EXPECT_EQ(lines.word(), "a");
  EXPECT_EQ(lines.word(), "bc");
  EXPECT_EQ(lines.word(), "");
  lines.endLine();
  ASSERT_TRUE(lines.nextWithWords());
  EXPECT_EQ(lines.lineNumber(), 4U) << "blanks alone are no words";
  EXPECT_EQ(lines.number(100.0), 12.0);
  EXPECT_EQ(lines.number(100.0), -0.5);
  EXPECT_EQ(lines.number(100.0), 3.0);
  EXPECT_EQ(lines.rest(), "rest\n of it");
  ASSERT_TRUE(lines.next() && lines.next());
  EXPECT_EQ(lines.word(), "of");
  EXPECT_FALSE(lines.next());
}

TEST(MeshLines, OtherBlanksPartWords) {
  MeshLines lines("a b;c;;d", ";");
  ASSERT_TRUE(lines.next());
  for (const char* const word : {"a b", "c", "d", ""}) EXPECT_EQ(lines.word(), word);
}

TEST(MeshLines, FaultsHaveTheirPlace) {
  const auto numberIn2 = [](const std::string& line) {
    return complaint([&] {
      MeshLines lines("first\n" + line);
      lines.next();
      lines.next();
      lines.word();
      lines.number(16.0);
      lines.endLine();
    });
  };
  EXPECT_EQ(numberIn2("v 16"), "nothing is wrong");
  EXPECT_EQ(numberIn2("v  16.5"), "2:4: '16.5' is wrong, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v nan"), "2:3: 'nan' is wrong, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v -inf"), "2:3: '-inf' is wrong, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v 1x"), "2:3: '1x' is wrong, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v \x01\xff"),
            "2:3: '?"
            "?' is wrong, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v"), "2:2: something is missing here, expected a number from -16 to 16");
  EXPECT_EQ(numberIn2("v 1 2"), "2:5: '2' is wrong, expected the line's end");
}

TEST(MeshLines, NumbersAreTheWholeText) {
  EXPECT_EQ(numberIn("-1.5e3"), -1500.0);
  EXPECT_EQ(countIn("+7"), 7U);
  for (const char* const wrong : {"", "1 ", " 1", "1.5", "-1", "++1", "0x1", "18446744073709551616"})
    EXPECT_FALSE(countIn(wrong)) << wrong;
  for (const char* const wrong : {"", "1,5", "1.5m", "--1", "+"}) EXPECT_FALSE(numberIn(wrong)) << wrong;
}

}  // namespace
}  // namespace carom
