#pragma once
// The numbers of a binary file with a mesh.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace carom {

/// Little-endian numbers from the beginning of a text. Throws std::runtime_error, "1:1: …, at byte N", where
/// it ends too early.
class MeshBytes {
 public:
  explicit MeshBytes(std::string_view content, std::size_t at = 0) : content_(content), at_(at) {}

  std::uint8_t byte() { return static_cast<std::uint8_t>(take(1).front()); }
  std::uint32_t whole();
  float number();
  std::string_view take(std::size_t bytes);
  std::size_t at() const { return at_; }
  std::size_t left() const { return content_.size() - at_; }

 private:
  std::string_view content_;
  std::size_t at_;
};

}  // namespace carom
