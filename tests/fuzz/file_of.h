#pragma once
// Bytes as a file, for readers that take a path.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace carom::test {

/// A file of the program's own with these bytes; the next call overwrites it.
inline std::filesystem::path fileOf(const std::uint8_t* bytes, std::size_t size) {
  static const std::filesystem::path folder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
  static const struct File {
    std::filesystem::path path = folder / ("carom-fuzz-" + std::to_string(getpid()) + ".toml");
    ~File() { std::filesystem::remove(path); }
  } file;
  std::ofstream(file.path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  return file.path;
}

}  // namespace carom::test
