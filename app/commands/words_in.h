#pragma once
// The language of what a command draws without a session's frames: pages, diagrams, test patterns.

#include <string>

namespace carom {

/// What is said and drawn on this thread is in a language (app/file_keys/language_name.h), as long as this
/// object lives; English if its name is empty.
class WordsIn {
 public:
  explicit WordsIn(std::string language) : language_(std::move(language)) {}
  WordsIn(const WordsIn&) = delete;
  WordsIn& operator=(const WordsIn&) = delete;

  const std::string& language() const { return language_; }

 private:
  std::string language_;
};

}  // namespace carom
