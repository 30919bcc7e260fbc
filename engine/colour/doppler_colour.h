#pragma once
// The colours of moving bodies: Doppler colour and searchlight.
//
// Light keeps L_λ λ⁵ along its way, so what has spectral radiance L' in one frame has, where its frequencies
// are seen D times as high (Rybicki and Lightman, "Radiative Processes in Astrophysics", §4.9),
//   L(λ) = D⁵ L'(Dλ),   in all  ∫L dλ = D⁴ ∫L' dλ.
// A lamp's light comes to a body with D_l = lampToBody, is reflected there in the body's rest frame by
// ρ(λ), which is the body's colour, and comes to the head with D_h = bodyToHead. A lamp that is a black body
// of temperature T stays one, of temperature DT, since D⁵ B(Dλ, T) = B(λ, DT). So the head receives
//   L(λ) = D_h⁵ ρ(D_h λ) D_l⁵ B(D_l D_h λ, T) = ρ(D_h λ) B(λ, D_l D_h T),
// and sees the colour ∫ s(λ) L(λ) dλ, with s = seenPerRadiance: for a body of linear sRGB colour (r, g, b) it
// is a 3×3 matrix times (r, g, b). Two numbers make the matrix: `heat` = D_l D_h T/kReferenceTemperature_K,
// and bodyToHead. White bodies show black bodies of another temperature, and nothing else.
//
// Switches: with colour and searchlight the light is the above. Colour alone keeps the power, D L'(Dλ):
// radiance × D⁻⁴. Searchlight alone keeps the spectrum: radiance × D⁴. Both ways are switched alike.
// A lamp is seen by the body under a solid angle that aberration makes D_l⁻² times as large, so that what it
// lights it lights by D_l⁻² times the above (with searchlight; without, the power is kept).
//
// Hot matter is a black body in its own frame. Its temperature is a convention of this program, so that heat
// can be seen whose mass is a share of the cold mass m: T = 800 K + 2400 K (M/m − 1), at most 6500 K; light
// at 1.42 m/s makes a joule heavy, and no table of heats of real matter applies.
//
// On the GPU (doppler_kernel.glsl) the integral is a sum over six bands of light λ_k,
//   B(λ, heat T)/B(λ, T) ≈ Σ_k c_k(λ) B(λ_k, heat T)/B(λ_k, T),
// with c_k(λ) fitted for all heats: black bodies differ smoothly, and six numbers tell them apart. Then
//   matrix = Σ_k (light in band k) N_k(D_h),   N_k = ∫ s(λ) B(λ, T) c_k(λ) ρ(D_h λ) dλ,
// where lamps add up in the first factor and N_k is a table of one variable.
// Theory: app/doc/physics.md, Colour.

#include <array>
#include <vector>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "engine/colour/spectrum.h"

namespace carom {

/// Returns the matrix above as a sum over the spectrum, in units in which white at heat 1 is (1, 1, 1):
/// column j is the linear sRGB that a body of pure red, green or blue shows. Slow: a reference for the table.
glm::dmat3 colourResponse(double heat, double bodyToHead);

/// The functions N_k over ln bodyToHead as texels of a texture: `kRows` rows of `kColumns`. Beyond its ends
/// N_k is constant, because no part of ρ that changes is in view.
class ColourTable {
 public:
  static constexpr int kRows = 9;
  static constexpr int kColumns = 1024;
  static constexpr double kLargestLog = 1.5;  ///< columns are centred on −kLargestLog … kLargestLog

  ColourTable();

  /// The rows one after another, as OpenGL takes RGBA textures of floats. Rows 0 … 5 hold the first four
  /// bands' part in (red of red, green of red, blue of red, red of blue, … of blue); rows 6 … 8 hold that of
  /// the other two bands, two of these entries in each row.
  const std::vector<glm::vec4>& texels() const { return texels_; }

 private:
  std::vector<glm::vec4> texels_;
};

/// Returns the linear sRGB that white at heat 1 shows, per unit of light in each band (the sum is 1, 1, 1):
/// the constants kWhite… of the kernel.
std::array<Vec3, 6> whiteOfBands();

}  // namespace carom

#define COLOUR_TABLE const ColourTable&
#define KERNEL inline

/// The kernel in float, as the GPU computes it.
namespace carom::colour_kernel {
using glm::dot;
using glm::exp;
using glm::max;
using glm::min;
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using mat3 = glm::mat3;
#include "engine/colour/doppler_kernel.glsl"
}  // namespace carom::colour_kernel

#undef COLOUR_TABLE
#undef KERNEL
