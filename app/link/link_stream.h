#pragma once
// The messages in what comes over a line, piece by piece, and how many are too many.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/link/link_message.h"

namespace carom {

/// No room that plays sends more in a second.
inline constexpr double kMostMessages_1_s = 120.0, kMostBytes_1_s = 256 << 10;
/// For so long it may.
inline constexpr double kFloods_s = 2.0;

/// Cuts bytes into messages. Holds at most one message that is not whole.
class LinkStream {
 public:
  /// Adds what has arrived at `now_s` of any clock that never runs back. Throws BrokenLink if it comes too
  /// fast for too long: more than 120 messages or 256 kB a second for 2 s. One welcome is not counted.
  void add(std::span<const std::uint8_t> bytes, double now_s);

  /// Returns the next whole message; none if there is none yet. Throws BrokenLink as linkMessageOf does.
  std::optional<LinkMessage> next();

  /// Returns whether all that has come was whole messages.
  bool isWhole() const { return taken_ == bytes_.size(); }

 private:
  /// A bucket that fills with what comes and runs out at the rate that is allowed.
  struct Bucket {
    double most_1_s;
    double content = 0.0;
    double at_s = 0.0;
    void put(double amount, double now_s);
  };

  std::vector<std::uint8_t> bytes_;
  std::size_t taken_ = 0;  ///< of `bytes_`
  double now_s_ = 0.0;
  bool isWelcomed_ = false;
  Bucket messages_{kMostMessages_1_s}, size_{kMostBytes_1_s};
};

}  // namespace carom
