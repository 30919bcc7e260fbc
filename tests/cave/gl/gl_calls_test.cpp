// What a frame says to OpenGL: every call that asks, sets or uploads passes through this program first. The
// functions of OpenGL 1.1 are defined here and call the library's, those of later versions are pointers that
// are replaced.
#include <gtest/gtest.h>

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <vtk_glew.h>

#include "cave/display/display_walls.h"
#include "cave/frame/bodies.h"
#include "cave/gl/graphics.h"
#include "cave/render/wall_renderer.h"
#include "cave/scene/scene_builder.h"

namespace carom {
namespace {

/// What OpenGL was told: the calls by name, and of what can be set, what it was last set to.
class GlCalls {
 public:
  void count(const std::string& function) { ++calls_[function]; }
  void set(const std::string& function, const std::string& what, std::vector<float> value) {
    count(function);
    const auto [known, isNew] = state_.try_emplace(what, value);
    if (!isNew && known->second == value) ++calls_["in vain: " + what];
    known->second = std::move(value);
  }
  /// Forgets what others may set between two eyes. A program keeps its uniforms.
  void forgetAllButUniforms() {
    std::erase_if(state_, [](const auto& entry) { return !entry.first.starts_with("uniform"); });
  }
  std::map<std::string, int> take() { return std::exchange(calls_, {}); }
  unsigned program = 0;
  int unit = 0;

 private:
  std::map<std::string, int> calls_;
  std::map<std::string, std::vector<float>> state_;
};

GlCalls& calls() {
  static GlCalls all;
  return all;
}

template <typename... T>
std::vector<float> numbers(T... values) {
  return {static_cast<float>(values)...};
}

std::string numbered(const char* what, unsigned number) {
  return std::string(what) + " " + std::to_string(number);
}

void setUniform(const char* function, GLint at, std::vector<float> value) {
  calls().set(function, numbered("uniform", calls().program) + "." + std::to_string(at), std::move(value));
}

/// The functions of OpenGL after 1.1 as they were found.
struct Found {
  decltype(__glewUseProgram) useProgram = __glewUseProgram;
  decltype(__glewBindVertexArray) bindVertexArray = __glewBindVertexArray;
  decltype(__glewBindBuffer) bindBuffer = __glewBindBuffer;
  decltype(__glewBufferData) bufferData = __glewBufferData;
  decltype(__glewBindFramebuffer) bindFramebuffer = __glewBindFramebuffer;
  decltype(__glewActiveTexture) activeTexture = __glewActiveTexture;
  decltype(__glewBlendFuncSeparate) blendFuncSeparate = __glewBlendFuncSeparate;
  decltype(__glewUniform1i) uniform1i = __glewUniform1i;
  decltype(__glewUniform2i) uniform2i = __glewUniform2i;
  decltype(__glewUniform1f) uniform1f = __glewUniform1f;
  decltype(__glewUniform3fv) uniform3fv = __glewUniform3fv;
  decltype(__glewUniform4fv) uniform4fv = __glewUniform4fv;
  decltype(__glewUniformMatrix4fv) uniformMatrix4fv = __glewUniformMatrix4fv;
  decltype(__glewGetUniformLocation) getUniformLocation = __glewGetUniformLocation;
  decltype(__glewMultiDrawElements) multiDrawElements = __glewMultiDrawElements;
};

Found& found() {
  static Found all;
  return all;
}

void hookBindings() {
  __glewUseProgram = [](GLuint program) {
    calls().set("glUseProgram", "program", numbers(program));
    found().useProgram(calls().program = program);
  };
  __glewBindVertexArray = [](GLuint array) {
    calls().set("glBindVertexArray", "vertex array", numbers(array));
    found().bindVertexArray(array);
  };
  __glewBindBuffer = [](GLenum target, GLuint buffer) {
    calls().set("glBindBuffer", numbered("buffer", target), numbers(buffer));
    found().bindBuffer(target, buffer);
  };
  __glewBufferData = [](GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    calls().count("glBufferData");
    found().bufferData(target, size, data, usage);
  };
  __glewBindFramebuffer = [](GLenum target, GLuint framebuffer) {
    for (const GLenum half : {GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER})
      if (target == half || target == GL_FRAMEBUFFER)
        calls().set("glBindFramebuffer", numbered("framebuffer", half), numbers(framebuffer));
    found().bindFramebuffer(target, framebuffer);
  };
  __glewActiveTexture = [](GLenum unit) {
    calls().unit = static_cast<int>(unit - GL_TEXTURE0);
    calls().set("glActiveTexture", "texture unit", numbers(calls().unit));
    found().activeTexture(unit);
  };
  __glewBlendFuncSeparate = [](GLenum a, GLenum b, GLenum c, GLenum d) {
    calls().set("glBlendFuncSeparate", "blend function", numbers(a, b, c, d));
    found().blendFuncSeparate(a, b, c, d);
  };
  __glewMultiDrawElements = [](GLenum mode, const GLsizei* counts, GLenum type, const void* const* offsets,
                               GLsizei ranges) {
    calls().count("glMultiDrawElements");
    found().multiDrawElements(mode, counts, type, offsets, ranges);
  };
}

void hookUniforms() {
  __glewUniform1i = [](GLint at, GLint value) {
    setUniform("glUniform", at, numbers(value));
    found().uniform1i(at, value);
  };
  __glewUniform2i = [](GLint at, GLint x, GLint y) {
    setUniform("glUniform", at, numbers(x, y));
    found().uniform2i(at, x, y);
  };
  __glewUniform1f = [](GLint at, GLfloat value) {
    setUniform("glUniform", at, numbers(value));
    found().uniform1f(at, value);
  };
  __glewUniform3fv = [](GLint at, GLsizei count, const GLfloat* values) {
    setUniform("glUniform", at, {values, values + 3 * count});
    found().uniform3fv(at, count, values);
  };
  __glewUniform4fv = [](GLint at, GLsizei count, const GLfloat* values) {
    setUniform("glUniform", at, {values, values + 4 * count});
    found().uniform4fv(at, count, values);
  };
  __glewUniformMatrix4fv = [](GLint at, GLsizei count, GLboolean transposed, const GLfloat* values) {
    setUniform("glUniform", at, {values, values + 16 * count});
    found().uniformMatrix4fv(at, count, transposed, values);
  };
  __glewGetUniformLocation = [](GLuint program, const GLchar* name) {
    calls().count("glGetUniformLocation");
    return found().getUniformLocation(program, name);
  };
}

/// Returns the library's own function.
template <typename Function>
Function* library(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace carom

#define LIBRARY(name) carom::library<decltype(name)>(#name)

extern "C" {
void glGetIntegerv(GLenum what, GLint* values) {
  carom::calls().count("glGetIntegerv");
  LIBRARY(glGetIntegerv)(what, values);
}
const GLubyte* glGetString(GLenum what) {
  carom::calls().count("glGetString");
  return LIBRARY(glGetString)(what);
}
GLboolean glIsEnabled(GLenum what) {
  carom::calls().count("glIsEnabled");
  return LIBRARY(glIsEnabled)(what);
}
void glEnable(GLenum what) {
  carom::calls().set("glEnable", carom::numbered("switch", what), {1.0F});
  LIBRARY(glEnable)(what);
}
void glDisable(GLenum what) {
  carom::calls().set("glDisable", carom::numbered("switch", what), {0.0F});
  LIBRARY(glDisable)(what);
}
void glDepthMask(GLboolean on) {
  carom::calls().set("glDepthMask", "depth mask", carom::numbers(on));
  LIBRARY(glDepthMask)(on);
}
void glDepthFunc(GLenum function) {
  carom::calls().set("glDepthFunc", "depth function", carom::numbers(function));
  LIBRARY(glDepthFunc)(function);
}
void glViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
  carom::calls().set("glViewport", "viewport", carom::numbers(x, y, width, height));
  LIBRARY(glViewport)(x, y, width, height);
}
void glScissor(GLint x, GLint y, GLsizei width, GLsizei height) {
  carom::calls().set("glScissor", "scissor", carom::numbers(x, y, width, height));
  LIBRARY(glScissor)(x, y, width, height);
}
void glClearColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  carom::calls().set("glClearColor", "clear colour", {red, green, blue, alpha});
  LIBRARY(glClearColor)(red, green, blue, alpha);
}
void glBindTexture(GLenum target, GLuint texture) {
  carom::calls().set("glBindTexture",
                     carom::numbered("texture", target) + " of unit " + std::to_string(carom::calls().unit),
                     carom::numbers(texture));
  LIBRARY(glBindTexture)(target, texture);
}
void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* offset) {
  carom::calls().count("glDrawElements");
  LIBRARY(glDrawElements)(mode, count, type, offset);
}
}

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

/// Four walls of a room of 3 m around its origin.
std::vector<Wall> roomWalls() {
  const auto wall = [](const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight,
                       const glm::dvec3& upperLeft) {
    Wall made;
    made.lowerLeft_m = lowerLeft;
    made.lowerRight_m = lowerRight;
    made.upperLeft_m = upperLeft;
    made.pixels = {120, 120};
    return made;
  };
  return {wall({-1.5, 1.5, 0}, {1.5, 1.5, 0}, {-1.5, 1.5, 3}),
          wall({-1.5, -1.5, 0}, {-1.5, 1.5, 0}, {-1.5, -1.5, 3}),
          wall({1.5, 1.5, 0}, {1.5, -1.5, 0}, {1.5, 1.5, 3}),
          wall({-1.5, -1.5, 0}, {1.5, -1.5, 0}, {-1.5, 1.5, 0})};
}

class GlCallsTest : public testing::Test {
 protected:
  GlCallsTest() {
    found();
    hookBindings();
    hookUniforms();
    for (int i = 0; i < 8; ++i) pictures_.push_back(std::make_unique<RenderTarget>(walls_.front().pixels));
  }

  /// Draws a frame for two eyes; `at` is how far the game has gone.
  void draw(WallRenderer& renderer, const Scene& scene, std::span<const WorldLine> lines, double t_s,
            const Vec3& beta) {
    const Lorentz headFromBoard = Lorentz::boost(uFromBeta(beta), kC_m_s);
    std::vector<BodyView> bodies(scene.bodyCount);
    for (const std::size_t side : {0U, 1U}) {
      calls().forgetAllButUniforms();
      const Vec3 aside(side == 0 ? -0.032 : 0.032, 0.0, 0.0);
      const EyeView eye{{t_s, Vec3(0.0, -1.6 + 0.1 * t_s, 0.85) + aside}, Vec3(0.0, 0.0, 1.6) + aside};
      for (std::size_t i = 0; i < bodies.size(); ++i)
        viewBody(lines[i], eye.observation, headFromBoard, bodies[i]);
      renderer.look(headFromBoard, eye, bodies);
      std::vector<WallPicture> shown;
      for (std::size_t i = 0; i < walls_.size(); ++i)
        shown.push_back({&walls_[i], pictures_[4 * side + i].get(), {}});
      EXPECT_EQ(renderer.draw(shown, eye.positionInRoom_m), 4U);
    }
  }

  Graphics graphics_;
  std::vector<Wall> walls_ = roomWalls();
  std::vector<std::unique_ptr<RenderTarget>> pictures_;
};

/// Returns what a frame may not do: ask OpenGL, or set what is so already.
std::map<std::string, int> forbiddenOf(const std::map<std::string, int>& all) {
  std::map<std::string, int> forbidden;
  for (const auto& [name, count] : all)
    if (name.starts_with("glGet") || name.starts_with("glIs") || name.starts_with("in vain"))
      forbidden[name] = count;
  return forbidden;
}

TEST_F(GlCallsTest, WhatIsAskedAndWhatIsSetInVainIsCounted) {
  calls().take();
  calls().forgetAllButUniforms();
  for (int i = 0; i < 3; ++i) glBindVertexArray(0);
  glDepthMask(GL_TRUE);
  glDepthMask(GL_FALSE);
  glDepthMask(GL_TRUE);
  int array = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &array);
  const std::map<std::string, int> expected{{"in vain: vertex array", 2}, {"glGetIntegerv", 1}};
  EXPECT_EQ(forbiddenOf(calls().take()), expected);
}

TEST_F(GlCallsTest, ASteadyFrameAsksNothingSetsNothingInVainAndUploadsOnceAnEye) {
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  const std::vector<BodyLooks> looks{
      {"white", "", 0.0305, 0.02}, {"red", "", 0.0305, 0.02}, {"blue", "", 0.0305, 0.02}};
  const Scene scene = buildScene(setup, looks, {}, {}, {0.001, 5000});
  std::vector<WorldLine> lines{restingWorldLine(kC_m_s)};
  for (const double x_m : {-0.5, 0.0, 0.5})
    lines.push_back(
        WorldLine({{0.0, {x_m, 0.0, 0.01}}, {0.2 * x_m, 0.1, 0.0}, 0.0, {}, 0.0}, kC_m_s, scene.reach_m[1]));
  WallRenderer renderer(graphics_, scene, kC_m_s);
  for (const Vec3& beta : {Vec3(0.0, 0.4, 0.1), Vec3(0.0)}) {
    for (int frame = 0; frame < 4; ++frame) {
      calls().take();
      draw(renderer, scene, lines, 1.0 + 0.1 * frame, beta);
      if (frame == 0) continue;  // makes programs and buffers
      const std::map<std::string, int> all = calls().take();
      EXPECT_EQ(forbiddenOf(all), (std::map<std::string, int>{})) << "frame " << frame;
      EXPECT_EQ(all.at("glBufferData"), 2) << "frame " << frame;
      EXPECT_GT(all.at("glDrawElements") + all.at("glMultiDrawElements"), 16);
      EXPECT_GT(all.at("glUniform"), 16);
    }
  }
}

TEST_F(GlCallsTest, WallsWithNothingInSightCostNoCallsOnceTheyAreBlack) {
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  Scene scene = buildScene(setup, std::vector<BodyLooks>{{"white", "", 0.0305, 0.02}}, {}, {}, {0.001, 5000});
  std::erase_if(scene.parts, [](const ScenePart& part) { return part.body == kRestingBody; });
  const std::vector<WorldLine> lines{
      restingWorldLine(kC_m_s),
      WorldLine({{0.0, {0.0, -20.0, 20.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, scene.reach_m[1])};
  WallRenderer renderer(graphics_, scene, kC_m_s);
  draw(renderer, scene, lines, 1.0, Vec3(0.0));
  calls().take();
  draw(renderer, scene, lines, 1.1, Vec3(0.0));
  EXPECT_EQ(calls().take(), (std::map<std::string, int>{}));
}

// All that a session draws, in windows too, with every view of time and aid.
TEST_F(GlCallsTest, ASessionAsksForNoStateOnceItRuns) {
  Wall wall = walls_.front();
  wall.name = "front";
  wall.window = {0, {0, 0}, wall.pixels, false};
  const Scene scene =
      buildScene({}, std::vector<BodyLooks>{{"white", "", 0.0305, 0.02}}, {}, {}, {0.001, 5000});
  DisplayWalls shown(graphics_, scene, kC_m_s, {wall}, std::nullopt, true);
  RoomGeometry room;
  room.walls = {wall};
  shown.setRoom(room);
  const World world{
      {restingWorldLine(kC_m_s),
       WorldLine({{0.0, {0.0, 0.0, 0.01}}, {0.1, 0.1, 0.0}, 0.0, {}, 0.0}, kC_m_s, scene.reach_m[1])},
      {}};
  FrameRecord record;
  record.pucks = 1;
  record.lightSpeed_m_s = kC_m_s;
  record.views = {1, 1, 1, 1, 1, 1, 1, 1, 0};
  for (int frame = 0; frame < 4; ++frame) {
    record.number = static_cast<std::uint64_t>(frame);
    record.viewers[0].observer.headFromBoard = Lorentz::boost({0.0, 0.1 * frame, 0.0}, kC_m_s);
    for (EyeView* eye : {&record.viewers[0].observer.left, &record.viewers[0].observer.middle,
                         &record.viewers[0].observer.right})
      *eye = {{0.1 * frame, {0.0, -1.6, 0.85}}, {0.0, 0.0, 1.6}};
    calls().take();
    shown.draw(record, world);
    shown.show();
    shown.swap();
    const std::map<std::string, int> all = calls().take();
    if (frame < 2) continue;
    EXPECT_EQ(all.count("glGetIntegerv") + all.count("glIsEnabled") + all.count("glGetString"), 0U);
    EXPECT_GT(all.at("glDrawElements"), 0);
  }
}

}  // namespace
}  // namespace carom
