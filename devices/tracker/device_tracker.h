#pragma once
// A tracker whose device speaks when it likes: a thread listens, a bounded queue hands over, the frame
// never waits.

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "devices/tracker/reading.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// What a transport tells while it runs. Given to it by DeviceTracker; to be used on the transport's thread.
class DeviceSink {
 public:
  /// Readings of one packet, which arrived at `arrival` (when the bytes were there, not when they were
  /// decoded).
  virtual void deliver(std::span<const Reading> readings, std::chrono::steady_clock::time_point arrival) = 0;
  virtual void connected() = 0;
  virtual void remark(const std::string& /*what*/) {}     ///< connected, and yet the person should know this
  virtual void disconnected(const std::string& why) = 0;  ///< it will be tried again
  virtual void failed(const std::string& why) = 0;        ///< someone has to help: what is wrong, what to do
  virtual void refused() = 0;                             ///< a packet that was not understood
  virtual void missed(std::uint64_t packets) = 0;         ///< numbered by the device, never came

 protected:
  ~DeviceSink() = default;
};

/// Listens to one device until asked to stop, reconnecting by itself. Throws nothing.
using Transport = std::function<void(std::stop_token stop, DeviceSink& sink)>;

/// Runs a transport on a thread of its own, which asks to be prompt (devices/tracker/realtime_thread.h). Device
/// times become times of the session's clock through a DeviceClock; readings without one are stamped with
/// their arrival, and so are those of a device whose clock stands (devices/tracker/standing_clock.h), which
/// its health then says. Late samples (before one already delivered of the same sensor) are counted and
/// dropped.
class DeviceTracker : public Tracker {
 public:
  /// `sessionStart`: where the session's clock reads zero. `silence_s`: how long without any reading, be it a
  /// pose, a button or an axis, until it counts as silent; infinite for a device that speaks only while it is
  /// used, which then delivers as long as it is connected.
  DeviceTracker(Transport transport, std::chrono::steady_clock::time_point sessionStart,
                double silence_s = 0.25);
  ~DeviceTracker() override;  ///< stops the thread within 0.3 s

  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  void takeInputs(std::vector<Reading>& inputs) override;
  TrackerHealth health(double now_s) const override;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace carom
