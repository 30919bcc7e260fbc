// The table of texts that have no room: what is too long is told by its pixels, and what is shipped fits.
#include "app/file_tools/text_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "places.h"

namespace carom {
namespace {

std::vector<TextPlace> placesOn(const std::string& rig, const std::vector<EntryWords>& entries) {
  return textPlaces(rig, readRig(std::string(CAROM_CONFIG_DIR "/rigs/") + rig + ".toml"), entries);
}

int mostOver(const std::vector<TextPlace>& places) {
  int most_px = 0;
  for (const TextPlace& place : places) most_px = std::max(most_px, place.over_px());
  return most_px;
}

/// The entries of the shipped lessons, in English.
std::vector<EntryWords> lessonEntries() {
  std::vector<EntryWords> entries;
  for (const auto& file : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    const Scenario game = readScenario(file.path());
    if (!game.lesson) continue;
    const std::string name = file.path().filename().string() + " lesson ";
    entries.push_back({name + "question", game.lesson->words.question});
    entries.push_back({name + "notice", game.lesson->words.notice});
  }
  return entries;
}

TEST(TextPlaces, ValuesAreTheWidestThatTheirFormatShows) {
  EXPECT_EQ(withWidestValues("message.kA", "{} left at {:.1f} s: {{}}", "the long name"),
            "the long name left at 888.8 s: {}");
  EXPECT_EQ(withWidestValues("console.kA", "{} pucks, {1:.2f} c", "the long name"), "888 pucks, 88.88 c");
  EXPECT_EQ(withWidestValues("console.kA", "{:.7f} {", "x"), "888 888")
      << "an unknown format, and a broken one";
  EXPECT_EQ(withWidestValues("console.kA", "", "x"), "");
}

TEST(TextPlaces, EnglishLessonsFitOnAllExaminedRigs) {
  const std::vector<EntryWords> entries = lessonEntries();
  ASSERT_GT(entries.size(), 20U);
  for (const char* rig : examinedRigs()) {
    const std::vector<TextPlace> places = placesOn(rig, entries);
    EXPECT_GE(places.size(), 3 * 3 * entries.size() / 2) << rig << ": three places in each of three phases";
    for (const TextPlace& place : places) {
      EXPECT_EQ(place.over_px(), 0) << place.entry;
      EXPECT_GT(place.width_px, 0) << place.entry;
    }
  }
}

TEST(TextPlaces, WhatIsTooLongIsToldByItsPixels) {
  const auto tile = [](const std::string& words) {
    return mostOver(placesOn("play", {{"tile.kHome", words}}));
  };
  EXPECT_EQ(tile("Back to the table"), 0);
  const int over_px = tile(std::string(60, 'n'));
  EXPECT_GT(over_px, 0);
  EXPECT_GT(tile(std::string(70, 'n')), over_px);
  const auto plate = [](const std::string& words) {
    return mostOver(placesOn("desk", {{"plate.kYou", words}}));
  };
  EXPECT_EQ(plate("twelve plate"), 0);
  EXPECT_EQ(plate("thirteen here"), 58) << "a cell of the letters";
  std::vector<EntryWords> lesson{{"angles.toml lesson question", std::string(4000, 'n')}};
  EXPECT_GT(mostOver(placesOn("desk", lesson)), 0) << "the band would need letters that are too small";
}

TEST(TextPlaces, ATableHasTheColumnsThatItNames) {
  std::FILE* file = std::tmpfile();
  const std::vector<TextPlace> places{{"tile.kHome: desk, tile", 90, 80}, {"tile.kKeys: desk, tile", 20, 80}};
  printTextPlaces("fr", places, file);
  std::rewind(file);
  std::string all(2000, '\0');
  all.resize(std::fread(all.data(), 1, all.size(), file));
  std::fclose(file);
  EXPECT_EQ(all,
            "entry                   language  width  room  pixels over\n"
            "tile.kHome: desk, tile  fr           90    80           10\n"
            "tile.kKeys: desk, tile  fr           20    80            0\n");
}

}  // namespace
}  // namespace carom
