// What sharing a frame and swapping together costs: run under mpirun with 2, 4, 5 ranks (cluster_bench.sh).
// Not a test; run it by hand on a quiet machine. Prints the median and the 99th percentile of rank 0.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "cave/cluster/cluster.h"

namespace {

using namespace carom;

/// A game of three pucks; every tenth frame brings a knot.
FrameState frameOf(std::uint64_t number) {
  FrameState state;
  state.record.number = number;
  state.record.viewers[0].observer.headFromBoard = Lorentz::boost({0.1, 0.2, 0.3}, 1.42);
  const double t_s = static_cast<double>(number + 1) / 60.0;
  if (number % 10 == 0) state.knots.push_back({1, {{t_s, Vec3(0.0)}, Vec3(0.0), t_s, {}, 0.0}});
  return state;
}

}  // namespace

int main() {
  constexpr std::uint64_t kFrames = 20000;
  Cluster cluster;
  const WorldLine still({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, 1.42, 0.1);
  World world{std::vector<WorldLine>(4, still), {}};
  FrameState state;
  std::vector<double> took_us;
  for (std::uint64_t number = 0; number < kFrames; ++number) {
    if (cluster.rank() == 0) state = frameOf(number);
    const auto start = std::chrono::steady_clock::now();
    cluster.share(state);
    applyFrame(state, world);
    cluster.gatherDrawn(state, world, false);
    cluster.releaseSwap(world);
    took_us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  if (cluster.rank() > 0) return 0;
  std::sort(took_us.begin(), took_us.end());
  fmt::print("{} ranks: median {:.1f} us, 99th percentile {:.1f} us, longest {:.0f} us a frame\n",
             cluster.size(), took_us[kFrames / 2], took_us[kFrames * 99 / 100], took_us.back());
}
