#include "app/link/line_connection.h"

#include <utility>

namespace carom {
namespace {

constexpr std::uint64_t kFirstPings = 10;
constexpr std::chrono::milliseconds kFirstEvery{50};

std::int64_t nanosecondsOf(LinkClock::time_point now) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now.time_since_epoch()).count();
}

}  // namespace

bool LineConnection::shakeHands(LinkClock::time_point now) {
  const TlsStream::State state = tls_.shakeHands();
  if (state == TlsStream::State::over) end("it has not proven the key");
  isProven_ = state == TlsStream::State::open;
  if (isProven_) at_.begun = at_.heard = now;
  return isProven_;
}

/// Answers a ping, or takes the answer to one's own; returns whether it was one of them.
bool LineConnection::answer(const LinkMessage& message, LinkClock::time_point now) {
  if (const auto* ping = std::get_if<LinkPing>(&message)) {
    if (!isClosing_) append(LinkPong{*ping}, waiting_.bytes);
    return true;
  }
  const auto* pong = std::get_if<LinkPong>(&message);
  if (!pong) return false;
  const double round_s = 1e-9 * static_cast<double>(nanosecondsOf(now) - pong->ping.sent_ns);
  if (pong->ping.number >= pings_ || !(round_s >= 0.0 && round_s < 3600.0))
    throw BrokenLink("it answered a ping that was not sent");
  roundTrips_.add(round_s);
  return true;
}

void LineConnection::look(LinkClock::time_point now, const LinkLimits& limits, bool calls) {
  if (!isProven_) {
    if (now - at_.begun > limits.handshake) end("it has not proven the key in time");
    return;
  }
  // The last words are on their way; the other end closes when it has read them.
  if (shutAt_ && now - *shutAt_ > std::chrono::seconds(1)) end("it was closed here");
  // The first answer may take longer than any silence later.
  const bool isNew = traffic_.receivedBytes == 0;
  const auto silence = !calls  ? limits.listening
                       : isNew ? 2 * limits.silence + limits.handshake
                               : limits.silence;
  if (now - at_.heard > silence)
    end(stream_.isWhole() ? "nothing has come for too long" : "it stopped in the middle of a message");
  if (!calls && !isLetIn_ && now - at_.begun > limits.unknown) end("it has the key, and has not joined");
  const auto every = pings_ < kFirstPings ? std::chrono::duration<double>(kFirstEvery)
                                          : std::chrono::duration<double>(1.0 / limits.pings_1_s);
  if (now - at_.pinged < every || isClosing_) return;
  at_.pinged = now;
  append(LinkPing{pings_++, nanosecondsOf(now)}, waiting_.bytes);
}

void LineConnection::add(std::span<const std::uint8_t> bytes, const LinkLimits& limits) {
  if (waiting_.bytes.size() - waiting_.written + bytes.size() > limits.waitingBytes)
    return end("it takes nothing any more");
  waiting_.bytes.insert(waiting_.bytes.end(), bytes.begin(), bytes.end());
}

void LineConnection::write(const LinkLimits& limits) {
  if (!isProven_ || isOver() || shutAt_) return;
  isCrowded_ = tls_.unsent() > limits.unsentBytes;
  if (!present_.empty() && !isCrowded_ && !isClosing_) {
    waiting_.bytes.insert(waiting_.bytes.end(), present_.begin(), present_.end());
    present_.clear();
  }
  const std::size_t size =
      tls_.write(std::span<const std::uint8_t>(waiting_.bytes).subspan(waiting_.written));
  traffic_.sentBytes += size;
  waiting_.written += size;
  if (waiting_.written == waiting_.bytes.size()) {
    waiting_.bytes.clear();
    waiting_.written = 0;
    if (isClosing_ && !shutAt_) {
      tls_.close();
      shutAt_ = LinkClock::now();
    }
  }
  if (tls_.state() == TlsStream::State::over) end("the line broke");
}

}  // namespace carom
