#include "app/link/tls_stream.h"

#include <linux/sockios.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace carom {
namespace {

constexpr unsigned char kName[] = "carom";  // of the key, as the ends tell each other
constexpr std::size_t kNameSize = sizeof kName - 1;

/// Returns the session that the shared key stands for: TLS 1.3 with a hash of SHA-256.
SSL_SESSION* sessionOf(SSL* ssl) {
  const auto& secret = *static_cast<const std::array<std::uint8_t, 32>*>(SSL_get_app_data(ssl));
  static const unsigned char kAes128[] = {0x13, 0x01};  // TLS_AES_128_GCM_SHA256 (RFC 8446, B.4)
  SSL_SESSION* session = SSL_SESSION_new();
  SSL_SESSION_set1_master_key(session, secret.data(), secret.size());
  SSL_SESSION_set_cipher(session, SSL_CIPHER_find(ssl, kAes128));
  SSL_SESSION_set_protocol_version(session, TLS1_3_VERSION);
  return session;
}

/// Offers the key, as the end that calls.
int offer(SSL* ssl, const EVP_MD* hash, const unsigned char** name, std::size_t* size,
          SSL_SESSION** session) {
  *name = kName;
  *size = kNameSize;
  *session = hash == nullptr || EVP_MD_get_type(hash) == NID_sha256 ? sessionOf(ssl) : nullptr;
  return 1;
}

/// Finds the key of that name, as the end that was called.
int find(SSL* ssl, const unsigned char* name, std::size_t size, SSL_SESSION** session) {
  *session = size == kNameSize && std::memcmp(name, kName, size) == 0 ? sessionOf(ssl) : nullptr;
  return 1;
}

}  // namespace

TlsEnd::TlsEnd(bool listens, const LinkKey& key)
    : listens_(listens),
      secret_(key.secret()),
      context_(SSL_CTX_new(listens ? TLS_server_method() : TLS_client_method()), SSL_CTX_free) {
  SSL_CTX* const context = context_.get();
  const bool isSet =
      context != nullptr && SSL_CTX_set_min_proto_version(context, TLS1_3_VERSION) == 1 &&
      SSL_CTX_set_max_proto_version(context, TLS1_3_VERSION) == 1 &&
      SSL_CTX_set_num_tickets(context, 0) == 1 && SSL_CTX_set1_groups_list(context, "X25519") == 1 &&
      SSL_CTX_set_ciphersuites(context, "TLS_AES_128_GCM_SHA256:TLS_CHACHA20_POLY1305_SHA256") == 1;
  if (!isSet) throw std::runtime_error("OpenSSL does not offer TLS 1.3 as a link needs it");
  SSL_CTX_set_options(context, SSL_OP_NO_TICKET | SSL_OP_NO_COMPRESSION | SSL_OP_NO_RENEGOTIATION);
  SSL_CTX_set_mode(context, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  // A certificate in the place of the key is not accepted.
  if (!listens) SSL_CTX_set_verify(context, SSL_VERIFY_PEER, nullptr);
}

TlsStream::TlsStream(TlsEnd& end, int socket) : socket_(socket), ssl_(SSL_new(end.context_.get()), SSL_free) {
  if (!ssl_) throw std::runtime_error("OpenSSL has no memory for a link");
  SSL_set_app_data(ssl_.get(), &end.secret_);
  if (end.listens()) {
    SSL_set_psk_find_session_callback(ssl_.get(), find);
    SSL_set_accept_state(ssl_.get());
  } else {
    SSL_set_psk_use_session_callback(ssl_.get(), offer);
    SSL_set_connect_state(ssl_.get());
  }
  SSL_set_fd(ssl_.get(), socket);
}

TlsStream::~TlsStream() { ::close(socket_); }

/// Judges what a call of OpenSSL returned that did not succeed.
TlsStream::State TlsStream::after(int result) {
  const int why = SSL_get_error(ssl_.get(), result);
  if (why != SSL_ERROR_WANT_READ && why != SSL_ERROR_WANT_WRITE) state_ = State::over;
  return state_;
}

TlsStream::State TlsStream::shakeHands() {
  if (state_ != State::shakesHands) return state_;
  ERR_clear_error();
  const int result = SSL_do_handshake(ssl_.get());
  if (result != 1) return after(result);
  state_ = SSL_session_reused(ssl_.get()) == 1 ? State::open : State::over;  // by the key, not otherwise
  return state_;
}

TlsStream::State TlsStream::read(std::vector<std::uint8_t>& into) {
  constexpr std::size_t kPiece = 16384;  // a record of TLS holds no more
  while (state_ == State::open) {
    ERR_clear_error();
    const std::size_t had = into.size();
    into.resize(had + kPiece);
    const int size = SSL_read(ssl_.get(), into.data() + had, static_cast<int>(kPiece));
    into.resize(had + static_cast<std::size_t>(std::max(size, 0)));
    if (size <= 0) {
      after(size);
      break;
    }
    if (SSL_pending(ssl_.get()) == 0) break;
  }
  return state_;
}

std::size_t TlsStream::write(std::span<const std::uint8_t> bytes) {
  std::size_t written = 0;
  while (state_ == State::open && written < bytes.size()) {
    ERR_clear_error();
    const int size = SSL_write(ssl_.get(), bytes.data() + written, static_cast<int>(bytes.size() - written));
    if (size <= 0) {
      after(size);
      break;
    }
    written += static_cast<std::size_t>(size);
  }
  return written;
}

void TlsStream::close() {
  if (state_ != State::open) return;
  ERR_clear_error();
  SSL_shutdown(ssl_.get());
  shutdown(socket_, SHUT_WR);
}

std::size_t TlsStream::unsent() const {
  int size = 0;
  return ioctl(socket_, SIOCOUTQNSD, &size) == 0 && size > 0 ? static_cast<std::size_t>(size) : 0;
}

}  // namespace carom
