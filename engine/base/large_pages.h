#pragma once
// Memory in large pages, for arrays that are read here and there: the processor then finds with few entries
// of its tables where they are.

#ifndef __wasm__  // a page in a browser has one memory, and nothing to advise
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace carom {

/// Allocates `bytes` at an alignment that is a power of two, 2 MiB at most and a cache line at least; of 2
/// MiB and more in pages of that size where the system has some. To be given back by std::free.
inline void* allocateInLargePages(std::size_t bytes, std::size_t alignment) {
  constexpr std::size_t kLine = 64, kPage = std::size_t{1} << 21;
  const std::size_t page = bytes < kPage ? std::max(alignment, kLine) : kPage;
  void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
  if (memory == nullptr) throw std::bad_alloc();
#ifndef __wasm__
  if (page == kPage) madvise(memory, bytes, MADV_HUGEPAGE);  // advice: nothing changes if it is not taken
#endif
  return memory;
}

/// Allocates the arrays of containers so.
template <class T>
struct LargePageAllocator {
  using value_type = T;

  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(allocateInLargePages(count * sizeof(T), alignof(T)));
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
