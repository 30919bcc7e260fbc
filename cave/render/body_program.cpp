#include "cave/render/body_program.h"

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"

namespace carom {
namespace {

/// Returns where the body of a leg is drawn, shifted to its centre, if its frame is the one that is drawn:
/// when all switches are off.
glm::mat4 placement(const GpuLeg& leg) {
  const auto column = [&](int i) { return glm::vec4(leg.toSeenX[i], leg.toSeenY[i], leg.toSeenZ[i], 0.0F); };
  return {column(1), column(2), column(3), glm::vec4(leg.seenCentre, 1.0F)};
}

void set(int at, const glm::mat4& matrix) {
  if (at >= 0) glUniformMatrix4fv(at, 1, GL_FALSE, glm::value_ptr(matrix));
}
void set(int at, const glm::vec3& value) {
  if (at >= 0) glUniform3fv(at, 1, glm::value_ptr(value));
}
void set(int at, const glm::vec4& value) {
  if (at >= 0) glUniform4fv(at, 1, glm::value_ptr(value));
}
void set(int at, float value) {
  if (at >= 0) glUniform1f(at, value);
}
void set(int at, int value) {
  if (at >= 0) glUniform1i(at, value);
}

}  // namespace

BodyProgram::BodyProgram(const BodyVariant& variant)
    : variant_(variant),
      program_(makeProgram(
          "body", bodyVertexShader(variant.legs, variant.paint, variant.switches, variant.moment),
          surfaceFragmentShader(variant.paint, variant.switches, variant.moment), kVertexInputs)) {
  const auto place = [this](const char* name) { return glGetUniformLocation(program_, name); };
  at_ = {place("clipFromDrawn"),  place("boardFromDrawn"), place("headOnBoard"),     place("eyeOnBoard_m"),
         place("exposure"),       place("lamps_m"),        place("observedWhole_s"), place("observedPart_s"),
         place("lightSpeed_m_s"), place("drawnFromSeen"),  place("drawnFromBody"),   place("onlyLeg"),
         place("firstLeg"),       place("legCount"),       place("appears_m"),       place("colour"),
         place("gloss"),          place("tint"),           place("nearer"),          place("ghostColour"),
         place("hatch_m")};
  glUseProgram(program_);
  set(place("legTexels"), kLegUnit);
  set(place("colourTexels"), kColourUnit);
}

void BodyProgram::setEye(const EyeUniforms& eye) const {
  set(at_.boardFromDrawn, eye.boardFromDrawn);
  set(at_.headOnBoard, eye.headOnBoard);
  set(at_.eyeOnBoard_m, eye.eyeOnBoard_m);
  set(at_.exposure, eye.exposure);
  if (at_.lamps_m >= 0) glUniform3fv(at_.lamps_m, 3, glm::value_ptr(eye.lamps_m[0]));
  set(at_.observedWhole_s, eye.observedWhole_s);
  set(at_.observedPart_s, eye.observedPart_s);
  set(at_.lightSpeed_m_s, eye.lightSpeed_m_s);
}

void BodyProgram::setPart(const PartUniforms& part) const {
  set(at_.drawnFromSeen, part.drawnFromSeen);
  set(at_.drawnFromBody, placement(*part.legs));
  if (at_.onlyLeg >= 0) glUniform4fv(at_.onlyLeg, kLegTexels, reinterpret_cast<const float*>(part.legs));
  set(at_.firstLeg, part.firstLeg);
  set(at_.legCount, part.legCount);
  set(at_.appears_m, part.appears_m);
  set(at_.colour, part.colour);
  set(at_.gloss, part.gloss);
  set(at_.tint, part.tint);
  set(at_.nearer, part.nearer);
  set(at_.ghostColour, part.ghostColour);
  set(at_.hatch_m, part.hatch_m);
}

void BodyProgram::use(const EyeUniforms& eye, const WallUniforms& wall, const PartUniforms& part) {
  glUseProgram(program_);
  if (wall_ != wall.number) set(at_.clipFromDrawn, wall.clipFromDrawn);
  if (eye_ != eye.number) setEye(eye);
  if (eye_ != eye.number || part_ != part.number) setPart(part);
  eye_ = eye.number;
  wall_ = wall.number;
  part_ = part.number;
}

}  // namespace carom
