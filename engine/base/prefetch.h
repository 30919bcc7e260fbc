#pragma once
// Asking for data from memory before they are needed.

#include <cstddef>
#include <cstdint>

namespace carom {

/// Prefetches the cache line of `data` into the second cache, where data prefetched far ahead does not drive
/// out data in use. The empty statement keeps the compiler from leaving out calls of functions that do
/// nothing but this.
inline void prefetch(const void* data) {
  __builtin_prefetch(data, 0, 2);
  asm volatile("");
}

/// Does so with the cache lines of the `size` bytes from `data` on.
inline void prefetch(const void* data, std::size_t size) {
  constexpr std::uintptr_t kLine = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  for (std::uintptr_t line = begin & ~(kLine - 1); line < begin + size; line += kLine)
    prefetch(reinterpret_cast<const void*>(line));
}

}  // namespace carom
