#pragma once
// Light as a spectrum, and the eye that sees it as a colour.
//
// Motion shifts ultraviolet and infrared into view, so three numbers a colour are not enough: what a surface
// reflects and what a lamp sends must be known far outside the visible. Here both are smooth functions of
// every wavelength. Wavelengths are in nanometres (in vacuum), spectra per nanometre; colours are linear sRGB
// (IEC 61966-2-1, white = 1, 1, 1), and may lie outside the screen's gamut (components below 0).
// Theory: app/doc/physics.md, Colour.

#include <glm/mat3x3.hpp>

#include "engine/spacetime/event.h"

namespace carom {

/// The light to which the eye is adapted and under which reflectances are given: a black body of the colour
/// of day. Its ultraviolet and infrared are Planck's, and seen at a Doppler factor D it is a black body
/// again.
inline constexpr double kReferenceTemperature_K = 6500.0;

/// The visible range in steps. The integrals of this module are sums over them; finer steps change no colour
/// by more than 0.1/255.
inline constexpr double kVisibleFirst_nm = 360.0;
inline constexpr double kVisibleStep_nm = 5.0;
inline constexpr int kVisibleCount = 95;
inline double visibleWavelength_nm(int i) { return kVisibleFirst_nm + i * kVisibleStep_nm; }

/// hc/k, m K in nanometres: x = kPlanckSecond_nm_K/(λT) = hν/kT.
inline constexpr double kPlanckSecond_nm_K = 1.438776877e7;

/// Radiance of a black body, B(λ, T) = 2hc²/λ⁵ / (exp(hc/λkT) − 1), in W m⁻² sr⁻¹ nm⁻¹.
double blackBodyRadiance(double wavelength_nm, double temperature_K);

/// Colour-matching functions x̄, ȳ, z̄ of the CIE 1931 2° observer, as sums of half-width Gaussians: Wyman,
/// Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2
/// (2013), eq. (4). Their chromaticities of black bodies are within 0.005 of the tabulated observer's.
Vec3 matchingFunctions(double wavelength_nm);

/// The colour seen per unit of radiance at a wavelength (W m⁻² sr⁻¹, linear sRGB). White surfaces under the
/// reference light are white: the eye is adapted to it by Bradford's transform (Lam 1985; as in ICC.1:2010,
/// annex E), which from a 6500 K black body to D65, the white of sRGB, is a small one.
Vec3 seenPerRadiance(double wavelength_nm);

/// Luminance of a linear sRGB colour, white = 1.
inline double luminanceOf(const Vec3& colour) { return glm::dot(colour, Vec3(0.2126, 0.7152, 0.0722)); }

/// The share of light that surfaces of colour pure red, green and blue reflect at a wavelength: ρ(λ). A
/// surface of colour (r, g, b) reflects r ρ_r + g ρ_g + b ρ_b, which is linear in its colour, as in Mallett
/// and Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance" (EGSR 2019): never below
/// 0, and never above 1, since at every wavelength ρ_r + ρ_g + ρ_b = 1; white and grey are the same grey at
/// all wavelengths, so that they show the light's own spectrum and nothing else.
///
/// The shape is the sigmoid of a quadratic (Jakob and Hanika, "A Low-Dimensional Function Space for Efficient
/// Spectral Upsampling", 2019) made into a partition of unity:
///   ρ_r : ρ_g : ρ_b = e^p : 1 : e^q,   p, q quadratic in  x = (s¹⁰ − 1)/(s¹⁰ + 1) = tanh(5 ln s),  s = λ/560
///   nm.
/// p and q have six coefficients, and that the three primaries are seen as themselves under the reference
/// light is six equations: they follow, exactly. Beyond the visible nothing is known of a painted colour, and
/// the smoothest guess is no change: x tends to ∓1 and ρ to constants: red stays on to the infrared (as
/// nearly all red dyes do), blue to the ultraviolet.
Vec3 reflectanceBasis(double wavelength_nm);

}  // namespace carom
