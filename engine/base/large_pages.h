#pragma once
// Memory in large pages, for arrays that are read here and there: the processor then finds with few entries
// of its tables where they are.

#include <sys/mman.h>
#include <algorithm>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace carom {

/// Allocates arrays, of 2 MiB and more in pages of that size where the system has some.
template <class T>
struct LargePageAllocator {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t{1} << 21;

  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    const std::size_t page = bytes < kPage ? std::max(alignof(T), std::size_t{64}) : kPage;
    void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (memory == nullptr) throw std::bad_alloc();
    if (page == kPage) madvise(memory, bytes, MADV_HUGEPAGE);  // advice: nothing changes if it is not taken
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <class U>
  bool operator==(const LargePageAllocator<U>&) const {
    return true;
  }
};

/// An array in large pages.
template <class T>
using LargeArray = std::vector<T, LargePageAllocator<T>>;

}  // namespace carom
