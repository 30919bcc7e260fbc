#pragma once
// One connection of a line: its handshake, the messages that come, and the bytes that wait to be sent.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/link/line.h"
#include "app/link/link_stream.h"
#include "app/link/tls_stream.h"

namespace carom {

class LineConnection {
 public:
  /// `with`: whom it connects to, in words.
  LineConnection(std::uint64_t number, TlsEnd& end, int socket, std::string with, LinkClock::time_point now)
      : number_(number), tls_(end, socket), with_(std::move(with)), at_{now, now, now} {}

  std::uint64_t number() const { return number_; }
  const std::string& with() const { return with_; }
  int socket() const { return tls_.socket(); }
  bool isProven() const { return isProven_; }
  bool isOver() const { return !ended_.empty(); }
  const std::string& ended() const { return ended_; }

  /// Reads what has come, and calls `take(message)` for every message but pings and their answers. Returns
  /// true when the key has just been proven.
  template <typename Take>
  bool read(LinkClock::time_point now, Take&& take);
  /// Ends what has lasted too long, and pings.
  void look(LinkClock::time_point now, const LinkLimits& limits, bool calls);
  /// Sends what waits.
  void write(const LinkLimits& limits);
  /// Whether something waits that the socket did not take.
  bool wantsToWrite() const { return !waiting_.bytes.empty() || (!present_.empty() && !isCrowded_); }

  void add(std::span<const std::uint8_t> bytes, const LinkLimits& limits);
  void setPresent(std::vector<std::uint8_t>& bytes) {
    std::swap(present_, bytes);
    isLetIn_ = true;  // only who plays is told of presents
  }
  void closeAfter() { isClosing_ = true; }
  void end(std::string why) {
    if (ended_.empty()) ended_ = std::move(why);
  }

  const RoundTrip& roundTrip() const { return roundTrips_.now(); }
  LineTraffic traffic() const { return traffic_; }

 private:
  bool shakeHands(LinkClock::time_point now);
  bool answer(const LinkMessage& message, LinkClock::time_point now);

  std::uint64_t number_;
  TlsStream tls_;
  std::string with_, ended_;
  struct Times {
    LinkClock::time_point begun, heard, pinged;
  } at_;  // when it began, was last heard, and last pinged
  bool isProven_ = false, isLetIn_ = false, isClosing_ = false, isCrowded_ = false;
  LinkStream stream_;
  std::vector<std::uint8_t> arrived_, present_;
  struct Waiting {
    std::vector<std::uint8_t> bytes;
    std::size_t written = 0;  ///< of these
  } waiting_;
  std::optional<LinkClock::time_point> shutAt_;  ///< when all was written of one that closes
  std::uint64_t pings_ = 0;
  RoundTrips roundTrips_;
  LineTraffic traffic_;
};

template <typename Take>
bool LineConnection::read(LinkClock::time_point now, Take&& take) try {
  if (!isProven_) return shakeHands(now);
  arrived_.clear();
  const bool isClosed = tls_.read(arrived_) == TlsStream::State::over;
  traffic_.receivedBytes += arrived_.size();
  if (!arrived_.empty()) at_.heard = now;
  stream_.add(arrived_, std::chrono::duration<double>(now.time_since_epoch()).count());
  while (std::optional<LinkMessage> message = stream_.next()) {
    if (!answer(*message, now)) take(*message);
  }
  if (isClosed) end("the line was closed");
  return false;
} catch (const BrokenLink& broken) {
  end(broken.what());
  return false;
}

}  // namespace carom
