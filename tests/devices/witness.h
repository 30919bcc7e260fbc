#pragma once
// Hears what a transport tells.

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "devices/tracker/device_tracker.h"

namespace carom::test {

/// Everything that a transport tells, in order.
class Witness : public DeviceSink {
 public:
  explicit Witness(Transport transport) : transport_(std::move(transport)) {
    thread_ = std::jthread([this](const std::stop_token& stop) { transport_(stop, *this); });
  }

  void deliver(std::span<const Reading> delivered, std::chrono::steady_clock::time_point arrival) override {
    const std::lock_guard lock(mutex_);
    for (const Reading& reading : delivered) {
      readings_.push_back(reading);
      arrivals_.push_back(arrival);
    }
  }
  void connected() override { note("connected"); }
  void disconnected(const std::string& why) override { note("disconnected: " + why); }
  void failed(const std::string& why) override { note("failed: " + why); }
  void refused() override { note("refused"); }
  void missed(std::uint64_t packets) override { note("missed " + std::to_string(packets)); }

  std::vector<Reading> readings() const {
    const std::lock_guard lock(mutex_);
    return readings_;
  }
  std::vector<std::chrono::steady_clock::time_point> arrivals() const {
    const std::lock_guard lock(mutex_);
    return arrivals_;
  }
  /// Whether one of its notes begins so.
  bool told(const std::string& beginning) const {
    const std::lock_guard lock(mutex_);
    return std::any_of(notes_.begin(), notes_.end(),
                       [&](const auto& note) { return note.starts_with(beginning); });
  }

  std::size_t count(const std::string& what) const {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count(notes_.begin(), notes_.end(), what));
  }

  /// At most a minute, for busy machines.
  bool until(const std::function<bool()>& so) const {
    for (const std::chrono::steady_clock::time_point end =
             std::chrono::steady_clock::now() + std::chrono::seconds(60);
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
      if (so()) return true;
    }
    return false;
  }
  bool untilReadings(std::size_t count) const {
    return until([&] { return readings().size() >= count; });
  }

 private:
  void note(const std::string& what) {
    const std::lock_guard lock(mutex_);
    notes_.push_back(what);
  }

  Transport transport_;
  mutable std::mutex mutex_;
  std::vector<Reading> readings_;
  std::vector<std::chrono::steady_clock::time_point> arrivals_;
  std::vector<std::string> notes_;
  std::jthread thread_;
};

}  // namespace carom::test
