#include "cave/bodies/body_shaders.h"

#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include "cave/frame/hall.h"
#include "engine/light/spin_steps.h"
#include "engine/spacetime/world_line.h"
#include "shaders/body_vert.h"
#include "shaders/colour_texel.h"
#include "shaders/digits.h"
#include "shaders/doppler_kernel.h"
#include "shaders/emission_kernel.h"
#include "shaders/glide_kernel.h"
#include "shaders/hall_colours.h"
#include "shaders/highlight.h"
#include "shaders/leg_at.h"
#include "shaders/leg_kernel.h"
#include "shaders/legs.h"
#include "shaders/light_types.h"
#include "shaders/mirror.h"
#include "shaders/noise.h"
#include "shaders/paint_bands.h"
#include "shaders/paint_clock.h"
#include "shaders/paint_cloth.h"
#include "shaders/paint_floor.h"
#include "shaders/paint_ghost.h"
#include "shaders/paint_lamp.h"
#include "shaders/paint_metal.h"
#include "shaders/paint_panels.h"
#include "shaders/paint_plain.h"
#include "shaders/paint_puck.h"
#include "shaders/paint_sectors.h"
#include "shaders/paint_shadow.h"
#include "shaders/paint_soft.h"
#include "shaders/paint_wood.h"
#include "shaders/spin_kernel.h"
#include "shaders/surface_frag.h"
#include "shaders/turning_kernel.h"

namespace carom {
namespace {

const std::string kPreamble = "#version 150\n";

std::string paintText(Paint paint) {
  switch (paint) {
    case Paint::plain:
      return shaders::paint_plain;
    case Paint::cloth:
      return std::string(shaders::noise) + shaders::paint_cloth;
    case Paint::wood:
      return std::string(shaders::noise) + shaders::paint_wood;
    case Paint::floor:
      return shaders::paint_floor;
    case Paint::panels:
      return std::string(shaders::hall_colours) + shaders::paint_panels;
    case Paint::puck:
      return shaders::paint_puck;
    case Paint::soft:
      return shaders::paint_soft;
    case Paint::bands:
      return shaders::paint_bands;
    case Paint::metal:
      return shaders::paint_metal;
    case Paint::sectors:
      return shaders::paint_sectors;
    case Paint::shadow:
      return shaders::paint_shadow;
    case Paint::clock:
      return std::string(shaders::digits) + shaders::paint_clock;
    case Paint::lamp:
      return shaders::paint_lamp;
  }
  return shaders::paint_plain;
}

/// Returns whether this paint has no varnish, whatever the roughness of its part.
bool isMatt(Paint paint) { return paint == Paint::cloth || paint == Paint::panels || paint == Paint::shadow; }

bool mirrors(Legs legs, Paint paint) { return legs == Legs::rest && isPolished(paint); }

/// Returns the definitions that differ from one program to another.
ShaderParts variantParts(const BodyVariant& variant) {
  const auto& [legs, paint, switches, moment, followsLamps, isHot] = variant;
  const auto define = [](const char* name, bool value) {
    return std::string("#define ") + name + (value ? " true\n" : " false\n");
  };
  const bool ghost = moment != ViewTime::seen;
  const bool retarded = !ghost && switches.retardation;
  const bool boardNow = moment == ViewTime::boardNow || (!ghost && !switches.retardation);
  std::string text = define("RETARDED", retarded) + define("BOARD_NOW", boardNow) +
                     define("CONTRACTED", switches.contraction || moment == ViewTime::myNow) +
                     define("ABERRATED", switches.aberration) + define("COLOURED", switches.colour) +
                     define("SEARCHLIGHT", switches.searchlight);
  if (ghost) return {text + "#define GHOST\n" + define("CROSSED", moment == ViewTime::myNow)};
  if (switches == kNoSwitches) text += "#define EUCLID\n";
  if (switches.colour) text += "#define COLOUR\n";
  if (paint == Paint::clock) text += "#define CLOCK\n";
  if (paint == Paint::shadow) text += "#define SHADOW\n";
  if (isMatt(paint)) text += "#define MATT\n";
  if (mirrors(legs, paint)) text += "#define MIRRORS\n";
  if (!isMatt(paint) && (followsLamps || mirrors(legs, paint))) text += "#define EACH_SHINE\n";
  if (followsLamps) text += "#define LAMPS\n";
  if (followsLamps && paint == Paint::lamp) text += "#define BULB\n";
  if (paint == Paint::clock || paint == Paint::lamp) text += "#define GLOWS\n";
  if (isHot) text += "#define HOT\n";
  return {text, shaders::light_types};
}

/// Returns the colours of the hall, which have their names in mirror.glsl.
std::string hallColours() {
  constexpr std::array kNames{"kWallX", "kWallMinusX", "kWallY", "kWallMinusY", "kCeiling"};
  static_assert(kNames.size() == kHallColours.size());
  std::string text;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const glm::vec3& colour = kHallColours[i];
    text += fmt::format("const vec3 {} = vec3({:.4f}, {:.4f}, {:.4f});\n", kNames[i], colour.r, colour.g,
                        colour.b);
  }
  return text;
}

ShaderParts kernelParts(Legs legs) {
  std::string definitions =
      fmt::format("#define CATCH_UP_SPEED {}\n#define FEW_SPIN_STEPS {:.1f}\n", kCatchUpSpeed, kFewSpinSteps);
  if (legs == Legs::aroundTurn)
    definitions += "#define TWO_LEGS\n";
  else if (legs != Legs::many && legs != Legs::manySpinning)
    definitions += "#define ONE_LEG\n";
  if (legs == Legs::oneSpinning || legs == Legs::manySpinning) definitions += "#define SPINS\n";
  if (legs == Legs::rest) definitions += "#define RESTS\n";
  if (legs == Legs::followed) definitions += "#define FOLLOWED\n";
  return {shaders::legs,
          definitions,
          shaders::leg_kernel,
          shaders::spin_kernel,
          shaders::glide_kernel,
          shaders::turning_kernel,
          shaders::emission_kernel,
          shaders::leg_at,
          shaders::doppler_kernel,
          shaders::colour_texel};
}

std::string joined(const ShaderParts& parts) {
  std::string text;
  for (const std::string& part : parts) text += part;
  return text;
}

ShaderParts joinedParts(std::initializer_list<ShaderParts> lists) {
  ShaderParts all;
  for (const ShaderParts& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

std::string kernelText(Legs legs) { return joined(kernelParts(legs)); }

ShaderParts bodyVertexParts(const BodyVariant& variant) {
  const bool isVarnished =
      variant.moment == ViewTime::seen && !isMatt(variant.paint) && !mirrors(variant.legs, variant.paint);
  const ShaderParts varnish = isVarnished ? ShaderParts{shaders::highlight} : ShaderParts{};
  return joinedParts(
      {{kPreamble}, variantParts(variant), kernelParts(variant.legs), varnish, {shaders::body_vert}});
}

ShaderParts surfaceFragmentParts(const BodyVariant& variant) {
  static const std::string kMarker = "//CAROM::Paint", kText = shaders::surface_frag;
  static const std::size_t kAt = kText.find(kMarker);
  const bool isSeen = variant.moment == ViewTime::seen;
  const ShaderParts mirror = isSeen && mirrors(variant.legs, variant.paint)
                                 ? ShaderParts{shaders::hall_colours, hallColours(), shaders::mirror}
                                 : ShaderParts{};
  return joinedParts(
      {{kPreamble},
       variantParts(variant),
       {kText.substr(0, kAt)},
       mirror,
       {isSeen ? paintText(variant.paint) : shaders::paint_ghost, kText.substr(kAt + kMarker.size())}});
}

std::string bodyVertexShader(const BodyVariant& variant) { return joined(bodyVertexParts(variant)); }

std::string surfaceFragmentShader(const BodyVariant& variant) {
  return joined(surfaceFragmentParts(variant));
}

}  // namespace carom
