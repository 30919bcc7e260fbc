#include "engine/base/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>

namespace carom {
namespace {

TEST(LargePages, MemoryIsAlignedAndAllOfItCanBeWritten) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{100}, kPage - 1, kPage, 3 * kPage + 5}) {
    for (const std::size_t alignment : {std::size_t{8}, std::size_t{64}, std::size_t{4096}}) {
      const std::unique_ptr<void, void (*)(void*)> memory(allocateInLargePages(bytes, alignment), std::free);
      const std::size_t expected = bytes < kPage ? std::max(alignment, std::size_t{64}) : kPage;
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory.get()) % expected, 0u) << bytes << ", " << alignment;
      std::memset(memory.get(), 7, bytes);
    }
  }
}

TEST(LargePages, AnArrayGrowsAndKeepsItsItems) {
  struct alignas(64) Line {
    int number;
  };
  LargeArray<Line> lines;
  for (int i = 0; i < 100000; ++i) lines.push_back({i});
  const LargeArray<Line> copy = lines;
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(copy[i].number, i);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % 64, 0u);
  EXPECT_TRUE(LargePageAllocator<int>() == LargePageAllocator<double>())
      << "what one takes another gives back";
}

}  // namespace
}  // namespace carom
