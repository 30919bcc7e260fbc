#include "app/link/link_socket.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace carom {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

/// Returns the socket addresses of a name or address with its port; if there are none, the reason in `why`.
Addresses addressesOf(const LinkAddress& address, std::string& why) {
  addrinfo hints{};
  hints.ai_family = address.listens && address.host.empty() ? AF_INET6 : AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = address.listens ? AI_PASSIVE : AI_ADDRCONFIG;
  addrinfo* found = nullptr;
  const char* const host = address.host.empty() ? nullptr : address.host.c_str();
  int error = getaddrinfo(host, std::to_string(address.port).c_str(), &hints, &found);
  if (error != 0 && !address.listens) {  // AI_ADDRCONFIG does not know of loopback
    hints.ai_flags = 0;
    error = getaddrinfo(host, std::to_string(address.port).c_str(), &hints, &found);
  }
  if (error != 0) why = gai_strerror(error);
  return {found, freeaddrinfo};
}

void sendAtOnce(int socket) {
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

LinkSocket socketOf(const addrinfo& address) {
  return LinkSocket(
      socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, address.ai_protocol));
}

bool listens(const LinkSocket& socket, const addrinfo& address) {
  const int on = 1, off = 0;
  setsockopt(*socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (address.ai_family == AF_INET6) setsockopt(*socket, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
  constexpr int kWaiting = 16;
  return bind(*socket, address.ai_addr, address.ai_addrlen) == 0 && listen(*socket, kWaiting) == 0;
}

}  // namespace

LinkSocket& LinkSocket::operator=(LinkSocket&& other) noexcept {
  reset();
  number_ = other.release();
  return *this;
}

int LinkSocket::release() { return std::exchange(number_, -1); }

void LinkSocket::reset() {
  if (number_ >= 0) close(number_);
  number_ = -1;
}

LinkSocket listenAt(const LinkAddress& address) {
  std::string why;
  const Addresses addresses = addressesOf(address, why);
  for (const addrinfo* one = addresses.get(); one != nullptr; one = one->ai_next) {
    LinkSocket socket = socketOf(*one);
    if (socket && listens(socket, *one)) return socket;
    why = errno == EADDRINUSE ? "another program has that port, expected a free one" : std::strerror(errno);
  }
  if (address.host.empty() && errno == EAFNOSUPPORT) return listenAt({true, "0.0.0.0", address.port});
  throw std::runtime_error(fmt::format("link: {}: {}", address.text(), why));
}

std::uint16_t portOf(const LinkSocket& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  getsockname(*socket, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                             : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

std::optional<Called> nextCaller(const LinkSocket& listening) {
  sockaddr_storage from{};
  socklen_t size = sizeof from;
  LinkSocket socket(
      accept4(*listening, reinterpret_cast<sockaddr*>(&from), &size, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!socket) return std::nullopt;
  sendAtOnce(*socket);
  std::array<char, NI_MAXHOST> name{};
  getnameinfo(reinterpret_cast<const sockaddr*>(&from), size, name.data(), name.size(), nullptr, 0,
              NI_NUMERICHOST);
  return Called{std::move(socket), name.data()};
}

LinkSocket callTo(const LinkAddress& address, std::size_t attempt, std::string& why) {
  const Addresses addresses = addressesOf(address, why);
  std::size_t count = 0;
  for (const addrinfo* one = addresses.get(); one != nullptr; one = one->ai_next) ++count;
  if (count == 0) return {};
  const addrinfo* chosen = addresses.get();
  for (std::size_t i = 0; i < attempt % count; ++i) chosen = chosen->ai_next;
  LinkSocket socket = socketOf(*chosen);
  if (!socket) {
    why = std::strerror(errno);
    return {};
  }
  sendAtOnce(*socket);
  if (connect(*socket, chosen->ai_addr, chosen->ai_addrlen) == 0 || errno == EINPROGRESS) return socket;
  why = std::strerror(errno);
  return {};
}

std::optional<bool> isAnswered(const LinkSocket& calling, std::string& why) {
  pollfd waits{*calling, POLLOUT, 0};
  if (poll(&waits, 1, 0) == 0) return std::nullopt;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(*calling, SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) why = std::strerror(error);
  return error == 0;
}

}  // namespace carom
