#include "engine/colour/exposure.h"

#include <algorithm>
#include <cmath>

#include "engine/colour/doppler_colour.h"

namespace carom {
namespace {

constexpr double kBrightestAtRest = 1.57;  // in units of white in full light: room for lamps and varnish
constexpr double kFallAtRest = 0.55;
constexpr int kSkyCount = 64;

/// g(D): the luminance of white that rests on the board.
double brightness(double doppler, bool colour, bool searchlight) {
  const auto bodyToHead = static_cast<float>(doppler);
  const double power = colour_kernel::radiancePower(bodyToHead, colour, searchlight);
  if (!colour) return power;
  return power * luminanceOf(Vec3(colour_kernel::seenWhite(colour_kernel::blackBody(bodyToHead))));
}

/// The curve that reaches 1 at `brightest` ≥ kBrightestAtRest: there (1 + rise x)/(1 + fall x) = 1/x. `fall`
/// goes from its value at rest to 1, where the middle of the curve is x/(1 + x), as brightest → ∞; then
/// rise > 0 and the curve increases throughout.
Exposure curveTo(double gain, double brightest) {
  const double fall = 1.0 - (1.0 - kFallAtRest) * kBrightestAtRest / brightest;
  const double rise = (1.0 + fall * brightest) / (brightest * brightest) - 1.0 / brightest;
  return {static_cast<float>(gain), static_cast<float>(rise), static_cast<float>(fall)};
}

}  // namespace

Exposure exposureFor(double beta, bool colour, bool searchlight) {
  if (!colour && !searchlight) return curveTo(1.0, kBrightestAtRest);
  const double rapidity = std::atanh(beta);
  double sum = 0.0;
  double weights = 0.0;
  double brightest = std::max(1.0, brightness(std::exp(rapidity), colour, searchlight));
  for (int i = 0; i < kSkyCount; ++i) {
    const double x = rapidity * ((2.0 * i + 1.0) / kSkyCount - 1.0);
    const double g = brightness(std::exp(x), colour, searchlight);
    sum += g * std::exp(-x);
    weights += std::exp(-x);
    brightest = std::max(brightest, g);
  }
  const double gain = weights / sum;
  return curveTo(gain, kBrightestAtRest * std::max(1.0, gain * brightest));
}

}  // namespace carom
