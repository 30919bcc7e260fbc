#include "app/file_tools/check_translation.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "app/file_tools/import.h"
#include "app/file_tools/text_places.h"
#include "app/rig/rig.h"
#include "app/toml/config_folder.h"
#include "cave/gl/glyph_bitmap.h"

namespace carom {

LetterFonts fontsHere() { return {lettersWithoutFont, missingFontPackage}; }

namespace {

/// Returns the places of a file's texts on a rig, in its language.
std::vector<TextPlace> placesOn(const std::filesystem::path& rig, std::span<const EntryWords> entries) {
  return textPlaces(rig.stem().string(), readRig(rig), entries);
}

}  // namespace

bool tellTranslation(const std::filesystem::path& file, const std::filesystem::path& rig) {
  const ReadTranslation read = readTranslation(file, fontsHere());
  const bool failed = printFindings(file, read.judged.findings);
  fmt::print("{}: {} of {} texts are translated\n", read.judged.code, read.judged.translated.size(),
             read.rules.sources.size());
  if (failed) return true;
  const auto language = loadLanguage(file.string(), {});
  const texts::InLanguage reads(language.get());
  std::vector<EntryWords> entries;
  for (const Translated& text : read.judged.translated)
    for (const std::string& form : text.forms)
      entries.push_back({read.rules.sources[text.source].context, form});
  std::vector<TextPlace> places;
  if (!rig.empty()) places = placesOn(rig, entries);
  if (rig.empty()) {
    for (const char* const name : examinedRigs())
      for (TextPlace& place : placesOn(configFolder() / "rigs" / (std::string(name) + ".toml"), entries))
        places.push_back(std::move(place));
  }
  if (!places.empty()) printTextPlaces(read.judged.code, places);
  return false;
}

}  // namespace carom
