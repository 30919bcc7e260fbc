#pragma once
// The kernel (engine/light/emission_kernel.glsl and the texts it needs) compiled as C++: in double, for
// chains of bounces, and in float, as the GPU computes it. Single answers (`carom observe`) come from
// vertex_history.h.

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/spacetime/world_line.h"

#define LEGS const LegView*
#define LEG const LegView&
#define INOUT(type) type&
#define UNROLLED _Pragma("GCC unroll 8")
#define CATCH_UP_SPEED carom::kCatchUpSpeed

#define KERNEL inline
namespace carom::kernel {
using std::floor;
using std::log;
using std::sqrt;
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat4 = glm::dmat4;
constexpr int MAX_PIECES = 64;
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
// Each text needs those before it.
// clang-format off
#include "engine/light/leg_kernel.glsl"
#include "engine/light/spin_kernel.glsl"
#include "engine/light/glide_kernel.glsl"
#include "engine/light/turning_kernel.glsl"
#include "engine/light/emission_kernel.glsl"
// clang-format on
inline const LegView& legAt(const LegView* legs, int i) { return legs[i]; }
/// Solves with retardation and contraction.
inline VertexEmission solveEmission(const LegView* legs, int legCount, vec3 d) {
  return solveEmission(legs, legCount, d, true, true);
}
}  // namespace carom::kernel
#undef KERNEL

#define KERNEL [[gnu::always_inline]] inline  // or no loop over vertices becomes vector instructions
namespace carom::kernel_float {
using std::floor;
using std::log;
using std::sqrt;
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using mat4 = glm::mat4;
constexpr int MAX_PIECES = 8;
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
// Each text needs those before it.
// clang-format off
#include "engine/light/leg_kernel.glsl"
#include "engine/light/spin_kernel.glsl"
#include "engine/light/glide_kernel.glsl"
#include "engine/light/turning_kernel.glsl"
#include "engine/light/emission_kernel.glsl"
// clang-format on
inline const LegView& legAt(const LegView* legs, int i) { return legs[i]; }
/// Solves with retardation and contraction.
inline VertexEmission solveEmission(const LegView* legs, int legCount, vec3 d) {
  return solveEmission(legs, legCount, d, true, true);
}
}  // namespace carom::kernel_float

#undef LEGS
#undef LEG
#undef CATCH_UP_SPEED
#undef UNROLLED
#undef INOUT
#undef KERNEL
