#pragma once
// The messages of phones and of the teacher's page to the class: one small JSON object each, of one of these
// kinds. Everything else is refused.
//
//   {"hello": TOKEN or ""}                               from a phone that joins, or comes back with its
//   token
//   {"answer": 2, "confidence": 3, "round": 1}           answers and votes count from 1; confidence 1 to 4
//   may be missing
//   {"reason": "…", "round": 1}
//   {"pin": "123456"}                                    from the teacher's page
//   {"do": "ask"}                                        a step of the class (app/classroom/class_flow.h)

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "app/classroom/class_flow.h"

namespace carom {

/// The most bytes of a message.
inline constexpr std::size_t kMostMessageBytes = 1024;
/// The most signs of a reason.
inline constexpr std::size_t kMostReasonSigns = 200;
/// The steps of confidence: guessed, unsure, fairly sure, certain.
inline constexpr int kMostConfidence = 4;

struct PhoneHello {
  std::string token;  ///< as the phone has kept it; empty: it joins for the first time
};
struct PhoneAnswer {
  int answer = 0;      ///< 1 to kMostAnswers
  int confidence = 0;  ///< 1 to kMostConfidence; 0: not told
  int round = 0;       ///< 1 or 2
};
struct PhoneReason {
  std::string words;  ///< on one line, at most kMostReasonSigns signs
  int round = 0;
};
struct TeacherPin {
  std::string pin;
};
struct TeacherStep {
  ClassStep step = ClassStep::ask;
};
using PhoneMessage = std::variant<PhoneHello, PhoneAnswer, PhoneReason, TeacherPin, TeacherStep>;

/// Returns the message, or none if it is not one: too long, not JSON, not UTF-8, with other keys or values.
std::optional<PhoneMessage> phoneMessageOf(std::string_view bytes);

}  // namespace carom
