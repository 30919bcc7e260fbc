#include "devices/programs/trackd_tracker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "devices/network/source_url.h"
#include "devices/programs/shared_segment.h"
#include "devices/programs/trackd_pause.h"
#include "devices/protocol/trackd_segment.h"
#include "devices/tracker/retry.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kLookEvery = 300us, kWatchEvery = 50us;  // while the daemon's pauses are not known
constexpr auto kUnchangedIfLate = 1000us;
constexpr int kMostLooks = 8;        // at sensors that keep changing
constexpr auto kCheckEvery = 250ms;  // whether the segment is still there
constexpr auto kBadFor = 250ms;      // a header that makes no sense for longer is no header
constexpr auto kTrackdPause = 1000ms;
constexpr auto kAliveEvery = 100ms;  // a sensor without a time, at rest, counts as seen again
constexpr auto kQuietFor = 1s;
constexpr std::size_t kPoseBytes = 24, kTimeBytes = 8;  // of a sensor
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double timeOf(std::uint32_t seconds, std::uint32_t microseconds) {
  return seconds == 0 && microseconds == 0 ? kNone : seconds + 1e-6 * microseconds;
}

/// One sensor, as it was when it was last taken.
class FollowedSensor {
 public:
  /// Returns whether these bytes are a pose that was not there before. `headerMoved`: the daemon has written
  /// something since.
  bool isNews(const TrackdSensorBytes& bytes, bool headerMoved, Clock::time_point now) {
    const bool isLater = hasOtherTime(bytes, last_);
    hasTimes_ = hasTimes_ || isLater;
    if (!pause_.isKnown()) return false;
    if (hasTimes_) return isLater;
    const bool isAlive = taken_ && headerMoved && now - *taken_ > kAliveEvery;
    return isAlive || std::memcmp(bytes.data(), last_.data(), kPoseBytes) != 0;
  }
  void take(const TrackdSensorBytes& bytes, Clock::time_point now) {
    last_ = bytes;
    taken_ = now;
  }
  /// Notes what a look sees: the bytes, and the time of the header. What is there at first may be old.
  void watch(const TrackdSensorBytes& bytes, double written_s, Clock::time_point now) {
    const bool isLater =
        hasTimes_ ? hasOtherTime(bytes, seen_) : written_s == written_s && written_s != written_s_;
    if (!known_) {
      last_ = bytes;
    } else if (isLater || bytes != seen_) {
      pause_.changed(isLater, now);
    }
    known_ = true;
    seen_ = bytes;
    written_s_ = written_s;
  }
  /// Returns whether the daemon gives it a time.
  bool hasTimes() const { return hasTimes_; }
  /// Returns whether the daemon moves it and its pauses are still to be learned.
  bool isWatched() const { return pause_.isBegun() && !pause_.isKnown(); }
  Clock::duration settle() const { return pause_.settle(hasTimes_); }

 private:
  static bool hasOtherTime(const TrackdSensorBytes& a, const TrackdSensorBytes& b) {
    return std::memcmp(a.data() + kPoseBytes, b.data() + kPoseBytes, kTimeBytes) != 0;
  }

  TrackdPause pause_;
  TrackdSensorBytes seen_{};  // at the last look
  double written_s_ = kNone;  // then
  bool known_ = false, hasTimes_ = false;
  TrackdSensorBytes last_{};
  std::optional<Clock::time_point> taken_;
};

/// The segment of a wand, if there is one, and what changes in it.
class Wand {
 public:
  explicit Wand(int key) : key_(key) {}

  /// Appends the buttons and axes that differ from those before.
  void read(std::vector<Reading>& readings, Clock::time_point now) {
    if (!segment_ && now - looked_ < kTrackdPause) return;
    try {
      if (!segment_) attach(now);
      readTrackdWand(segment_->bytes(), now_);
      fault_.clear();
    } catch (const std::exception& error) {
      fault_ = std::string("the wand: ") + error.what();
      looked_ = now;
      segment_.reset();
      return;
    }
    const auto add = [&](Reading::Kind kind, const auto& values, const auto& before) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (i < before.size() && values[i] == before[i]) continue;
        Reading& reading = readings.emplace_back();
        reading.kind = kind;
        reading.sensor = kTrackdWand;
        reading.index = static_cast<std::int32_t>(i);
        reading.value = static_cast<double>(values[i]);
      }
    };
    add(Reading::Kind::button, now_.buttons, before_.buttons);
    add(Reading::Kind::axis, now_.axes, before_.axes);
    before_ = now_;
  }
  void check() {
    if (segment_ && segment_->isGone()) segment_.reset();
  }
  const std::string& fault() const { return fault_; }  ///< empty if there is none

 private:
  void attach(Clock::time_point now) {
    looked_ = now;
    segment_.emplace(key_);
    before_ = {};
  }

  int key_;
  std::optional<SharedSegment> segment_;
  TrackdWand now_, before_;
  std::string fault_;
  Clock::time_point looked_{};
};

/// From where the segment is found to where it is gone.
class Session {
 public:
  Session(const TrackdSource& source, double unit_m, DeviceSink& sink)
      : key_(source.sensors), unit_m_(unit_m), sink_(sink), segment_(source.sensors) {
    if (source.wand) wand_.emplace(*source.wand);
    readHeader();
    sink.connected();
  }

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      look();
      check();
      const bool isWatched = std::any_of(sensors_.begin(), sensors_.end(),
                                         [](const FollowedSensor& sensor) { return sensor.isWatched(); });
      std::this_thread::sleep_for(isWatched ? kWatchEvery : kLookEvery);
    }
  }

 private:
  TrackdSensors readHeader() const {
    try {
      return readTrackdSensors(segment_.bytes());
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("the shared memory of key " + std::to_string(key_) +
                               " is not trackd's: " + error.what());
    }
  }

  /// Returns the header; nothing, for a while, if it makes no sense: a daemon may be writing it.
  std::optional<TrackdSensors> headerAt(Clock::time_point now) {
    try {
      const TrackdSensors header = readHeader();
      sound_ = now;
      return header;
    } catch (const std::runtime_error&) {
      if (now - sound_ > kBadFor) throw;
      sink_.refused();
      return {};
    }
  }

  void look() {
    const auto now = Clock::now();
    const auto sinceLast = now - looked_;
    looked_ = now;
    const auto read = headerAt(now);
    if (!read) return;
    const TrackdSensors& header = *read;
    const double written_s = timeOf(header.seconds, header.microseconds);
    const bool headerMoved = written_s == written_s && written_s != written_s_;
    readings_.clear();
    changed_.clear();
    for (std::size_t i = 0; i < header.count; ++i) {
      seen_[i] = copyTrackdSensor(segment_.bytes(), header, i);
      sensors_[i].watch(seen_[i], written_s, now);
      if (sensors_[i].isNews(seen_[i], headerMoved, now)) changed_.push_back(i);
    }
    if (headerMoved) written_s_ = written_s;
    takeUnchanging(header, now, sinceLast);
    if (wand_) wand_->read(readings_, now);
    if (readings_.empty()) return;
    heard_ = now;
    sink_.deliver(readings_, now);
  }

  /// Takes those of the changed sensors that the daemon is not just writing. A look that comes late may come
  /// when the next pose is begun, so it waits for longer.
  void takeUnchanging(const TrackdSensors& header, Clock::time_point now, Clock::duration sinceLast) {
    if (changed_.empty()) return;
    Clock::duration settle{0};
    for (const std::size_t i : changed_) settle = std::max(settle, sensors_[i].settle());
    Clock::duration wait = std::clamp(sinceLast, settle, std::max<Clock::duration>(settle, kUnchangedIfLate));
    for (int looks = 0; looks < kMostLooks && !changed_.empty(); ++looks) {
      std::this_thread::sleep_for(std::exchange(wait, settle));
      const TrackdSensors later = headerAt(Clock::now()).value_or(header);
      const double written_s = timeOf(later.seconds, later.microseconds);
      std::erase_if(changed_, [&](std::size_t i) {
        const TrackdSensorBytes again = copyTrackdSensor(segment_.bytes(), header, i);
        sensors_[i].watch(again, written_s, Clock::now());
        if (again == seen_[i]) return take(i, written_s, now), true;
        seen_[i] = again;
        return false;
      });
    }
    for (std::size_t i = 0; i < changed_.size(); ++i) sink_.refused();
  }

  void take(std::size_t sensor, double written_s, Clock::time_point now) {
    sensors_[sensor].take(seen_[sensor], now);
    const auto read = readTrackdSensor(seen_[sensor], unit_m_);
    if (!read) return sink_.refused();
    Reading& reading = readings_.emplace_back();
    reading.sensor = static_cast<std::int32_t>(sensor);
    reading.pose = read->pose;
    reading.hasOrientation = true;
    reading.device_s = sensors_[sensor].hasTimes() ? timeOf(read->seconds, read->microseconds) : written_s;
  }

  void check() {
    const auto now = Clock::now();
    if (now - checked_ < kCheckEvery) return;
    checked_ = now;
    if (segment_.isGone())
      throw std::runtime_error("the shared memory of key " + std::to_string(key_) + " was removed");
    if (wand_) wand_->check();
    std::string remark = wand_ ? wand_->fault() : "";
    if (now - heard_ > kQuietFor && segment_.isOurs()) {
      remark =
          "no other program uses the shared memory of key " + std::to_string(key_) + ": trackd has ended";
    }
    if (remark == remark_) return;
    remark_ = remark;
    sink_.remark(remark);
  }

  const int key_;
  const double unit_m_;
  DeviceSink& sink_;
  SharedSegment segment_;
  std::optional<Wand> wand_;
  std::array<TrackdSensorBytes, TrackdSensors::kMost> seen_{};
  std::array<FollowedSensor, TrackdSensors::kMost> sensors_;
  std::vector<std::size_t> changed_;
  std::vector<Reading> readings_;
  double written_s_ = kNone;  // when the daemon last wrote
  std::string remark_;
  Clock::time_point checked_ = Clock::now(), heard_ = checked_, looked_ = checked_, sound_ = checked_;
};

int readKey(std::string_view text) {
  const bool isHex = text.starts_with("0x");
  const std::string_view digits = text.substr(isHex ? 2 : 0);
  int key = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), key, isHex ? 16 : 10);
  if (error != std::errc{} || end != digits.data() + digits.size() || key <= 0) {
    throw std::invalid_argument("the key is '" + std::string(text) +
                                "', expected a number from 1 to 2147483647, such as 4126");
  }
  return key;
}

}  // namespace

TrackdSource readTrackdSource(std::string_view text) {
  constexpr std::array<std::string_view, 1> kOptions{"wand"};
  constexpr std::string_view kExample = "shm://4126?wand=4127";
  const SourceUrl url = readSourceUrl(text, "shm", 0, kOptions, kExample);
  if (url.endpoint.port != 0) {
    throw std::invalid_argument("shared memory has no port, expected one such as '" + std::string(kExample) +
                                '\'');
  }
  TrackdSource source{readKey(url.endpoint.host)};
  const auto wand = url.options.find("wand");
  if (wand != url.options.end()) source.wand = readKey(wand->second);
  return source;
}

Transport trackdTransport(const TrackdSource& source, double unit_m) {
  return [source, unit_m](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kTrackdPause, [&] { std::make_unique<Session>(source, unit_m, sink)->run(stop); });
  };
}

}  // namespace carom
