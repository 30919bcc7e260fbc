#include "cave/body_shaders.h"

#include "shaders/body_vert.h"
#include "shaders/emission_kernel.h"
#include "shaders/leg_at.h"
#include "shaders/legs.h"
#include "shaders/paint_bands.h"
#include "shaders/paint_clock.h"
#include "shaders/paint_cloth.h"
#include "shaders/paint_floor.h"
#include "shaders/paint_lamp.h"
#include "shaders/paint_panels.h"
#include "shaders/paint_plain.h"
#include "shaders/paint_puck.h"
#include "shaders/paint_shadow.h"
#include "shaders/paint_wood.h"
#include "shaders/surface_frag.h"

namespace carom {
namespace {

// VTK puts the version line here.
const std::string kPreamble = "//VTK::System::Dec\n";

const char* paintText(Paint paint) {
  switch (paint) {
    case Paint::plain:
      return shaders::paint_plain;
    case Paint::cloth:
      return shaders::paint_cloth;
    case Paint::wood:
      return shaders::paint_wood;
    case Paint::floor:
      return shaders::paint_floor;
    case Paint::panels:
      return shaders::paint_panels;
    case Paint::puck:
      return shaders::paint_puck;
    case Paint::bands:
      return shaders::paint_bands;
    case Paint::shadow:
      return shaders::paint_shadow;
    case Paint::clock:
      return shaders::paint_clock;
    case Paint::lamp:
      return shaders::paint_lamp;
  }
  return shaders::paint_plain;
}

}  // namespace

std::string emissionKernelText(bool oneLeg) {
  std::string text = shaders::legs;
  text += shaders::emission_kernel;
  text += shaders::leg_at;
  text += oneLeg ? "#define LEG_COUNT 1\n" : "#define LEG_COUNT legCount\n";
  return text;
}

std::string bodyVertexShader(bool oneLeg, Paint paint) {
  const std::string switches = paint == Paint::clock ? "#define CLOCK\n" : "";
  return kPreamble + switches + emissionKernelText(oneLeg) + shaders::body_vert;
}

std::string surfaceFragmentShader(Paint paint) {
  const std::string marker = "//CAROM::Paint";
  std::string text = kPreamble + shaders::surface_frag;
  text.replace(text.find(marker), marker.size(), paintText(paint));
  return text;
}

}  // namespace carom
