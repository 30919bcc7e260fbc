#pragma once
// Starts and stops the measurement of an ART controller (DTRACK2, DTRACK3) through its command port.

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/protocol/dtrack_answer.h"

namespace carom {

/// A connection to a controller, which is asked to measure, and to stop if it has begun for us.
class DtrackController {
 public:
  /// An answer may take `patience`: the cameras may have to wake up.
  explicit DtrackController(Endpoint endpoint, std::chrono::milliseconds patience = std::chrono::seconds(15))
      : endpoint_(std::move(endpoint)), patience_(patience) {}
  DtrackController(const DtrackController&) = delete;
  DtrackController& operator=(const DtrackController&) = delete;
  ~DtrackController() { stop(); }

  /// Starts the measurement, if it does not run already. Throws std::runtime_error, which says why it does
  /// not start and what can be done, or "stopped".
  void start(const std::stop_token& stop);
  /// Stops the measurement, if `start` began it. Waits at most 0.2 s for the answer, and throws nothing: the
  /// session ends in any case.
  void stop() noexcept;

 private:
  DtrackAnswer ask(std::string_view command, std::string_view asked, const std::stop_token& stop);
  std::optional<DtrackAnswer> receive(std::string_view asked, std::chrono::milliseconds longest,
                                      const std::stop_token& stop);

  Endpoint endpoint_;
  std::chrono::milliseconds patience_;
  std::optional<Socket> socket_;
  bool begun_ = false;  // by us
};

}  // namespace carom
