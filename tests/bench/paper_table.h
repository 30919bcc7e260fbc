#pragma once
// The paper's history of a vertex (its section 3.2): a table of past events in floats, searched by bisection
// of the sign of the interval and interpolated. What the engine's solves are measured against, as fast as
// this data structure allows.

#include <cstddef>
#include <vector>

namespace carom::bench {

struct TableEvent {
  float ct_m, x_m, y_m, z_m;
  float properTime_s;
};

/// Of each vertex, as in the paper's table 1.
constexpr std::size_t kTableEvents = 1000;

/// kTableEvents of the first vertex, oldest first, then of the next vertex …
using PaperTable = std::vector<TableEvent>;

/// The place from the eye of every vertex when its light left that reaches `eye`; one vertex after the other.
void seeOneByOne(const PaperTable& table, const TableEvent& eye, float* seenX, float* seenY, float* seenZ);

/// The same, 32 vertices in step, so that their cache misses overlap and AVX2 gathers their events.
void seeInStep(const PaperTable& table, const TableEvent& eye, float* seenX, float* seenY, float* seenZ);

}  // namespace carom::bench
