#pragma once
// TLS 1.3 by a shared key over a connected socket that never blocks: no certificates, no tickets, no early
// data.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/link/link_key.h"

struct ssl_st;
struct ssl_ctx_st;

namespace carom {

/// The settings of all streams of one end.
class TlsEnd {
 public:
  /// `listens`: this end was called; otherwise it calls. Throws std::runtime_error if OpenSSL refuses.
  TlsEnd(bool listens, const LinkKey& key);

  bool listens() const { return listens_; }

 private:
  friend class TlsStream;
  bool listens_;
  std::array<std::uint8_t, 32> secret_;
  std::unique_ptr<ssl_ctx_st, void (*)(ssl_ctx_st*)> context_;
};

class TlsStream {
 public:
  enum class State { shakesHands, open, over };

  /// Takes the socket, which is closed with this object. `end` must outlive it.
  TlsStream(TlsEnd& end, int socket);
  ~TlsStream();
  TlsStream(const TlsStream&) = delete;
  TlsStream& operator=(const TlsStream&) = delete;

  /// Goes on with the handshake as far as it can. It is over if the other end does not prove the key.
  State shakeHands();
  /// Appends what has arrived. It is over when the other end has closed it or anything on the way has
  /// changed.
  State read(std::vector<std::uint8_t>& into);
  /// Writes as much as the socket takes, and returns how many bytes that were.
  std::size_t write(std::span<const std::uint8_t> bytes);
  /// Says that this end writes no more.
  void close();

  State state() const { return state_; }
  int socket() const { return socket_; }
  /// Returns the number of written bytes that have not been sent yet.
  std::size_t unsent() const;

 private:
  State after(int result);

  int socket_;
  std::unique_ptr<ssl_st, void (*)(ssl_st*)> ssl_;
  State state_ = State::shakesHands;
};

}  // namespace carom
