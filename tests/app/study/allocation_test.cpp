// The allocation of participants: a generator that is the same everywhere, and balanced orders, arms and
// forms.
#include "app/study/allocation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/tables/json_text.h"

namespace carom {
namespace {

// The first numbers of the authors' own program, splitmix64.c, from the seed 1234567.
TEST(Allocation, TheGeneratorIsSplitMix64) {
  SplitMix64 random(1234567);
  for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                       4593380528125082431U, 16408922859458223821U})
    EXPECT_EQ(random.next(), expected);
}

TEST(Allocation, NumbersBelowABoundAreEquallyLikely) {
  constexpr int kDraws = 60000;
  for (const std::uint64_t n : {1U, 2U, 3U, 7U}) {
    SCOPED_TRACE(n);
    SplitMix64 random(3);
    std::map<std::uint64_t, int> counts;
    for (int i = 0; i < kDraws; ++i) ++counts[random.below(n)];
    EXPECT_EQ(counts.size(), n);
    EXPECT_LT(counts.rbegin()->first, n);
    const double mean = kDraws / static_cast<double>(n);
    for (const auto& [number, count] : counts) EXPECT_NEAR(count, mean, 5.0 * std::sqrt(mean)) << number;
  }
}

TEST(Allocation, InAWilliamsSquareEachLessonStandsAndFollowsEquallyOften) {
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 10U}) {
    SCOPED_TRACE(n);
    const auto rows = williamsRows(n);
    ASSERT_EQ(rows.size(), n % 2 == 0 ? n : 2 * n);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> stands, follows;
    for (const auto& row : rows) {
      EXPECT_EQ(std::set<std::size_t>(row.begin(), row.end()).size(), n) << "a lesson twice";
      ASSERT_EQ(row.size(), n);
      for (std::size_t place = 0; place < n; ++place) {
        ++stands[{place, row[place]}];
        if (place > 0) ++follows[{row[place - 1], row[place]}];
      }
    }
    EXPECT_EQ(stands.size(), n * n);
    EXPECT_EQ(follows.size(), n * (n - 1)) << "each lesson follows each other one";
    for (const auto& [at, count] : stands) EXPECT_EQ(count, rows.size() / n);
    for (const auto& [pair, count] : follows) EXPECT_EQ(count, rows.size() / n);
  }
  EXPECT_EQ(williamsRows(4)[0], (std::vector<std::size_t>{0, 1, 3, 2}));
}

Study studyOf(std::uint64_t seed, std::size_t participants, std::size_t lessons) {
  Study study;
  study.seed = seed;
  study.participants = participants;
  study.sha256 = "abc";
  study.arms.resize(3);
  for (std::size_t i = 0; i < 3; ++i) study.arms[i].name = "arm" + std::to_string(i);
  for (std::size_t i = 0; i < lessons; ++i) study.lessons.push_back({"lesson" + std::to_string(i), {}});
  return study;
}

/// Returns how often the rarest and the most frequent of `of` stand there, of `kinds` that there are.
std::pair<std::size_t, std::size_t> rangeOf(const std::map<std::size_t, std::size_t>& counts,
                                            std::size_t kinds) {
  std::size_t least = counts.size() < kinds ? 0 : counts.begin()->second, most = 0;
  for (const auto& [kind, count] : counts) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  return {least, most};
}

TEST(Allocation, ArmsOrdersAndFormsAreBalanced) {
  for (const std::uint64_t seed : {1U, 2U, 99U}) {
    SCOPED_TRACE(seed);
    const Study study = studyOf(seed, 75, 4);
    const auto all = allocate(study);
    ASSERT_EQ(all.size(), 75U);
    for (std::size_t block = 0; block + 6 <= all.size(); block += 6) {
      std::map<std::size_t, std::size_t> arms;
      for (std::size_t i = block; i < block + 6; ++i) ++arms[all[i].arm];
      EXPECT_EQ(rangeOf(arms, 3), std::pair(std::size_t{2}, std::size_t{2})) << "two of each arm in six";
    }
    const auto rows = williamsRows(4);
    for (std::size_t arm = 0; arm < 3; ++arm) {
      std::map<std::size_t, std::size_t> orders, forms;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Participant& one = all[i];
        EXPECT_EQ(one.number, i + 1);
        EXPECT_EQ(one.lessons, rows.at(one.orderRow));
        EXPECT_EQ((std::set<std::size_t>(one.forms.begin(), one.forms.end())),
                  (std::set<std::size_t>{0, 1, 2}));
        if (one.arm != arm) continue;
        ++orders[one.orderRow];
        ++forms[one.forms[0] * 3 + one.forms[1]];
      }
      const auto [fewestOrders, mostOrders] = rangeOf(orders, rows.size());
      EXPECT_LE(mostOrders - fewestOrders, 1U);
      const auto [fewestForms, mostForms] = rangeOf(forms, 6);
      EXPECT_LE(mostForms - fewestForms, 1U);
    }
  }
}

TEST(Allocation, FollowsFromTheSeedAndIsToldAsJson) {
  Study study = studyOf(5, 12, 2);
  const std::string plan = planJson(study, allocate(study));
  EXPECT_EQ(plan, planJson(study, allocate(study)));
  study.seed = 6;
  EXPECT_NE(plan, planJson(study, allocate(study)));
  study.hasFixedOrder = study.hasFixedForms = true;
  const auto fixed = allocate(study);
  for (const Participant& one : fixed) {
    EXPECT_EQ(one.lessons, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(one.forms, (std::array<std::size_t, 3>{0, 1, 2}));
    EXPECT_EQ(one.orderRow, 0U);
  }
  const Json told = Json::parse(planJson(study, fixed));
  EXPECT_EQ(told.at("sha256"), "abc");
  ASSERT_EQ(told.at("participants").size(), 12U);
  const Json& last = told.at("participants")[11];
  EXPECT_EQ(last.at("number"), 12);
  EXPECT_EQ(last.at("arm"), study.arms[fixed[11].arm].name);
  EXPECT_EQ(last.at("lessons"), Json::array({"lesson0", "lesson1"}));
  EXPECT_EQ(last.at("forms"), Json::array({"A", "B", "C"}));
}

}  // namespace
}  // namespace carom
