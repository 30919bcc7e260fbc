#pragma once
// The colours of the views of time, in one place so that a legend can name them: sRGB. They differ for every
// eye that sees blue, and the patterns differ for everyone.

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// Ghosts "now on the board", which are striped one way.
constexpr glm::vec3 kBoardNowColour(0.30F, 0.75F, 1.0F);
/// Ghosts "my now", which are striped both ways.
constexpr glm::vec3 kMyNowColour(1.0F, 0.45F, 0.85F);
/// Markers where pucks met each other or a cushion, or were struck by a cue.
constexpr glm::vec3 kEventColour(0.95F, 0.95F, 0.95F);
/// Flashes, and their light on its way.
constexpr glm::vec3 kFlashColour(1.0F, 0.93F, 0.35F);
/// A stroke on its way to its puck, and the light that brings back the news of it.
constexpr glm::vec3 kStrokeColour(1.0F, 0.98F, 0.85F), kStrokeBackColour(0.62F, 0.72F, 0.90F);
/// Angles between paths, and light along the ruler.
constexpr glm::vec3 kAngleColour(1.0F, 0.78F, 0.45F);
constexpr glm::vec3 kRulerLightColour(1.0F, 0.9F, 0.2F);
/// Pulses of light that the scenario gives, in turn.
constexpr std::array<glm::vec3, 3> kPulseColours{
    {{1.0F, 0.97F, 0.75F}, {0.55F, 0.95F, 1.0F}, {1.0F, 0.65F, 0.95F}}};

/// The platform's motion; a round object of the board as it is in the moving room; the platform's thrust; and
/// the thrust at its limit.
constexpr glm::vec3 kMotionColour(1.0F, 0.62F, 0.15F), kContractedColour(0.45F, 0.90F, 0.45F),
    kThrustColour(0.74F, 0.66F, 1.0F), kLimitColour(1.0F, 0.28F, 0.22F);

/// Converts sRGB to linear light, IEC 61966-2-1.
inline glm::vec3 linearOf(const glm::vec3& code) {
  glm::vec3 linear{0.0F};
  for (int i = 0; i < 3; ++i) {
    linear[i] = code[i] <= 0.04045F ? code[i] / 12.92F : std::pow((code[i] + 0.055F) / 1.055F, 2.4F);
  }
  return linear;
}

/// Converts linear light to sRGB.
inline glm::vec3 codeOf(const glm::vec3& linear) {
  glm::vec3 code{0.0F};
  for (int i = 0; i < 3; ++i) {
    code[i] =
        linear[i] <= 0.0031308F ? 12.92F * linear[i] : 1.055F * std::pow(linear[i], 1.0F / 2.4F) - 0.055F;
  }
  return code;
}

/// Returns the colour of light from a body of this linear colour, as a mark: so bright that it stands out
/// from the cloth for every eye.
inline glm::vec3 lightOf(const glm::vec3& body) {
  constexpr float kLeast = 0.45F;
  const float bright = glm::dot(body, glm::vec3(0.2126F, 0.7152F, 0.0722F));
  return codeOf(bright < kLeast ? glm::mix(body, glm::vec3(1.0F), (kLeast - bright) / (1.0F - bright))
                                : body);
}

}  // namespace carom
