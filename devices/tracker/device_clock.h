#pragma once
// Converts times of a device's clock to times of this program's clock.

#include <array>
#include <cstddef>
#include <limits>

namespace carom {

/// Fits the offset and the slow drift between a device's clock and ours from pairs of device time and arrival
/// time. Arrival is the device's time plus a delay that is never negative and mostly small, so the fit
/// follows the earliest arrivals of the last 20 s (the lower envelope), never single arrivals: what a busy
/// machine adds to one packet does not move a sample in time. A single absurd stamp changes nothing; where
/// the device's clock has jumped (it was set, or the device restarted) the fit starts anew, five packets
/// after a jump ahead, half a second after a jump back of over 20 ms. (Of a smaller one, what has been fitted
/// is forgotten in 20 s; until then samples seem older by it.)
///
/// The method is that of clock skew measured from one-way delays: the line under all points whose mean
/// distance to them is least is an edge of their lower convex hull. (S. B. Moon, P. Skelly, D. Towsley,
/// "Estimation and removal of clock skew from network delay measurements", IEEE INFOCOM 1999.)
class DeviceClock {
 public:
  /// Converts `device_s`, the stamp of a packet that arrived at `arrival_s` of this program's clock (which
  /// never runs back). Returns when, on this program's clock, the stamp was made: never after `arrival_s`,
  /// and strictly increasing while `device_s` is, if these two agree (packets that arrive at once before an
  /// offset is known come rounding errors apart). A stamp that is not finite counts as made at its arrival.
  double ours_s(double device_s, double arrival_s);

 private:
  /// The earliest arrival in half a second of device time.
  struct Earliest {
    double device_s;
    double offset_s;  // arrival − device time
  };
  /// Packets that do not fit, one after another.
  struct Misfits {
    int count = 0;
    double firstArrival_s = 0.0;
    Earliest first{};
    Earliest least{};
  };

  double offsetAt(double device_s) const;
  double rate() const;
  bool hasJumped(Misfits& misfits, Earliest packet, double arrival_s);
  void restart(Earliest packet);
  void keep(Earliest packet);

  static constexpr std::size_t kMost = 41;
  std::array<Earliest, kMost> earliest_{};  // in order of time
  std::size_t count_ = 0;
  double rate_ = 0.0;  // change of the offset with device time
  Misfits tooEarly_;
  Misfits tooLate_;
  double newestDevice_s_ = -std::numeric_limits<double>::infinity();
  double newestOurs_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace carom
