#include "devices/tracker/device_tracker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/lockfree/spsc_queue.hpp>

#include "devices/tracker/device_clock.h"
#include "devices/tracker/realtime_thread.h"
#include "devices/tracker/standing_clock.h"

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

/// The newest pose of each sensor.
class NewestPoses {
 public:
  struct Newest {
    std::int32_t sensor = 0;
    double made_s = -std::numeric_limits<double>::infinity();
    double stamp_s = std::numeric_limits<double>::quiet_NaN();  ///< of the device
    double stampSince_s = 0.0;                                  ///< arrival of its first pose
    Pose pose;
  };
  /// That of the sensor, now or to be; null where there are too many sensors.
  Newest* find(std::int32_t sensor) {
    const auto end = newest_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found =
        std::find_if(newest_.begin(), end, [&](const Newest& newest) { return newest.sensor == sensor; });
    if (found != end) return &*found;
    if (count_ == kMostSensors) return nullptr;
    newest_[count_] = {};
    newest_[count_].sensor = sensor;
    return &newest_[count_++];
  }

 private:
  std::array<Newest, kMostSensors> newest_;
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
  void named(const std::string& what) override {
    const std::lock_guard lock(messageMutex);
    names = what;
  }
  void disconnected(const std::string& why) override { become(Link::down, why); }
  void failed(const std::string& why) override { become(Link::failed, why); }
  void refused() override { ++refusedCount; }
  void missed(std::uint64_t packets) override { gaps += packets; }

  void judgeStamp(const Reading& reading, double arrival_s);
  double made_s(const Reading& reading, double arrival_s);
  bool isNext(const Reading& reading);
  void push(const Reading& reading);
  void listen(const std::stop_token& stopToken, const Transport& transport);

  enum class Link { down, up, failed };
  TrackerHealth::State stateAt(double now_s) const;  // with the mutex
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
  StandingClock standing;
  NewestPoses newest;
  bool wasConnected = false;
  double stamp_s = 0.0, stampArrival_s = 0.0, stampOurs_s = 0.0;  // the clock is asked once a stamp
  bool stamped = false;

  // Written by the transport's thread, read by anyone.
  std::atomic<std::uint64_t> samples{0}, gaps{0}, late{0}, refusedCount{0}, overflowed{0}, reconnections{0};
  std::atomic<double> newestArrival_s{-1.0};
  std::atomic<bool> clockStands{false}, hasPoses{false};
  mutable std::mutex messageMutex;
  Link link = Link::down;  // with the mutex
  std::string message;     // with the mutex
  std::string names;       // with the mutex

  std::vector<Reading> inputs;  // the frame's thread alone
  std::jthread thread;          // the last member: it ends before the rest goes
};

/// Whether the device's clock goes, as far as this pose tells.
void DeviceTracker::Shared::judgeStamp(const Reading& reading, double arrival_s) {
  NewestPoses::Newest* last = newest.find(reading.sensor);
  if (!last || std::isnan(reading.device_s)) return;
  const bool same = reading.device_s == last->stamp_s;
  const bool moved =
      reading.pose.position_m != last->pose.position_m || reading.pose.orientation != last->pose.orientation;
  standing.see(same, moved || arrival_s - last->stampSince_s > StandingClock::kLong_s);
  if (!same) last->stampSince_s = arrival_s;
  last->stamp_s = reading.device_s;
  last->pose = reading.pose;
  if (standing.stands() == clockStands) return;
  clockStands = standing.stands();
  clock = {};
  stamped = false;
}

/// When the device made the reading, on the session's clock; a reading that bears no time, or one of a clock
/// that stands: when it came.
double DeviceTracker::Shared::made_s(const Reading& reading, double arrival_s) {
  if (std::isnan(reading.device_s) || clockStands) return arrival_s;
  if (!stamped || reading.device_s != stamp_s || arrival_s != stampArrival_s) {
    stamped = true;
    stamp_s = reading.device_s;
    stampArrival_s = arrival_s;
    stampOurs_s = clock.ours_s(reading.device_s, arrival_s);
  }
  return stampOurs_s;
}

/// Whether the pose is after the newest of its sensor, which it then is itself.
bool DeviceTracker::Shared::isNext(const Reading& reading) {
  NewestPoses::Newest* last = newest.find(reading.sensor);
  if (!last || !(reading.device_s >= last->made_s + kLeastSpacing_s)) return false;
  last->made_s = reading.device_s;
  return true;
}

void DeviceTracker::Shared::deliver(std::span<const Reading> readings,
                                    std::chrono::steady_clock::time_point arrival) {
  const double arrival_s = since_s(sessionStart, arrival);
  if (!readings.empty()) newestArrival_s = arrival_s;
  for (Reading reading : readings) {
    if (reading.kind == Reading::Kind::pose || reading.kind == Reading::Kind::lost) hasPoses = true;
    if (reading.kind == Reading::Kind::pose) judgeStamp(reading, arrival_s);
    const double made = made_s(reading, arrival_s);
    const double delay_s = arrival_s - made;
    reading.device_s = made - reading.latency_s;
    if (reading.kind == Reading::Kind::pose) {
      const bool useful = delay_s <= kUseless_s && isNext(reading);
      if (!useful || delay_s > kLate_s) ++late;
      if (!useful) continue;
    }
    push(reading);
  }
}

/// The state by what has come and when. A connection with a remark and without a reading has no such device.
TrackerHealth::State DeviceTracker::Shared::stateAt(double now_s) const {
  using State = TrackerHealth::State;
  if (link == Link::failed) return State::failed;
  if (link == Link::down) return State::connecting;
  const bool speaksWhenUsed = std::isinf(silence_s);
  const double arrival_s = newestArrival_s;
  if (arrival_s < 0.0) return speaksWhenUsed && message.empty() ? State::untouched : State::connecting;
  const bool maySayNothing = speaksWhenUsed || !hasPoses;
  return maySayNothing || now_s - arrival_s <= silence_s ? State::delivering : State::silent;
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
  standing = {};
  clockStands = false;
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
  TrackerHealth health;
  health.samples = shared_->samples;
  health.gaps = shared_->gaps;
  health.late = shared_->late;
  health.refused = shared_->refusedCount;
  health.overflowed = shared_->overflowed;
  health.reconnections = shared_->reconnections;
  const std::lock_guard lock(shared_->messageMutex);
  health.message = shared_->message;
  health.names = shared_->names;
  health.state = shared_->stateAt(now_s);
  health.connected = shared_->link == Shared::Link::up;
  if (health.connected && health.message.empty() && shared_->clockStands) {
    health.message =
        "its messages carry the same time again and again; each is taken to be of the moment when it came";
  }
  return health;
}

}  // namespace carom
