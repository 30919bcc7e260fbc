#include "app/study/allocation.h"

#include <algorithm>
#include <utility>

#include "app/tables/json_text.h"

namespace carom {
namespace {

/// The ordered pairs of the forms before and after the lessons, each with the third as the delayed one.
constexpr std::array<std::array<std::size_t, 3>, 6> kFormOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}};

/// Shuffles by Fisher and Yates, from the end.
void shuffle(std::vector<std::size_t>& values, SplitMix64& random) {
  for (std::size_t i = values.size(); i-- > 1;) std::swap(values[i], values[random.below(i + 1)]);
}

/// Returns 0, 1, …, n − 1, 0, 1, … up to a length, shuffled.
std::vector<std::size_t> shuffledCycle(std::size_t n, std::size_t length, SplitMix64& random) {
  std::vector<std::size_t> values(length);
  for (std::size_t i = 0; i < length; ++i) values[i] = i % n;
  shuffle(values, random);
  return values;
}

/// Returns the arm of each participant, in shuffled blocks of two of each arm.
std::vector<std::size_t> armsOf(const Study& study, SplitMix64& random) {
  std::vector<std::size_t> arms;
  while (arms.size() < study.participants) {
    std::vector<std::size_t> block;
    for (std::size_t arm = 0; arm < study.arms.size(); ++arm) block.insert(block.end(), 2, arm);
    shuffle(block, random);
    arms.insert(arms.end(), block.begin(), block.end());
  }
  arms.resize(study.participants);
  return arms;
}

}  // namespace

std::uint64_t SplitMix64::next() {
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

std::uint64_t SplitMix64::below(std::uint64_t n) {
  // The last 2^64 mod n numbers would make some results likelier: they are drawn again.
  const std::uint64_t excess = (0 - n) % n, last = ~excess;  // last = 2^64 − 1 − excess
  std::uint64_t x = next();
  while (x > last) x = next();
  return x % n;
}

std::vector<std::vector<std::size_t>> williamsRows(std::size_t n) {
  std::vector<std::vector<std::size_t>> rows(n);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t place = 0; place < n; ++place) {
      const std::size_t first = place % 2 == 1 ? (place + 1) / 2 : (n - place / 2) % n;
      rows[r].push_back((first + r) % n);
    }
  }
  if (n % 2 == 0) return rows;
  for (std::size_t r = 0; r < n; ++r) rows.emplace_back(rows[r].rbegin(), rows[r].rend());
  return rows;
}

std::vector<Participant> allocate(const Study& study) {
  SplitMix64 random(study.seed);
  std::vector<Participant> all(study.participants);
  const std::vector<std::size_t> arms = armsOf(study, random);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].number = i + 1;
    all[i].arm = arms[i];
    for (std::size_t lesson = 0; lesson < study.lessons.size(); ++lesson) all[i].lessons.push_back(lesson);
  }
  const std::vector<std::vector<std::size_t>> rows = williamsRows(study.lessons.size());
  for (std::size_t arm = 0; arm < study.arms.size(); ++arm) {
    std::vector<Participant*> members;
    for (Participant& one : all) {
      if (one.arm == arm) members.push_back(&one);
    }
    if (!study.hasFixedOrder) {
      const std::vector<std::size_t> row = shuffledCycle(rows.size(), members.size(), random);
      for (std::size_t i = 0; i < members.size(); ++i) {
        members[i]->orderRow = row[i];
        members[i]->lessons = rows[row[i]];
      }
    }
    if (!study.hasFixedForms) {
      const std::vector<std::size_t> order = shuffledCycle(kFormOrders.size(), members.size(), random);
      for (std::size_t i = 0; i < members.size(); ++i) members[i]->forms = kFormOrders[order[i]];
    }
  }
  return all;
}

std::string planJson(const Study& study, const std::vector<Participant>& participants) {
  Json rows = Json::array();
  for (const Participant& one : participants) {
    Json lessons = Json::array(), forms = Json::array();
    for (const std::size_t lesson : one.lessons) lessons.push_back(study.lessons[lesson].name);
    for (const std::size_t form : one.forms) forms.push_back(kForms[form]);
    rows.push_back({{"number", one.number},
                    {"arm", study.arms[one.arm].name},
                    {"order_row", one.orderRow},
                    {"lessons", lessons},
                    {"forms", forms}});
  }
  return jsonText({{"sha256", study.sha256}, {"participants", rows}});
}

}  // namespace carom
