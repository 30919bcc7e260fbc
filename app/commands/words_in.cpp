#include "app/commands/words_in.h"

#include "app/languages/language_files.h"
#include "app/tools/check_translation.h"

namespace carom {

WordsIn::WordsIn(const std::string& language)
    : words_(language.empty() ? nullptr : loadLanguage(language, fontsHere())), inUse_(words_.get()) {}

}  // namespace carom
