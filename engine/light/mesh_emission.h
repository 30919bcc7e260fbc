#pragma once
// The emission solve for whole meshes: where one eye sees every vertex of a body, many vertices at once.
//
// The equations are those of engine/light/emission_kernel.glsl, solved in float in the rest frame of the
// leg. A body whose points are all seen on one leg takes the short path (one square root and one division a
// vertex), or that of a spinning body; a body between two legs takes the kernel written without branches;
// longer chains of bounces take the kernel itself in double, vertex by vertex.
//
// A solve is a pure function of its spans and starts no thread: a caller that has several bodies knows best
// how to distribute them. Any slice of a mesh gives the same bits as the whole, on every instruction set.
// Theory: app/doc/physics.md, Emission.

#include <cstddef>
#include <span>

#include "engine/base/instruction_set.h"
#include "engine/light/light_cone.h"

namespace carom {

/// Coordinates of points, x of all, then y, then z (metres); the three are of equal length.
struct Points {
  std::span<const float> x_m;
  std::span<const float> y_m;
  std::span<const float> z_m;

  std::size_t size() const { return x_m.size(); }
  Points slice(std::size_t first, std::size_t count) const {
    return {x_m.subspan(first, count), y_m.subspan(first, count), z_m.subspan(first, count)};
  }
};

/// The places at which one eye sees points. The solves write it. Spans must not overlap each other or the
/// input. An unseen point (its light has not arrived yet) has the place NaN.
struct SeenPoints {
  std::span<float> x_m;  ///< head frame, from the eye, along the straight ray that the walls draw
  std::span<float> y_m;
  std::span<float> z_m;
  std::span<float> doppler;      ///< ν_seen/ν_emitted; may be empty: then not computed
  std::span<float> boardTime_m;  ///< c (t − t_o), negative: when the light left; may be empty

  std::size_t size() const { return x_m.size(); }
  SeenPoints slice(std::size_t first, std::size_t count) const {
    return {x_m.subspan(first, count), y_m.subspan(first, count), z_m.subspan(first, count),
            doppler.empty() ? doppler : doppler.subspan(first, count),
            boardTime_m.empty() ? boardTime_m : boardTime_m.subspan(first, count)};
  }
};

/// Solves for the points at the intrinsic `offsets` (from the centre, in the body's rest frame) of the body
/// that one eye sees as `view`, with retardation and contraction. Returns how many of them are unseen.
///
/// A vertex that is catching up with its leg after a bounce has the Doppler factor of its incoming leg. With
/// its own it would be lit and coloured otherwise, and its colour would flash.
std::size_t seePoints(const BodyView& view, const Points& offsets, const SeenPoints& seen,
                      InstructionSet instructions = bestInstructionSet());

}  // namespace carom
