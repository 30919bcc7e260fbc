// How files and options name languages, and what is said of a wrong name.
#include "app/file_keys/language_name.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "app/input_faults.h"
#include "app/rig/rig.h"
#include "app/scenario/playlist.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

const std::string kRoom =
    "unit = 'm'\n"
    "axes = 'x-right y-up z-back'\n";
const std::string kWall =
    "[[tracker]]\nname = 'cap'\nkind = 'simulated'\n"
    "[[wall]]\nname = 'front'\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, -1]\n"
    "pixels = [64, 64]\n";
const std::string kHead = "[head]\ntracker = 'cap'\n";

TEST(LanguageName, IsAPlainCodeOrAPoFileThatExists) {
  const test::TemporaryFolder folder;
  const std::string mine = folder.file("mine.po", "").string();
  for (const std::string& name :
       {std::string("fr"), std::string("pt-BR"), std::string("x_1"), std::string("ABCDEFGHIJKLMNOP"), mine})
    EXPECT_EQ(refusalOfLanguage(name), "") << name;
  for (const std::string name :
       {"", "../fr", "/etc/passwd", "fr/", "français", "fr en", "fr\n", "ABCDEFGHIJKLMNOPQ", "fr.pot"}) {
    EXPECT_EQ(
        refusalOfLanguage(name),
        "'" + name +
            "' is no language, expected a code of at most 16 letters, digits, - and _, such as fr, or a "
            "PO file");
  }
  EXPECT_EQ(refusalOfLanguage("/gone/mine.po"),
            "there is no file '/gone/mine.po', expected a PO file with the texts of a language");
  EXPECT_NE(refusalOfLanguage((folder / "").string() + ".po"), "") << "a folder";
}

TEST(LanguageName, APoFileIsLookedForInTheFolder) {
  EXPECT_EQ(languageNamed("fr", "/rooms"), "fr");
  EXPECT_EQ(languageNamed("words/mine.po", "/rooms"), "/rooms/words/mine.po");
  EXPECT_EQ(languageNamed("../mine.po", "/rooms/here"), "/rooms/mine.po");
  EXPECT_EQ(languageNamed("/words/mine.po", "/rooms"), "/words/mine.po");
}

TEST(LanguageName, ARigHasItsOwnThoseOfATileAndThoseOfItsViewers) {
  const test::TemporaryFolder folder;
  const std::string mine = folder.file("mine.po", "").string();
  const auto viewer = [](const char* name, int sensor, const char* more) {
    return fmt::format("[[viewer]]\nname = '{}'\ntracker = 'cap'\nsensor = {}\n{}", name, sensor, more);
  };
  const Rig alone = readRig(folder.file(
      "alone.toml", kRoom + "language = 'de'\nlanguages = ['fr', 'mine.po', 'en']\n" + kHead + kWall));
  EXPECT_EQ(alone.language, "de");
  EXPECT_EQ(alone.languages, (std::vector<std::string>{"fr", mine, "en"}));
  EXPECT_EQ(alone.viewers.at(0).language, "");
  const Rig two = readRig(
      folder.file("two.toml", kRoom + viewer("anna", 0, "language = 'ja'\n") + viewer("ben", 1, "") + kWall +
                                  "stereo = 'side-by-side'\neyes = ['anna.middle', 'ben.middle']\n"));
  EXPECT_EQ(two.language, "");
  EXPECT_TRUE(two.languages.empty());
  EXPECT_EQ(two.viewers.at(0).language, "ja");
  EXPECT_EQ(two.viewers.at(1).language, "");
}

TEST(LanguageName, AWrongOneIsRefusedAtItsPlace) {
  const auto read = [](const std::string& text) {
    const test::TemporaryFolder folder;
    readRig(folder.file("given.toml", kRoom + text));
  };
  const std::string rest = kHead + kWall;
  for (const test::Fault& fault : {
           test::Fault{"a path", "language = '../fr'\n" + rest, 3, 12, "'../fr' is no language"},
           {"no file", "language = 'gone.po'\n" + rest, 3, 12, "gone.po', expected a PO file"},
           {"one of several", "languages = ['fr', 'f r']\n" + rest, 3, 20, "'f r' is no language"},
           {"twice", "languages = ['fr', 'en', 'fr']\n" + rest, 3, 26, "'fr' stands here twice"},
           {"too many", "languages = ['a','b','c','d','e','f','g','h','i']\n" + rest, 3, 46, "at most 8"},
           {"no text", "language = 3\n" + rest, 3, 12, "a text in quotes"},
           {"no array", "languages = 'fr'\n" + rest, 3, 13, "an array of texts"},
       })
    test::expectExplained(fault, read);
}

TEST(LanguageName, APlaylistHasItsOwn) {
  const test::TemporaryFolder folder;
  const std::string games = "[[game]]\nscenario = 'twins'\n";
  EXPECT_EQ(readPlaylist(folder.file("list.toml", "languages = ['ja', 'en']\n" + games)).languages,
            (std::vector<std::string>{"ja", "en"}));
  EXPECT_TRUE(readPlaylist(folder.file("list.toml", games)).languages.empty());
  EXPECT_THROW(readPlaylist(folder.file("list.toml", "languages = ['/']\n" + games)), InputErrors);
}

TEST(LanguageName, ARigOfASessionMayNamePoFilesThatHaveGone) {
  const std::string text = kRoom + "language = 'gone.po'\n" + kHead + kWall;
  EXPECT_EQ(readRig("/rooms/given.toml", text).language, "/rooms/gone.po");
}

}  // namespace
}  // namespace carom
