#include "engine/light/mesh_emission.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace carom {
namespace {

using glm::vec3;
using glm::vec4;
using FloatLeg = kernel_float::LegView;

/// Points are solved in blocks: what only the solve itself asks for then stays on the stack.
constexpr std::size_t kBlock = 1024;

/// One block.
struct Block {
  const float* x;
  const float* y;
  const float* z;
  float* seenX;
  float* seenY;
  float* seenZ;
  float* doppler;
  float* boardTime;
  std::size_t count;
};

// The same as parameters: GCC believes __restrict of parameters only, and without it no loop is vectorised.
#define CAROM_ARRAYS                                                                                        \
  const float* __restrict x, const float* __restrict y, const float* __restrict z, float* __restrict seenX, \
      float* __restrict seenY, float* __restrict seenZ, float* __restrict doppler,                          \
      float* __restrict boardTime, std::size_t count
#define CAROM_ARRAYS_OF(block)                                                                      \
  block.x, block.y, block.z, block.seenX, block.seenY, block.seenZ, block.doppler, block.boardTime, \
      block.count

// D = |seen|/ℓ, distance in the head frame over distance in the body frame.
[[gnu::always_inline]] inline float dopplerOf(const vec3& seen, float distanceInBody) {
  return std::sqrt(glm::dot(seen, seen)) / distanceInBody;
}

/// The short path: the kernel for a single leg.
template <bool kDetails>
[[gnu::always_inline]] inline void onOneLeg(FloatLeg leg, CAROM_ARRAYS) {
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 d(x[i], y[i], z[i]);
    const vec4 event(-kernel_float::extraDistance(leg, d), d);
    const vec3 seen = kernel_float::seenFromEye(leg, event);
    seenX[i] = seen.x;
    seenY[i] = seen.y;
    seenZ[i] = seen.z;
    if constexpr (kDetails) {
      doppler[i] = dopplerOf(seen, kernel_float::distanceInBody(leg, event));
      boardTime[i] = kernel_float::boardTimeOf(leg, event);
    }
  }
}

/// The kernel for a single leg on which the body spins, with kSteps steps.
template <bool kDetails, int kSteps>
[[gnu::always_inline]] inline void onOneSpinningLeg(FloatLeg leg, CAROM_ARRAYS) {
  for (std::size_t i = 0; i < count; ++i) {
    const vec4 event = kernel_float::spinEmission(leg, vec3(x[i], y[i], z[i]), kSteps);
    const vec3 seen = kernel_float::seenFromEye(leg, event);
    seenX[i] = seen.x;
    seenY[i] = seen.y;
    seenZ[i] = seen.z;
    if constexpr (kDetails) {
      // The light's way against the four-velocity γ_w (1, w) of the point.
      const vec3 place(event.y, event.z, event.w);
      const vec3 w = leg.spin.x * vec3(-place.y, place.x, 0.0F);
      const float way = kernel_float::distanceInBody(leg, event) - glm::dot(w, leg.eye - place);
      doppler[i] = dopplerOf(seen, way) * std::sqrt(std::max(1.0F - glm::dot(w, w), 0.0F));
      boardTime[i] = kernel_float::boardTimeOf(leg, event);
    }
  }
}

/// The distance that light reaching the eye from `event` travels in the rest frame of the previous leg:
/// its wave vector (ℓ, e − x) against that frame's four-velocity, the first column of fromPrevious.
[[gnu::always_inline]] inline float distanceInPrevious(const FloatLeg& leg, const vec4& event) {
  const vec4 u = leg.fromPrevious[0];
  const vec3 toEye = leg.eye - vec3(event.y, event.z, event.w);
  return u.x * (leg.distance - event.x) - glm::dot(vec3(u.y, u.z, u.w), toEye);
}

/// Between two legs: the kernel for legCount = 2, both outcomes computed and one chosen. On the incoming leg
/// the vertex rests, so A is the event (t_n + |d − x_n|, d). The way from A to B is a + s (|gap|/w, gap) with
/// w the speed of catching up and 0 ≤ s ≤ 1; the retarded root of T − s |gap|/w = |X − s gap| is
/// s = C/(b + sqrt(b² − a C)),  C = T² − X²,  b = T |gap|/w − X·gap,  a = gap² (1/w² − 1).
template <bool kDetails>
[[gnu::always_inline]] inline void betweenTwoLegs(FloatLeg from, FloatLeg to, CAROM_ARRAYS) {
  const vec3 signalPlace(to.signalInPrevious.y, to.signalInPrevious.z, to.signalInPrevious.w);
  const float slowness = 1.0F / kernel_float::catchUpSpeed();
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 d(x[i], y[i], z[i]);
    const vec4 onFrom(-kernel_float::extraDistance(from, d), d);
    const float onTo = -kernel_float::extraDistance(to, d);

    const vec3 fromSignal = d - signalPlace;
    const float left = to.signalInPrevious.x + std::sqrt(glm::dot(fromSignal, fromSignal));
    const bool reached = onFrom.x >= left;

    const vec4 a = to.originInThis + to.fromPrevious * vec4(left, d);  // A
    const vec3 gap = d - vec3(a.y, a.z, a.w);
    const float gapSquared = glm::dot(gap, gap);
    const float duration = std::sqrt(gapSquared) * slowness;
    const bool catchingUp = onTo < a.x + duration;  // before B

    const float T = to.distance - a.x;
    const vec3 X = to.eye - vec3(a.y, a.z, a.w);
    const float distance = std::sqrt(glm::dot(X, X));
    const float product = (T - distance) * (T + distance);
    const float b = T * duration - glm::dot(X, gap);
    const float root =
        std::sqrt(kernel_float::max(b * b - gapSquared * (slowness * slowness - 1.0F) * product, 0.0F));
    const float s = product / kernel_float::max(b + root, std::numeric_limits<float>::min());
    const float share = catchingUp ? s : 1.0F;
    const vec4 event(catchingUp ? a.x + s * duration : onTo, a.y + share * gap.x, a.z + share * gap.y,
                     a.w + share * gap.z);

    const vec3 seenTo = kernel_float::seenFromEye(to, event);
    const vec3 seenFrom = kernel_float::seenFromEye(from, onFrom);
    const vec3 seen(reached ? seenTo.x : seenFrom.x, reached ? seenTo.y : seenFrom.y,
                    reached ? seenTo.z : seenFrom.z);
    seenX[i] = seen.x;
    seenY[i] = seen.y;
    seenZ[i] = seen.z;
    if constexpr (kDetails) {
      const float onOutgoing =
          catchingUp ? distanceInPrevious(to, event) : kernel_float::distanceInBody(to, event);
      const float onIncoming = kernel_float::distanceInBody(from, onFrom);
      doppler[i] = dopplerOf(seen, reached ? onOutgoing : onIncoming);
      const float boardTimeTo = kernel_float::boardTimeOf(to, event);
      const float boardTimeFrom = kernel_float::boardTimeOf(from, onFrom);
      boardTime[i] = reached ? boardTimeTo : boardTimeFrom;
    }
  }
}

// The same loops for each instruction set. None contracts, so all give the same bits.
#define CAROM_LOOPS(NAME, TARGET)                                                              \
  template <bool kDetails>                                                                     \
  struct NAME {                                                                                \
    TARGET static void oneLeg(const FloatLeg& leg, const Block& block) {                       \
      onOneLeg<kDetails>(leg, CAROM_ARRAYS_OF(block));                                         \
    }                                                                                          \
    template <int kSteps>                                                                      \
    TARGET static void oneSpinningLeg(const FloatLeg& leg, const Block& block) {               \
      onOneSpinningLeg<kDetails, kSteps>(leg, CAROM_ARRAYS_OF(block));                         \
    }                                                                                          \
    TARGET static void twoLegs(const FloatLeg& from, const FloatLeg& to, const Block& block) { \
      betweenTwoLegs<kDetails>(from, to, CAROM_ARRAYS_OF(block));                              \
    }                                                                                          \
  };
CAROM_LOOPS(Baseline, )
CAROM_LOOPS(Avx2, CAROM_AVX2)
CAROM_LOOPS(Avx512, CAROM_AVX512)

bool glides(const LegView& leg) { return leg.glide.w > 0.0; }
bool spins(const LegView& leg) { return leg.spin.w > 0.0; }
bool spinsUniformly(const LegView& leg) { return spins(leg) && !glides(leg) && !kernel::isSlowed(leg); }

/// The least 1/γ² of a point: floats may put one of a rim at all but the speed of light a little beyond the
/// rim.
constexpr double kLeastByGamma = 1e-14;

/// (γ, γβ) in the frame of the leg of a vertex that keeps to it: at rest, but for friction and spin.
glm::dvec4 fourVelocity(const LegView& leg, const Vec3& offset, const glm::dvec4& event) {
  if (spins(leg)) {
    const Vec3 w = kernel::spinVelocity(leg, Vec3(event.y, event.z, event.w), event.x);
    return glm::dvec4(1.0, w) / std::sqrt(std::max(1.0 - glm::dot(w, w), kLeastByGamma));
  }
  if (!glides(leg)) return {1.0, 0.0, 0.0, 0.0};
  const glm::dvec4 flow = kernel::glideFlow(leg, offset, glm::dot(leg.toBoardTime, event), true);
  const Vec3 step(flow.y, flow.z, flow.w);
  return flow / std::sqrt(flow.x * flow.x - glm::dot(step, step));
}

/// Chains of bounces, spin in a bounce, and friction: the kernel in double, a vertex at a time. Written out
/// here, it is 5 % faster than with calls.
[[gnu::flatten]] void alongChain(const BodyView& view, const Block& block) {
  for (std::size_t i = 0; i < block.count; ++i) {
    const Vec3 offset(block.x[i], block.y[i], block.z[i]);
    const kernel::VertexEmission emission =
        kernel::solveEmission(view.legs.data(), static_cast<int>(view.legs.size()), offset);
    const LegView& leg = view.legs[static_cast<std::size_t>(emission.leg)];
    const Vec3 seen = kernel::seenFromEye(leg, emission.event);
    block.seenX[i] = static_cast<float>(seen.x);
    block.seenY[i] = static_cast<float>(seen.y);
    block.seenZ[i] = static_cast<float>(seen.z);
    if (block.doppler == nullptr) continue;
    const glm::dvec4 u =
        emission.catchingUp ? leg.fromPrevious[0] : fourVelocity(leg, offset, emission.event);
    const Vec3 toEye = leg.eye - Vec3(emission.event.y, emission.event.z, emission.event.w);
    const double distance_m =
        u.x * kernel::distanceInBody(leg, emission.event) - glm::dot(Vec3(u.y, u.z, u.w), toEye);
    block.doppler[i] = static_cast<float>(glm::length(seen) / distance_m);
    block.boardTime[i] = static_cast<float>(kernel::boardTimeOf(leg, emission.event));
  }
}

template <class Loops>
void solveBlock(const BodyView& view, const std::array<FloatLeg, 2>& legs, const Block& block) {
  const bool straight = std::none_of(view.legs.begin(), view.legs.end(),
                                     [](const LegView& leg) { return glides(leg) || spins(leg); });
  if (view.legs.size() == 1 && straight) {
    Loops::oneLeg(legs[0], block);
  } else if (view.legs.size() == 2 && straight) {
    Loops::twoLegs(legs[0], legs[1], block);
  } else if (view.legs.size() == 1 && spinsUniformly(view.legs[0])) {
    const bool fast = view.legs[0].spin.w > 4.0;
    (fast ? Loops::template oneSpinningLeg<6> : Loops::template oneSpinningLeg<4>)(legs[0], block);
  } else {
    alongChain(view, block);
  }
}

template <bool kDetails>
void solveBlock(const BodyView& view, const std::array<FloatLeg, 2>& legs, InstructionSet instructions,
                const Block& block) {
  switch (instructions) {
    case InstructionSet::baseline:
      return solveBlock<Baseline<kDetails>>(view, legs, block);
    case InstructionSet::avx2:
      return solveBlock<Avx2<kDetails>>(view, legs, block);
    case InstructionSet::avx512:
      return solveBlock<Avx512<kDetails>>(view, legs, block);
  }
}

/// Takes the place from the points whose light left before the body appeared; returns how many.
std::size_t hideUnseen(const Block& block, float appears_m) {
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < block.count; ++i) {
    if (!(block.boardTime[i] < appears_m)) continue;
    block.seenX[i] = block.seenY[i] = block.seenZ[i] = std::numeric_limits<float>::quiet_NaN();
    ++unseen;
  }
  return unseen;
}

}  // namespace

std::size_t seePoints(const BodyView& view, const Points& offsets, const SeenPoints& seen,
                      InstructionSet instructions) {
  assert(offsets.size() == seen.size());
  assert(view.retarded && view.contracted);
  const std::array<FloatLeg, 2> legs{toFloat(view.legs.front()), toFloat(view.legs.back())};
  const bool mayBeUnseen = std::isfinite(view.appears_m);
  const bool details = mayBeUnseen || !seen.doppler.empty() || !seen.boardTime_m.empty();
  std::array<float, kBlock> dopplerUnasked;
  std::array<float, kBlock> boardTimeUnasked;
  std::size_t unseen = 0;
  for (std::size_t first = 0; first < offsets.size(); first += kBlock) {
    Block block{offsets.x_m.data() + first,
                offsets.y_m.data() + first,
                offsets.z_m.data() + first,
                seen.x_m.data() + first,
                seen.y_m.data() + first,
                seen.z_m.data() + first,
                nullptr,
                nullptr,
                std::min(kBlock, offsets.size() - first)};
    if (details) {
      block.doppler = seen.doppler.empty() ? dopplerUnasked.data() : seen.doppler.data() + first;
      block.boardTime = seen.boardTime_m.empty() ? boardTimeUnasked.data() : seen.boardTime_m.data() + first;
      solveBlock<true>(view, legs, instructions, block);
    } else {
      solveBlock<false>(view, legs, instructions, block);
    }
    if (mayBeUnseen) unseen += hideUnseen(block, static_cast<float>(view.appears_m));
  }
  return unseen;
}

}  // namespace carom
