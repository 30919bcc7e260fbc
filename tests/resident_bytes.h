#pragma once
// The memory that this process holds.

#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace carom::test {

/// Returns the bytes in memory, after what was freed has been given back to the system.
inline std::size_t residentBytes() {
  malloc_trim(0);
  std::size_t size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace carom::test
