#include "engine/light/ring_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr std::size_t kVertices = 40, kSamples = 30;

/// A ring of random ways, and the same as plain lists of events.
struct Wanderers {
  VertexRing ring{kVertices, kSamples, kC_m_s};
  std::vector<std::vector<Event>> events{kVertices};

  explicit Wanderers(test::Random& random) {
    for (std::size_t k = 0; k < kSamples; ++k) {
      const Event anchor{0.1 * static_cast<double>(k), {0.0, 0.0, 0.0}};
      std::vector<float> ct_m(kVertices, 0.0f), x_m(kVertices), y_m(kVertices), z_m(kVertices);
      for (std::size_t v = 0; v < kVertices; ++v) {
        const Vec3 last_m = k == 0 ? random.inBox(0.3) : events[v].back().r_m;
        const Vec3 r_m = last_m + random.inBall(k == 0 ? 0.0 : 0.7 * 0.1 * kC_m_s);
        x_m[v] = static_cast<float>(r_m.x), y_m[v] = static_cast<float>(r_m.y),
        z_m[v] = static_cast<float>(r_m.z);
        events[v].push_back({anchor.t_s, {x_m[v], y_m[v], z_m[v]}});
      }
      ring.append({anchor, ct_m, x_m, y_m, z_m});
    }
  }

  Vec3 placeAt(std::size_t v, double t_s) const {
    std::size_t k = 0;
    while (k + 2 < kSamples && events[v][k + 1].t_s <= t_s) ++k;
    const Event &a = events[v][k], &b = events[v][k + 1];
    return a.r_m + (b.r_m - a.r_m) * ((t_s - a.t_s) / (b.t_s - a.t_s));
  }
};

// By bisection of f(t) = c (t_o − t) − |r_o − r(t)| along the whole history, which falls strictly; the view
// searches from where it was and solves on one straight piece. The eye jumps to and fro in time.
TEST(RingView, SeesWhereBisectionOfTheWholeHistoryFindsIt) {
  test::Random random(1);
  const Wanderers wanderers(random);
  RingView view(wanderers.ring);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const Event eye{random.in(1.5, 2.8), random.inBox(1.0)};
    view.look(eye, Lorentz(kC_m_s));
    for (std::size_t v = 0; v < kVertices; ++v) {
      double early_s = 0.0, late_s = eye.t_s;
      for (int step = 0; step < 100; ++step) {
        const double t_s = 0.5 * (early_s + late_s);
        (kC_m_s * (eye.t_s - t_s) > glm::length(eye.r_m - wanderers.placeAt(v, t_s)) ? early_s : late_s) =
            t_s;
      }
      const auto seen = view.emission(v);
      if (early_s == 0.0) {
        EXPECT_FALSE(seen) << "vertex " << v << " was not there yet";
        continue;
      }
      ASSERT_TRUE(seen) << "vertex " << v;
      EXPECT_NEAR(seen->event.t_s, early_s, 1e-6) << "vertex " << v;
      EXPECT_LE(glm::length(seen->event.r_m - wanderers.placeAt(v, early_s)), 1e-6) << "vertex " << v;
    }
  }
}

}  // namespace
}  // namespace carom
