#pragma once
// A client of HTTP and WebSockets (RFC 6455) for tests, on plain sockets and without a library, so that it
// can also send what no library would.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace carom::test {

class WebClient {
 public:
  static constexpr std::chrono::milliseconds kPatience{10000};

  /// Connects from an address of this computer, any 127.x.y.z.
  explicit WebClient(std::uint16_t port, const char* from = "127.0.0.1")
      : port_(port), socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in here = address(from, 0), there = address("127.0.0.1", port);
    bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here);
    isConnected_ = connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
  }
  ~WebClient() {
    if (socket_ >= 0) ::close(socket_);
  }
  WebClient(WebClient&& other) noexcept
      : port_(other.port_),
        socket_(std::exchange(other.socket_, -1)),
        isConnected_(other.isConnected_),
        received_(std::move(other.received_)) {}
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  bool isConnected() const { return isConnected_; }
  std::string host() const { return "127.0.0.1:" + std::to_string(port_); }

  void send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  /// Returns the whole answer to a request, until the server closes.
  std::string get(const std::string& target, const std::string& host) {
    send("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
    return rest();
  }
  std::string get(const std::string& target) { return get(target, host()); }
  /// Returns all that comes until the server closes.
  std::string rest() {
    while (receive()) {
    }
    return std::exchange(received_, {});
  }
  /// Returns whether the server closes the connection in time; what comes before is dropped.
  bool isClosed(std::chrono::milliseconds patience = kPatience) {
    const auto until = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < until) {
      if (!receive(std::chrono::milliseconds(100)) && closed_) return true;
    }
    return false;
  }

  /// Asks for a WebSocket. Returns the status of the answer, 101 if there is one.
  int open(const std::string& host, const std::string& origin = "", const std::string& path = "/socket") {
    send("GET " + path + " HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
         (origin.empty() ? "" : "Origin: " + origin + "\r\n") + "\r\n");
    std::size_t ends;
    while ((ends = received_.find("\r\n\r\n")) == std::string::npos) {
      if (!receive()) return 0;
    }
    const int status = received_.size() > 12 ? std::atoi(received_.c_str() + 9) : 0;
    received_.erase(0, ends + 4);
    return status;
  }
  int open() { return open(host()); }

  /// Sends a frame: `first` has its kind and whether it is the last, 0x81 for a whole text. The length may
  /// lie.
  void frame(std::uint8_t first, std::string_view payload, std::optional<std::size_t> length = {}) {
    const std::size_t told = length.value_or(payload.size());
    std::string bytes(1, static_cast<char>(first));
    const auto number = [&](int count) {
      for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(told >> (8 * i) & 0xffU);
    };
    if (told < 126) {
      bytes += static_cast<char>(0x80U | told);
    } else {
      bytes += static_cast<char>(told < 65536 ? 0xfe : 0xff);
      number(told < 65536 ? 2 : 8);
    }
    constexpr std::string_view kMask("\x11\x22\x33\x44", 4);
    bytes += kMask;
    for (std::size_t i = 0; i < payload.size(); ++i) bytes += static_cast<char>(payload[i] ^ kMask[i % 4]);
    send(bytes);
  }
  void say(std::string_view text) { frame(0x81, text); }

  /// Returns the next text or the next bytes, answering pings, or the code of a close as "close CODE", or ""
  /// if none comes.
  std::string hear(std::chrono::milliseconds patience = kPatience) {
    for (;;) {
      std::uint8_t kind = 0;
      std::string payload;
      if (!next(kind, payload, patience)) return "";
      if (kind == 0x1 || kind == 0x2) return payload;
      if (kind == 0x9) frame(0x8a, payload);
      if (kind == 0x8 && payload.size() >= 2)
        return "close " + std::to_string(static_cast<unsigned char>(payload[0]) * 256 +
                                         static_cast<unsigned char>(payload[1]));
      if (kind == 0x8) return "close";
    }
  }

 private:
  static sockaddr_in address(const char* text, std::uint16_t port) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_port = htons(port);
    inet_pton(AF_INET, text, &at.sin_addr);
    return at;
  }

  /// Receives what there is; returns false if nothing comes in time, or nothing more.
  bool receive(std::chrono::milliseconds patience = kPatience) {
    pollfd wait{socket_, POLLIN, 0};
    if (poll(&wait, 1, static_cast<int>(patience.count())) <= 0) return false;
    char bytes[4096];
    const ssize_t count = recv(socket_, bytes, sizeof bytes, 0);
    closed_ = count <= 0;
    if (count <= 0) return false;
    received_.append(bytes, static_cast<std::size_t>(count));
    return true;
  }
  bool await(std::size_t bytes, std::chrono::milliseconds patience) {
    while (received_.size() < bytes) {
      if (!receive(patience)) return false;
    }
    return true;
  }
  /// Takes the next frame of the server, which is not masked.
  bool next(std::uint8_t& kind, std::string& payload, std::chrono::milliseconds patience) {
    if (!await(2, patience)) return false;
    kind = static_cast<std::uint8_t>(received_[0]) & 0x0fU;
    std::size_t size = static_cast<std::uint8_t>(received_[1]) & 0x7fU, header = 2;
    const auto number = [&](std::size_t count) {
      size = 0;
      for (std::size_t i = 0; i < count; ++i) size = size << 8U | static_cast<std::uint8_t>(received_[2 + i]);
      header = 2 + count;
    };
    if (size >= 126) {
      const std::size_t count = size == 126 ? 2 : 8;
      if (!await(2 + count, patience)) return false;
      number(count);
    }
    if (!await(header + size, patience)) return false;
    payload = received_.substr(header, size);
    received_.erase(0, header + size);
    return true;
  }

  std::uint16_t port_;
  int socket_;
  bool isConnected_ = false, closed_ = false;
  std::string received_;
};

}  // namespace carom::test
