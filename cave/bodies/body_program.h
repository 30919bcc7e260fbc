#pragma once
// The programs that draw bodies, and their uniforms: those that all parts share for one eye and wall, and
// those of each part.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/bodies/body_shaders.h"
#include "cave/bodies/hot_bodies.h"
#include "cave/gl/gl_objects.h"
#include "engine/light/light_cone.h"

namespace carom {

/// A leg as the shaders take it.
using GpuLeg = kernel_float::LegView;
inline constexpr int kLegTexels = 17;
static_assert(sizeof(GpuLeg) == kLegTexels * 4 * sizeof(float),
              "shaders/leg_at.glsl reads seventeen texels a leg");
using LegUniform = std::array<float, 4 * std::size_t{kLegTexels}>;

/// The texture units of the legs and of the table of colours.
inline constexpr int kLegUnit = 0, kColourUnit = 1;

/// What the shaders of all parts need of one eye.
struct EyeUniforms {
  glm::mat4 boardFromDrawn{1.0F};
  glm::vec4 headOnBoard{1.0F, 0.0F, 0.0F, 0.0F};
  glm::vec3 eyeOnBoard_m{0.0F};
  glm::vec3 exposure{0.0F};
  int observedWhole_s = 0;
  float observedPart_s = 0.0F;
  float lightSpeed_m_s = 0.0F;
  std::array<glm::vec3, 3> lamps_m{};
  // Of lamps that are followed: from the eye; when they go on, c (t_on − t_o); their light.
  std::array<glm::vec3, 3> lampsFromEye_m{}, lampLights{};
  glm::vec3 lampsOn_m{0.0F};
  glm::vec4 hall_m{0.0F};  ///< from its middle to the walls towards x and y; heights of floor and ceiling
};

/// What they need of one part.
struct PartUniforms {
  glm::mat4 drawnFromSeen{1.0F};
  const GpuLeg* legs = nullptr;  ///< of this body, the first; none if its points have been solved for
  int firstLeg = 0;
  int legCount = 0;
  float appears_m = 0.0F;
  glm::vec3 colour{0.0F};
  float roughness = 0.0F;
  float seenShare = 1.0F;  ///< of its light, which the picture shows
  float tint = 0.0F;       ///< sets its tone off from other parts' (cave/render/edge_pixels.h)
  float nearer = 0.0F;
  glm::vec3 ghostColour{0.0F};
  float hatch_m = 1.0F;
  glm::vec4 middleMotion{1.0F, 0.0F, 0.0F, 0.0F};  ///< of a body whose points have been solved for
  int telling = 0;                                 ///< a `Told`
  HotBlows heat;                                   ///< of a rigid body
  float cooling_m = 1.0F;                          ///< c kCooling_s
};

/// The inputs of a vertex: in the order of MeshVertex, and then those of a body whose points have been solved
/// for (SeenVertex of cave/bodies/seen_rows.h).
inline constexpr std::array<const char*, 6> kVertexInputs{"vertexMC", "normalMC", "surfaceMC",
                                                          "litMC",    "sightMC",  "motionMC"};

class BodyProgram {
 public:
  /// Compiles. Throws std::runtime_error with the compiler's message.
  explicit BodyProgram(const BodyVariant& variant);

  const BodyVariant& variant() const { return variant_; }

  /// Sets those of its uniforms that differ from what it has. It must be in use.
  void set(const EyeUniforms& eye, const glm::mat4& clipFromDrawn, const PartUniforms& part);

  unsigned name() const { return program_; }

 private:
  void set(const EyeUniforms& eye);
  void set(const PartUniforms& part);

  /// A uniform and the value that the program has for it.
  template <typename T>
  struct Uniform {
    int at = -1;  ///< its place; −1 if the program does not have it
    T value{};
    bool isSet = false;

    void set(const T& wanted);
  };
  struct Uniforms {
    Uniform<glm::mat4> clipFromDrawn, boardFromDrawn, drawnFromSeen, drawnFromBody;
    Uniform<glm::vec4> headOnBoard, middleMotion, blowHeats;
    Uniform<HotBlows::Places> blows;
    Uniform<glm::vec3> eyeOnBoard_m, exposure, colour, ghostColour, lampsOn_m;
    Uniform<std::array<glm::vec3, 3>> lamps_m, lampsFromEye_m, lampLights;
    Uniform<glm::vec4> hall_m;
    Uniform<LegUniform> onlyLeg;
    Uniform<int> observedWhole_s, firstLeg, legCount, telling;
    Uniform<float> observedPart_s, lightSpeed_m_s, appears_m, roughness, seenShare, tint, nearer, hatch_m,
        cooling_m;
  };
  BodyVariant variant_;
  GlProgram program_;
  Uniforms has_;
};

}  // namespace carom
