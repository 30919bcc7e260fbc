// Owners of OpenGL objects, on a real context: what they own exists as long as they do, and streams draw what
// was uploaded.
#include "cave/gl/gl_objects.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/gl/graphics.h"
#include "cave/gl/picture.h"

namespace carom {
namespace {

class GlObjects : public testing::Test {
 protected:
  ~GlObjects() override { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }
  Graphics graphics_;
};

/// OpenGL counts a name as an object once it has been bound.
bool isBuffer(unsigned name) {
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return glIsBuffer(name) == GL_TRUE;
}

TEST_F(GlObjects, AnObjectEndsWithItsOwner) {
  unsigned buffer = 0, vertexArray = 0, texture = 0, framebuffer = 0, renderbuffer = 0, program = 0;
  const auto exist = [&](GLboolean expected) {
    EXPECT_EQ(glIsBuffer(buffer), expected);
    EXPECT_EQ(glIsVertexArray(vertexArray), expected);
    EXPECT_EQ(glIsTexture(texture), expected);
    EXPECT_EQ(glIsFramebuffer(framebuffer), expected);
    EXPECT_EQ(glIsRenderbuffer(renderbuffer), expected);
    EXPECT_EQ(glIsProgram(program), expected);
  };
  {
    const GlBuffer ownsBuffer;
    const GlVertexArray ownsVertexArray;
    const GlTexture ownsTexture;
    const GlFramebuffer ownsFramebuffer;
    const GlRenderbuffer ownsRenderbuffer;
    const GlProgram ownsProgram;
    glBindBuffer(GL_ARRAY_BUFFER, buffer = ownsBuffer);
    glBindVertexArray(vertexArray = ownsVertexArray);
    glBindTexture(GL_TEXTURE_2D, texture = ownsTexture);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer = ownsFramebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer = ownsRenderbuffer);
    program = ownsProgram;
    exist(GL_TRUE);
  }
  exist(GL_FALSE);
}

TEST_F(GlObjects, AMoveHandsTheObjectOver) {
  GlBuffer first;
  const unsigned name = first;
  ASSERT_TRUE(isBuffer(name));
  GlBuffer second = std::move(first);
  EXPECT_EQ(unsigned{second}, name);
  EXPECT_EQ(unsigned{first}, 0U);  // moved from, which is what is tested
  EXPECT_TRUE(isBuffer(name));

  GlBuffer third;
  const unsigned replaced = third;
  ASSERT_TRUE(isBuffer(replaced));
  third = std::move(second);
  EXPECT_EQ(unsigned{third}, name);
  EXPECT_TRUE(glIsBuffer(name));
  EXPECT_FALSE(glIsBuffer(replaced)) << "its object was deleted at once";

  std::vector<GlBuffer> many;
  many.push_back(std::move(third));
  for (int i = 0; i < 20; ++i) many.emplace_back();  // moved whenever the vector grows
  EXPECT_EQ(unsigned{many.front()}, name);
  EXPECT_TRUE(glIsBuffer(name));
  many.clear();
  EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GlObjects, AFenceEndsWithItsOwnerAndIsPassed) {
  GlFence fence = placeFence();
  const auto sync = static_cast<GLsync>(fence.get());
  EXPECT_TRUE(glIsSync(sync));
  awaitFence(fence);
  EXPECT_EQ(glClientWaitSync(sync, 0, 0), GLenum{GL_ALREADY_SIGNALED});
  fence.reset();
  EXPECT_FALSE(glIsSync(sync));
  awaitFence(fence);  // null: returns at once
}

struct Point {
  glm::vec2 place{0.0F};
  glm::vec2 green_blue{0.0F};
};

/// How many pixels of the picture have each colour: black, green, blue, any other.
std::array<int, 4> coloursOf(const RenderTarget& picture) {
  const glm::ivec2 size_px = picture.size_px();
  std::vector<std::array<std::uint8_t, 4>> pixels(static_cast<std::size_t>(size_px.x * size_px.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::array<int, 4> counts{};
  for (const auto& [red, green, blue, alpha] : pixels) {
    const bool pure = red == 0 && (green == 0 || green == 255) && (blue == 0 || blue == 255);
    ++counts[pure && !(green && blue) ? (green ? 1 : blue ? 2 : 0) : 3];
  }
  return counts;
}

TEST_F(GlObjects, AStreamDrawsWhatWasUploadedLastAndLeavesNothingBound) {
  const GlProgram program = makeProgram("points",
                                        "#version 150\nin vec2 place; in vec2 greenBlue; out vec2 gb;\n"
                                        "void main() { gb = greenBlue; gl_Position = vec4(place, 0, 1); }",
                                        "#version 150\nin vec2 gb; out vec4 colour;\n"
                                        "void main() { colour = vec4(0, gb, 1); }");
  VertexStream<Point> stream(
      program, {{"place", 2, offsetof(Point, place)}, {"greenBlue", 2, offsetof(Point, green_blue)}});
  const auto half = [](float side, const glm::vec2& colour) {  // of the picture, as two triangles
    const glm::vec2 a(0, -1), b(side, -1), c(0, 1), d(side, 1);
    return std::vector<Point>{{a, colour}, {b, colour}, {c, colour}, {c, colour}, {b, colour}, {d, colour}};
  };
  const std::vector<Point> green = half(-1.0F, {1, 0}), blue = half(1.0F, {0, 1});
  const auto expectNothingBound = [&] {
    GLint array = 0, buffer = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &array);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer);
    EXPECT_EQ(array, 0);
    EXPECT_EQ(buffer, 0);
  };
  expectNothingBound();

  const RenderTarget picture({8, 4});
  for (const auto& [points, counts] :
       {std::pair{green, std::array{16, 16, 0, 0}}, {blue, std::array{16, 0, 16, 0}}}) {
    stream.upload(points);
    expectNothingBound();
    const GlStateGuard state(picture.framebuffer(), picture.size_px());
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(program);
    const VertexStream<Point> moved = std::move(stream);
    moved.bind();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(points.size()));
    EXPECT_EQ(coloursOf(picture), counts);
    stream = VertexStream<Point>(
        program, {{"place", 2, offsetof(Point, place)}, {"greenBlue", 2, offsetof(Point, green_blue)}});
  }
}

}  // namespace
}  // namespace carom
