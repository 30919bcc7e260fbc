#pragma once
// Sockets of the trackers that speak over a network: IPv4, never blocking, closed by themselves.

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

namespace carom {

/// A name or number of a machine, and a port.
struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
};
std::string toString(const Endpoint& endpoint);

struct Ipv4 {
  std::uint32_t address = 0;  ///< the first number in the highest byte; 0: any
  std::uint16_t port = 0;
  bool isGroup() const { return address >> 28 == 0xE; }
};

/// The four numbers of an address; none where it is written otherwise.
std::optional<std::uint32_t> ipv4Of(const std::string& numbers);

/// Finds a machine's address. Throws std::runtime_error where it has none, or `stop` comes first.
Ipv4 resolve(const Endpoint& endpoint, const std::stop_token& stop);

class Socket {
 public:
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&&) = delete;
  ~Socket();

  /// Connects within 3 s, unless `stop` comes; a connection whose other end is gone breaks within 5 s. Throws
  /// std::runtime_error.
  static Socket connectedTo(Ipv4 server, const std::stop_token& stop);
  /// Receives the datagrams that come to `local` (port 0: any free one), or to a group through the interface
  /// that has the address `interface` (0: the one that leads there). Throws NeedsHelp
  /// (devices/tracker/retry.h): the machine has no such address, or another program has the port.
  static Socket boundTo(Ipv4 local, std::uint32_t interface = 0);

  /// What has come, and from whom; none where nothing has. Of a connection, 0 bytes are its end. Throws
  /// std::runtime_error where the connection broke.
  std::optional<std::size_t> receive(std::span<std::uint8_t> bytes, Ipv4* from = nullptr);
  /// All of it, at once. Throws std::runtime_error.
  void send(std::span<const std::uint8_t> bytes);
  void send(std::span<const std::uint8_t> datagram, Ipv4 to);

  std::uint16_t localPort() const;
  int descriptor() const { return descriptor_; }

 private:
  explicit Socket(int type);
  void set(int level, int option, int value);
  int descriptor_;
};

/// Waits until one of them has something to read; false when the time is over.
bool waitReadable(std::initializer_list<const Socket*> sockets, std::chrono::milliseconds longest);

}  // namespace carom
