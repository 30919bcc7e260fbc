// The emission kernel as the graphics card computes it, against the same text in double.
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "cave/bodies/body_shaders.h"
#include "cave/display/window.h"
#include "cave/gl/gl_objects.h"
#include "engine/light/light_cone.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

// Error allowed, as a share of the distance (the larger of that in the head frame and that in the body frame,
// since a fast observer sees far things near): 10 µm at 5 m.
constexpr double kOfDistance = 2e-6;
constexpr double kDay_s = 86400.0;

/// One vertex: on which legs of the buffer, and where in the body.
struct Input {
  glm::vec3 offset_m{0.0F};
  int firstLeg = 0;
  int legCount = 0;
};

struct Output {
  glm::vec3 seen_m{0.0F};
  float distanceInBody_m = 0.0F;
  float boardTime_m = 0.0F;
};

GlProgram compileSolver(const Switches& switches, Legs legs) {
  const std::string states =
      std::string("const bool kRetarded = ") + (switches.retardation ? "true" : "false") +
      "; const bool kContracted = " + (switches.contraction ? "true" : "false") + ";\n";
  const std::string text = "#version 150\n" + kernelText(legs) + states + R"(
    in vec3 offset_m;
    in ivec2 range;
    out vec3 seen_m;
    out float distanceInBody_m;
    out float boardTime_m;
    void main() {
      int legCount = range.y;
      VertexEmission emission = solveEmission(range.x, LEG_COUNT, offset_m, kRetarded, kContracted);
      LegView leg = legAt(range.x, emission.leg);
      seen_m = seenFromEye(leg, emission.event);
      distanceInBody_m = distanceInBody(leg, emission.event);
      boardTime_m = boardTimeOf(leg, emission.event);
    })";
  GlProgram program;
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glBindAttribLocation(program, 0, "offset_m");
  glBindAttribLocation(program, 1, "range");
  const std::array<const char*, 3> outputs{"seen_m", "distanceInBody_m", "boardTime_m"};
  glTransformFeedbackVaryings(program, 3, outputs.data(), GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  std::string log(8192, '\0');
  glGetShaderInfoLog(shader, 8192, nullptr, log.data());
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_EQ(linked, GL_TRUE) << log.c_str();
  return program;
}

/// Runs the solver on the graphics card over all inputs.
std::vector<Output> solveByShader(const std::vector<kernel_float::LegView>& legs,
                                  const std::vector<Input>& inputs, const Switches& switches, Legs sort) {
  const GlProgram program = compileSolver(switches, sort);
  const std::array<GlBuffer, 3> buffers;
  const GlVertexArray vertices;
  const GlTexture texture;
  glBindBuffer(GL_TEXTURE_BUFFER, buffers[0]);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(legs.size() * sizeof(legs[0])), legs.data(),
               GL_STATIC_DRAW);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffers[0]);

  glBindVertexArray(vertices);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(inputs.size() * sizeof(Input)), inputs.data(),
               GL_STATIC_DRAW);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Input), nullptr);
  glVertexAttribIPointer(1, 2, GL_INT, sizeof(Input), reinterpret_cast<const void*>(sizeof(glm::vec3)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);

  std::vector<Output> outputs(inputs.size());
  const auto bytes = static_cast<GLsizeiptr>(outputs.size() * sizeof(Output));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[2]);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "legTexels"), 0);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(inputs.size()));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, outputs.data());
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  return outputs;
}

struct Cases {
  Switches switches;
  std::vector<kernel_float::LegView> legs;
  std::vector<Input> inputs;
  std::vector<BodyView> views;
  int manyLegs = 0;
};

/// The same motion, so much later.
WorldLine later(const WorldLine& line, double late_s) {
  std::vector<Knot> knots(line.knots().begin(), line.knots().end());
  for (Knot& knot : knots) knot.turn.t_s += late_s, knot.signal.t_s += late_s;
  WorldLine moved(knots[0], line.lightSpeed_m_s(), line.radius_m());
  for (std::size_t i = 1; i < knots.size(); ++i) moved.append(knots[i]);
  return moved;
}

/// Bodies of the sizes of a puck and of a hall, at rest and up to `maxBeta`, seen by eyes that move up to
/// 0.99 c. Rims move at up to `maxRim` c; the cloth slows the bodies and their spins. All this at board times
/// up to `latest_s`, and of bodies that have met nothing as long after they began to turn.
Cases makeCases(std::uint64_t seed, int count, double maxBeta, int maxBounces, const Switches& switches = {},
                double maxRim = 0.0, double friction_m_s2 = 0.0, double slowing_1_s = 0.0,
                double latest_s = 0.0) {
  Cases cases{switches, {}, {}, {}, 0};
  test::Random random(seed);
  for (int i = 0; i < count; ++i) {
    const bool hall = maxBounces == 0 && i % 4 == 0;
    const double radius_m = hall ? 10.0 : random.in(0.02, 0.3);
    const int bounces = static_cast<int>(random.in(0.0, maxBounces + 1.0));
    WorldLine line =
        randomWorldLine(random, kC_m_s, radius_m, bounces, 0.5, hall ? 0.0 : maxBeta, friction_m_s2);
    if (maxRim > 0.0 && !hall) line = test::spun(random, line, maxRim, slowing_1_s);
    Event eye{random.in(-1.0, line.knots().back().turn.t_s + 3.0), random.inBox(2.0)};
    if (latest_s > 0.0) {
      const double late_s = random.in(0.0, latest_s);
      eye.t_s += late_s;
      if (bounces > 0) line = later(line, late_s);
      if (bounces == 0) eye.r_m += line.at(eye.t_s).event.r_m;
    }
    BodyView view;
    viewBody(line, eye, Lorentz::boost(random.u(0.99), kC_m_s), view, switches);
    const glm::vec3 offset_m(random.inBall(radius_m));
    cases.inputs.push_back(
        {offset_m, static_cast<int>(cases.legs.size()), static_cast<int>(view.legs.size())});
    for (const LegView& leg : view.legs) cases.legs.push_back(toFloat(leg));
    if (view.legs.size() > 1) ++cases.manyLegs;
    cases.views.push_back(std::move(view));
  }
  return cases;
}

/// The largest error over all cases, as a share of the distance.
double worstError(const Cases& cases, Legs sort = Legs::manySpinning) {
  const std::vector<Output> outputs = solveByShader(cases.legs, cases.inputs, cases.switches, sort);
  double worst = 0.0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const BodyView& view = cases.views[i];
    const kernel::VertexEmission emission = emissionIn(view, glm::dvec3(cases.inputs[i].offset_m));
    const LegView& leg = view.legs[static_cast<std::size_t>(emission.leg)];
    const glm::dvec3 seen_m = kernel::seenFromEye(leg, emission.event);
    const double inBody_m = cases.switches.retardation ? kernel::distanceInBody(leg, emission.event) : 0.0;
    const double distance_m = std::max(glm::length(seen_m), inBody_m);
    const double error = glm::length(glm::dvec3(outputs[i].seen_m) - seen_m) / distance_m;
    const double timeError = std::abs(outputs[i].boardTime_m - kernel::boardTimeOf(leg, emission.event)) /
                             std::abs(kernel::boardTimeOf(leg, emission.event));
    EXPECT_LT(error, kOfDistance) << "case " << i << ", " << view.legs.size() << " legs, offset "
                                  << cases.inputs[i].offset_m.x << " " << cases.inputs[i].offset_m.y << " "
                                  << cases.inputs[i].offset_m.z << ", seen " << glm::length(seen_m)
                                  << " m away";
    if (cases.switches.retardation) {
      EXPECT_LT(timeError, kOfDistance) << "case " << i;
    }
    worst = std::max(worst, error);
  }
  return worst;
}

TEST(EmissionShader, AgreesWithDoubleOnStraightLegs) {
  Graphics graphics;
  const Cases cases = makeCases(11, 10000, 0.99, 0);
  const double worst = worstError(cases);
  RecordProperty("worst_share_of_distance", std::to_string(worst * 1e9) + "e-9");
  std::printf("worst error: %.2g of the distance\n", worst);
}

TEST(EmissionShader, AgreesWithDoubleThroughBounces) {
  Graphics graphics;
  const Cases cases = makeCases(12, 10000, 0.9, 6);
  EXPECT_GT(cases.manyLegs, 2000);
  const double worst = worstError(cases);
  std::printf("worst error: %.2g of the distance, %d cases with several legs\n", worst, cases.manyLegs);
}

// The shader for bodies with two straight legs knows their number.
TEST(EmissionShader, AgreesWithDoubleAroundOneTurn) {
  Graphics graphics;
  for (const Switches switches : {Switches{}, Switches{0, 1, 1}, Switches{1, 0, 1}}) {
    SCOPED_TRACE(testing::Message() << "retardation " << +switches.retardation << ", contraction "
                                    << +switches.contraction);
    const Cases all = makeCases(19, 10000, 0.9, 2, switches);
    Cases cases{switches, all.legs, {}, {}, 0};
    for (std::size_t i = 0; i < all.inputs.size(); ++i) {
      if (all.inputs[i].legCount != 2) continue;
      cases.inputs.push_back(all.inputs[i]);
      cases.views.push_back(all.views[i]);
    }
    EXPECT_GT(cases.inputs.size(), 500U);
    worstError(cases, Legs::aroundTurn);
  }
}

TEST(EmissionShader, AgreesWithDoubleWithoutRetardationOrContraction) {
  Graphics graphics;
  for (const Switches switches : {Switches{0, 1, 1}, Switches{1, 0, 1}, Switches{0, 0, 1}}) {
    SCOPED_TRACE(testing::Message() << "retardation " << +switches.retardation << ", contraction "
                                    << +switches.contraction);
    worstError(makeCases(13, 5000, 0.9, 4, switches));
  }
}

TEST(EmissionShader, AgreesWithDoubleOnSpinningBodies) {
  Graphics graphics;
  const double spinning = worstError(makeCases(14, 10000, 0.9, 0, {}, 0.99, 0.0, 0.0, kDay_s));
  const Cases bouncing = makeCases(15, 10000, 0.9, 2, {}, 0.95, 0.0, 0.0, kDay_s);
  EXPECT_GT(bouncing.manyLegs, 1500);
  std::printf("worst errors: %.2g of the distance, through bounces %.2g\n", spinning, worstError(bouncing));
  for (const Switches switches : {Switches{0, 1, 1}, Switches{1, 0, 1}, Switches{0, 0, 1}}) {
    SCOPED_TRACE(testing::Message() << "retardation " << +switches.retardation << ", contraction "
                                    << +switches.contraction);
    worstError(makeCases(16, 2000, 0.8, 1, switches, 0.9));
  }
}

TEST(EmissionShader, AgreesWithDoubleWhereTheClothSlowsBodiesAndSpins) {
  Graphics graphics;
  for (const auto& [friction_m_s2, slowing_1_s] : {std::pair(0.0, 1.5), {0.3, 0.0}, {0.3, 1.5}}) {
    SCOPED_TRACE(testing::Message() << "friction " << friction_m_s2 << ", slowing " << slowing_1_s);
    const double worst = worstError(makeCases(17, 5000, 0.8, 2, {}, 0.9, friction_m_s2, slowing_1_s));
    std::printf("worst error: %.2g of the distance\n", worst);
    worstError(makeCases(18, 1000, 0.8, 1, {0, 1, 1}, 0.9, friction_m_s2, slowing_1_s));
  }
}

}  // namespace
}  // namespace carom
