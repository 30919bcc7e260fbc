// A box between two threads: whole values, the newest first, and none comes back.

#include "devices/force/force_mailbox.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace carom {
namespace {

struct Value {
  std::array<std::uint64_t, 16> parts{};
};

TEST(ForceMailbox, GivesWholeValuesInOrder) {
  ForceMailbox<Value> box;
  constexpr std::uint64_t kLast = 200000;
  std::jthread poster([&] {
    for (std::uint64_t i = 1; i <= kLast; ++i) {
      Value value;
      value.parts.fill(i);
      box.post(value);
    }
  });
  std::uint64_t before = 0, looks = 0;
  while (before < kLast) {
    const Value value = box.look();
    for (const std::uint64_t part : value.parts) ASSERT_EQ(part, value.parts[0]) << "a torn value";
    ASSERT_GE(value.parts[0], before) << "an older value came back";
    before = value.parts[0];
    ++looks;
  }
  EXPECT_GT(looks, 0u);
}

TEST(ForceMailbox, KeepsTheNewestUntilItIsLookedAt) {
  ForceMailbox<int> box;
  EXPECT_EQ(box.look(), 0);
  for (int i = 1; i <= 5; ++i) box.post(i);
  EXPECT_EQ(box.look(), 5);
  EXPECT_EQ(box.look(), 5);
}

}  // namespace
}  // namespace carom
