#include "cave/mesh_files/mesh_bytes.h"

#include <bit>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"

namespace carom {

std::string_view MeshBytes::take(std::size_t bytes) {
  if (at_ > content_.size() || content_.size() - at_ < bytes)
    meshFault(1, 1,
              fmt::format("the file has {} bytes and ends early, expected {} more at byte {}",
                          content_.size(), bytes, at_));
  at_ += bytes;
  return content_.substr(at_ - bytes, bytes);
}

std::uint32_t MeshBytes::whole() {
  std::uint32_t value = 0;
  const std::string_view raw = take(4);
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(raw[i]);
  return value;
}

float MeshBytes::number() { return std::bit_cast<float>(whole()); }

}  // namespace carom
