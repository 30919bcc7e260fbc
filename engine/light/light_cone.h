#pragma once
// What an eye sees: for one observation event, the emission events of a body's points on its past cone.
//
// The solve is made in the rest frame of each leg (see engine/light/emission_kernel.glsl for the equations);
// here a world line becomes the few numbers a leg that the solve needs, in double.

#include <optional>
#include <vector>

#include "engine/light/emission_kernel.h"
#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

using LegView = kernel::LegView;

/// Which event of each point of a body is shown.
enum class ViewTime {
  seen,      ///< the one whose light the eye receives (without retardation: as boardNow)
  boardNow,  ///< the one at the eye's board time, taken for light that has come straight from there
  myNow,     ///< the one at the head's own time of the observation, where it is in the head's frame
};

/// The legs of one body on which any of its points may have emitted the light that one eye receives.
struct BodyView {
  std::vector<LegView> legs;  ///< never empty
  std::size_t firstLeg = 0;   ///< index in the world line of the first of them
  double appears_m = 0.0;     ///< c (appears − t_o): a point whose light left before this is unseen
  bool retarded = true;       ///< what the kernel is to be told of the switches
  bool contracted = true;
};

/// The same numbers as the GPU takes them.
kernel_float::LegView toFloat(const LegView& leg);

/// The frame in which the kernel gives seen places, from the eye, and what then becomes of them.
struct ViewFrame {
  ViewFrame(const Lorentz& headFromBoard, const Switches& switches, ViewTime moment = ViewTime::seen);

  /// The head's; without aberration, or for what is taken at a moment of the board's, the board's with the
  /// head's axes.
  Lorentz seenFromBoard;
  /// At a moment of the board's: rayThrough() this matrix makes seen places drawn ones. Otherwise they are.
  Lorentz drawnFromSeen;
  /// The frame in which walls draw: the head's, or without aberration the board's with the head's axes.
  Lorentz drawnFromBoard;
};

/// Fills `view` (its memory is reused) for an eye at the board event `observation` whose head frame is
/// `headFromBoard`; the seen places are in that frame (or else as ViewFrame says), from the eye. Of the
/// switches, colour and searchlight do not matter; bodies at the head's own moment are always contracted.
///
/// The head's moment may lie ahead on the board: at a place r by β·(r − r_o)/c, β being the head's v/c. Where
/// the world line is not known so far, its last leg goes on.
void viewBody(const WorldLine& line, const Event& observation, const Lorentz& headFromBoard, BodyView& view,
              const Switches& switches = {}, ViewTime moment = ViewTime::seen);

/// The centre's event whose light the eye receives (without retardation: at the eye's board time), with its
/// own clock's reading there.
Motion centreSeen(const WorldLine& line, const Event& observation, const Switches& switches = {});

/// Where and when the light that the eye receives was emitted.
struct Emission {
  Event event;           ///< board frame
  Displacement seen;     ///< emission − observation, in the head frame
  Vec3 u{0.0};           ///< γβ of the point at emission, board frame
  double doppler = 1.0;  ///< ν_seen/ν_emitted
  double properTime_s =
      0.0;  ///< along the point's own world line, from `appears_s` where given, else from board time 0
};

/// The emission event of one body-fixed point, `offset_m` from the centre in the body's rest frame; none
/// if the body did not exist yet on the eye's past cone.
std::optional<Emission> emission(const WorldLine& line, const Vec3& offset_m, const Event& observation,
                                 const Lorentz& headFromBoard);

}  // namespace carom
