#pragma once
// Asking for data from memory before they are needed.

#include <cstddef>

namespace carom {

/// Prefetches `size` bytes from `data` on. The empty statement keeps the compiler from leaving out calls of
/// functions that do nothing but this.
inline void prefetch(const void* data, std::size_t size = 1) {
  for (std::size_t byte = 0; byte < size; byte += 64) {
    __builtin_prefetch(static_cast<const char*>(data) + byte);
    asm volatile("");
  }
}

}  // namespace carom
