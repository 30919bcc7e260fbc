#include "app/toml/toml_file.h"

#include <gtest/gtest.h>

#include "app/repeated_text.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using namespace declare;
using test::repeated;
using test::TemporaryFolder;

using Keys = std::vector<FileKey>;

/// "LINE:COLUMN MESSAGE" of every fault that `read` notes in a file of this text.
template <class Read>
std::vector<std::string> faultsOf(const std::string& given, Keys keys, const Read& read) {
  const FileKey declared = table("file", "", std::move(keys));
  const TemporaryFolder folder;
  std::vector<std::string> shown;
  try {
    const TomlFile file(folder.file("given.toml", given), declared);
    read(file, file.root());
    file.throwFaults();
  } catch (const InputErrors& errors) {
    for (const InputError& fault : errors.faults()) {
      EXPECT_EQ(fault.file(), (folder / "given.toml").string());
      shown.push_back(std::to_string(fault.line()) + ":" + std::to_string(fault.column()) + " " +
                      fault.message());
    }
    EXPECT_STREQ(errors.what(), errors.faults().front().what());
  }
  return shown;
}

using Faults = std::vector<std::string>;

TEST(TomlFile, ReadsEveryKindOfValue) {
  const Keys keys{number("number", {}, ""),
                  whole("whole", 0, 5, ""),
                  flag("yes", ""),
                  text("word", ""),
                  choice("kind", {"a", "b"}, ""),
                  numbers("pair", 2, {}, ""),
                  table("inner", "", {number("x", {}, "")}),
                  tables("many", "", {number("x", {}, "")}),
                  number("absent", {}, "", 7.0),
                  whole("none", 0, 9, "", 4),
                  flag("on", "", true),
                  choice("colour", {"red", "blue"}, "", 1),
                  numbers("two", 2, {}, "", {1.0, 2.0}),
                  number("dynamic", {}, "", 3.0),
                  tables("no", "", {})};
  const auto faults = faultsOf(
      "number = 1.5\nwhole = 3\nyes = true\nword = 'text'\nkind = 'b'\npair = [1, 2.5]\n[inner]\nx = "
      "1\n[[many]]\n"
      "x = 1\n[[many]]\nx = 2\n",
      keys, [](const TomlFile& file, const TomlTable& root) {
        EXPECT_EQ(root.number("number"), 1.5);
        EXPECT_EQ(root.integer("whole"), 3);
        EXPECT_TRUE(root.flag("yes"));
        EXPECT_EQ(root.text("word"), "text");
        EXPECT_EQ(root.choice("kind"), 1u);
        EXPECT_EQ(root.numbers<2>("pair"), (std::array<double, 2>{1.0, 2.5}));
        ASSERT_TRUE(root.table("inner"));
        EXPECT_EQ(root.table("inner")->number("x"), 1.0) << "whole numbers do where numbers are wanted";
        ASSERT_EQ(root.tables("many").size(), 2u);
        EXPECT_EQ(root.tables("many")[0].number("x"), 1.0);
        EXPECT_EQ(root.tables("many")[1].number("x"), 2.0);
        EXPECT_EQ(root.number("absent"), 7.0);
        EXPECT_EQ(root.integer("none"), 4);
        EXPECT_TRUE(root.flag("on"));
        EXPECT_EQ(root.choice("colour"), 1u);
        EXPECT_EQ(root.numbers<2>("two"), (std::array<double, 2>{1.0, 2.0}));
        EXPECT_EQ(root.numberOr("dynamic", 5.0), 5.0);
        EXPECT_TRUE(root.tables("no").empty());
        EXPECT_TRUE(file.contains("word"));
        EXPECT_FALSE(file.contains("absent"));
      });
  EXPECT_EQ(faults, Faults{});
}

TEST(TomlFile, ReadsOnlyWhatIsDeclared) {
  faultsOf("a = 1\n", {number("a", {}, ""), numbers("c", 2, {}, "")},
           [](const TomlFile&, const TomlTable& root) {
             EXPECT_EQ(root.number("a"), 1.0);
             EXPECT_THROW(root.number("b"), std::logic_error);
             EXPECT_THROW(root.has("b"), std::logic_error);
             EXPECT_THROW(root.integer("a"), std::logic_error) << "of another type";
             EXPECT_THROW(root.text("a"), std::logic_error);
             EXPECT_THROW(root.numbers<3>("c"), std::logic_error) << "of another size";
           });
}

TEST(TomlFile, SaysWhatIsWrongAndWhatWasExpected) {
  const auto faults =
      faultsOf("a = 'x'\nb = -1\nc = nan\nd = [1, 'y']\ne = 2.5\nf = 1\ng = 'blue'\nh = [1]\ni = ''\n",
               {number("a", {}, ""), number("b", kPositive, ""), number("c", {}, ""), numbers("d", 2, {}, ""),
                whole("e", 0, 9, ""), flag("f", ""), choice("g", {"red", "green"}, ""),
                numbers("h", 3, {}, ""), text("i", "")},
               [](const TomlFile&, const TomlTable& root) {
                 root.number("a");
                 root.number("b");
                 root.number("c");
                 root.numbers<2>("d");
                 root.integer("e");
                 root.flag("f");
                 root.choice("g");
                 root.numbers<3>("h");
                 root.text("i");
               });
  EXPECT_EQ(faults, (Faults{
                        "1:5 a is a text, expected a number from -1e+09 to 1e+09",
                        "2:5 b is -1, expected a number above 0 up to 1e+09",
                        "3:5 c is nan, expected a number from -1e+09 to 1e+09",
                        "4:9 d[1] is a text, expected a number from -1e+09 to 1e+09",
                        "5:5 e is a number, expected a whole number from 0 to 9",
                        "6:5 f is a whole number, expected true or false",
                        "7:5 g is 'blue', expected 'red' or 'green'",
                        "8:5 h has 1 values, expected 3 numbers",
                        "9:5 i is empty, expected a text",
                    }));
}

TEST(TomlFile, NoticesUnknownKeysAndGuessesWhatWasMeant) {
  const Keys keys{number("length_m", {}, ""), number("width_m", {}, "", 1.0)};
  const auto read = [](const TomlFile&, const TomlTable& root) {
    root.number("length_m");
    root.number("width_m");
  };
  EXPECT_EQ(faultsOf("lenght_m = 1\n", keys, read),
            Faults{"1:1 unknown key 'lenght_m', expected 'length_m'?"});
  EXPECT_EQ(faultsOf("length = 1\n", keys, read), Faults{"1:1 unknown key 'length', expected 'length_m'?"});
  EXPECT_EQ(faultsOf("length_m = 1\ncolour = 2\n", keys, read),
            Faults{"2:1 unknown key 'colour', expected one of length_m, width_m"});
  EXPECT_EQ(faultsOf("width_m = 2\n", keys, read), Faults{"1:1 length_m is missing here"});
  EXPECT_EQ(faultsOf("length_m = 1\n\"\\u001b[31m\" = 2\n", keys, read),
            Faults{"2:1 unknown key '?[31m', expected one of length_m, width_m"})
      << "nothing from a file may steer the terminal";
}

TEST(TomlFile, RefusesWhatIsNoToml) {
  const auto nothing = [](const TomlFile&, const TomlTable&) {};
  const std::vector<std::pair<std::string, std::string>> cases{
      {"a = 0/05\n", "1:6 "},     {"a = 1\na = 2\n", "2:5 "}, {"a = [1, 2\n", "1:11 "},
      {"a = \"\xff\"\n", "1:5 "}, {"a = 1e999\n", "1:10 "},   {std::string("a = 1\0", 6), "1:6 "},
  };
  for (const auto& [text, place] : cases) {
    const auto faults = faultsOf(text, {}, nothing);
    ASSERT_EQ(faults.size(), 1u) << text;
    EXPECT_EQ(faults[0].substr(0, place.size()), place) << text << faults[0];
  }
  EXPECT_EQ(faultsOf(std::string(17 << 20, '\n'), {}, nothing),
            Faults{"1:1 the file is too large, 17 MiB, expected at most 16 MiB"});
}

const FileKey kNoKeys;

TEST(TomlFile, RefusesMissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_THROW(TomlFile(folder / "absent.toml", kNoKeys), InputErrors);
  EXPECT_THROW(TomlFile(folder / ".", kNoKeys), InputErrors);
}

TEST(TomlFile, RefusesDeepNestingBeforeTheParserRecurses) {
  const auto nothing = [](const TomlFile&, const TomlTable&) {};
  constexpr std::size_t kDeep = 200'000;
  const std::vector<std::pair<std::string, const char*>> cases{
      {"[" + repeated("a.", kDeep) + "a]\n", "1:67 "},
      {"[[" + repeated("a . ", kDeep) + "a]]\n", ""},
      {repeated("a.", kDeep) + "a = 1\n", ""},
      {repeated("\"a\".", kDeep) + "a = 1\n", ""},
      {"a = " + repeated("[", kDeep), "1:37 "},
      {"a = " + repeated("{a=", kDeep), ""},
      {"a = {" + repeated("a.", kDeep) + "a = 1}\n", ""},
      {"a = " + repeated("[{a.a=", kDeep), ""}};
  for (const auto& [text, place] : cases) {
    const auto faults = faultsOf(text, {}, nothing);
    ASSERT_EQ(faults.size(), 1u) << text.substr(0, 20);
    EXPECT_EQ(faults[0].find(place), 0u) << faults[0];
    EXPECT_NE(faults[0].find("values are nested too deep, expected at most 32"), std::string::npos)
        << faults[0];
  }
}

TEST(TomlFile, TakesDotsAndBracketsThatNestNothing) {
  const auto read = [](const TomlFile&, const TomlTable& root) {
    root.texts("a");
    root.text("b");
    root.number("c");
  };
  const Keys keys{texts("a", ""), text("b", ""), number("c", {}, "")};
  const std::string dots(300, '.'), brackets(300, '[');
  EXPECT_EQ(faultsOf("a = ['" + dots + "', \"" + brackets + "\"] # " + dots + brackets + "\nb = \"\"\"\n" +
                         dots + brackets + "\"\"\"\nc = 1.5\n",
                     keys, read),
            Faults{});
  EXPECT_EQ(faultsOf("a = [" + repeated("'x.y', ", 1000) + "]\nb = 'b'\nc = 1\n", keys, read), Faults{});
}

TEST(TomlFile, RefusesMoreValuesThanItsParserHasMemoryFor) {
  const auto faults =
      faultsOf("a = [" + repeated("1,", 3'500'000) + "]\n", {}, [](const TomlFile&, const TomlTable&) {});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("too many values, expected at most 3000000"), std::string::npos) << faults[0];
}

TEST(TomlFile, ThreeThousandUnknownKeysAreOneFault) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  const auto faults = faultsOf(text, {number("length_m", {}, "", 1.0)},
                               [](const TomlFile&, const TomlTable& root) { root.number("length_m"); });
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].find("1:1 3000 keys: unknown key 'key0', expected one of length_m (also in lines"), 0u)
      << faults[0];
}

TEST(TomlFile, RefusesNumbersTooSmallToCalculateWith) {
  EXPECT_EQ(faultsOf("c = 5e-324\nr = 1e-29\n", {number("c", kPositive, ""), number("r", kPositive, "")},
                     [](const TomlFile&, const TomlTable& root) {
                       root.number("c");
                       root.number("r");
                     }),
            Faults{"1:5 c is 5e-324, too small to calculate with, expected at least 1e-30"});
}

TEST(NearestWord, ForgivesSlipsOnly) {
  const std::vector<std::string> known{"radius_m", "mass_kg", "beta"};
  EXPECT_EQ(nearestWord("raduis_m", known), "radius_m");
  EXPECT_EQ(nearestWord("mass", known), "mass_kg");
  EXPECT_EQ(nearestWord("bet", known), "beta");
  EXPECT_FALSE(nearestWord("temperature", known));
  EXPECT_FALSE(nearestWord(std::string(1000, 'x'), known));
}

TEST(TomlFile, UnknownKeysAreNeverAmongTheExpected) {
  const test::TemporaryFolder folder;
  const FileKey keys = table("file", "", {number("length_m", {}, "")});
  const TomlFile file(folder.file("given.toml", "zebra = 1\nxylophone = 2\nquagga = 3\n"), keys);
  file.root().has("length_m");
  try {
    file.throwFaults();
    FAIL();
  } catch (const InputErrors& errors) {
    ASSERT_EQ(errors.faults().size(), 3u);
    for (const InputError& fault : errors.faults()) {
      EXPECT_NE(fault.message().find("expected one of length_m"), std::string::npos) << fault.what();
      EXPECT_TRUE(fault.message().ends_with("length_m")) << fault.what();
    }
  }
}

}  // namespace
}  // namespace carom
