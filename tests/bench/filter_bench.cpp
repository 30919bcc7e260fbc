// Prints how well velocity filters do on a recorded head: RMS error of a component, of the walking parts
// apart, lag, noise at rest, and the time a sample takes, at 60, 120 and 240 Hz.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <glm/gtc/quaternion.hpp>

#include "devices/filter/head_filter.h"
#include "devices/recorded_head.h"
#include "devices/velocity_peers.h"

namespace {

using namespace carom;

VelocityFilter ours() {
  return [filter = HeadFilter()](double time_s, const glm::dvec3& position_m) mutable {
    filter.add(time_s, {position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)});
    return filter.at(time_s).celerity_m_s;
  };
}

VelocityFilter rawDifference() {
  return [last_s = 0.0, last_m = glm::dvec3(0.0), first = true](double time_s,
                                                                const glm::dvec3& position_m) mutable {
    const glm::dvec3 velocity_m_s = first ? glm::dvec3(0.0) : (position_m - last_m) / (time_s - last_s);
    first = false;
    last_s = time_s;
    last_m = position_m;
    return velocity_m_s;
  };
}

/// The least of some runs: what other programs take of the machine is not the filter's.
double microsecondsPerSample(const Path& path, const FilterMaker& make) {
  constexpr int kRuns = 7;
  double least_us = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    VelocityFilter filter = make();
    glm::dvec3 sum(0.0);
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < path.times_s.size(); ++i) sum += filter(path.times_s[i], path.positions_m[i]);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    if (sum.x == sum.x)
      least_us = std::min(least_us, spent.count() / static_cast<double>(path.times_s.size()));
  }
  return least_us;
}

// Other noises than the filter begins with, from the first sample in motion and after 15 s at rest.
void printNoises() {
  std::printf("RMS mm/s, noise told to the others but not to carom\n");
  std::printf("  %-22s %6s %6s %8s %8s %8s %8s %8s %8s %6s\n", "", "Hz", "mm", "from", "4 Singer", "Singer",
              "line", "1 euro", "carom", "ratio");
  for (const NoisyHead& head : noisyHeads()) {
    const NoisyScore score = noisyScoreOf(head, ours, 3);
    std::printf("  %-22s %6d %6.1f %8s", head.recording, head.rate_hz, 1e3 * head.noise_m,
                head.isRested ? "rest" : "motion");
    for (const double peer_m_s : score.peers_m_s) std::printf(" %8.2f", 1e3 * peer_m_s);
    std::printf(" %8.2f %6.3f\n", 1e3 * score.own_m_s, score.ratio());
  }
}

}  // namespace

int main() {
  const auto path = recordedHead(2000, 8000);
  if (!path) {
    std::puts("no recording of a head in " CAROM_SHARED_DIR ": nothing to measure");
    return 0;
  }
  struct Entry {
    const char* name;
    std::function<FilterMaker(int rate_hz)> make;
  };
  const std::array<Entry, 5> entries = {{
      {"carom", [](int) { return ours; }},
      {"4 Singer models", [](int) { return [] { return fourSingers(kTrackerNoise_m); }; }},
      {"Singer Kalman", [](int) { return [] { return oneSinger(kTrackerNoise_m); }; }},
      {"1 euro, tuned", [](int rate_hz) { return [rate_hz] { return tunedOneEuro(rate_hz); }; }},
      {"raw difference", [](int) { return rawDifference; }},
  }};
  constexpr int kSeeds = 20;
  for (const int rate_hz : {60, 120, 240}) {
    const Path head = resampled(*path, rate_hz);
    const std::vector<bool> walking = walkingParts(head);
    const auto walked = std::count(walking.begin(), walking.end(), true);
    std::printf("%d Hz, mean of %d seeds (walking: %.0f %% of the time)\n", rate_hz, kSeeds,
                100.0 * static_cast<double>(walked) / static_cast<double>(walking.size()));
    std::printf("  %-16s %10s %10s %8s %10s %12s %12s\n", "", "RMS mm/s", "walking", "lag ms", "rest mm/s",
                "set off ms", "us a sample");
    for (const Entry& entry : entries) {
      const FilterMaker make = entry.make(rate_hz);
      const FilterScore score = scoreOf(head, rate_hz, make, kSeeds);
      std::printf("  %-16s %10.2f %10.2f %8.1f %10.2f %12.1f %12.2f\n", entry.name, 1e3 * score.error_m_s,
                  1e3 * score.walking_m_s, 1e3 * score.lag_s, 1e3 * score.rest_m_s, 1e3 * score.setOff_s,
                  microsecondsPerSample(head, make));
    }
  }
  printNoises();
}
