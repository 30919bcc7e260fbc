// Triangles of any mesh: their footprint is refused, or it is an outline around them. Each corner is two
// bytes, which often lie on each other and on one line; the first byte says in which size.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

#include "cave/outlines/footprint.h"
#include "engine/polygons/outline.h"
#include "fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t kMost = 600;  // bytes: more take long
  if (size < 7 || size > kMost) return 0;
  std::vector<glm::dvec2> triangles;
  for (std::size_t i = 1; i + 5 < size; i += 6)
    for (std::size_t k = 0; k < 6; k += 2)
      triangles.emplace_back(std::ldexp(bytes[i + k] - 128.0, bytes[0] % 64 - 32),
                             std::ldexp(bytes[i + k + 1] - 100.0, bytes[0] % 64 - 32));
  try {
    const carom::Footprint footprint = carom::footprintOf(triangles);
    carom::test::expect(!carom::faultOf(footprint.corners), "a footprint is an outline");
    carom::test::expect(footprint.radius > 0.0 && std::isfinite(footprint.radius), "it has a radius");
    const carom::Outline outline(footprint.corners);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const glm::dvec2 a = triangles[i + 1] - triangles[i], b = triangles[i + 2] - triangles[i];
      if (std::abs(a.x * b.y - a.y * b.x) == 0.0) continue;  // it covers nothing
      for (std::size_t k = 0; k < 3; ++k) {
        const double outside = outline.clearanceOf(triangles[i + k] - footprint.centre).outside;
        carom::test::expect(outside <= 1e-6 * footprint.radius, "it contains every triangle");
      }
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
