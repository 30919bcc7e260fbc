#include "cave/display/alignment_pattern.h"

#include <cmath>

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "shaders/seam_frag.h"
#include "shaders/stereo_vert.h"

namespace carom {

AlignmentPattern::AlignmentPattern()
    : program_(makeProgram("seam", shaders::stereo_vert, shaders::seam_frag)) {
  glGenVertexArrays(1, &vertexArray_);
}

AlignmentPattern::~AlignmentPattern() {
  glDeleteVertexArrays(1, &vertexArray_);
  glDeleteProgram(program_);
}

void AlignmentPattern::draw(const Wall& wall, double time_s, RenderTarget& picture) const {
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  const auto set = [&](const char* name, const glm::dvec3& value) {
    glUniform3fv(glGetUniformLocation(program_, name), 1, glm::value_ptr(glm::vec3(value)));
  };
  set("lowerLeft_m", wall.lowerLeft_m);
  set("across_m", wall.lowerRight_m - wall.lowerLeft_m);
  set("upwards_m", wall.upperLeft_m - wall.lowerLeft_m);
  set("first_m", glm::dvec3(std::fmod(kSpeed_m_s * time_s, kPeriod_m)));
  glUniform1f(glGetUniformLocation(program_, "period_m"), static_cast<float>(kPeriod_m));
  glUniform1f(glGetUniformLocation(program_, "halfLine_m"), static_cast<float>(kHalfLine_m));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace carom
