#pragma once
// How far a participant has come, and what each step asks.

#include <array>
#include <cstddef>
#include <string_view>

namespace carom {

/// The steps of a participant, in their order.
enum class StudyStep : int {
  consent,
  background,
  before,      ///< the test before the lessons
  wellBefore,  ///< the rating before the lessons
  lessons,     ///< in the room
  after,       ///< the test after them
  ratings,
  done,
  delayed,  ///< the test a week later, in the hands of a participant who was done
  doneDelayed,
};

/// The phases of the tests, in the order of a participant's forms.
inline constexpr std::array<const char*, 3> kTestPhases{"pre", "post", "delayed"};

/// The band of age in which a guardian's consent is needed.
inline constexpr const char* kUnderAge = "under-18";

/// A question about the person, with bands from which one chooses; none: a short text.
struct BackgroundQuestion {
  const char* id;
  const char* words;
  std::array<const char*, 6> bands;
};

inline constexpr std::array<BackgroundQuestion, 6> kBackground{
    {{"age_band", "How old are you?", {kUnderAge, "18-24", "25-34", "35-49", "50-64", "65-"}},
     {"physics_years", "How many years of physics courses have you had?", {"0", "1-2", "3-4", "5-"}},
     {"relativity", "What do you know about relativity so far?", {"none", "read", "course"}},
     {"games_hours", "How many hours a week do you play 3D games?", {"0", "1-3", "4-9", "10-"}},
     {"language", "Which language do you speak best?", {}},
     {"gender", "What is your gender? In your own words, or leave it out.", {}}}};

/// A question that is answered by a number from 0 to 10.
struct RatingQuestion {
  const char* id;
  const char* words;
  const char *least, *most;  ///< what 0 and 10 mean
};

inline constexpr RatingQuestion kUnwellBefore{"unwell-before", "How unwell do you feel now?", "not at all",
                                              "very"};
inline constexpr RatingQuestion kUnwellDuring{"unwell-during", "How unwell do you feel now?", "not at all",
                                              "very"};
inline constexpr std::array<RatingQuestion, 3> kRatingsAfter{
    {{"unwell-after", "How unwell do you feel now?", "not at all", "very"},
     {"hard", "How hard was it to follow?", "easy", "very hard"},
     {"there", "How much did you feel that you were there, at that table?", "not at all", "wholly"}}};

/// From this rating of feeling unwell on, the page offers to stop.
inline constexpr int kUnwell = 7;

/// In lessons the question how unwell one feels comes again after so long.
inline constexpr double kAskUnwellEvery_s = 600.0;
/// Until it is answered they are reminded of it.
inline constexpr double kRemindEvery_s = 30.0;

}  // namespace carom
