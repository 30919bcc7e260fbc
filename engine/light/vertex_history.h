#pragma once
// The whole world line of one body-fixed point with its bounces, in the board frame, as a list of pieces. It
// is continuous and slower than light. For single points; meshes use the emission kernel.
// Theory: app/doc/physics.md, Bounce and catching up.

#include <optional>
#include <vector>

#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// One piece. From `start` until the start of the next piece the point moves straight, with γβ = u, or with
/// its body, which glides under friction or spins.
struct VertexPiece {
  /// A leg on which a point does not move straight, and the point's place on the body.
  struct OnLeg {
    Knot knot;
    Vec3 offset_m{0.0};
  };
  Event start;
  Vec3 u{0.0};
  double properTime_s = 0.0;   ///< the point's own clock at the start
  std::optional<OnLeg> onLeg;  ///< of a point that does not move straight
};

/// Returns the pieces of the point `offset_m` from the centre (rest frame of the body). The first piece
/// reaches back without end. The point's clock shows 0 at the body's appearance, or else at board time 0.
///
/// Rigid motion: centre(t) + L(v) d, with L(v) d = d + (1/γ − 1)(d·v̂) v̂ in board time. Spin: Rot(φ(τ)) d
/// in the centre's rest frame, where τ is its time; on the board a helix. Bounces: the point keeps to its
/// leg until the signal arrives at light speed, then catches up with the next (emission_kernel.glsl).
std::vector<VertexPiece> vertexHistory(const WorldLine& line, const Vec3& offset_m);

/// Returns how long after the last turn, by the centre's own clock, all points within the line's radius have
/// joined the last leg, counted from the last leg that all had joined. The bound is proved for legs without
/// friction (with it, for decelerations that change little while light crosses the body). Where none of the
/// legs is faster than 0.95 c and none has friction, it is twice the longest of 64 points around the body if
/// that is less: for turns in the board's plane, and by experiment, not by proof. Where more than 32 legs
/// have begun since all had joined one, it is three times the longest of 16 points, whatever the speeds: by
/// experiment, too.
double joinedAfter_s(const WorldLine& line);

/// Returns the piece on which the point is at board time `t_s`.
const VertexPiece& pieceAt(const std::vector<VertexPiece>& history, double t_s);

/// Return the place, γβ and the point's own clock on a piece, continued both ways, at board time `t_s`.
Vec3 placeAt(const VertexPiece& piece, double t_s, double c_m_s);
Vec3 uAt(const VertexPiece& piece, double t_s, double c_m_s);
double properTimeAt(const VertexPiece& piece, double t_s, double c_m_s);

/// Returns the one event of the history on the past light cone of `observation`.
Event eventOnPastCone(const std::vector<VertexPiece>& history, const Event& observation, double c_m_s);

}  // namespace carom
