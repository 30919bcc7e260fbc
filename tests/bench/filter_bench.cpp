// Prints how well velocity filters do on a recorded head: RMS error of a component, of the walking parts
// apart, lag, noise at rest, and the time a sample takes, at 60, 120 and 240 Hz. Then with other noises,
// after gaps, and at rest under noise that lasts.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "devices/filter/head_filter.h"
#include "devices/gap_score.h"
#include "devices/lasting_noise.h"
#include "devices/recorded_head.h"
#include "devices/simulated_heads.h"
#include "devices/unturned_head.h"
#include "devices/velocity_peers.h"

namespace {

using namespace carom;

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
    const NoisyScore score = noisyScoreOf(head, test::headFilter, 3);
    std::printf("  %-22s %6d %6.1f %8s", head.recording, head.rate_hz, 1e3 * head.noise_m,
                head.isRested ? "rest" : "motion");
    for (const double peer_m_s : score.peers_m_s) std::printf(" %8.2f", 1e3 * peer_m_s);
    std::printf(" %8.2f %6.3f\n", 1e3 * score.own_m_s, score.ratio());
  }
}

// The 0.3 s after samples were missing, on recorded and simulated heads.
void printGaps() {
  constexpr int kSeeds = 3, kRate_hz = 60;
  constexpr std::array<double, 4> kGaps_s = {0.1, 0.2, 0.3, 0.5};
  std::vector<SimulatedHead> heads = simulatedHeads(kRate_hz);
  for (const NoisyHead& head : noisyHeads()) {
    if (head.rate_hz == kRate_hz && head.noise_m == kTrackerNoise_m && !head.isRested)
      heads.push_back({head.recording, head.path});
  }
  std::printf("RMS mm/s in the 0.3 s after a gap, 0.3 mm, 60 Hz, mean of %d seeds: carom, 4 Singer, ratio\n",
              kSeeds);
  std::printf("  %-22s", "");
  for (const double gap_s : kGaps_s) std::printf("            %4.0f ms", 1e3 * gap_s);
  std::printf("\n");
  std::array<std::vector<double>, kGaps_s.size()> ratios;
  for (const SimulatedHead& head : heads) {
    std::printf("  %-22s", head.name.c_str());
    for (std::size_t i = 0; i < kGaps_s.size(); ++i) {
      const GapScore own = gapScoreOf(head.path, kGaps_s[i], test::headFilter, kSeeds);
      const GapScore peer = gapScoreOf(
          head.path, kGaps_s[i], [] { return fourSingers(kTrackerNoise_m); }, kSeeds);
      ratios[i].push_back(own.error_m_s / peer.error_m_s);
      std::printf("  %5.1f %5.1f %5.2f", 1e3 * own.error_m_s, 1e3 * peer.error_m_s, ratios[i].back());
    }
    std::printf("\n");
  }
  std::printf("  %-22s", "median, worst");
  for (std::vector<double>& each : ratios) {
    std::sort(each.begin(), each.end());
    std::printf("  %11.2f %5.2f", each[each.size() / 2], each.back());
  }
  std::printf("\n");
}

void printLastingNoise() {
  std::printf("RMS mm/s at rest, noise of 1 mm that lasts for so long, after 5 s, carom and 4 Singer\n");
  for (const double rate_hz : {30.0, 60.0, 120.0, 240.0}) {
    std::printf("  %3.0f Hz", rate_hz);
    for (const double tau_s : {0.02, 0.05, 0.1}) {
      const auto rest = [&](const FilterMaker& make) {
        double mean_m_s = 0.0;
        for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
          LastingNoise noise(seed, 0.001, tau_s, rate_hz);
          mean_m_s +=
              restOf_m_s(make(), rate_hz, [&noise] { return glm::dvec3(0.5, 1.7, -0.3) + noise(); }) / 5.0;
        }
        return 1e3 * mean_m_s;
      };
      std::printf("   %3.0f ms %6.2f %6.2f", 1e3 * tau_s, rest(test::headFilter),
                  rest([] { return fourSingers(0.001); }));
    }
    std::printf("\n");
  }
}

}  // namespace

int main() {
  printGaps();
  printLastingNoise();
  const Path path = recordedHead(2000, 8000);
  struct Entry {
    const char* name;
    std::function<FilterMaker(int rate_hz)> make;
  };
  const std::array<Entry, 5> entries = {{
      {"carom", [](int) { return test::headFilter; }},
      {"4 Singer models", [](int) { return [] { return fourSingers(kTrackerNoise_m); }; }},
      {"Singer Kalman", [](int) { return [] { return oneSinger(kTrackerNoise_m); }; }},
      {"1 euro, tuned", [](int rate_hz) { return [rate_hz] { return tunedOneEuro(rate_hz); }; }},
      {"raw difference", [](int) { return rawDifference; }},
  }};
  constexpr int kSeeds = 20;
  for (const int rate_hz : {60, 120, 240}) {
    const Path head = resampled(path, rate_hz);
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
