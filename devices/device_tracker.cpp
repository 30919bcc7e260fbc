#include "devices/device_tracker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/lockfree/spsc_queue.hpp>

#include "devices/device_clock.h"
#include "devices/prompt_thread.h"

namespace carom {
namespace {

constexpr std::size_t kMostQueued = 4096;  // 20 bodies for 0.8 s at 240 Hz
constexpr std::size_t kMostInputs = 1024;  // between two polls
constexpr std::size_t kMostSensors = 256;  // of one tracker; further ones are refused
constexpr double kLate_s = 0.05;           // worth counting
constexpr double kUseless_s = 1.0;         // worth nothing
constexpr double kLeastSpacing_s = 1e-4;   // no tracker is faster

double since_s(std::chrono::steady_clock::time_point start, std::chrono::steady_clock::time_point time) {
  return std::chrono::duration<double>(time - start).count();
}

/// When the newest sample of each sensor was made.
class NewestTimes {
 public:
  /// Whether the sample is after the newest of its sensor, which it then is itself; false also where there
  /// are too many sensors.
  bool advance(std::int32_t sensor, double time_s) {
    const auto end = newest_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found =
        std::find_if(newest_.begin(), end, [&](const auto& entry) { return entry.first == sensor; });
    if (found == end) {
      if (count_ == kMostSensors) return false;
      newest_[count_++] = {sensor, time_s};
      return true;
    }
    if (!(time_s >= found->second + kLeastSpacing_s)) return false;
    found->second = time_s;
    return true;
  }

 private:
  std::array<std::pair<std::int32_t, double>, kMostSensors> newest_;
  std::size_t count_ = 0;
};

}  // namespace

struct DeviceTracker::Shared final : DeviceSink {
  Shared(std::chrono::steady_clock::time_point start, double silence)
      : sessionStart(start), silence_s(silence) {}

  // On the transport's thread.
  void deliver(std::span<const Reading> readings, std::chrono::steady_clock::time_point arrival) override;
  void connected() override;
  void remark(const std::string& what) override { become(Link::up, what); }
  void disconnected(const std::string& why) override { become(Link::down, why); }
  void failed(const std::string& why) override { become(Link::failed, why); }
  void refused() override { ++refusedCount; }
  void missed(std::uint64_t packets) override { gaps += packets; }

  double made_s(const Reading& reading, double arrival_s);
  void push(const Reading& reading);
  void listen(const std::stop_token& stopToken, const Transport& transport);

  enum class Link { down, up, failed };
  void become(Link how, const std::string& why) {
    const std::lock_guard lock(messageMutex);
    link = how;
    message = why;
  }

  const std::chrono::steady_clock::time_point sessionStart;
  const double silence_s;
  boost::lockfree::spsc_queue<Reading, boost::lockfree::capacity<kMostQueued>> queue;

  // The transport's thread alone.
  DeviceClock clock;
  NewestTimes newest;
  bool wasConnected = false;
  double stamp_s = 0.0, stampArrival_s = 0.0, stampOurs_s = 0.0;  // the clock is asked once a stamp
  bool stamped = false;

  // Written by the transport's thread, read by anyone.
  std::atomic<std::uint64_t> samples{0}, gaps{0}, late{0}, refusedCount{0}, overflowed{0}, reconnections{0};
  std::atomic<double> newestArrival_s{-1.0};
  mutable std::mutex messageMutex;
  Link link = Link::down;  // with the mutex
  std::string message;     // with the mutex

  std::vector<Reading> inputs;  // the frame's thread alone
  std::jthread thread;          // the last member: it ends before the rest goes
};

/// When the device made the reading, on the session's clock; a reading that bears no time: when it came.
double DeviceTracker::Shared::made_s(const Reading& reading, double arrival_s) {
  if (std::isnan(reading.device_s)) return arrival_s;
  if (!stamped || reading.device_s != stamp_s || arrival_s != stampArrival_s) {
    stamped = true;
    stamp_s = reading.device_s;
    stampArrival_s = arrival_s;
    stampOurs_s = clock.ours_s(reading.device_s, arrival_s);
  }
  return stampOurs_s;
}

void DeviceTracker::Shared::deliver(std::span<const Reading> readings,
                                    std::chrono::steady_clock::time_point arrival) {
  const double arrival_s = since_s(sessionStart, arrival);
  if (!readings.empty()) newestArrival_s = arrival_s;
  for (Reading reading : readings) {
    const double made = made_s(reading, arrival_s);
    const double delay_s = arrival_s - made;
    reading.device_s = made - reading.latency_s;
    if (reading.kind == Reading::Kind::pose) {
      const bool useful = delay_s <= kUseless_s && newest.advance(reading.sensor, reading.device_s);
      if (!useful || delay_s > kLate_s) ++late;
      if (!useful) continue;
    }
    push(reading);
  }
}

void DeviceTracker::Shared::push(const Reading& reading) {
  if (!queue.push(reading)) {
    ++overflowed;
  } else if (reading.kind == Reading::Kind::pose) {
    ++samples;
  }
}

void DeviceTracker::Shared::connected() {
  clock = {};
  stamped = false;
  if (wasConnected) ++reconnections;
  wasConnected = true;
  become(Link::up, {});
}

void DeviceTracker::Shared::listen(const std::stop_token& stopToken, const Transport& transport) {
  askForPromptness();
  try {
    transport(stopToken, *this);
  } catch (const std::exception& error) {
    failed(error.what());
  }
}

DeviceTracker::DeviceTracker(Transport transport, std::chrono::steady_clock::time_point sessionStart,
                             double silence_s)
    : shared_(std::make_unique<Shared>(sessionStart, silence_s)) {
  shared_->inputs.reserve(kMostInputs);
  shared_->thread =
      std::jthread([shared = shared_.get(), listener = std::move(transport)](
                       const std::stop_token& stopToken) { shared->listen(stopToken, listener); });
}

DeviceTracker::~DeviceTracker() = default;

void DeviceTracker::poll(double now_s, std::vector<TrackerSample>& samples) {
  shared_->inputs.clear();
  while (shared_->queue.read_available() > 0 && shared_->queue.front().device_s <= now_s) {
    const Reading reading = shared_->queue.front();
    shared_->queue.pop();
    if (reading.kind == Reading::Kind::pose) {
      samples.push_back(
          {reading.device_s, reading.sensor, reading.pose, reading.hasOrientation, reading.quality});
    } else if (shared_->inputs.size() < kMostInputs) {
      shared_->inputs.push_back(reading);
    } else {
      ++shared_->overflowed;
    }
  }
}

void DeviceTracker::takeInputs(std::vector<Reading>& inputs) {
  inputs.insert(inputs.end(), shared_->inputs.begin(), shared_->inputs.end());
}

TrackerHealth DeviceTracker::health(double now_s) const {
  using State = TrackerHealth::State;
  TrackerHealth health;
  health.samples = shared_->samples;
  health.gaps = shared_->gaps;
  health.late = shared_->late;
  health.refused = shared_->refusedCount;
  health.overflowed = shared_->overflowed;
  health.reconnections = shared_->reconnections;
  const double newestArrival_s = shared_->newestArrival_s;
  const std::lock_guard lock(shared_->messageMutex);
  health.message = shared_->message;
  switch (shared_->link) {
    case Shared::Link::failed:
      health.state = State::failed;
      break;
    case Shared::Link::down:
      health.state = State::connecting;
      break;
    case Shared::Link::up:
      health.state = std::isinf(shared_->silence_s)                 ? State::delivering
                     : newestArrival_s < 0.0                        ? State::connecting
                     : now_s - newestArrival_s > shared_->silence_s ? State::silent
                                                                    : State::delivering;
      break;
  }
  return health;
}

}  // namespace carom
