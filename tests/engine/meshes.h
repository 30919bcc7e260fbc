#pragma once
// Meshes, their results, and ways to compare them, for the tests of whole-mesh solves.

#include <cstring>
#include <thread>
#include <vector>

#include "engine/light/mesh_view.h"
#include "engine/random_world.h"

namespace carom::test {

/// Storage behind Points.
struct Cloud {
  std::vector<float> x, y, z;
  Points points() const { return {x, y, z}; }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

inline Cloud randomCloud(Random& random, std::size_t count, double radius_m) {
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 d = random.inBall(radius_m * 0.999);
    cloud.x.push_back(static_cast<float>(d.x));
    cloud.y.push_back(static_cast<float>(d.y));
    cloud.z.push_back(static_cast<float>(d.z));
  }
  return cloud;
}

/// Storage behind SeenPoints.
struct SeenCloud {
  explicit SeenCloud(std::size_t n) : x(n), y(n), z(n), doppler(n), boardTime(n) {}
  std::vector<float> x, y, z, doppler, boardTime;
  SeenPoints points() { return {x, y, z, doppler, boardTime}; }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  /// The same bits, NaN included.
  bool operator==(const SeenCloud& other) const {
    return same(x, other.x) && same(y, other.y) && same(z, other.z) && same(doppler, other.doppler) &&
           same(boardTime, other.boardTime);
  }

 private:
  static bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
  }
};

/// The whole mesh, its slices shared out among threads.
inline SeenCloud seeOnThreads(MeshView& view, int threadCount) {
  SeenCloud seen(view.size());
  const auto work = [&](int thread) {
    for (std::size_t first = thread * MeshView::kSlice; first < view.size();
         first += threadCount * MeshView::kSlice) {
      const std::size_t count = std::min(MeshView::kSlice, view.size() - first);
      view.see(first, seen.points().slice(first, count));
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < threadCount; ++i) threads.emplace_back(work, i);
  work(0);
  for (std::thread& thread : threads) thread.join();
  return seen;
}

}  // namespace carom::test
