#pragma once
// What the server of a class is given: its address, its limits, and the pages that others make.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// What one phone, one computer and all together may take up.
struct ClassLimits {
  std::size_t sockets = 300;                 ///< in all
  std::size_t socketsOfAddress = 250;        ///< from one address, so that it cannot keep others out
  std::size_t requestBytes = 8192;           ///< of a request's header
  std::chrono::milliseconds request{10000};  ///< until a connection has said who it is
  std::chrono::milliseconds silence{30000};  ///< of a phone that does not even answer a ping
  double messages_1_s = 10.0;                ///< of a phone, in the mean
  double burst = 20.0;                       ///< messages at once
};

/// What phones may follow of the game that is played. Called in the server's thread.
struct FollowedGame {
  /// Returns the page that follows it; null while it is made.
  std::function<std::shared_ptr<const std::string>()> page;
  /// Return the bytes of the news since the last call, or none, and of all that is known.
  std::function<std::string()> more, whole;
};

struct ClassServerOptions {
  std::string address = "127.0.0.1";  ///< to listen on, in numbers
  std::uint16_t port = 0;             ///< 0: any that is free
  std::string word, pin;
  ClassLimits limits{};
  /// Of a study: returns the page of an address, from what follows its question mark. The server then has
  /// these pages alone. Called in the server's thread.
  std::function<std::string(std::string_view query)> studyPage{};
  /// Takes a form, and returns the address of the page that follows.
  std::function<std::string(std::string_view form)> studyForm{};
  std::string studyStyle{};
  std::optional<FollowedGame> followed{};
};

}  // namespace carom
