#include "engine/light/ring_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

namespace carom {
namespace {

// f(t) = c (t_o − t) − |r_o − r(t)| falls along every vertex (it is slower than light), so exactly one pair
// of neighbouring samples has f ≥ 0 before and f < 0 after. Between them the vertex moves straight, (T, X) +
// s (ΔT, ΔX) from the observation, and the retarded root of −T − sΔT = |X + sΔX| is s = C/(B + sqrt(B² − A
// C)),  A = ΔT² − ΔX²,  B = X·ΔX − T ΔT,  C = T² − X² = f (|X| − T).

constexpr std::size_t kRun = VertexRing::kRun;
constexpr double kNear_m = 0.3;  // an eye that steps further is searched for by bisection
using Floats = std::array<float, kRun>;

/// Events of a run of vertices from the observation, and f there.
struct alignas(64) Events {
  Floats t, x, y, z, f;
};

/// For each vertex the sample before its emission and the way from it to the next.
struct alignas(64) Pieces {
  Floats t, x, y, z, dt, dx, dy, dz;
};

/// Where a run's results go.
struct Out {
  float* seenX;
  float* seenY;
  float* seenZ;
  float* doppler;
  float* boardTime;
};

/// Fills `events` with the vertices of a run; returns for how many of them f < 0.
[[gnu::always_inline]] inline std::size_t place(const RingView::Sample& of, std::size_t runIndex,
                                                std::size_t count, Events& __restrict events) {
  const RingView::Sample sample = of;
  const VertexRing::Run& run = sample.runs[runIndex];
  int later = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float T = sample.anchorT + run.ct_m[i];
    const float X = sample.anchorX + run.x_m[i];
    const float Y = sample.anchorY + run.y_m[i];
    const float Z = sample.anchorZ + run.z_m[i];
    const float f = -T - std::sqrt(X * X + Y * Y + Z * Z);
    events.t[i] = T;
    events.x[i] = X;
    events.y[i] = Y;
    events.z[i] = Z;
    events.f[i] = f;
    later += f < 0.0F ? 1 : 0;
  }
  return static_cast<std::size_t>(later);
}

/// Notes the pieces of the vertices whose f changes its sign between the samples.
[[gnu::always_inline]] inline void notePieces(const Events& before, const Events& after, std::size_t count,
                                              Pieces& __restrict pieces) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool here = (before.f[i] >= 0.0F) & (after.f[i] < 0.0F);
    pieces.t[i] = here ? before.t[i] : pieces.t[i];
    pieces.x[i] = here ? before.x[i] : pieces.x[i];
    pieces.y[i] = here ? before.y[i] : pieces.y[i];
    pieces.z[i] = here ? before.z[i] : pieces.z[i];
    pieces.dt[i] = here ? after.t[i] - before.t[i] : pieces.dt[i];
    pieces.dx[i] = here ? after.x[i] - before.x[i] : pieces.dx[i];
    pieces.dy[i] = here ? after.y[i] - before.y[i] : pieces.dy[i];
    pieces.dz[i] = here ? after.z[i] - before.z[i] : pieces.dz[i];
  }
}

/// The vertices that the eye sees after the last sample move on as before it.
inline void noteEnds(const Events& beforeLast, const Events& last, bool single, std::size_t count,
                     Pieces& pieces) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!(last.f[i] >= 0.0F)) continue;
    pieces.t[i] = last.t[i];
    pieces.x[i] = last.x[i];
    pieces.y[i] = last.y[i];
    pieces.z[i] = last.z[i];
    pieces.dt[i] = single ? 1.0F : last.t[i] - beforeLast.t[i];
    pieces.dx[i] = single ? 0.0F : last.x[i] - beforeLast.x[i];
    pieces.dy[i] = single ? 0.0F : last.y[i] - beforeLast.y[i];
    pieces.dz[i] = single ? 0.0F : last.z[i] - beforeLast.z[i];
  }
}

/// Solves every piece. D = |seen|/ℓ, with ℓ = (−T' ΔT + X'·ΔX)/sqrt(A) the distance in the vertex's rest
/// frame.
template <bool kDetails>
[[gnu::always_inline]] inline void solvePieces(const Pieces& pieces, glm::mat4 head, std::size_t count,
                                               float* __restrict seenX, float* __restrict seenY,
                                               float* __restrict seenZ, float* __restrict doppler,
                                               float* __restrict boardTime) {
  for (std::size_t i = 0; i < count; ++i) {
    const float T = pieces.t[i], X = pieces.x[i], Y = pieces.y[i], Z = pieces.z[i];
    const float dT = pieces.dt[i], dX = pieces.dx[i], dY = pieces.dy[i], dZ = pieces.dz[i];
    const float distance = std::sqrt(X * X + Y * Y + Z * Z);
    const float A = dT * dT - (dX * dX + dY * dY + dZ * dZ);
    const float B = X * dX + Y * dY + Z * dZ - T * dT;
    const float C = (distance + T) * (T - distance);
    const float s = C / (B + std::sqrt(std::max(0.0F, B * B - A * C)));
    const glm::vec4 event(T + s * dT, X + s * dX, Y + s * dY, Z + s * dZ);
    const glm::vec4 seen = head * event;
    seenX[i] = seen.y;
    seenY[i] = seen.z;
    seenZ[i] = seen.w;
    if constexpr (kDetails) {
      const float inVertex = event.y * dX + event.z * dY + event.w * dZ - event.x * dT;
      const float seenLength = std::sqrt(seen.y * seen.y + seen.z * seen.z + seen.w * seen.w);
      doppler[i] = seenLength * std::sqrt(std::max(0.0F, A)) / inVertex;
      boardTime[i] = event.x;
    }
  }
}

/// Solves for the first `count` vertices of a run. `cursor` says where to begin, counted from the newest
/// sample, and then where the eye last saw a sample of all of them. Returns how many are unseen.
template <bool kDetails>
[[gnu::always_inline]] inline std::size_t seeRun(std::span<const RingView::Sample> samples,
                                                 const glm::mat4& headFromBoard, std::size_t run,
                                                 std::size_t count, std::uint16_t& cursor, const Out& out) {
  // Back to a sample that the eye sees of every vertex, or to the oldest.
  Events places[2];
  Events* before = &places[0];
  Events* after = &places[1];
  const std::size_t newest = samples.size() - 1;
  std::size_t sample = newest - std::min<std::size_t>(cursor, newest);
  const std::size_t unseen = [&] {
    std::size_t later = place(samples[sample], run, count, *before);
    while (later > 0 && sample > 0) later = place(samples[--sample], run, count, *before);
    return later;
  }();
  std::size_t seenOfAll = sample;

  // Forward until the eye sees the next sample of none.
  Pieces pieces;
  if (unseen > 0) {
    pieces = {};
    pieces.t.fill(std::numeric_limits<float>::quiet_NaN());
  }
  std::size_t later = unseen;
  while (later < count && sample < newest) {
    const std::size_t laterNow = place(samples[++sample], run, count, *after);
    if (laterNow != later) notePieces(*before, *after, count, pieces);
    later = laterNow;
    if (later == 0) seenOfAll = sample;
    std::swap(before, after);
  }
  if (later < count) {
    if (newest > 0) place(samples[newest - 1], run, count, *after);
    noteEnds(*after, *before, newest == 0, count, pieces);
  }
  cursor = static_cast<std::uint16_t>(newest - seenOfAll);
  solvePieces<kDetails>(pieces, headFromBoard, count, out.seenX, out.seenY, out.seenZ, out.doppler,
                        out.boardTime);
  return unseen;
}

/// `count` vertices from a run's first on; `cursors` begins with that run's.
template <bool kDetails>
[[gnu::always_inline]] inline std::size_t seeRuns(std::span<const RingView::Sample> samples,
                                                  const glm::mat4& headFromBoard, std::size_t run,
                                                  std::size_t count, std::uint16_t* cursors, Out out) {
  std::size_t unseen = 0;
  for (std::size_t done = 0; done < count; done += kRun, ++run, ++cursors) {
    unseen += seeRun<kDetails>(samples, headFromBoard, run, std::min(kRun, count - done), *cursors, out);
    out.seenX += kRun;
    out.seenY += kRun;
    out.seenZ += kRun;
    if constexpr (kDetails) {
      out.doppler += kRun;
      out.boardTime += kRun;
    }
  }
  return unseen;
}

using SeeRuns = std::size_t(std::span<const RingView::Sample>, const glm::mat4&, std::size_t, std::size_t,
                            std::uint16_t*, Out);

template <bool kDetails>
CAROM_AVX2 std::size_t seeRunsAvx2(std::span<const RingView::Sample> samples, const glm::mat4& headFromBoard,
                                   std::size_t run, std::size_t count, std::uint16_t* cursors, Out out) {
  return seeRuns<kDetails>(samples, headFromBoard, run, count, cursors, out);
}
template <bool kDetails>
std::size_t seeRunsBaseline(std::span<const RingView::Sample> samples, const glm::mat4& headFromBoard,
                            std::size_t run, std::size_t count, std::uint16_t* cursors, Out out) {
  return seeRuns<kDetails>(samples, headFromBoard, run, count, cursors, out);
}

}  // namespace

RingView::RingView(const VertexRing& ring, InstructionSet instructions)
    : ring_(ring), instructions_(instructions), cursors_(ring.runCount(), 0) {
  samples_.reserve(ring.capacity());
}

void RingView::look(const Event& observation, const Lorentz& headFromBoard) {
  // The step of f at every sample is at most this; a small one moves the emissions by a few samples only.
  const Displacement step = observation - observation_;
  const double step_m = ring_.lightSpeed_m_s() * std::abs(step.dt_s) + glm::length(step.dr_m);
  const bool searchAnew = !(looked_ && step_m <= kNear_m);
  observation_ = observation;
  headFromBoard_ = headFromBoard;

  samples_.clear();
  for (std::size_t k = 0; k < ring_.sampleCount(); ++k) {
    const Displacement anchor = ring_.anchorOf(k) - observation;
    samples_.push_back({static_cast<float>(ring_.lightSpeed_m_s() * anchor.dt_s),
                        static_cast<float>(anchor.dr_m.x), static_cast<float>(anchor.dr_m.y),
                        static_cast<float>(anchor.dr_m.z), ring_.runsOf(k)});
  }
  looked_ = !samples_.empty();
  if (!searchAnew || samples_.empty()) return;
  for (std::size_t run = 0; run < cursors_.size(); ++run) {
    cursors_[run] = static_cast<std::uint16_t>(samples_.size() - 1 - lastBefore(run * kRun));
  }
}

double RingView::fAt(std::size_t sample, std::size_t vertex) const {
  const Displacement d = observation_ - ring_.eventOf(sample, vertex);
  return ring_.lightSpeed_m_s() * d.dt_s - glm::length(d.dr_m);
}

std::size_t RingView::lastBefore(std::size_t vertex) const {
  std::size_t before = 0;
  std::size_t after = ring_.sampleCount();
  while (after - before > 1) {
    const std::size_t middle = (before + after) / 2;
    if (fAt(middle, vertex) >= 0.0) {
      before = middle;
    } else {
      after = middle;
    }
  }
  return before;
}

std::size_t RingView::see(std::size_t first, const SeenPoints& seen) {
  assert(first % kRun == 0);
  if (samples_.empty()) {
    for (const auto& place : {seen.x_m, seen.y_m, seen.z_m}) {
      std::fill(place.begin(), place.end(), std::numeric_limits<float>::quiet_NaN());
    }
    return seen.size();
  }
  const bool details = !seen.doppler.empty() || !seen.boardTime_m.empty();
  const bool avx2 = instructions_ != InstructionSet::baseline;
  SeeRuns* const seeRuns = details ? (avx2 ? seeRunsAvx2<true> : seeRunsBaseline<true>)
                                   : (avx2 ? seeRunsAvx2<false> : seeRunsBaseline<false>);
  const glm::mat4 headFromBoard(headFromBoard_.matrix());
  std::array<float, kSlice> dopplerUnasked;
  std::array<float, kSlice> boardTimeUnasked;
  std::size_t unseen = 0;
  for (std::size_t done = 0; done < seen.size(); done += kSlice) {
    const std::size_t count = std::min(kSlice, seen.size() - done);
    const std::size_t run = (first + done) / kRun;
    const SeenPoints to = seen.slice(done, count);
    const Out out{to.x_m.data(), to.y_m.data(), to.z_m.data(),
                  to.doppler.empty() ? dopplerUnasked.data() : to.doppler.data(),
                  to.boardTime_m.empty() ? boardTimeUnasked.data() : to.boardTime_m.data()};
    unseen += seeRuns(samples_, headFromBoard, run, count, &cursors_[run], out);
  }
  return unseen;
}

RingView::Way RingView::wayFrom(std::size_t sample, std::size_t vertex) const {
  const std::size_t count = ring_.sampleCount();
  const Event start = ring_.eventOf(sample, vertex);
  Way way{start - observation_, {1.0, Vec3(0.0)}, ring_.properTime_s(sample, vertex), 1.0};  // at rest
  if (count > 1) {
    const std::size_t from = std::min(sample, count - 2);
    way.step = ring_.eventOf(from + 1, vertex) - ring_.eventOf(from, vertex);
    way.properTimeStep_s = ring_.properTime_s(from + 1, vertex) - ring_.properTime_s(from, vertex);
  }
  return way;
}

void RingView::properTimes(std::size_t first, std::span<const float> boardTime_m,
                           std::span<double> properTime_s) {
  for (std::size_t i = 0; i < boardTime_m.size(); ++i) {
    const std::size_t vertex = first + i;
    const double t_s = boardTime_m[i] / ring_.lightSpeed_m_s();  // from the observation
    std::size_t before = 0;
    std::size_t after = ring_.sampleCount();
    while (after - before > 1) {
      const std::size_t middle = (before + after) / 2;
      if (ring_.eventOf(middle, vertex).t_s - observation_.t_s <= t_s) {
        before = middle;
      } else {
        after = middle;
      }
    }
    const Way way = wayFrom(before, vertex);
    properTime_s[i] = way.properTime_s + way.properTimeStep_s * ((t_s - way.start.dt_s) / way.step.dt_s);
  }
}

std::optional<Emission> RingView::emission(std::size_t vertex) const {
  if (ring_.sampleCount() == 0 || fAt(0, vertex) < 0.0) return std::nullopt;
  const double c_m_s = ring_.lightSpeed_m_s();
  const Way way = wayFrom(lastBefore(vertex), vertex);
  const double T = c_m_s * way.start.dt_s;
  const double dT = c_m_s * way.step.dt_s;
  const Vec3& X = way.start.dr_m;
  const Vec3& dX = way.step.dr_m;
  const double distance = glm::length(X);
  const double A = dT * dT - glm::dot(dX, dX);
  const double B = glm::dot(X, dX) - T * dT;
  const double C = (distance + T) * (T - distance);
  const double s = C / (B + std::sqrt(std::max(0.0, B * B - A * C)));

  Emission result;
  const Displacement fromEye = way.start + Displacement{s * way.step.dt_s, s * dX};
  result.event = observation_ + fromEye;
  result.seen = headFromBoard_ * fromEye;
  result.u = dX / std::sqrt(A);
  const double distanceInVertex_m = (glm::dot(fromEye.dr_m, dX) - c_m_s * fromEye.dt_s * dT) / std::sqrt(A);
  result.doppler = glm::length(result.seen.dr_m) / distanceInVertex_m;
  result.properTime_s = way.properTime_s + s * way.properTimeStep_s;
  return result;
}

}  // namespace carom
