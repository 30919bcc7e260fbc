// The fitted clock against simulated devices whose true times are known.

#include "devices/tracker/device_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace carom {
namespace {

struct Packet {
  double made_s;  // on our clock: the truth
  double device_s;
  double arrival_s;
};

struct Device {
  double rate_hz = 60.0;
  double ahead_s = 1.7e9;  // of our clock
  double drift = 50e-6;
  double meanDelay_s = 0.0005;
  double burst_s = 0.05;  // now and then packets are held back so long and come at once
  double burstsPerSecond = 0.5;
  unsigned seed = 1;
};

std::vector<Packet> packetsOf(const Device& device, double duration_s) {
  std::mt19937_64 random(device.seed);
  std::exponential_distribution<double> delay_s(1.0 / device.meanDelay_s);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  std::vector<Packet> packets;
  double heldUntil_s = 0.0, newestArrival_s = 0.0;
  for (double made_s = 0.0; made_s < duration_s; made_s += 1.0 / device.rate_hz) {
    if (chance(random) < device.burstsPerSecond / device.rate_hz) heldUntil_s = made_s + device.burst_s;
    newestArrival_s = std::max({made_s + delay_s(random), heldUntil_s, newestArrival_s});
    packets.push_back({made_s, device.ahead_s + made_s * (1.0 + device.drift), newestArrival_s});
  }
  return packets;
}

/// Largest error of a time, and the largest change of the error between one packet and the next.
struct Errors {
  double largest_s = 0.0, largestStep_s = 0.0;
};

Errors errorsOf(DeviceClock& clock, const std::vector<Packet>& packets, double settled_s) {
  Errors errors;
  double last_s = -std::numeric_limits<double>::infinity(), lastError_s = 0.0;
  for (const Packet& packet : packets) {
    const double ours_s = clock.ours_s(packet.device_s, packet.arrival_s);
    EXPECT_LE(ours_s, packet.arrival_s);
    // Until the offset is known, packets that come at once lie rounding errors apart, beyond their arrival.
    EXPECT_GT(ours_s, last_s);
    last_s = ours_s;
    const double error_s = ours_s - packet.made_s;
    if (packet.made_s >= settled_s) {
      errors.largest_s = std::max(errors.largest_s, std::abs(error_s));
      errors.largestStep_s = std::max(errors.largestStep_s, std::abs(error_s - lastError_s));
    }
    lastError_s = error_s;
  }
  return errors;
}

// A head at 1 m/s: 0.2 ms is 0.2 mm of place, less than a tracker's noise; 0.05 ms between samples 16.7 ms
// apart is 0.3 % of speed. Arrival times would be wrong by 50 ms.
TEST(DeviceClock, FindsTimesThroughDelaysBurstsAndDrift) {
  for (const double drift : {-50e-6, 0.0, 50e-6}) {
    for (const double rate_hz : {60.0, 240.0}) {
      for (unsigned seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(testing::Message() << drift << ' ' << rate_hz << " Hz, seed " << seed);
        Device device{.rate_hz = rate_hz, .drift = drift, .seed = seed};
        DeviceClock clock;
        const Errors errors = errorsOf(clock, packetsOf(device, 60.0), 3.0);
        EXPECT_LE(errors.largest_s, 0.0002);
        EXPECT_LE(errors.largestStep_s, 0.00005);
      }
    }
  }
}

// Before a rate can be told the oldest offset holds: 50 ppm over 2 s is 0.1 ms, beside the first delays.
TEST(DeviceClock, IsUsableFromTheFirstSecond) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    DeviceClock clock;
    const Errors errors = errorsOf(clock, packetsOf({.burstsPerSecond = 0.0, .seed = seed}, 4.0), 0.5);
    EXPECT_LE(errors.largest_s, 0.0005) << "seed " << seed;
  }
}

TEST(DeviceClock, AFirstPacketHeldBackDoesNotStay) {
  std::vector<Packet> packets = packetsOf({.burstsPerSecond = 0.0}, 10.0);
  for (Packet& packet : packets) {
    if (packet.made_s < 0.05) packet.arrival_s = 0.05;  // three packets come at once
  }
  packets[0].arrival_s -= 1e-6;  // so that none of them comes at another's time exactly
  packets[1].arrival_s -= 5e-7;
  DeviceClock clock;
  EXPECT_LE(errorsOf(clock, packets, 0.3).largest_s, 0.0005);
}

TEST(DeviceClock, StartsAnewWhenTheDeviceIsSet) {
  for (const double jump_s : {-86400.0, -2.0, -0.05, 0.05, 3600.0}) {
    SCOPED_TRACE(testing::Message() << "jump of " << jump_s << " s");
    std::vector<Packet> packets = packetsOf({}, 30.0);
    for (Packet& packet : packets) {
      if (packet.made_s >= 15.0) packet.device_s += jump_s;
    }
    DeviceClock clock;
    double largest_s = 0.0;
    for (const Packet& packet : packets) {
      const double ours_s = clock.ours_s(packet.device_s, packet.arrival_s);
      ASSERT_LE(ours_s, packet.arrival_s);
      // Half a second, or a burst's length more, until it is believed.
      const bool known = (packet.made_s > 3.0 && packet.made_s < 15.0) || packet.made_s > 16.5;
      if (known) largest_s = std::max(largest_s, std::abs(ours_s - packet.made_s));
    }
    EXPECT_LE(largest_s, 0.0005);  // the first second after a start
  }
}

TEST(DeviceClock, OneAbsurdStampChangesNothing) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double absurd_s : {std::nan(""), infinity, -infinity, 0.0, 1e300, -1e300, 5e9}) {
    SCOPED_TRACE(testing::Message() << "stamp " << absurd_s);
    DeviceClock clock;
    double largest_s = 0.0;
    for (const Packet& packet : packetsOf({}, 20.0)) {
      const bool spoilt = std::abs(packet.made_s - 10.0) < 0.005;
      const double ours_s = clock.ours_s(spoilt ? absurd_s : packet.device_s, packet.arrival_s);
      ASSERT_LE(ours_s, packet.arrival_s);
      if (!spoilt && packet.made_s > 3.0) largest_s = std::max(largest_s, std::abs(ours_s - packet.made_s));
    }
    EXPECT_LE(largest_s, 0.0002);
  }
}

// A stall of 2 s, as of a wireless link, and its burst of old packets do not pass for a jump of the clock.
TEST(DeviceClock, AStallIsNoJump) {
  std::vector<Packet> packets = packetsOf({}, 30.0);
  for (Packet& packet : packets) {
    if (packet.made_s >= 10.0) packet.arrival_s = std::max(packet.arrival_s, 12.0 + packet.made_s * 1e-6);
  }
  DeviceClock clock;
  EXPECT_LE(errorsOf(clock, packets, 3.0).largest_s, 0.0002);
}

TEST(DeviceClock, GoesOnAfterALongSilence) {
  std::vector<Packet> packets = packetsOf({}, 3630.0);
  std::erase_if(packets, [](const Packet& packet) { return packet.made_s > 10.0 && packet.made_s < 3610.0; });
  DeviceClock clock;
  double largest_s = 0.0;
  for (const Packet& packet : packets) {
    const double ours_s = clock.ours_s(packet.device_s, packet.arrival_s);
    if (packet.made_s > 3611.5) largest_s = std::max(largest_s, std::abs(ours_s - packet.made_s));
  }
  EXPECT_LE(largest_s, 0.0005);
}

TEST(DeviceClock, APacketOvertakenKeepsItsEarlierTime) {
  DeviceClock clock;
  for (int i = 0; i < 60; ++i) clock.ours_s(i * 0.01, 5.0 + i * 0.01);
  const double newer_s = clock.ours_s(0.62, 5.62);
  EXPECT_NEAR(newer_s - clock.ours_s(0.61, 5.6205), 0.01, 1e-9);
}

}  // namespace
}  // namespace carom
