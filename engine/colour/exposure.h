#pragma once
// The exposure of the picture. Searchlight makes what lies ahead up to D⁴ times brighter (1500 times at 0.95
// c), and colour without searchlight makes much of the sky dark. An eye would adapt, and so must a picture.
//
// The exposure follows from the head's speed on the board alone, never from what one wall happens to show:
// all walls of all nodes agree, nothing pumps as a puck crosses an edge, and the same session gives the same
// pixels. It is that of an incident-light meter carried along: the picture is divided by the mean brightness
// of the sky, which at rest is 1 all around. From a head with rapidity η the sky at an angle has Doppler
// factor e^x, where equal solid angles of the head's sky hold e^(−x) dx, |x| ≤ η (from D = 1/(γ(1 − βμ))). So
//   mean = ∫ g(e^x) e^(−x) dx / ∫ e^(−x) dx,   g(D) = brightness of white at D / at rest.
// For searchlight alone, g = D⁴, mean = γ²(1 + β²/3): the energy density of isotropic light, as it must be.
// Theory: app/doc/physics.md, Colour.

#include "engine/spacetime/event.h"

namespace carom {

struct Exposure {
  float gain = 1.0F;  ///< multiplies linear light
  float rise = 0.0F;  ///< for the curve to the screen: of gained light x, the screen shows
  float fall = 0.0F;  ///<   x (1 + rise x)/(1 + fall x), which is x for little light and 1 for the brightest
};

/// Returns the exposure for a head that moves on the board at `beta` = v/c below 1. At rest and with both
/// switches off the gain is 1, and white at 1.57 is the screen's white. `searchlight` and `colour` are
/// explained in doppler_colour.h.
Exposure exposureFor(double beta, bool colour, bool searchlight);

}  // namespace carom
