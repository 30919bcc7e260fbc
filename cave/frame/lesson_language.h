#pragma once
// The words of a lesson in the language in use (cave/texts/language.h).

#include <map>
#include <utility>

#include "cave/frame/lesson_plan.h"
#include "cave/record/lesson_words.h"
#include "cave/texts/language.h"

namespace carom {

/// Returns the same lesson with its words, and the names that people read, in the language in use.
LessonWords inLanguage(LessonWords english);
LessonPlan inLanguage(LessonPlan english);

/// What a lesson says, as its readers read it: each may have another language.
template <typename Said>
class InLanguages {
 public:
  InLanguages() = default;
  explicit InLanguages(Said english) : english_(std::move(english)) {}

  /// Returns it in the language in use; kept, so that nothing is allocated but the first time in a language.
  const Said& read() {
    const auto [said, isNew] = read_.try_emplace(texts::language());
    if (isNew) said->second = inLanguage(english_);
    return said->second;
  }

 private:
  Said english_;
  std::map<const texts::Language*, Said> read_;
};

}  // namespace carom
