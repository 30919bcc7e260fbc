#pragma once
// Sockets for trackers on a network: IPv4, never blocking, closed by their destructor.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

namespace carom {

/// Room for any datagram.
inline constexpr std::size_t kMostDatagram = 65536;

/// A machine, by name or number, and a port.
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

/// Returns the address that four numbers such as 192.168.1.5 give; none if the text has another form.
std::optional<std::uint32_t> ipv4Of(const std::string& numbers);

/// Returns a machine's address. Throws std::runtime_error if it has none, or if `stop` is requested first.
Ipv4 resolve(const Endpoint& endpoint, const std::stop_token& stop);

class Socket {
 public:
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&&) = delete;
  ~Socket();

  /// Connects within 3 s, unless `stop` is requested. A connection whose other end is gone breaks within 5 s.
  /// Throws std::runtime_error.
  static Socket connectedTo(Ipv4 server, const std::stop_token& stop);
  /// Receives the datagrams that come to `local` (port 0: any free one), or to a group through the interface
  /// with the address `interface` (0: chosen by the system). Throws NeedsHelp (devices/tracker/retry.h) if
  /// the machine has no such address, or if another program has the port.
  static Socket boundTo(Ipv4 local, std::uint32_t interface = 0);

  /// Reads what has arrived into `bytes` and its sender into `from`; returns the size, or none if nothing has
  /// arrived. On a connection, 0 bytes mean that the other end has closed it. Throws std::runtime_error if
  /// the connection broke.
  std::optional<std::size_t> receive(std::span<std::uint8_t> bytes, Ipv4* from = nullptr);
  /// Sends all bytes at once. Throws std::runtime_error.
  void send(std::span<const std::uint8_t> bytes);
  void send(std::span<const std::uint8_t> datagram, Ipv4 to);

  std::uint16_t localPort() const;
  int descriptor() const { return descriptor_; }

 private:
  explicit Socket(int type);
  void set(int level, int option, int value);
  int descriptor_;
};

/// Waits until one of the sockets has something to read; returns false if the time is over first.
bool waitReadable(std::initializer_list<const Socket*> sockets, std::chrono::milliseconds longest);

}  // namespace carom
