// What a vertex costs. Rows NAME/N for N vertices on one thread and NAME_all/N on all; "a vertex" is the
// time of one, in nanoseconds. Two yardsticks (a copy of the arrays, a 3×4 matrix on them), the paper's
// table, and the engine's solves; last, the memory of the paper's table 1 scene after 1000 frames.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "bench/paper_table.h"
#include "counted_new.h"
#include "engine/billiard/billiard.h"
#include "engine/light/mesh_view.h"
#include "engine/light/ring_view.h"

namespace carom::bench {
namespace {

constexpr double kC_m_s = 1.42;
constexpr double kRadius_m = 0.1;

/// x, y, z of n vertices.
struct Arrays {
  explicit Arrays(std::size_t n) : x(n), y(n), z(n) {}
  std::vector<float> x, y, z;
  Points points() const { return {x, y, z}; }
  SeenPoints seen() { return {x, y, z, {}, {}}; }
};

/// A sphere in rows of vertices, as meshes are: neighbours in the array are neighbours in space.
Arrays sphere(std::size_t n) {
  Arrays mesh(n);
  const double turns = std::sqrt(static_cast<double>(n) * M_PI) / 2.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double height = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double angle_rad = turns * std::acos(height) * 2.0;
    const double ring_m = kRadius_m * 0.999 * std::sqrt(1.0 - height * height);
    mesh.x[i] = static_cast<float>(ring_m * std::cos(angle_rad));
    mesh.y[i] = static_cast<float>(ring_m * std::sin(angle_rad));
    mesh.z[i] = static_cast<float>(kRadius_m * 0.999 * height);
  }
  return mesh;
}

/// Runs work(first, count) on slices of n vertices: on this thread, or on all.
void inSlices(std::size_t n, bool all, const std::function<void(std::size_t, std::size_t)>& work) {
  if (!all) return work(0, n);
  constexpr std::size_t kGrain = 16;
  const std::size_t slices = (n + MeshView::kSlice - 1) / MeshView::kSlice;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, slices, kGrain), [&](const auto& range) {
    const std::size_t first = range.begin() * MeshView::kSlice;
    work(first, std::min(n, range.end() * MeshView::kSlice) - first);
  });
}

void reportVertices(benchmark::State& state, std::size_t n) {
  using Counter = benchmark::Counter;
  state.counters["a vertex"] =
      Counter(static_cast<double>(n), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

CAROM_AVX2 void copyArrays(const Points& in, const SeenPoints& out) {
  std::copy(in.x_m.begin(), in.x_m.end(), out.x_m.begin());
  std::copy(in.y_m.begin(), in.y_m.end(), out.y_m.begin());
  std::copy(in.z_m.begin(), in.z_m.end(), out.z_m.begin());
}

/// (Of parameters only does GCC believe __restrict.)
CAROM_AVX2 void affineArrays(const float* m, const float* __restrict x, const float* __restrict y,
                             const float* __restrict z, float* __restrict outX, float* __restrict outY,
                             float* __restrict outZ, std::size_t count) {
  const float m0 = m[0], m1 = m[1], m2 = m[2], m3 = m[3], m4 = m[4], m5 = m[5];
  const float m6 = m[6], m7 = m[7], m8 = m[8], m9 = m[9], m10 = m[10], m11 = m[11];
  for (std::size_t i = 0; i < count; ++i) {
    outX[i] = m0 * x[i] + m1 * y[i] + m2 * z[i] + m3;
    outY[i] = m4 * x[i] + m5 * y[i] + m6 * z[i] + m7;
    outZ[i] = m8 * x[i] + m9 * y[i] + m10 * z[i] + m11;
  }
}

void copy(benchmark::State& state, std::size_t n, bool all) {
  const Arrays mesh = sphere(n);
  Arrays out(n);
  for (auto _ : state) {
    inSlices(n, all, [&](std::size_t first, std::size_t count) {
      copyArrays(mesh.points().slice(first, count), out.seen().slice(first, count));
    });
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

void affine(benchmark::State& state, std::size_t n, bool all) {
  const Arrays mesh = sphere(n);
  Arrays out(n);
  const float matrix[12]{0.8F, 0.6F, 0.0F, 1.0F, -0.6F, 0.8F, 0.0F, 2.0F, 0.0F, 0.0F, 1.0F, 3.0F};
  for (auto _ : state) {
    inSlices(n, all, [&](std::size_t first, std::size_t count) {
      affineArrays(matrix, &mesh.x[first], &mesh.y[first], &mesh.z[first], &out.x[first], &out.y[first],
                   &out.z[first], count);
    });
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

/// A body at 0.8 c that bounces back at board time 0, its signal from its rim.
WorldLine bouncing() {
  const Vec3 u = uFromBeta({0.8, 0.1, 0.0});
  WorldLine line({{-1.0, -betaFromU(u) * kC_m_s}, u, 0.0, {}, 0.0}, kC_m_s, kRadius_m);
  const Displacement signalInBody{-kRadius_m / kC_m_s, {kRadius_m, 0.0, 0.0}};
  const Event turn{0.0, Vec3(0.0)};
  line.append({turn, uFromBeta({-0.8, 0.1, 0.0}), 0.6, turn + Lorentz::boost(u, kC_m_s) * signalInBody, 0.0});
  return line;
}

/// One body, seen by a walking eye. `mid`: the eye sees it in the middle of its bounce.
void rigid(benchmark::State& state, std::size_t n, bool all, bool mid) {
  const Arrays mesh = sphere(n);
  Arrays out(n);
  const WorldLine line = bouncing();
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.3, 0.4, 0.0}), kC_m_s);
  RigidMeshView view(line, mesh.points());
  int frame = 0;
  for (auto _ : state) {
    // Light from the bounce arrives a second later; the middle of the bounce is seen 0.1 s after that.
    const double later_s = (mid ? 0.1 : -0.5) + 0.001 * (frame++ % 10);
    view.look({1.0 + later_s, {0.0, -kC_m_s, 0.0}}, headFromBoard);
    inSlices(n, all,
             [&](std::size_t first, std::size_t count) { view.see(first, out.seen().slice(first, count)); });
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

/// A disc at 0.8 c whose rim moves at 0.9 c, seen by a walking eye.
void emissionSpin(benchmark::State& state, std::size_t n, bool all) {
  const Arrays mesh = sphere(n);
  Arrays out(n);
  Knot flight{{0.0, Vec3(0.0)}, uFromBeta({0.8, 0.1, 0.0}), 0.0, {}, 0.0, {0.0, 0.9 * kC_m_s / kRadius_m}};
  flight.signal = flight.turn;
  const WorldLine line(flight, kC_m_s, kRadius_m);
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.3, 0.4, 0.0}), kC_m_s);
  RigidMeshView view(line, mesh.points());
  int frame = 0;
  for (auto _ : state) {
    view.look({1.0 + 0.001 * (frame++ % 10), {0.0, -kC_m_s, 0.0}}, headFromBoard);
    inSlices(n, all,
             [&](std::size_t first, std::size_t count) { view.see(first, out.seen().slice(first, count)); });
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

void emission(benchmark::State& state, std::size_t n, bool all) { rigid(state, n, all, false); }
void emissionBounce(benchmark::State& state, std::size_t n, bool all) { rigid(state, n, all, true); }

/// A second of samples of a mesh that breathes as it drifts: 128 of them, fewer where that would be
/// gigabytes.
VertexRing breathing(const Arrays& mesh) {
  const std::size_t n = mesh.points().size();
  const std::size_t samples = std::clamp<std::size_t>(100'000'000 / n, 12, 128);
  VertexRing ring(n, samples, kC_m_s);
  Arrays sample(n);
  const std::vector<float> simultaneous(n);
  for (std::size_t k = 0; k < samples; ++k) {
    const double t_s = static_cast<double>(k) / static_cast<double>(samples);
    const float breath = static_cast<float>(1.0 + 0.2 * std::sin(6.0 * t_s));
    for (std::size_t i = 0; i < n; ++i) {
      sample.x[i] = mesh.x[i] * breath;
      sample.y[i] = mesh.y[i] * breath;
      sample.z[i] = mesh.z[i];
    }
    ring.append({{t_s, {0.3 * t_s, 0.0, 0.0}}, simultaneous, sample.x, sample.y, sample.z});
  }
  return ring;
}

void ring(benchmark::State& state, std::size_t n, bool all) {
  Arrays out(n);
  const VertexRing history = breathing(sphere(n));
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.3, 0.4, 0.0}), kC_m_s);
  RingView view(history);
  int frame = 0;
  for (auto _ : state) {
    // 60 frames a second, to and fro.
    const double t_s = 0.9 + 0.1 * std::sin(frame++ / 6.0);
    view.look({t_s, {0.1, -0.5, 0.2}}, headFromBoard);
    inSlices(n, all,
             [&](std::size_t first, std::size_t count) { view.see(first, out.seen().slice(first, count)); });
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

using SeeTable = void (*)(const PaperTable&, const TableEvent&, float*, float*, float*);

/// 1000 frames of a puck to and fro between cushions.
template <SeeTable kSee>
void paperTable(benchmark::State& state, std::size_t n, bool) {
  const Arrays mesh = sphere(n);
  Arrays out(n);
  PaperTable table(n * kTableEvents);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < kTableEvents; ++k) {
      const float ct_m = static_cast<float>(k) / 60.0F * static_cast<float>(kC_m_s);
      const float x_m = std::abs(std::fmod(0.5F * ct_m, 5.68F) - 2.84F) - 1.42F;
      table[i * kTableEvents + k] = {ct_m, x_m + mesh.x[i], mesh.y[i], mesh.z[i], ct_m * 0.6F};
    }
  }
  int frame = 0;
  for (auto _ : state) {
    const float walked_m = 0.3F * std::sin(static_cast<float>(frame++) / 6.0F);
    const TableEvent eye{999.0F / 60.0F * static_cast<float>(kC_m_s), walked_m, -1.0F, 0.8F, 0.0F};
    kSee(table, eye, out.x.data(), out.y.data(), out.z.data());
    benchmark::ClobberMemory();
  }
  reportVertices(state, n);
}

/// The paper's measurement: 10 pucks that meet in pairs, each pair along its own lane between the cushions.
BilliardSetup tableOne() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.84, 1.42};
  for (int i = 0; i < 10; ++i) {
    const double side = i % 2 == 0 ? -1.0 : 1.0;
    setup.pucks.push_back(
        {std::to_string(i), 0.0305, 0.02, 0.2, {0.7 * side, 0.284 * (i / 2) - 0.568}, {-0.8 * side, 0.0}});
  }
  return setup;
}

/// That scene, 4960 vertices seen by two eyes through 1000 frames: all that is held beside the mesh and the
/// arrays that are drawn, the game's own records included.
void tableOneMemory(benchmark::State& state) {
  const Arrays mesh = sphere(496);
  Arrays out(496);
  std::size_t held = 0;
  std::size_t knots = 0;
  for (auto _ : state) {
    const std::size_t before = test::bytesHeld();
    Billiard billiard(tableOne());
    std::vector<std::unique_ptr<RigidMeshView>> views;
    for (const WorldLine& line : billiard.worldLines()) {
      for (int eye = 0; eye < 2; ++eye) views.push_back(std::make_unique<RigidMeshView>(line, mesh.points()));
    }
    for (int frame = 0; frame < 1000; ++frame) {
      const double t_s = frame / 60.0;
      billiard.advanceTo(t_s);
      for (std::size_t i = 0; i < views.size(); ++i) {
        views[i]->look({t_s, {i % 2 == 0 ? -0.032 : 0.032, -1.0, 0.8}}, Lorentz(kC_m_s));
        views[i]->see(0, out.seen());
      }
    }
    held = test::bytesHeld() - before;
    knots = 0;
    for (const WorldLine& line : billiard.worldLines()) knots += line.knots().size();
  }
  state.counters["bytes"] = static_cast<double>(held);
  state.counters["knots"] = static_cast<double>(knots);
  state.counters["bytes of tables"] = 4960.0 * kTableEvents * sizeof(TableEvent);
}

struct Row {
  const char* name;
  void (*run)(benchmark::State&, std::size_t, bool);
  std::vector<std::size_t> sizes;
  bool onAllThreads;  // too
};

/// One thread is timed by its own clock, which other work on the machine does not run; all by the wall's.
void registerRow(const Row& row, bool all) {
  for (const std::size_t n : row.sizes) {
    const std::string name = row.name + std::string(all ? "_all/" : "/") + std::to_string(n);
    benchmark::internal::Benchmark* const made = benchmark::RegisterBenchmark(name.c_str(), row.run, n, all);
    if (all) made->UseRealTime();
    made->Unit(benchmark::kMicrosecond)

        ->ComputeStatistics("least", [](const std::vector<double>& runs) {
          return *std::min_element(runs.begin(), runs.end());
        });
  }
}

void registerRows() {
  const std::vector<std::size_t> sizes{1488, 4960, 100'000, 1'000'000, 8'000'000};
  const std::vector<std::size_t> tableSizes{1488, 4960, 20'000};
  const Row rows[]{{"copy", copy, sizes, true},
                   {"affine", affine, sizes, true},
                   {"paper_table_in_step", paperTable<seeInStep>, tableSizes, false},
                   {"paper_table", paperTable<seeOneByOne>, tableSizes, false},
                   {"emission", emission, sizes, true},
                   {"emission_spin", emissionSpin, sizes, true},
                   {"emission_bounce", emissionBounce, sizes, true},
                   {"ring", ring, sizes, true}};
  for (const Row& row : rows) registerRow(row, false);
  for (const Row& row : rows) {
    if (row.onAllThreads) registerRow(row, true);
  }
  benchmark::RegisterBenchmark("memory_table_1", tableOneMemory)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
  carom::bench::registerRows();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
