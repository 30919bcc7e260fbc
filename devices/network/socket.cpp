#include "devices/network/socket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

constexpr std::chrono::seconds kConnectFor{3};

std::string reason(int error) { return std::generic_category().message(error); }

std::string toString(Ipv4 address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  const in_addr network{htonl(address.address)};
  inet_ntop(AF_INET, &network, text.data(), text.size());
  return std::string(text.data()) + ':' + std::to_string(address.port);
}

sockaddr_in toSystem(Ipv4 address) {
  sockaddr_in system{};
  system.sin_family = AF_INET;
  system.sin_port = htons(address.port);
  system.sin_addr.s_addr = htonl(address.address);
  return system;
}

Ipv4 fromSystem(const sockaddr_in& system) { return {ntohl(system.sin_addr.s_addr), ntohs(system.sin_port)}; }

const sockaddr* generic(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

/// Asks the system for a name's address, which can take it many seconds.
std::optional<std::uint32_t> lookUp(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &wanted, &found) != 0) return {};
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, &freeaddrinfo);
  return fromSystem(*reinterpret_cast<const sockaddr_in*>(found->ai_addr)).address;
}

}  // namespace

std::string toString(const Endpoint& endpoint) { return endpoint.host + ':' + std::to_string(endpoint.port); }

std::optional<std::uint32_t> ipv4Of(const std::string& numbers) {
  in_addr address{};
  if (inet_pton(AF_INET, numbers.c_str(), &address) != 1) return {};
  return ntohl(address.s_addr);
}

Ipv4 resolve(const Endpoint& endpoint, const std::stop_token& stop) {
  if (const auto address = ipv4Of(endpoint.host)) return {*address, endpoint.port};
  // On a thread of its own, which may outlive the wish for it: the system's look-up cannot be stopped.
  std::packaged_task<std::optional<std::uint32_t>()> task([host = endpoint.host] { return lookUp(host); });
  std::future<std::optional<std::uint32_t>> answer = task.get_future();
  std::thread(std::move(task)).detach();
  while (answer.wait_for(kLookAtStop) != std::future_status::ready) {
    if (stop.stop_requested()) throw std::runtime_error("stopped");
  }
  const auto address = answer.get();
  if (!address) throw std::runtime_error("no machine '" + endpoint.host + "' is known here");
  return {*address, endpoint.port};
}

Socket::Socket(int type) : descriptor_(socket(AF_INET, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  if (descriptor_ < 0) throw std::runtime_error("no socket: " + reason(errno));
}

Socket::Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

Socket::~Socket() {
  if (descriptor_ >= 0) close(descriptor_);
}

void Socket::set(int level, int option, int value) {
  setsockopt(descriptor_, level, option, &value, sizeof value);
}

Socket Socket::connectedTo(Ipv4 server, const std::stop_token& stop) {
  const auto refuse = [&](int error) {
    throw std::runtime_error("no connection to " + toString(server) + ": " + reason(error));
  };
  Socket socket(SOCK_STREAM);
  socket.set(IPPROTO_TCP, TCP_NODELAY, 1);
  socket.set(SOL_SOCKET, SO_KEEPALIVE, 1);
  socket.set(IPPROTO_TCP, TCP_KEEPIDLE, 2);
  socket.set(IPPROTO_TCP, TCP_KEEPINTVL, 1);
  socket.set(IPPROTO_TCP, TCP_KEEPCNT, 3);
  const sockaddr_in address = toSystem(server);
  if (connect(socket.descriptor_, generic(address), sizeof address) == 0) return socket;
  if (errno != EINPROGRESS) refuse(errno);
  const auto end = std::chrono::steady_clock::now() + kConnectFor;
  pollfd waiting{socket.descriptor_, POLLOUT, 0};
  while (poll(&waiting, 1, static_cast<int>(kLookAtStop.count())) <= 0) {
    if (stop.stop_requested()) throw std::runtime_error("stopped");
    if (std::chrono::steady_clock::now() > end) refuse(ETIMEDOUT);
  }
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket.descriptor_, SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) refuse(error);
  return socket;
}

Socket Socket::boundTo(Ipv4 local, std::uint32_t interface) {
  Socket socket(SOCK_DGRAM);
  const bool isGroup = local.isGroup();
  if (isGroup) {
    socket.set(SOL_SOCKET, SO_REUSEADDR, 1);  // other programs may listen to the same group
    socket.set(IPPROTO_IP, IP_MULTICAST_ALL, 0);
  }
  const sockaddr_in address = toSystem(local);
  if (bind(socket.descriptor_, generic(address), sizeof address) != 0) {
    const std::string what = "cannot listen at " + toString(local) + ": " + reason(errno);
    throw NeedsHelp(
        errno == EADDRINUSE      ? what + "; another program listens there, end it or choose another port"
        : errno == EADDRNOTAVAIL ? what + "; expected an address of this machine, or 0.0.0.0 for all of them"
                                 : what);
  }
  if (!isGroup) return socket;
  ip_mreq membership{};
  membership.imr_multiaddr = address.sin_addr;
  membership.imr_interface.s_addr = htonl(interface);
  if (setsockopt(socket.descriptor_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
    throw NeedsHelp("cannot join the group " + toString(local) + ": " + reason(errno) +
                    "; expected ?interface= with the address of this machine in the trackers' network");
  }
  return socket;
}

std::optional<std::size_t> Socket::receive(std::span<std::uint8_t> bytes, Ipv4* from) {
  sockaddr_in sender{};
  socklen_t size = sizeof sender;
  const ssize_t count =
      recvfrom(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&sender), &size);
  if (count >= 0) {
    if (from) *from = fromSystem(sender);
    return static_cast<std::size_t>(count);
  }
  // A datagram of ours that was refused, by a server that is not running, is no fault of this socket.
  if (errno == EAGAIN || errno == EINTR || errno == ECONNREFUSED) return {};
  throw std::runtime_error("the connection broke: " + reason(errno));
}

void Socket::send(std::span<const std::uint8_t> bytes) {
  const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (count == static_cast<ssize_t>(bytes.size())) return;
  throw std::runtime_error("the connection broke: " + (count < 0 ? reason(errno) : "it takes no more bytes"));
}

void Socket::send(std::span<const std::uint8_t> datagram, Ipv4 to) {
  const sockaddr_in address = toSystem(to);
  if (sendto(descriptor_, datagram.data(), datagram.size(), MSG_NOSIGNAL, generic(address), sizeof address) <
          0 &&
      errno != ECONNREFUSED) {
    throw std::runtime_error("nothing can be sent to " + toString(to) + ": " + reason(errno));
  }
}

std::uint16_t Socket::localPort() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

bool waitReadable(std::initializer_list<const Socket*> sockets, std::chrono::milliseconds longest) {
  std::array<pollfd, 4> waiting{};
  nfds_t count = 0;
  for (const Socket* socket : sockets) {
    if (socket) waiting.at(count++) = {socket->descriptor(), POLLIN, 0};
  }
  return poll(waiting.data(), count, static_cast<int>(longest.count())) > 0;
}

}  // namespace carom
