#pragma once
// The other side of trackd for tests: real System V shared memory, written as a daemon does.

#include <sys/ipc.h>
#include <sys/shm.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace carom::test {

/// A segment with a key that was free, removed with this object.
class Segment {
 public:
  explicit Segment(std::size_t size, int key = 0) : key_(key) {
    for (int i = 0; key_ == 0 && i < 1000; ++i) {
      const int candidate = static_cast<int>(0x5ca20000 + (getpid() * 16 + i) % 0xffff);
      if (shmget(candidate, 0, 0) < 0) key_ = candidate;
    }
    id_ = shmget(key_, size, IPC_CREAT | IPC_EXCL | 0600);
    if (id_ < 0) throw std::runtime_error("no shared memory");
    bytes_ = static_cast<std::uint8_t*>(shmat(id_, nullptr, 0));
  }
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;
  ~Segment() {
    detach();
    remove();
  }

  int key() const { return key_; }
  std::uint8_t* bytes() { return bytes_; }
  void remove() {
    if (id_ >= 0) shmctl(id_, IPC_RMID, nullptr);
    id_ = -1;
  }
  void detach() {
    if (bytes_) shmdt(bytes_);
    bytes_ = nullptr;
  }

  template <class T>
  void put(std::size_t offset, T value) {
    std::memcpy(bytes_ + offset, &value, sizeof value);
    std::atomic_signal_fence(std::memory_order_seq_cst);  // in this order
  }

 private:
  int key_, id_;
  std::uint8_t* bytes_;
};

/// A segment of sensors. Every number of a pose tells the same count, so that a pose of two counts shows
/// itself.
class TrackdSensorsWriter {
 public:
  static constexpr std::size_t kHeader = 28, kSensor = 40;

  explicit TrackdSensorsWriter(std::uint32_t sensors, int key = 0)
      : segment(kHeader + sensors * kSensor, key) {
    const std::array<std::uint32_t, 7> header{1, sensors, kHeader, kSensor, 0, 0, 0};
    std::memcpy(segment.bytes(), header.data(), sizeof header);
  }

  /// Writes a pose: the place, then the angles (azimuth, elevation, roll), then the time.
  void write(std::uint32_t sensor, const std::array<float, 3>& place, const std::array<float, 3>& angles_deg,
             double time_s) {
    const std::size_t at = kHeader + sensor * kSensor;
    for (std::size_t i = 0; i < 3; ++i) segment.put(at + 4 * i, place[i]);
    for (std::size_t i = 0; i < 3; ++i) segment.put(at + 12 + 4 * i, angles_deg[i]);
    stamp(at + 24, time_s);
    stamp(16, time_s);
  }
  /// The same without a time of the sensor: the header's alone, as some daemons do.
  void writeUnstamped(std::uint32_t sensor, const std::array<float, 3>& place, double time_s) {
    const std::size_t at = kHeader + sensor * kSensor;
    for (std::size_t i = 0; i < 3; ++i) segment.put(at + 4 * i, place[i]);
    stamp(16, time_s);
  }
  void stamp(std::size_t offset, double time_s) {
    const auto seconds = static_cast<std::uint32_t>(time_s);
    segment.put(offset, seconds);
    segment.put(offset + 4, static_cast<std::uint32_t>((time_s - seconds) * 1e6));
  }

  Segment segment;
};

/// A segment of a wand, in trackd's shape.
class TrackdWandWriter {
 public:
  TrackdWandWriter(std::uint32_t buttons, std::uint32_t axes)
      : segment(32 + 4 * (buttons + axes)), axes_(32 + 4 * buttons) {
    const std::array<std::uint32_t, 8> header{1, 32, static_cast<std::uint32_t>(axes_), buttons, axes, 0,
                                              0, 0};
    std::memcpy(segment.bytes(), header.data(), sizeof header);
  }
  void press(std::size_t button, bool pressed) { segment.put(32 + 4 * button, std::int32_t{pressed}); }
  void push(std::size_t axis, float value) { segment.put(axes_ + 4 * axis, value); }

  Segment segment;

 private:
  std::size_t axes_;
};

}  // namespace carom::test
