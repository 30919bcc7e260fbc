// A rod that flies towards an eye at half the speed of light: how long does it look, and how blue? The
// engine is used as anyone may use it. Exits with 0 if the answers are those of the textbook.

#include <array>
#include <cmath>
#include <cstdio>

#include <engine/light/mesh_view.h>

int main() {
  constexpr double c_m_s = 1.42;
  constexpr double beta = 0.5;
  const carom::Knot flight{{0.0, {0.0, 0.0, 0.0}}, carom::uFromBeta({beta, 0.0, 0.0}), 0.0, {}, 0.0};
  const carom::WorldLine rod(flight, c_m_s, 0.5);

  // The two ends of the rod, 1 m apart in its rest frame, and an eye at rest 1000 m ahead.
  const std::array<float, 2> x_m{-0.5F, 0.5F};
  const std::array<float, 2> zero_m{};
  carom::RigidMeshView view(rod, {x_m, zero_m, zero_m});
  view.look({0.0, {1000.0, 0.0, 0.0}}, carom::Lorentz(c_m_s));

  std::array<float, 2> seenX_m{}, seenY_m{}, seenZ_m{}, doppler{};
  view.see(0, {seenX_m, seenY_m, seenZ_m, doppler, {}});

  const double length_m = seenX_m[1] - seenX_m[0];
  const double expected = std::sqrt((1.0 + beta) / (1.0 - beta));
  std::printf("It looks %.4f m long and %.4f times as blue; both should be %.4f.\n", length_m, doppler[0],
              expected);
  const bool right = std::abs(length_m - expected) < 1e-3 && std::abs(doppler[0] - expected) < 1e-3;
  return right ? 0 : 1;
}
