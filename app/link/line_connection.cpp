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
  if (isProven_) begun_ = heard_ = now;
  return isProven_;
}

/// Answers a ping, or takes the answer to one's own; returns whether it was one of them.
bool LineConnection::answer(const LinkMessage& message, LinkClock::time_point now) {
  if (const auto* ping = std::get_if<LinkPing>(&message)) {
    if (!isClosing_) append(LinkPong{*ping}, waiting_);
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
    if (now - begun_ > limits.handshake) end("it has not proven the key in time");
    return;
  }
  // The last words are on their way; the other end closes when it has read them.
  if (shutAt_ && now - *shutAt_ > std::chrono::seconds(1)) end("it was closed here");
  // The first answer may take longer than any silence later.
  const bool isNew = traffic_.receivedBytes == 0;
  const auto silence = !calls  ? limits.listening
                       : isNew ? 2 * limits.silence + limits.handshake
                               : limits.silence;
  if (now - heard_ > silence)
    end(stream_.isWhole() ? "nothing has come for too long" : "it stopped in the middle of a message");
  if (!calls && !isLetIn_ && now - begun_ > limits.unknown) end("it has the key, and has not joined");
  const auto every = pings_ < kFirstPings ? std::chrono::duration<double>(kFirstEvery)
                                          : std::chrono::duration<double>(1.0 / limits.pings_1_s);
  if (now - pinged_ < every || isClosing_) return;
  pinged_ = now;
  append(LinkPing{pings_++, nanosecondsOf(now)}, waiting_);
}

void LineConnection::add(std::span<const std::uint8_t> bytes, const LinkLimits& limits) {
  if (waiting_.size() - written_ + bytes.size() > limits.waitingBytes)
    return end("it takes nothing any more");
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
}

void LineConnection::write(const LinkLimits& limits) {
  if (!isProven_ || isOver() || shutAt_) return;
  isCrowded_ = tls_.unsent() > limits.unsentBytes;
  if (!present_.empty() && !isCrowded_ && !isClosing_) {
    waiting_.insert(waiting_.end(), present_.begin(), present_.end());
    present_.clear();
  }
  const std::size_t size = tls_.write(std::span<const std::uint8_t>(waiting_).subspan(written_));
  traffic_.sentBytes += size;
  written_ += size;
  if (written_ == waiting_.size()) {
    waiting_.clear();
    written_ = 0;
    if (isClosing_ && !shutAt_) {
      tls_.close();
      shutAt_ = LinkClock::now();
    }
  }
  if (tls_.state() == TlsStream::State::over) end("the line broke");
}

}  // namespace carom
