#include "counted_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {
std::atomic<std::size_t> count{0};
std::atomic<std::size_t> held{0};
}  // namespace

void* operator new(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  ++count;
  held += malloc_usable_size(memory);
  return memory;
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) throw std::bad_alloc();
  ++count;
  held += malloc_usable_size(memory);
  return memory;
}

void operator delete(void* memory) noexcept {
  held -= malloc_usable_size(memory);  // 0 for nullptr
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { operator delete(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { operator delete(memory); }

namespace carom::test {
std::size_t allocationCount() { return count; }
std::size_t bytesHeld() { return held; }
}  // namespace carom::test

/// For a program into which this is loaded before others (LD_PRELOAD).
extern "C" __attribute__((visibility("default"))) std::size_t caromAllocationCount() { return count; }
