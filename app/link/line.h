#pragma once
// A line between two rooms as frames see it: news that have come, and messages to be sent.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/link/link_message.h"
#include "app/link/round_trips.h"

namespace carom {

using LinkClock = std::chrono::steady_clock;

/// What the line allows, and for how long it waits.
struct LinkLimits {
  std::chrono::milliseconds handshake{5000};   ///< until the key must be proven
  std::chrono::milliseconds callAgain{2000};   ///< after a call that failed, or a line that broke
  std::chrono::milliseconds silence{2000};     ///< until the one who calls tries anew
  std::chrono::milliseconds listening{12000};  ///< and until the one who listens gives up
  std::chrono::milliseconds unknown{15000};    ///< of a caller who has the key and is not let in
  std::size_t unproven = 4;                    ///< connections at once that have not proven the key
  double calls_1_s = 1.0;                      ///< of one address, once it has called `unproven` times
  double pings_1_s = 2.0;                      ///< beyond the first ten, which come faster
  std::size_t unsentBytes = 2048;              ///< while more is unsent, presents wait and are replaced
  std::size_t waitingBytes = 8 << 20;          ///< of all that waits to be sent; more closes the connection
};

/// What a line has for the frames. Connections are numbered from 1 on.
struct LineNews {
  enum class Kind { opened, message, closed };
  Kind kind = Kind::opened;
  std::uint64_t connection = 0;
  LinkClock::time_point at{};  ///< when it came
  LinkMessage message{};
  std::string words;  ///< closed: why; opened: with whom
};

/// How much a line has carried.
struct LineTraffic {
  std::uint64_t sentBytes = 0, receivedBytes = 0;
};

/// A line as frames see it. No call waits.
class Line {
 public:
  virtual ~Line() = default;

  /// Moves all news into `news`, in their order; of presents that have not been taken the newest alone.
  virtual void take(std::vector<LineNews>& news) = 0;
  /// Sends a message; what has been sent before arrives before it.
  virtual void send(std::uint64_t connection, const LinkMessage& message) = 0;
  /// Sends a present, unless a newer one follows before it can be sent.
  virtual void present(std::uint64_t connection, const LinkPresent& present) = 0;
  /// Sends a reason, then closes the connection.
  virtual void close(std::uint64_t connection, const std::string& reason) = 0;
  virtual RoundTrip roundTrip(std::uint64_t connection) const = 0;
  virtual LineTraffic traffic() const = 0;
};

}  // namespace carom
