#pragma once
// The thread of a force device, at the device's rate: it opens the device, ticks its loop, and opens it again
// when it was gone. It asks for prompt scheduling (devices/tracker/realtime_thread.h). Nothing in a tick
// allocates or waits for the game.

#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>

#include "devices/force/force_channel.h"
#include "devices/force/force_device.h"

namespace carom {

/// Opens a device. Throws NeedsHelp or std::runtime_error (devices/tracker/retry.h), which say why it cannot.
using OpenForce = std::function<std::unique_ptr<ForceDevice>(const std::stop_token& stop)>;

class ForceThread : public ForceChannel {
 public:
  /// The session's clock reads zero at `sessionStart`. `name`: of the device, for people.
  ForceThread(std::string name, OpenForce open, const ForceLimits& limits,
              std::chrono::steady_clock::time_point sessionStart);
  ~ForceThread() override;

  void post(const ForceLaw& law) override;
  const ForceReport& report() override;
  double now_s(double given_s) const override;
  std::vector<std::string> takeNews() override;
  void end() noexcept override;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace carom
