#include "bench/paper_table.h"

#include "engine/base/instruction_set.h"

namespace carom::bench {
namespace {

constexpr std::size_t kLanes = 32;
constexpr int kFloats = sizeof(TableEvent) / sizeof(float);

/// Δs² of an event from the eye: positive inside the past cone (no event of the table is in the eye's
/// future).
[[gnu::always_inline]] inline float interval(const float* event, const TableEvent& eye) {
  const float ct = event[0] - eye.ct_m;
  const float x = event[1] - eye.x_m;
  const float y = event[2] - eye.y_m;
  const float z = event[3] - eye.z_m;
  return ct * ct - (x * x + y * y + z * z);
}

/// kCount vertices; the bisection halves without branching.
template <std::size_t kCount>
[[gnu::always_inline]] inline void see(const float* first, const TableEvent& eyeEvent,
                                       float* __restrict seenX, float* __restrict seenY,
                                       float* __restrict seenZ) {
  const float* __restrict events = first;
  const TableEvent eye = eyeEvent;
  int before[kCount];
  for (std::size_t k = 0; k < kCount; ++k) before[k] = static_cast<int>(k * kTableEvents) * kFloats;
  for (int left = kTableEvents - 1; left > 1;) {
    const int half = left / 2;
    for (std::size_t k = 0; k < kCount; ++k) {
      const int middle = before[k] + half * kFloats;
      before[k] = interval(events + middle, eye) >= 0.0F ? middle : before[k];
    }
    left -= half;
  }
  for (std::size_t k = 0; k < kCount; ++k) {
    const float* p = events + before[k];
    const float* q = p + kFloats;
    const float a = interval(p, eye);
    const float s = a / (a - interval(q, eye));
    seenX[k] = p[1] + s * (q[1] - p[1]) - eye.x_m;
    seenY[k] = p[2] + s * (q[2] - p[2]) - eye.y_m;
    seenZ[k] = p[3] + s * (q[3] - p[3]) - eye.z_m;
  }
}

}  // namespace

CAROM_AVX2 void seeOneByOne(const PaperTable& table, const TableEvent& eye, float* seenX, float* seenY,
                            float* seenZ) {
  const std::size_t vertices = table.size() / kTableEvents;
  for (std::size_t i = 0; i < vertices; ++i) {
    see<1>(&table[i * kTableEvents].ct_m, eye, seenX + i, seenY + i, seenZ + i);
  }
}

CAROM_AVX2 void seeInStep(const PaperTable& table, const TableEvent& eye, float* seenX, float* seenY,
                          float* seenZ) {
  const std::size_t vertices = table.size() / kTableEvents;
  std::size_t i = 0;
  for (; i + kLanes <= vertices; i += kLanes) {
    see<kLanes>(&table[i * kTableEvents].ct_m, eye, seenX + i, seenY + i, seenZ + i);
  }
  for (; i < vertices; ++i) {
    see<1>(&table[i * kTableEvents].ct_m, eye, seenX + i, seenY + i, seenZ + i);
  }
}

}  // namespace carom::bench
