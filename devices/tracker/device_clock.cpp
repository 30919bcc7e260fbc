#include "devices/tracker/device_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr double kBin_s = 0.5;
constexpr double kMemory_s = 20.0;
constexpr double kShortestForRate_s =
    2.0;                               // a drift of 100 ppm is then 0.2 ms, more than the delays' scatter
constexpr double kFastest = 500e-6;    // no quartz, and no clock that is being slewed, is further off
constexpr double kTooEarly_s = 0.005;  // no drift does this between packets: the clock was set ahead
constexpr double kTooLate_s = 0.020;   // usual delays are below
constexpr double kLateFor_s = 0.5;     // … and no burst of them lasts as long without one good packet
constexpr int kMisfits = 5;
constexpr double kAgreement_s = 0.1;  // between stamps of one clock
constexpr double kLargest_s = 1e11;   // doubles have steps of 15 µs there

}  // namespace

double DeviceClock::ours_s(double device_s, double arrival_s) {
  if (!(std::abs(device_s) <= kLargest_s)) return arrival_s;
  const Earliest packet{device_s, arrival_s - device_s};
  if (count_ == 0) restart(packet);

  const double delay_s = packet.offset_s - offsetAt(device_s);
  if (delay_s < -kTooEarly_s) {
    tooLate_.count = 0;
    if (!hasJumped(tooEarly_, packet, arrival_s)) return arrival_s;
    restart(tooEarly_.least);
  } else if (delay_s > kTooLate_s) {
    tooEarly_.count = 0;
    if (hasJumped(tooLate_, packet, arrival_s) && arrival_s - tooLate_.firstArrival_s >= kLateFor_s) {
      restart(tooLate_.least);
    }
  } else {
    tooEarly_.count = tooLate_.count = 0;
    keep(packet);
  }

  double ours_s = std::min(device_s + offsetAt(device_s), arrival_s);
  if (device_s > newestDevice_s_) {
    ours_s = std::max(ours_s, std::nextafter(newestOurs_s_, std::numeric_limits<double>::infinity()));
    newestDevice_s_ = device_s;
    newestOurs_s_ = ours_s;
  }
  return ours_s;
}

/// Notes a misfit; true once there have been enough of them. Those ahead must agree with each other.
bool DeviceClock::hasJumped(Misfits& misfits, Earliest packet, double arrival_s) {
  const bool agrees =
      &misfits == &tooLate_ || std::abs(packet.offset_s - misfits.first.offset_s) < kAgreement_s;
  if (misfits.count == 0 || !agrees) misfits = {0, arrival_s, packet, packet};
  if (packet.offset_s < misfits.least.offset_s) misfits.least = packet;
  return ++misfits.count >= kMisfits;
}

void DeviceClock::restart(Earliest packet) {
  earliest_[0] = packet;
  count_ = 1;
  rate_ = 0.0;
  tooEarly_.count = tooLate_.count = 0;
  newestDevice_s_ = -std::numeric_limits<double>::infinity();
}

/// The line's height: as high as no point lies below it.
double DeviceClock::offsetAt(double device_s) const {
  double offset_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) {
    offset_s = std::min(offset_s, earliest_[i].offset_s + rate_ * (device_s - earliest_[i].device_s));
  }
  return offset_s;
}

void DeviceClock::keep(Earliest packet) {
  const auto end = [&] { return earliest_.begin() + static_cast<std::ptrdiff_t>(count_); };
  const auto forgotten = std::find_if(earliest_.begin(), end(), [&](const Earliest& old) {
    return old.device_s >= packet.device_s - kMemory_s;
  });
  count_ -= static_cast<std::size_t>(forgotten - earliest_.begin());
  std::move(forgotten, forgotten + static_cast<std::ptrdiff_t>(count_), earliest_.begin());

  if (count_ == 0) {
    earliest_[count_++] = packet;
    rate_ = 0.0;
    return;
  }
  const auto bin = [](const Earliest& earliest) { return std::floor(earliest.device_s / kBin_s); };
  if (bin(packet) > bin(earliest_[count_ - 1])) {
    if (count_ < kMost) earliest_[count_++] = packet;
  } else if (bin(packet) == bin(earliest_[count_ - 1])) {
    Earliest& newest = earliest_[count_ - 1];
    if (packet.offset_s < newest.offset_s) newest = packet;
  }  // what comes later than packets of the next bin is no early arrival
  rate_ = rate();
}

/// The slope of the lower convex hull's edge at the mean time of the points; 0 while they lie close together.
double DeviceClock::rate() const {
  const Earliest& first = earliest_[0];
  if (earliest_[count_ - 1].device_s - first.device_s < kShortestForRate_s) return 0.0;
  double mean_s = 0.0;
  for (std::size_t i = 0; i < count_; ++i) mean_s += earliest_[i].device_s - first.device_s;
  mean_s /= static_cast<double>(count_);
  // Andrew's monotone chain, as far as the edge that is asked for.
  std::array<Earliest, kMost> hull;
  std::size_t size = 0;
  const auto turnsUp = [](const Earliest& a, const Earliest& b, const Earliest& c) {
    return (b.offset_s - a.offset_s) * (c.device_s - a.device_s) <
           (c.offset_s - a.offset_s) * (b.device_s - a.device_s);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    while (size >= 2 && !turnsUp(hull[size - 2], hull[size - 1], earliest_[i])) --size;
    hull[size++] = earliest_[i];
  }
  std::size_t right = 1;
  while (right + 1 < size && hull[right].device_s - first.device_s < mean_s) ++right;
  const Earliest &a = hull[right - 1], &b = hull[right];
  return std::clamp((b.offset_s - a.offset_s) / (b.device_s - a.device_s), -kFastest, kFastest);
}

}  // namespace carom
