#pragma once
// Memory for many small arrays of few sizes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <memory_resource>
#include <utility>
#include <vector>

#include "engine/base/large_pages.h"

namespace carom {

/// Small blocks lie side by side, in large pages where there are many. A block that is given back is kept for
/// the next one of its size.
class BlockPool : public std::pmr::memory_resource {
 public:
  /// Takes memory from the system for the next `bytes` bytes of blocks. Memory that is used for the first
  /// time costs time.
  void buy(std::size_t bytes) {
    newRegion(bytes);
    std::memset(next_, 0, bytes);
  }

 private:
  static constexpr std::size_t kStep = alignof(std::max_align_t), kLargest = 1024;
  static constexpr std::size_t kFirstRegion = std::size_t{1} << 16, kLargestRegion = std::size_t{1} << 24;
  struct FreeBlock {
    FreeBlock* next;
  };
  struct FreeMemory {
    void operator()(void* memory) const { std::free(memory); }
  };

  static bool isSmall(std::size_t bytes, std::size_t alignment) {
    return bytes <= kLargest && alignment <= kStep;
  }
  FreeBlock*& freeOf(std::size_t bytes) { return free_[(bytes + kStep - 1) / kStep]; }

  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    if (!isSmall(bytes, alignment)) return allocateInLargePages(bytes, alignment);
    FreeBlock*& free = freeOf(bytes);
    if (free != nullptr) return std::exchange(free, free->next);
    const std::size_t size = (bytes + kStep - 1) / kStep * kStep;
    if (size > left_) newRegion(std::clamp(bought_, kFirstRegion, kLargestRegion));
    left_ -= size;
    return std::exchange(next_, next_ + size);
  }
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
    if (!isSmall(bytes, alignment)) return std::free(memory);
    FreeBlock*& free = freeOf(bytes);
    free = new (memory) FreeBlock{free};
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

  void newRegion(std::size_t bytes) {
    regions_.emplace_back(static_cast<std::byte*>(allocateInLargePages(bytes, kStep)));
    next_ = regions_.back().get();
    left_ = bytes;
    bought_ += bytes;
  }

  std::vector<std::unique_ptr<std::byte, FreeMemory>> regions_;
  std::byte* next_ = nullptr;  // the rest of the last region
  std::size_t left_ = 0;
  std::size_t bought_ = 0;
  std::array<FreeBlock*, kLargest / kStep + 1> free_{};  // by size
};

}  // namespace carom
