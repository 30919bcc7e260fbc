#pragma once
// Between a game and a force device: the game posts what holds now and looks at what the device does. Neither
// waits for the other.

#include <string>
#include <vector>

#include "devices/force_law/force_law.h"

namespace carom {

class ForceChannel {
 public:
  ForceChannel() = default;
  ForceChannel(const ForceChannel&) = delete;
  ForceChannel& operator=(const ForceChannel&) = delete;
  virtual ~ForceChannel() = default;  ///< leaves the device at 0 N

  virtual void post(const ForceLaw& law) = 0;
  virtual const ForceReport& report() = 0;
  /// Returns the session's clock, on which laws and blows have their times, for a device that has a clock of
  /// its own thread; the given time otherwise.
  virtual double now_s(double given_s) const = 0;
  /// Returns what people should know of the device since the last call, a line each.
  virtual std::vector<std::string> takeNews() = 0;
  /// 0 N at once, for the end of the process. May be called from any thread.
  virtual void end() noexcept = 0;
};

}  // namespace carom
