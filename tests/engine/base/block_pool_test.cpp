#include "engine/base/block_pool.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>

#include "engine/random_world.h"

namespace carom {
namespace {

// Many blocks at once, given back in any order: none overlaps another, and each keeps what was written to it.
TEST(BlockPool, BlocksKeepWhatIsWrittenToThem) {
  test::Random random(51);
  BlockPool pool;
  pool.buy(10000);
  struct Block {
    std::size_t bytes;
    unsigned char sign;
  };
  std::map<unsigned char*, Block> held;
  std::size_t most = 0;
  for (int step = 0; step < 20000; ++step) {
    if (held.size() < 500 && random.in(0.0, 1.0) < 0.6) {
      const std::size_t bytes =
          1 + static_cast<std::size_t>(random.in(0.0, 1500.0));  // also beyond small ones
      auto* const memory = static_cast<unsigned char*>(pool.allocate(bytes, 16));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % 16, 0u);
      const auto after = held.lower_bound(memory);
      if (after != held.end()) {
        ASSERT_LE(memory + bytes, after->first);
      }
      if (after != held.begin()) {
        const auto before = std::prev(after);
        ASSERT_LE(before->first + before->second.bytes, memory);
      }
      const auto sign = static_cast<unsigned char>(step);
      std::fill_n(memory, bytes, sign);
      held[memory] = {bytes, sign};
      most = std::max(most, held.size());
    } else if (!held.empty()) {
      const auto chosen = std::next(
          held.begin(), static_cast<std::ptrdiff_t>(random.in(0.0, static_cast<double>(held.size()))));
      const auto [memory, block] = *chosen;
      for (std::size_t k = 0; k < block.bytes; ++k) ASSERT_EQ(memory[k], block.sign);
      pool.deallocate(memory, block.bytes, 16);
      held.erase(chosen);
    }
  }
  EXPECT_GT(most, 100u);
  for (const auto& [memory, block] : held) pool.deallocate(memory, block.bytes, 16);
}

TEST(BlockPool, ABlockThatIsGivenBackIsUsedForTheNextOfItsSize) {
  BlockPool pool;
  void* const first = pool.allocate(96);
  void* const second = pool.allocate(96);
  pool.deallocate(first, 96);
  EXPECT_NE(pool.allocate(200), first);
  EXPECT_EQ(pool.allocate(90), first) << "the same size, up to a step";
  EXPECT_NE(second, first);
}

TEST(BlockPool, MemoryThatWasBoughtComesFirst) {
  BlockPool pool;
  pool.buy(64 * 100);
  auto* last = static_cast<std::byte*>(pool.allocate(64));
  for (int k = 1; k < 100; ++k) {
    auto* const next = static_cast<std::byte*>(pool.allocate(64));
    EXPECT_EQ(next, last + 64);
    last = next;
  }
}

}  // namespace
}  // namespace carom
