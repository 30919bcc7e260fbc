#include "app/classroom/class_ballot.h"

namespace carom {
namespace {

std::size_t placeOf(int round) { return static_cast<std::size_t>(round - 1); }

}  // namespace

void ClassBallot::cast(const std::string& token, int round, const PhoneVote& vote) {
  std::optional<PhoneVote>& kept = votes_[token].at(placeOf(round));
  const std::string reason = kept ? kept->reason : "";
  kept = vote;
  if (kept->reason.empty()) kept->reason = reason;
}

bool ClassBallot::explain(std::string_view token, int round, std::string words) {
  const auto found = votes_.find(token);
  if (found == votes_.end() || !found->second.at(placeOf(round))) return false;
  found->second.at(placeOf(round))->reason = std::move(words);
  return true;
}

const PhoneVote* ClassBallot::voteOf(std::string_view token, int round) const {
  const auto found = votes_.find(token);
  if (round < 1 || found == votes_.end()) return nullptr;
  const std::optional<PhoneVote>& vote = found->second.at(placeOf(round));
  return vote ? &*vote : nullptr;
}

std::size_t ClassBallot::answered(int round) const {
  std::size_t count = 0;
  for (const auto& [token, votes] : votes_) count += round >= 1 && votes.at(placeOf(round)) ? 1 : 0;
  return count;
}

std::optional<VoteCounts> ClassBallot::countsOf(int round) const {
  if (answered(round) < kLeastForCounts) return {};
  VoteCounts counts{};
  for (const auto& [token, votes] : votes_) {
    if (const auto& vote = votes.at(placeOf(round))) ++counts.at(static_cast<std::size_t>(vote->answer - 1));
  }
  return counts;
}

std::vector<std::pair<std::string, PhoneVote>> ClassBallot::votesOf(int round) const {
  std::vector<std::pair<std::string, PhoneVote>> all;
  for (const auto& [token, votes] : votes_) {
    if (const auto& vote = votes.at(placeOf(round))) all.emplace_back(token, *vote);
  }
  return all;
}

}  // namespace carom
