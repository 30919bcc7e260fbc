#include "cave/bodies/body_program.h"

#include <cstring>

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

void send(int at, const glm::mat4& matrix) { glUniformMatrix4fv(at, 1, GL_FALSE, glm::value_ptr(matrix)); }
void send(int at, const glm::vec3& value) { glUniform3fv(at, 1, glm::value_ptr(value)); }
void send(int at, const glm::vec4& value) { glUniform4fv(at, 1, glm::value_ptr(value)); }
void send(int at, float value) { glUniform1f(at, value); }
void send(int at, int value) { glUniform1i(at, value); }
void send(int at, const std::array<glm::vec3, 3>& values) {
  glUniform3fv(at, 3, glm::value_ptr(values.front()));
}
void send(int at, const HotBlows::Places& places) {
  glUniform4fv(at, static_cast<GLsizei>(places.size()), glm::value_ptr(places.front()));
}
void send(int at, const LegUniform& leg) { glUniform4fv(at, kLegTexels, leg.data()); }

}  // namespace

BodyProgram::BodyProgram(const BodyVariant& variant)
    : variant_(variant),
      program_(
          makeProgram("body", bodyVertexShader(variant), surfaceFragmentShader(variant), kVertexInputs)) {
  const auto place = [this](auto& uniform, const char* name) {
    uniform.at = glGetUniformLocation(program_, name);
  };
  place(has_.clipFromDrawn, "clipFromDrawn");
  place(has_.boardFromDrawn, "boardFromDrawn");
  place(has_.headOnBoard, "headOnBoard");
  place(has_.eyeOnBoard_m, "eyeOnBoard_m");
  place(has_.exposure, "eyeExposure");
  place(has_.lamps_m, "lamps_m");
  place(has_.lampsFromEye_m, "lampsFromEye_m");
  place(has_.lampLights, "lampLights");
  place(has_.hall_m, "hall_m");
  place(has_.lampsOn_m, "lampsOn_m");
  place(has_.observedWhole_s, "observedWhole_s");
  place(has_.observedPart_s, "observedPart_s");
  place(has_.lightSpeed_m_s, "lightSpeed_m_s");
  place(has_.drawnFromSeen, "drawnFromSeen");
  place(has_.drawnFromBody, "drawnFromBody");
  place(has_.onlyLeg, "onlyLeg");
  place(has_.firstLeg, "firstLeg");
  place(has_.legCount, "legCount");
  place(has_.appears_m, "appears_m");
  place(has_.colour, "partColour");
  place(has_.roughness, "roughness");
  place(has_.seenShare, "seenShare");
  place(has_.tint, "tint");
  place(has_.nearer, "nearer");
  place(has_.ghostColour, "ghostColour");
  place(has_.hatch_m, "hatch_m");
  place(has_.middleMotion, "middleMotion");
  place(has_.telling, "telling");
  place(has_.blows, "blows");
  place(has_.blowHeats, "blowHeats");
  place(has_.cooling_m, "cooling_m");
  glUseProgram(program_);
  setUniform(program_, "legTexels", kLegUnit);
  setUniform(program_, "colourTexels", kColourUnit);
  glUseProgram(0);
}

template <typename T>
void BodyProgram::Uniform<T>::set(const T& wanted) {
  if (at < 0 || (isSet && value == wanted)) return;
  send(at, wanted);
  value = wanted;
  isSet = true;
}

void BodyProgram::set(const EyeUniforms& eye) {
  has_.boardFromDrawn.set(eye.boardFromDrawn);
  has_.headOnBoard.set(eye.headOnBoard);
  has_.eyeOnBoard_m.set(eye.eyeOnBoard_m);
  has_.exposure.set(eye.exposure);
  has_.lamps_m.set(eye.lamps_m);
  has_.lampsFromEye_m.set(eye.lampsFromEye_m);
  has_.lampLights.set(eye.lampLights);
  has_.hall_m.set(eye.hall_m);
  has_.lampsOn_m.set(eye.lampsOn_m);
  has_.observedWhole_s.set(eye.observedWhole_s);
  has_.observedPart_s.set(eye.observedPart_s);
  has_.lightSpeed_m_s.set(eye.lightSpeed_m_s);
}

void BodyProgram::set(const PartUniforms& part) {
  has_.drawnFromSeen.set(part.drawnFromSeen);
  if (part.legs) has_.drawnFromBody.set(placement(*part.legs));
  if (part.legs && has_.onlyLeg.at >= 0) {
    LegUniform leg;
    std::memcpy(leg.data(), part.legs, sizeof(leg));
    has_.onlyLeg.set(leg);
  }
  has_.firstLeg.set(part.firstLeg);
  has_.legCount.set(part.legCount);
  has_.appears_m.set(part.appears_m);
  has_.colour.set(part.colour);
  has_.roughness.set(part.roughness);
  has_.seenShare.set(part.seenShare);
  has_.tint.set(part.tint);
  has_.nearer.set(part.nearer);
  has_.ghostColour.set(part.ghostColour);
  has_.hatch_m.set(part.hatch_m);
  has_.middleMotion.set(part.middleMotion);
  has_.telling.set(part.telling);
  has_.blows.set(part.heat.fromEye_m);
  has_.blowHeats.set(part.heat.heats);
  has_.cooling_m.set(part.cooling_m);
}

void BodyProgram::set(const EyeUniforms& eye, const glm::mat4& clipFromDrawn, const PartUniforms& part) {
  has_.clipFromDrawn.set(clipFromDrawn);
  set(eye);
  set(part);
}

}  // namespace carom
