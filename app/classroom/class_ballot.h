#pragma once
// The votes on one question. Each phone has one in each vote: its last answer before the vote is closed.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cave/record/class_view.h"

namespace carom {

/// With fewer answers than this a distribution would tell what single students answered: there is none.
inline constexpr std::size_t kLeastForCounts = 5;

struct PhoneVote {
  int answer = 0;      ///< from 1
  int confidence = 0;  ///< 1 to 4; 0: not told
  double seconds = 0.0;
  std::string reason;
};

class ClassBallot {
 public:
  /// Takes the answer of a phone in the vote `round`, 1 or 2, in place of its earlier one; its reason stays.
  void cast(const std::string& token, int round, const PhoneVote& vote);
  /// Takes the reason of a phone that has answered. Returns whether it has.
  bool explain(std::string_view token, int round, std::string words);

  /// Returns the vote of a phone, or null. `round` may be 0: no vote has it.
  const PhoneVote* voteOf(std::string_view token, int round) const;
  std::size_t answered(int round) const;
  /// Returns how often each answer was given, or nothing if there are too few.
  std::optional<VoteCounts> countsOf(int round) const;
  /// Returns all votes of a round with the phones' tokens, in the order of these.
  std::vector<std::pair<std::string, PhoneVote>> votesOf(int round) const;
  bool has(std::string_view token) const { return votes_.contains(token); }

  void clear() { votes_.clear(); }

 private:
  using Votes = std::array<std::optional<PhoneVote>, kVotes>;
  std::map<std::string, Votes, std::less<>> votes_;  ///< by token
};

}  // namespace carom
