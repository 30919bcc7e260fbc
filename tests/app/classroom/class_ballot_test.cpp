// The votes on one question: one a phone in each vote, and no counts of a few.
#include "app/classroom/class_ballot.h"

#include <gtest/gtest.h>

#include <string>

namespace carom {
namespace {

TEST(ClassBallot, TheLastAnswerCountsAndAReasonStays) {
  ClassBallot ballot;
  EXPECT_FALSE(ballot.explain("a", 1, "too early"));
  ballot.cast("a", 1, {2, 4, 3.5, ""});
  EXPECT_FALSE(ballot.explain("a", 2, "of a vote without an answer"));
  EXPECT_TRUE(ballot.explain("a", 1, "because"));
  ballot.cast("a", 1, {3, 1, 7.25, ""});
  const PhoneVote* vote = ballot.voteOf("a", 1);
  ASSERT_TRUE(vote);
  EXPECT_EQ(vote->answer, 3);
  EXPECT_EQ(vote->confidence, 1);
  EXPECT_EQ(vote->seconds, 7.25);
  EXPECT_EQ(vote->reason, "because");
  EXPECT_EQ(ballot.answered(1), 1U);
  EXPECT_EQ(ballot.answered(2) + ballot.answered(0), 0U);
  EXPECT_EQ(ballot.voteOf("a", 2), nullptr);
  EXPECT_EQ(ballot.voteOf("a", 0), nullptr);
  EXPECT_EQ(ballot.voteOf("b", 1), nullptr);
  EXPECT_TRUE(ballot.has("a"));
  EXPECT_FALSE(ballot.has("b"));
  ballot.clear();
  EXPECT_FALSE(ballot.has("a"));
}

TEST(ClassBallot, CountsEachVoteByItselfOnceThereAreEnough) {
  ClassBallot ballot;
  for (std::size_t phone = 0; phone < kLeastForCounts + 2; ++phone) {
    SCOPED_TRACE(phone);
    const std::string token = "phone " + std::to_string(9 - phone);
    EXPECT_EQ(ballot.countsOf(1).has_value(), phone >= kLeastForCounts);
    ballot.cast(token, 1, {static_cast<int>(1 + phone % 3), 0, 1.0, ""});
    if (phone % 2 == 0) ballot.cast(token, 2, {1, 0, 1.0, ""});
  }
  const auto counts = ballot.countsOf(1);  // 7 phones: answers 1 2 3 1 2 3 1
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->at(0), 3U);
  EXPECT_EQ(counts->at(1), 2U);
  EXPECT_EQ(counts->at(2), 2U);
  EXPECT_EQ(ballot.answered(2), 4U);
  EXPECT_FALSE(ballot.countsOf(2)) << "four would tell what single students answered";
  const auto votes = ballot.votesOf(2);
  ASSERT_EQ(votes.size(), 4U);
  EXPECT_EQ(votes[0].first + votes[3].first, "phone 3phone 9") << "in the order of their tokens";
}

}  // namespace
}  // namespace carom
