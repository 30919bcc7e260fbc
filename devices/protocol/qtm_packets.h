#pragma once
// Packets of the real-time protocol of Qualisys Track Manager (QTM), in its version 1.19 and its
// little-endian form: a size, a type, and what follows.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

struct QtmPacket {
  enum class Type : std::uint32_t { error = 0, command = 1, xml = 2, data = 3, noMoreData = 4, event = 6 };
  Type type = Type::error;                ///< other numbers occur, too
  std::span<const std::uint8_t> content;  ///< without the header; valid until the next call
  /// Returns the content up to its first zero.
  std::string_view text() const;
};

/// Cuts what comes on a connection into packets.
class QtmPackets {
 public:
  void add(std::span<const std::uint8_t> bytes);
  /// Returns the next packet; none if it is not complete yet. Throws std::runtime_error, which says the
  /// fault, if its size is below that of a header or above kMostBytes.
  std::optional<QtmPacket> next();

  static constexpr std::size_t kMostBytes = 4 << 20;  ///< of a packet; the lists of hundreds of bodies fit

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t read_ = 0;
};

/// Returns the packet of a command.
std::vector<std::uint8_t> qtmCommand(std::string_view command);

}  // namespace carom
