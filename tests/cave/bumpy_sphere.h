#pragma once
// A closed mesh of any number of triangles, for tests and for trying how large meshes open.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace carom::test {

/// Returns a binary PLY of a sphere with bumps and a diameter of about 1: `rings` by 2 `rings` cells of two
/// triangles each. Rows of points run around z; all points of the first and of the last are the poles.
inline std::string bumpySphere(int rings) {
  const std::int64_t around = 2 * rings;
  std::string ply = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      (rings + 1) * around, 2 * rings * around);
  const auto add = [&](const auto& value) {
    ply.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const auto place = [&](double polar, double azimuth) {
    const double r_m = 0.5 + 0.01 * std::sin(40.0 * polar) * std::sin(40.0 * azimuth);
    add(static_cast<float>(r_m * std::sin(polar) * std::cos(azimuth)));
    add(static_cast<float>(r_m * std::sin(polar) * std::sin(azimuth)));
    add(static_cast<float>(r_m * std::cos(polar)));
  };
  const auto triangle = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    add(static_cast<std::uint8_t>(3));
    for (const std::int64_t corner : {a, b, c}) add(static_cast<std::int32_t>(corner));
  };
  for (int ring = 0; ring <= rings; ++ring) {
    for (int k = 0; k < around; ++k) place(std::numbers::pi * ring / rings, std::numbers::pi * k / rings);
  }
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    for (std::int64_t k = 0; k < around; ++k) {
      const std::int64_t a = ring * around + k, b = ring * around + (k + 1) % around;
      triangle(a, a + around, b);
      triangle(b, a + around, b + around);
    }
  }
  return ply;
}

}  // namespace carom::test
