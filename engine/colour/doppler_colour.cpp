#include "engine/colour/doppler_colour.h"

#include <cmath>

namespace carom {
namespace {

constexpr int kBandCount = 6;
using BandValues = std::array<double, kBandCount>;

/// hc/(λkT) of the bands at the reference temperature.
BandValues bandExponents() {
  const auto& first = colour_kernel::kBandsFirst;
  const auto& last = colour_kernel::kBandsLast;
  return {first.x, first.y, first.z, first.w, last.x, last.y};
}

/// B(λ, heat T)/B(λ, T), where x = hc/(λkT).
double brightening(double x, double heat) { return std::expm1(x) / std::expm1(x / heat); }

double exponentOf(double wavelength_nm) {
  return kPlanckSecond_nm_K / (wavelength_nm * kReferenceTemperature_K);
}

/// Returns the seen light of a white surface in the reference light, per step of the spectrum.
Vec3 seenOfReference(double wavelength_nm) {
  return seenPerRadiance(wavelength_nm) * blackBodyRadiance(wavelength_nm, kReferenceTemperature_K) *
         kVisibleStep_nm;
}

// The fit of c_k(λ) is by least squares over heats in equal steps of their logarithm, each weighed by
// 1/luminance, so that cold light is fitted as well as hot.
constexpr int kFitCount = 160;
constexpr double kFitColdest = 0.1;    // 650 K: hardly a glow
constexpr double kFitHottest = 200.0;  // beyond, every spectrum is that of infinite heat, λ⁻⁴
using FitColumn = std::array<double, kFitCount>;

double dot(const FitColumn& a, const FitColumn& b) {
  double sum = 0.0;
  for (int i = 0; i < kFitCount; ++i) sum += a[i] * b[i];
  return sum;
}

double fitHeat(int i) {
  return kFitColdest * std::pow(kFitHottest / kFitColdest, static_cast<double>(i) / (kFitCount - 1));
}

/// Brightening at one wavelength, with x = hc/(λkT), over all heats of the fit, as weighed.
FitColumn fitColumn(double x, const FitColumn& weights) {
  FitColumn column{};
  for (int i = 0; i < kFitCount; ++i) column[i] = weights[i] * brightening(x, fitHeat(i));
  return column;
}

FitColumn fitWeights() {
  FitColumn weights{};
  for (int i = 0; i < kFitCount; ++i) {
    double luminance = 0.0;
    for (int j = 0; j < kVisibleCount; ++j) {
      const double wavelength_nm = visibleWavelength_nm(j);
      luminance +=
          luminanceOf(seenOfReference(wavelength_nm)) * brightening(exponentOf(wavelength_nm), fitHeat(i));
    }
    weights[i] = 1.0 / luminance;
  }
  return weights;
}

/// The bands' columns made orthonormal one after another (Gram–Schmidt, modified): column k of the bands is
/// Σ_{i ≤ k} coefficient[i][k] orthonormal[i].
struct OrthonormalBands {
  std::array<FitColumn, kBandCount> orthonormal;
  std::array<BandValues, kBandCount> coefficient{};
};

OrthonormalBands orthonormalBands(const FitColumn& weights) {
  OrthonormalBands bands;
  for (int k = 0; k < kBandCount; ++k) {
    FitColumn rest = fitColumn(bandExponents()[k], weights);
    for (int i = 0; i < k; ++i) {
      bands.coefficient[i][k] = dot(bands.orthonormal[i], rest);
      for (int n = 0; n < kFitCount; ++n) rest[n] -= bands.coefficient[i][k] * bands.orthonormal[i][n];
    }
    bands.coefficient[k][k] = std::sqrt(dot(rest, rest));
    for (int n = 0; n < kFitCount; ++n) bands.orthonormal[k][n] = rest[n] / bands.coefficient[k][k];
  }
  return bands;
}

/// c_k that bring Σ_k c_k (column of band k) nearest to `wanted`.
BandValues nearest(const OrthonormalBands& bands, FitColumn wanted) {
  BandValues c{};
  for (int k = 0; k < kBandCount; ++k) {
    c[k] = dot(bands.orthonormal[k], wanted);
    for (int n = 0; n < kFitCount; ++n) wanted[n] -= c[k] * bands.orthonormal[k][n];
  }
  for (int k = kBandCount - 1; k >= 0; --k) {
    for (int j = k + 1; j < kBandCount; ++j) c[k] -= bands.coefficient[k][j] * c[j];
    c[k] /= bands.coefficient[k][k];
  }
  return c;
}

/// s(λ) B(λ, T) c_k(λ) dλ of every band, over the visible.
using BandColours = std::array<Vec3, kBandCount>;
std::array<BandColours, kVisibleCount> bandColours() {
  const FitColumn weights = fitWeights();
  const OrthonormalBands bands = orthonormalBands(weights);
  std::array<BandColours, kVisibleCount> colours;
  for (int i = 0; i < kVisibleCount; ++i) {
    const double wavelength_nm = visibleWavelength_nm(i);
    const BandValues c = nearest(bands, fitColumn(exponentOf(wavelength_nm), weights));
    for (int k = 0; k < kBandCount; ++k) colours[i][k] = seenOfReference(wavelength_nm) * c[k];
  }
  return colours;
}

}  // namespace

glm::dmat3 colourResponse(double heat, double bodyToHead) {
  glm::dmat3 response(0.0);
  for (int i = 0; i < kVisibleCount; ++i) {
    const double wavelength_nm = visibleWavelength_nm(i);
    const Vec3 seen = seenOfReference(wavelength_nm) * brightening(exponentOf(wavelength_nm), heat);
    response += glm::outerProduct(seen, reflectanceBasis(bodyToHead * wavelength_nm));
  }
  return response;
}

std::array<Vec3, 6> whiteOfBands() {
  std::array<Vec3, 6> white{};
  for (const BandColours& colours : bandColours()) {
    for (int k = 0; k < kBandCount; ++k) white[k] += colours[k];
  }
  return white;
}

ColourTable::ColourTable() : texels_(static_cast<std::size_t>(kRows) * kColumns) {
  const std::array<BandColours, kVisibleCount> colours = bandColours();
  for (int column = 0; column < kColumns; ++column) {
    const double bodyToHead = std::exp(kLargestLog * (2.0 * column / (kColumns - 1) - 1.0));
    BandColours red{};
    BandColours blue{};
    for (int i = 0; i < kVisibleCount; ++i) {
      const Vec3 reflected = reflectanceBasis(bodyToHead * visibleWavelength_nm(i));
      for (int k = 0; k < kBandCount; ++k) {
        red[k] += reflected.x * colours[i][k];
        blue[k] += reflected.z * colours[i][k];
      }
    }
    const auto texel = [&](int row) -> glm::vec4& {
      return texels_[static_cast<std::size_t>(row) * kColumns + column];
    };
    for (int i = 0; i < 6; ++i) {
      const auto of = [&](int k) { return i < 3 ? red[k][i] : blue[k][i - 3]; };
      texel(i) = glm::vec4(of(0), of(1), of(2), of(3));
      glm::vec4& shared = texel(6 + i / 2);
      shared[2 * (i % 2)] = static_cast<float>(of(4));
      shared[2 * (i % 2) + 1] = static_cast<float>(of(5));
    }
  }
}

namespace colour_kernel {

vec4 colourTexel(const ColourTable& table, int row, real bodyToHead) {
  const float along = 0.5F + 0.5F * std::log(bodyToHead) / static_cast<float>(ColourTable::kLargestLog);
  const float at = glm::clamp(along, 0.0F, 1.0F) * (ColourTable::kColumns - 1);
  const int left = glm::min(static_cast<int>(at), ColourTable::kColumns - 2);
  const vec4* texel = &table.texels()[static_cast<std::size_t>(row) * ColourTable::kColumns + left];
  return glm::mix(texel[0], texel[1], at - static_cast<float>(left));
}

}  // namespace colour_kernel
}  // namespace carom
