#pragma once
// The language of what a command draws without a session's frames: pages, diagrams, test patterns.

#include <memory>
#include <string>

#include "cave/texts/language.h"

namespace carom {

/// Puts a language (app/file_keys/language_name.h) in use on this thread, as long as it lives; English if its
/// name is empty.
class WordsIn {
 public:
  /// Throws InputErrors or std::runtime_error if there is no such language, its file has errors, or no font
  /// here has its letters.
  explicit WordsIn(const std::string& language);

 private:
  std::shared_ptr<const texts::Language> words_;
  texts::InLanguage inUse_;
};

}  // namespace carom
