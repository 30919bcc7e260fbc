#pragma once
// How a transport keeps trying.

#include <chrono>
#include <exception>
#include <functional>
#include <stdexcept>
#include <stop_token>

#include "devices/tracker/device_tracker.h"
#include "devices/tracker/stoppable_wait.h"

namespace carom {

/// A device cannot be used without someone's help: what is wrong, what to do.
class NeedsHelp : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How often a thread that waits for a device looks whether it should end.
inline constexpr std::chrono::milliseconds kLookAtStop{100};

/// Runs `session` again and again until asked to stop. What it throws is told to the sink; the next one
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
