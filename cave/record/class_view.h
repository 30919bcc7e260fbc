#pragma once
// What the walls show of a class that answers by phone (app/classroom): how to join, how many have answered
// and, once a vote is closed, what.

#include <array>
#include <cstddef>
#include <cstdint>

#include "cave/record/lesson_words.h"
#include "cave/record/notice.h"

namespace carom {

/// Where a class is in its question. The order is that of a lesson; each of two votes is opened and closed.
enum class ClassPhase : std::uint8_t { none, idle, vote, closed, discuss, shown, explained };

/// The names of the phases, as phones and session files have them.
inline constexpr std::array<const char*, 7> kClassPhases{"none",    "idle",  "vote",     "closed",
                                                         "discuss", "shown", "explained"};

/// A class votes twice: before and after it has discussed.
inline constexpr std::size_t kVotes = 2;

/// How often each answer was given in a vote.
using VoteCounts = std::array<std::uint64_t, kMostAnswers>;

struct ClassView {
  ClassPhase phase = ClassPhase::none;      ///< none: no class takes part
  std::uint8_t round = 0;                   ///< the present or latest vote, from 1; 0: none so far
  std::uint8_t choices = 0;                 ///< number of answers to the question; 0: the game asks none
  std::uint8_t right = 0;                   ///< the right answer, from 1, once it is explained; otherwise 0
  std::uint64_t answered = 0;               ///< in the present or latest vote
  std::uint64_t phones = 0;                 ///< that have joined
  std::array<VoteCounts, kVotes> counts{};  ///< all zero while a vote may not be shown
  ShortText<120> address;                   ///< of the pages, or of one to take home
  ShortText<120> word;                      ///< of the room whose class it is; empty: for a page to take home

  bool operator==(const ClassView&) const = default;
};

/// Returns whether a class answers by phone, and the walls do not only offer a page to take home.
inline bool hasClass(const ClassView& view) { return !view.word.words().empty(); }

}  // namespace carom
