#pragma once
// What the person at the console does for a study, and what they see of it: codes and steps, not arms.

#include <string>
#include <variant>

namespace carom {

/// Lets the owner of a code in, on the tablet that asks for it next.
struct CallCode {
  std::string typed;
};
/// Keeps what the person in the room says of how unwell they feel, 0 to 10.
struct RateUnwell {
  int value = 0;
};
/// The person in the room wants to stop.
struct StopInRoom {};
using StudyOrder = std::variant<CallCode, RateUnwell, StopInRoom>;

/// How far somebody is who takes part.
struct StudyStanding {
  std::string code, words;
  bool isInRoom = false;
  bool isAsked = false;  ///< it is time to ask them how they feel
  bool isUnwell = false;
};

}  // namespace carom
