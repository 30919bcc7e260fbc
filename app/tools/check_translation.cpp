#include "app/tools/check_translation.h"

#include <fmt/format.h>

#include <string>

#include "app/tools/import.h"
#include "cave/gl/glyph_bitmap.h"

namespace carom {

LetterFonts fontsHere() {
  return {lettersWithoutFont, [] {
            for (const LetterFont& font : letterFonts()) {
              if (!std::filesystem::exists(font.file)) return std::string(font.package);
            }
            return std::string();
          }};
}

bool tellTranslation(const std::filesystem::path& file) {
  const ReadTranslation read = readTranslation(file, fontsHere());
  const bool failed = printFindings(file, read.judged.findings);
  fmt::print("{}: {} of {} texts are translated\n", read.judged.code, read.judged.translated.size(),
             read.rules.sources.size());
  return failed;
}

}  // namespace carom
