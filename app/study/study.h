#pragma once
// A study file: all that is fixed before the first participant. Arms, lessons and their orders, forms of the
// tests, the seed, the planned number.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/item_bank.h"
#include "app/toml/findings.h"

namespace carom {

struct StudyArm {
  std::string name;
  std::filesystem::path rig;             ///< an existing file
  bool isStill = false;                  ///< the eyes stay where they were when the lesson began
  std::vector<std::string> switchesOff;  ///< names of effects (cave/record/effects.h)
  std::vector<std::string> viewsOff;     ///< names of views of time (cave/record/time_views.h)
};

struct StudyLesson {
  std::string name;                ///< as the study has it
  std::filesystem::path scenario;  ///< an existing file with a lesson
};

struct Study {
  std::filesystem::path file;
  std::string text;  ///< the file's content
  std::string title;
  std::uint64_t seed = 0;
  std::size_t participants = 0;
  std::vector<StudyLesson> lessons;
  bool hasFixedOrder = false, hasFixedForms = false;
  std::filesystem::path bankFile;
  std::string bankText;
  bool hasShippedBank = false;  ///< the items are those of the shipped bank
  ItemBank bank;
  std::string primary;
  bool asksGender = false, asksReasons = false, isOpen = false;
  std::optional<std::chrono::year_month_day> keepUntil;
  std::filesystem::path consent;
  std::vector<StudyArm> arms;
  std::string sha256;        ///< of the bytes of the study file, followed by those of its item bank
  std::vector<Finding> odd;  ///< oddities that are no errors
};

/// Reads and checks a study, its rigs, lessons and item bank. Throws InputErrors with the place of every
/// fault: an arm without a rig, a lesson that is not there, a bank that cannot be used.
Study readStudy(const std::filesystem::path& file);

/// Returns the study as it was when a session began, from the content of its files then. Rigs, lessons and
/// the consent page are not looked for. Throws InputErrors.
Study keptStudy(const std::string& text, const std::string& bankText);

/// Returns what of the template still stands in a consent page: words in [brackets], and the sentence that it
/// is a template.
std::vector<Finding> leftOfTemplate(const std::string& consent);

/// Returns the names of the rigs of the arms, each once. People of different ones take part in sessions of
/// their own.
std::vector<std::string> rigsOf(const Study& study);

/// Returns the number of orders in which the lessons are played: the rows of the Williams square, or 1.
std::size_t orderRows(const Study& study);

/// Returns the SHA-256 (FIPS 180-4) of bytes, as 64 hexadecimal digits.
std::string sha256Of(const std::string& bytes);

}  // namespace carom
