#pragma once
// A tracker whose device sends at its own times: a thread listens and a bounded queue hands over, so the
// frame never waits.

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "devices/tracker/reading.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Receives what a transport reports while it runs. DeviceTracker passes it to the transport, which uses it
/// on its own thread.
class DeviceSink {
 public:
  /// Takes the readings of one packet, which arrived at `arrival` (when its bytes were there, not when they
  /// were decoded).
  virtual void deliver(std::span<const Reading> readings, std::chrono::steady_clock::time_point arrival) = 0;
  virtual void connected() = 0;
  virtual void remark(const std::string& /*what*/) {}     ///< connected, but something needs to be known
  virtual void named(const std::string& /*names*/) {}     ///< what the device calls its sensors, in words
  virtual void disconnected(const std::string& why) = 0;  ///< the transport will try again
  virtual void failed(const std::string& why) = 0;        ///< needs help: the fault and its remedy
  virtual void refused() = 0;                             ///< a packet could not be read
  virtual void missed(std::uint64_t packets) = 0;         ///< packets that the device numbered never arrived

 protected:
  ~DeviceSink() = default;
};

/// Listens to one device until asked to stop, and reconnects by itself. Throws nothing.
using Transport = std::function<void(std::stop_token stop, DeviceSink& sink)>;

/// Runs a transport on a thread of its own, which asks for prompt scheduling
/// (devices/tracker/realtime_thread.h). A DeviceClock converts device times to the session's clock. Readings
/// without a time are stamped with their arrival, and so are those of a device whose clock stands
/// (devices/tracker/standing_clock.h); the health then says so. A sample that is older than one already
/// delivered for the same sensor is dropped and counted.
class DeviceTracker : public Tracker {
 public:
  /// The session's clock reads zero at `sessionStart`. The tracker counts as silent after `silence_s` without
  /// any reading, be it a pose, a button or an axis; infinite for a device that sends only while it is used,
  /// which counts as untouched until its first reading and as delivering from then on. A device that has sent
  /// buttons or axes and never a pose is such a device, too.
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
