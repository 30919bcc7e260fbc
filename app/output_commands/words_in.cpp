#include "app/output_commands/words_in.h"

#include "app/file_tools/check_translation.h"
#include "app/languages/language_files.h"

namespace carom {

WordsIn::WordsIn(const std::string& language)
    : words_(language.empty() ? nullptr : loadLanguage(language, fontsHere())), inUse_(words_.get()) {}

}  // namespace carom
