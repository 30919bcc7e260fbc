#include "cave/seam_pattern.h"

#include <array>
#include <cmath>

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl_program.h"
#include "shaders/seam_frag.h"
#include "shaders/stereo_vert.h"

namespace carom {
namespace {

/// Puts the state that a full-screen triangle needs, and puts back what was: others of this context rely on
/// it.
class PlainState {
 public:
  explicit PlainState(const WallPicture& picture) {
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    for (std::size_t i = 0; i < kOff.size(); ++i) {
      wasOn_[i] = glIsEnabled(kOff[i]);
      glDisable(kOff[i]);
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
    glViewport(0, 0, picture.size_px().x, picture.size_px().y);
  }
  ~PlainState() {
    for (std::size_t i = 0; i < kOff.size(); ++i) {
      if (wasOn_[i]) glEnable(kOff[i]);
    }
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    glBindVertexArray(static_cast<GLuint>(vertexArray_));
    glUseProgram(static_cast<GLuint>(program_));
  }
  PlainState(const PlainState&) = delete;
  PlainState& operator=(const PlainState&) = delete;

 private:
  static constexpr std::array<GLenum, 5> kOff{GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE,
                                              GL_CLIP_DISTANCE0};
  std::array<GLboolean, kOff.size()> wasOn_{};
  std::array<GLint, 4> viewport_{};
  GLint program_ = 0, vertexArray_ = 0, framebuffer_ = 0;
};

}  // namespace

SeamPattern::SeamPattern() : program_(makeProgram("seam", shaders::stereo_vert, shaders::seam_frag)) {
  glGenVertexArrays(1, &vertexArray_);
}

SeamPattern::~SeamPattern() {
  glDeleteVertexArrays(1, &vertexArray_);
  glDeleteProgram(program_);
}

void SeamPattern::draw(const Wall& wall, double time_s, WallPicture& picture) const {
  const PlainState state(picture);
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
