#pragma once
// The loop in which a transport tries again.

#include <chrono>
#include <exception>
#include <functional>
#include <stdexcept>
#include <stop_token>

#include "devices/tracker/device_tracker.h"
#include "devices/tracker/stoppable_wait.h"

namespace carom {

/// Thrown when a device cannot be used without help: the fault and its remedy.
class NeedsHelp : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How often a thread that waits for a device checks whether it must end.
inline constexpr std::chrono::milliseconds kLookAtStop{100};

/// Runs `session` again and again until a stop is requested. Tells the sink what it throws; the next run
/// begins `pause` later.
inline void retry(const std::stop_token& stop, DeviceSink& sink, std::chrono::milliseconds pause,
                  const std::function<void()>& session) {
  while (!stop.stop_requested()) {
    try {
      session();
    } catch (const NeedsHelp& fault) {
      sink.failed(fault.what());
    } catch (const std::exception& error) {
      sink.disconnected(error.what());
    }
    waitUnlessStopped(stop, pause);
  }
}

}  // namespace carom
