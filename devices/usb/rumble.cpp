#include "devices/usb/rumble.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::uint16_t kSony = 0x054c;
constexpr auto kLookForGamepad = 1s;
constexpr auto kSayAgain = 1s;         // pads stop by themselves when nothing more is said for some seconds
constexpr std::uint8_t kSteps = 0xF8;  // what a hand tells apart; fewer reports

bool isDualShock4(const HidEntry& entry) {
  return entry.vendor == kSony && (entry.product == 0x05c4 || entry.product == 0x09cc);
}
bool isDualSense(const HidEntry& entry) { return entry.vendor == kSony && entry.product == 0x0ce6; }

/// An open pad, and what it does.
class Pad {
 public:
  explicit Pad(HidEntry entry) : entry_(std::move(entry)), device_(entry_.node) {}

  bool isOpen() const { return device_.isOpen(); }

  /// False where it is gone.
  bool setRumble(std::uint8_t strength, Clock::time_point now) {
    const bool again = strength > 0 && now - said_ >= kSayAgain;
    if (strength == strength_ && !again) return true;
    strength_ = strength;
    said_ = now;
    return device_.write(rumbleReport(entry_, strength));
  }

 private:
  HidEntry entry_;
  HidDevice device_;
  std::uint8_t strength_ = 0;
  Clock::time_point said_{};
};

std::unique_ptr<Pad> findPad() {
  for (const HidEntry& entry : listHid()) {
    if (!entry.usb || rumbleReport(entry, 0).empty()) continue;
    auto pad = std::make_unique<Pad>(entry);
    if (pad->isOpen()) return pad;
  }
  return nullptr;
}

}  // namespace

std::vector<std::uint8_t> rumbleReport(const HidEntry& pad, std::uint8_t strength) {
  std::vector<std::uint8_t> report;
  if (isDualShock4(pad)) {
    report.resize(32);
    report[0] = 0x05;
    report[1] = 0x01;                  // what follows for the motors counts
    report[4] = report[5] = strength;  // right (weak), left (strong)
  } else if (isDualSense(pad)) {
    report.resize(48);
    report[0] = 0x02;
    report[1] = 0x03;  // motors as older pads have them, in place of its own haptics
    report[3] = report[4] = strength;
  }
  return report;
}

/// The wished strength, and the thread that sets it.
struct Rumble::Hand {
  std::mutex mutex;
  std::condition_variable_any changed;
  std::uint8_t strength = 0;
  Clock::time_point knocksUntil{};
  std::uint64_t wishes = 0;  // so far
  std::jthread thread;

  std::uint8_t wished(Clock::time_point now) const { return now < knocksUntil ? 255 : strength; }
  void run(const std::stop_token& stop);
};

void Rumble::Hand::run(const std::stop_token& stop) {
  std::unique_ptr<Pad> pad;
  std::optional<Clock::time_point> looked;
  std::uint64_t seen = 0;
  for (std::unique_lock lock(mutex); !stop.stop_requested();) {
    const Clock::time_point now = Clock::now();
    const std::uint8_t wish = wished(now);
    Clock::time_point until = now + kSayAgain;
    if (now < knocksUntil) until = knocksUntil;
    seen = wishes;
    lock.unlock();  // a wish never waits for the device
    if (!pad && wish > 0 && (!looked || now - *looked >= kLookForGamepad)) {
      pad = findPad();
      looked = now;
    }
    if (pad && !pad->setRumble(wish, now)) pad.reset();
    lock.lock();
    const auto isNew = [&] { return wishes != seen; };
    if (wish > 0) {
      changed.wait_until(lock, stop, until, isNew);
    } else {
      changed.wait(lock, stop, isNew);
    }
  }
  if (pad) pad->setRumble(0, Clock::now());
}

Rumble::Rumble() : hand_(std::make_unique<Hand>()) {
  hand_->thread = std::jthread([hand = hand_.get()](const std::stop_token& stop) { hand->run(stop); });
}

Rumble::~Rumble() = default;

void Rumble::set(double strength) {
  const auto wanted = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(strength, 0.0, 1.0)) & kSteps);
  const std::lock_guard lock(hand_->mutex);
  if (wanted == hand_->strength) return;
  hand_->strength = wanted;
  ++hand_->wishes;
  hand_->changed.notify_one();
}

void Rumble::pulse() {
  const std::lock_guard lock(hand_->mutex);
  hand_->knocksUntil =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kPulse_s));
  ++hand_->wishes;
  hand_->changed.notify_one();
}

}  // namespace carom
