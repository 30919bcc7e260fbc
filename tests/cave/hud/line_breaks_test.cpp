// Lines are broken where Unicode allows it, and the English ones where they always were.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "app/rig/rig.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/hud/hud_line.h"
#include "cave/hud/line_breaks.h"
#include "cave/room/room_geometry.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kWide_em = 1e6;

std::vector<std::string> linesOf(std::string_view text, const LineRoom& room) {
  LineBreaker breaker;
  std::vector<std::string> lines;
  for (breaker.begin(text); !breaker.isAtEnd();) lines.emplace_back(breaker.take(room));
  return lines;
}

std::vector<std::string> linesOf(std::string_view text, std::size_t columns) {
  return linesOf(text, {columns, kWide_em});
}

std::string trimmed(std::string text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The lines of whole words, by the number of their letters alone: words end at blanks, but not between a
/// number and a letter.
std::vector<std::string> wordLines(const std::string& text, std::size_t most) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find(' ', begin);
    const auto isUnit = [&](std::size_t at) {
      const auto isSmall = [&](std::size_t i) { return i < text.size() && text[i] >= 'a' && text[i] <= 'z'; };
      return at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0 && isSmall(at + 1) &&
             !isSmall(at + 2);
    };
    while (end != std::string::npos && isUnit(end)) end = text.find(' ', end + 1);
    end = std::min(end, text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  const auto lettersOf = [](const std::string& line) {
    return static_cast<std::size_t>(
        std::count_if(line.begin(), line.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
  };
  std::vector<std::string> lines;
  for (const std::string& word : words) {
    if (lines.empty() || lettersOf(lines.back() + " " + word) > most) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  for (std::string& line : lines) line = trimmed(line);
  return lines;
}

void addTexts(const toml::node& node, std::vector<std::string>& texts) {
  if (const auto* text = node.as_string()) texts.push_back(text->get());
  if (const auto* table = node.as_table()) {
    for (const auto& entry : *table) addTexts(entry.second, texts);
  }
  if (const auto* array = node.as_array()) {
    for (const auto& entry : *array) addTexts(entry, texts);
  }
}

/// Every text of the shipped games.
std::vector<std::string> shippedTexts() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios"))
    addTexts(toml::parse_file(entry.path().string()), texts);
  return texts;
}

// The measured width of English lines is no more than their number of letters allows: the rooms are so wide
// that each line ends with the word that its letters make its last one.
TEST(LineBreaks, EnglishLinesEndWhereTheirNumberOfLettersEndsThem) {
  const std::vector<std::string> texts = shippedTexts();
  ASSERT_GT(texts.size(), 300U);
  std::vector<LineRoom> rooms{kPanelRoom};
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs"))
    rooms.push_back(bandRoom(frontWall(roomGeometryOf(readRig(entry.path()))).value()));
  for (const LineRoom& room : rooms) {
    for (const std::string& text : texts) {
      for (const LineRoom& part : {room, behindIndent(room)})
        EXPECT_EQ(linesOf(text, part), wordLines(text, part.columns)) << part.columns << " columns: " << text;
    }
  }
}

/// A line of the reference: its parts, between which Unicode allows a break.
std::vector<std::vector<std::string>> referenceLines() {
  constexpr std::string_view kMark = "\u240A";
  std::ifstream file(CAROM_TESTS_DIR "/data/line_breaks.txt");
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string>& parts = lines.emplace_back();
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(kMark, at), line.size());
      parts.push_back(line.substr(at, end - at));
      at = end + kMark.size();
    }
  }
  return lines;
}

/// Returns whether a text begins, or ends, with a letter of East Asia, of three bytes in these lines.
bool isWideSign(const std::string& sign) { return (sign.front() & 0xF0) == 0xE0 && columnsOf(sign) == 2; }
bool beginsWide(const std::string& part) { return isWideSign(part.substr(0, 3)); }
bool endsWide(const std::string& part) {
  return part.size() >= 3 && isWideSign(part.substr(part.size() - 3));
}

/// The parts that stay together as long as a line holds them: words with hyphens, and a number and its unit.
std::vector<std::string> wholeParts(const std::vector<std::string>& parts) {
  std::vector<std::string> whole;
  for (const std::string& part : parts) {
    const std::string before = whole.empty() ? "" : whole.back();
    const bool inWord = !before.empty() && before.back() != ' ' && !endsWide(before) && !beginsWide(part);
    const bool isUnit = before.size() > 1 && before.back() == ' ' &&
                        std::isdigit(static_cast<unsigned char>(before[before.size() - 2])) != 0 &&
                        std::islower(static_cast<unsigned char>(part[0])) != 0 &&
                        (part.size() == 1 || std::islower(static_cast<unsigned char>(part[1])) == 0);
    if (inWord || isUnit) {
      whole.back() += part;
    } else {
      whole.push_back(part);
    }
  }
  return whole;
}

TEST(LineBreaks, AreThoseOfUnicodeInJapaneseFrenchAndGerman) {
  const auto reference = referenceLines();
  ASSERT_EQ(reference.size(), 40U);
  std::size_t compared = 0;
  for (const std::vector<std::string>& allowed : reference) {
    const std::vector<std::string> parts = wholeParts(allowed);
    std::string text;
    std::size_t widest = 0;
    for (const std::string& part : parts) {
      text += part;
      widest = std::max(widest, columnsOf(trimmed(part)));
    }
    for (std::size_t columns = widest; columns <= columnsOf(text); ++columns) {
      std::vector<std::string> lines;
      for (const std::string& part : parts) {
        if (lines.empty() || columnsOf(trimmed(lines.back() + part)) > columns) lines.emplace_back();
        lines.back() += part;
      }
      for (std::string& line : lines) line = trimmed(line);
      EXPECT_EQ(linesOf(text, columns), lines) << columns << " columns: " << text;
      compared += lines.size();
    }
  }
  EXPECT_GT(compared, 2000U);
}

TEST(LineBreaks, ANumberAndItsUnitStayTogether) {
  EXPECT_EQ(linesOf("mit 0.6 c fliegt", 7), (std::vector<std::string>{"mit", "0.6 c", "fliegt"}));
  EXPECT_EQ(linesOf("mit 0,6 c fliegt", 7), (std::vector<std::string>{"mit", "0,6 c", "fliegt"}));
  EXPECT_EQ(linesOf("速さは 0.6 c です", 10), (std::vector<std::string>{"速さは", "0.6 c です"}));
  EXPECT_EQ(linesOf("c = 1\u202F000 m/s ici", 12),
            (std::vector<std::string>{"c =", "1\u202F000 m/s", "ici"}));
}

TEST(LineBreaks, FrenchSignsBeginNoLine) {
  for (const char* sign : {" ;", " :", " !", " ?", "\u00A0;", "\u202F!", "\u202F?", "\u00A0»", "\u00A0:"}) {
    for (std::size_t columns = 8; columns < 20; ++columns) {
      for (const std::string& line : linesOf("alors mon ami" + std::string(sign) + " voici", columns)) {
        EXPECT_EQ(std::string(";:!?").find(line.front()), std::string::npos) << sign << columns;
        EXPECT_FALSE(line.starts_with("»")) << columns;
      }
    }
  }
}

TEST(LineBreaks, WordsAreDividedWhereNothingElseHelps) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(linesOf("the light-second is", 12), (Lines{"the", "light-second", "is"}))
      << "whole, where it fits";
  EXPECT_EQ(linesOf("the light-second is", 8), (Lines{"the", "light-", "second", "is"}));
  EXPECT_EQ(linesOf("Geschwindigkeit", 6), (Lines{"Geschw", "indigk", "eit"}));
  EXPECT_EQ(linesOf("a\u0301b\u0301c\u0301", 1), (Lines{"a\u0301", "b\u0301", "c\u0301"})) << "marks stay";
  EXPECT_EQ(linesOf("光は遅い", 3), (Lines{"光", "は", "遅", "い"}));
  EXPECT_EQ(linesOf("光", 0), (Lines{"光"})) << "at least one letter";
  EXPECT_EQ(linesOf("  a   b  ", 4), (Lines{"a", "b"}));
  EXPECT_EQ(linesOf("one\ntwo", 40), (Lines{"one", "two"}));
  EXPECT_TRUE(linesOf("", 4).empty());
  EXPECT_TRUE(linesOf("   ", 4).empty());
}

TEST(LineBreaks, NoLineIsWiderThanItsRoom) {
  const std::string text = "WWWW mmmm llll iiii MMMM 光は遅い、だから過去が見えます。 WWWWWWWWWWWWWWWW Ende";
  for (double width_em = 2.0; width_em < 30.0; width_em += 0.37) {
    for (const std::string& line : linesOf(text, {40, width_em})) {
      EXPECT_LE(widthOf_em(line), width_em) << line;
      EXPECT_LE(columnsOf(line), 40U) << line;
      // Kerning brings letters nearer to each other.
      EXPECT_LE(widthOf_px(line), 1.02 * kMeasured_px * width_em) << line;
    }
  }
  EXPECT_NEAR(widthOf_em("Zwei Zwillinge trennen sich"), 0.01 * widthOf_px("Zwei Zwillinge trennen sich"),
              0.3);
}

TEST(LineBreaks, AnyBytesEndAndLoseNoLetter) {
  std::mt19937 random(4711);
  constexpr std::string_view kTelling[] = {" ",  "\n", "-",    "/",    "\u00A0",   "\u202F", "。",
                                           "「", "ッ", "ー",   "a",    "é",        "\u0301", "0",
                                           "c",  "光", "\xE5", "\xFF", "\xF0\x9F", "\u200B", "»"};
  for (int run = 0; run < 3000; ++run) {
    std::string text;
    for (auto i = random() % 40; i > 0; --i) {
      text += random() % 3 == 0 ? std::string(1, static_cast<char>(random() % 256))
                                : std::string(kTelling[random() % std::size(kTelling)]);
    }
    const LineRoom room{random() % 20, 0.1 * static_cast<double>(random() % 120)};
    LineBreaker breaker;
    breaker.begin(text);
    std::string kept;
    for (std::size_t lines = 0; !breaker.isAtEnd(); ++lines) {
      ASSERT_LE(lines, text.size()) << "run " << run;
      kept += breaker.take(room);
    }
    const auto withoutBlanks = [](std::string all) {
      std::erase_if(all,
                    [](char byte) { return byte == ' ' || byte == '\n' || byte == '\r' || byte == '\t'; });
      return all;
    };
    ASSERT_EQ(withoutBlanks(kept), withoutBlanks(text)) << "run " << run;
  }
}

}  // namespace
}  // namespace carom
