#pragma once
// Where the history of a body's point places it, and how exactly.

#include <vector>

#include "engine/light/vertex_history.h"
#include "engine/light_speed.h"

namespace carom::test {

/// Coordinates of metres, a chain of 20 boosts with γ up to 2.3.
inline constexpr double kHistoryRounding_m = 1e-11;

inline Vec3 placeAt(const std::vector<VertexPiece>& history, double t_s) {
  return carom::placeAt(pieceAt(history, t_s), t_s, kC_m_s);
}

}  // namespace carom::test
