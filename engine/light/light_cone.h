#pragma once
// Computes what an eye sees: the emission events of a body's points on the past light cone of one observation
// event.
//
// The equations are solved in the rest frame of each leg (engine/light/emission_kernel.glsl has them). This
// module turns a world line into the few numbers for each leg that the solve needs, in double.
// Theory: app/doc/physics.md, Emission.

#include <array>
#include <optional>
#include <vector>

#include "engine/light/emission_kernel.h"
#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

using LegView = kernel::LegView;

/// Selects which event of each point of a body is shown.
enum class ViewTime {
  seen,      ///< the event whose light the eye receives (without retardation: as boardNow)
  boardNow,  ///< the event at the eye's board time, as if its light had come straight from there
  myNow,     ///< the event that is simultaneous with the observation in the head's frame
};
inline constexpr std::array<ViewTime, 3> kViewTimes{ViewTime::seen, ViewTime::boardNow, ViewTime::myNow};

/// The legs of one body on which any of its points may have emitted the light that one eye receives.
struct BodyView {
  std::vector<LegView> legs;  ///< never empty
  std::size_t firstLeg = 0;   ///< index of the first of them in the world line
  double appears_m = 0.0;     ///< c (appears − t_o): a point whose light left before this is unseen
  bool retarded = true;       ///< whether the kernel solves with retardation
  bool contracted = true;     ///< and with contraction
};

/// Returns the same numbers in float, as the GPU takes them.
kernel_float::LegView toFloat(const LegView& leg);

/// The frame in which the kernel gives the seen places, from the eye, and the transform from there to the
/// frame in which walls draw.
struct ViewFrame {
  ViewFrame(const Lorentz& headFromBoard, const Switches& switches, ViewTime moment = ViewTime::seen);

  /// The head's frame; without aberration, or for an event at a moment of the board's, the board's frame with
  /// the head's axes.
  Lorentz seenFromBoard;
  /// At a moment of the board's, rayThrough() this matrix turns seen places into drawn ones. Otherwise they
  /// are equal.
  Lorentz drawnFromSeen;
  /// The frame in which walls draw: the head's, or without aberration the board's with the head's axes.
  Lorentz drawnFromBoard;
};

/// Fills `view`, whose memory is reused, for an eye at the board event `observation` with the head frame
/// `headFromBoard`. The seen places are in that frame (or in the one that ViewFrame says), from the eye. The
/// switches colour and searchlight do not matter; at the head's own moment, bodies are always contracted.
///
/// The head's own moment may lie ahead on the board: at a place r by β·(r − r_o)/c, where β is the head's
/// v/c. Where the world line is not known so far, its last leg is continued.
void viewBody(const WorldLine& line, const Event& observation, const Lorentz& headFromBoard, BodyView& view,
              const Switches& switches = {}, ViewTime moment = ViewTime::seen);

/// Returns the event of a body-fixed point, `offset_m` from the centre in the body's rest frame, that the
/// view shows: the kernel in double.
kernel::VertexEmission emissionIn(const BodyView& view, const Vec3& offset_m);

/// Returns the place of such an event from the eye, in the frame of viewBody().
inline Vec3 seenFromEye(const BodyView& view, const kernel::VertexEmission& emission) {
  return kernel::seenFromEye(view.legs[static_cast<std::size_t>(emission.leg)], emission.event);
}

/// Returns the centre's event whose light the eye receives (without retardation: the event at the eye's board
/// time), with the reading of its own clock there.
Motion centreSeen(const WorldLine& line, const Event& observation, const Switches& switches = {});

/// The event at which the light that the eye receives was emitted.
struct Emission {
  Event event;           ///< board frame
  Displacement seen;     ///< emission − observation, in the head frame
  Vec3 u{0.0};           ///< γβ of the point at emission, board frame
  double doppler = 1.0;  ///< ν_seen/ν_emitted
  double properTime_s =
      0.0;  ///< along the point's own world line, from `appears_s` where given, else from board time 0
};

/// Returns the emission event of one body-fixed point, `offset_m` from the centre in the body's rest frame;
/// none if the body did not exist yet on the eye's past cone.
std::optional<Emission> emission(const WorldLine& line, const Vec3& offset_m, const Event& observation,
                                 const Lorentz& headFromBoard);

}  // namespace carom
