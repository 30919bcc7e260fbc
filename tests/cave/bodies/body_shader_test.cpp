// How the shader of bodies lights and colours a vertex, read back from the graphics card, against light
// followed from the lamps to the head by Lorentz transforms and summed over its spectrum.
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <vector>

#include "cave/bodies/body_shaders.h"
#include "cave/bodies/hot_bodies.h"
#include "cave/display/window.h"
#include "cave/gl/gl_objects.h"
#include "engine/colour/doppler_colour.h"
#include "engine/colour_reference.h"
#include "engine/light/light_cone.h"
#include "engine/light/mesh_emission.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

constexpr std::array<Vec3, 3> kLamps_m{{{-1.0, 0.1, 1.4}, {0.1, 0.2, 1.5}, {0.9, -0.1, 1.3}}};
constexpr double kRoughness = 0.3;
constexpr float kSeenShare = 0.8F;  // of all light; results are given for 1

/// One vertex of one body, seen by one eye.
struct Case {
  WorldLine line;
  Vec3 offset_m;
  Vec3 normal;
  Event eye;
  Lorentz headFromBoard;
  glm::vec4 share{1.0F};  ///< of each lamp's light and of the hall's, that reaches the vertex
  std::array<Event, 4> blows{};
  glm::vec4 heats{0.0F};
};

Case randomCase(test::Random& random, int bounces, double maxBeta) {
  const WorldLine line = randomWorldLine(random, kC_m_s, 0.2, bounces, 0.5, maxBeta);
  const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 2.0), random.inBox(2.0)};
  Case c{line, random.inBall(0.2), random.direction(), eye, Lorentz::boost(random.u(maxBeta), kC_m_s)};
  for (int i = 0; i < 4; ++i) c.share[i] = static_cast<float>(random.in(0.0, 1.0));
  return c;
}

/// What the shader hands on for the vertex. Without colour, `light` and `glow` are diagonal, `shine` grey.
struct Lit {
  glm::dmat3 light{0.0};
  glm::dmat3 glow{0.0};
  Vec3 shine{0.0};
  Vec3 heatGlow{0.0};  ///< of a program for hot bodies
};

/// The program that draws a lamp's surface (whose `glow` is handed on, too) in one state of the switches.
class BodyProgram {
 public:
  BodyProgram(Legs legs, const Switches& switches, bool isHot = false) : switches_(switches) {
    const std::string text = bodyVertexShader({legs, Paint::lamp, switches, ViewTime::seen, false, isHot});
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program_, shader);
    const std::array<const char*, 4> outputs{"light", "glow", "shine", "heatGlow"};
    glTransformFeedbackVaryings(program_, isHot ? 4 : 3, outputs.data(), GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program_);
    std::string log(8192, '\0');
    glGetShaderInfoLog(shader, 8192, nullptr, log.data());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE) << log.c_str();
    const ColourTable table;
    upload(1, table.texels().data(), table.texels().size() * sizeof(glm::vec4));
  }

  Lit run(const Case& c) {
    BodyView view;
    viewBody(c.line, c.eye, c.headFromBoard, view, switches_);
    std::vector<kernel_float::LegView> legs;
    for (const LegView& leg : view.legs) legs.push_back(toFloat(leg));
    upload(0, legs.data(), legs.size() * sizeof(legs[0]));
    glUseProgram(program_);
    setUniforms(c, legs);
    return drawOne(c);
  }

 private:
  void upload(std::size_t unit, const void* data, std::size_t bytes) {
    glBindBuffer(GL_TEXTURE_BUFFER, texels_[unit]);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, textures_[unit]);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, texels_[unit]);
  }

  void setUniforms(const Case& c, const std::vector<kernel_float::LegView>& legs) const {
    const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
    const ViewFrame frame(c.headFromBoard, switches_);
    const glm::mat4 drawnFromSeen(frame.drawnFromSeen.matrix());
    const glm::mat4 boardFromDrawn(frame.drawnFromBoard.inverse().matrix());
    const Vec3 u = c.headFromBoard.inverse().u();
    const glm::vec3 eye_m(c.eye.r_m);
    std::array<glm::vec3, 3> lamps_m;
    for (std::size_t i = 0; i < 3; ++i) lamps_m[i] = glm::vec3(kLamps_m[i]);
    glUniform1i(at("legTexels"), 0);
    glUniform1i(at("colourTexels"), 1);
    glUniform1i(at("firstLeg"), 0);
    glUniform1i(at("legCount"), static_cast<int>(legs.size()));
    glUniform4fv(at("onlyLeg"), 15, reinterpret_cast<const float*>(legs.data()));
    glUniformMatrix4fv(at("drawnFromSeen"), 1, GL_FALSE, glm::value_ptr(drawnFromSeen));
    glUniformMatrix4fv(at("boardFromDrawn"), 1, GL_FALSE, glm::value_ptr(boardFromDrawn));
    glUniform4f(at("headOnBoard"), static_cast<float>(gammaFromU(u)), static_cast<float>(u.x),
                static_cast<float>(u.y), static_cast<float>(u.z));
    glUniform3fv(at("eyeOnBoard_m"), 1, glm::value_ptr(eye_m));
    glUniform3fv(at("lamps_m"), 3, glm::value_ptr(lamps_m[0]));
    glUniform1f(at("roughness"), static_cast<float>(kRoughness));
    glUniform1f(at("seenShare"), kSeenShare);
    std::array<glm::vec4, 4> blows;
    for (std::size_t i = 0; i < 4; ++i)
      blows[i] = glm::vec4(static_cast<float>(kC_m_s * (c.blows[i].t_s - c.eye.t_s)),
                           glm::vec3(c.blows[i].r_m - c.eye.r_m));
    glUniform4fv(at("blows"), 4, glm::value_ptr(blows[0]));
    glUniform4fv(at("blowHeats"), 1, glm::value_ptr(c.heats));
    glUniform1f(at("cooling_m"), static_cast<float>(kC_m_s * kCooling_s));
  }

  Lit drawOne(const Case& c) {
    const std::array<glm::vec3, 2> vertex{glm::vec3(c.offset_m), glm::vec3(c.normal)};
    glBindVertexArray(vertices_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertex, vertex.data(), GL_STREAM_DRAW);
    const auto attribute = [&](const char* name, std::size_t offset) {
      const auto location = static_cast<GLuint>(glGetAttribLocation(program_, name));
      glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof vertex,
                            reinterpret_cast<const void*>(offset));
      glEnableVertexAttribArray(location);
    };
    attribute("vertexMC", 0);
    attribute("normalMC", sizeof(glm::vec3));
    glVertexAttrib4fv(static_cast<GLuint>(glGetAttribLocation(program_, "litMC")), glm::value_ptr(c.share));
    std::array<float, 24> out{};
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers_[1]);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof out, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, 1);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof out, out.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    for (float& value : out) value /= kSeenShare;
    if (switches_.colour) {
      return {glm::dmat3(glm::make_mat3(&out[0])), glm::dmat3(glm::make_mat3(&out[9])),
              Vec3(glm::make_vec3(&out[18])), Vec3(glm::make_vec3(&out[21]))};
    }
    const auto diagonal = [&](std::size_t i) {
      return glm::dmat3(out[i], 0, 0, 0, out[i + 1], 0, 0, 0, out[i + 2]);
    };
    return {diagonal(0), diagonal(3), Vec3(out[6]), Vec3(glm::make_vec3(&out[7]))};
  }

  Switches switches_;
  GlProgram program_;
  GlVertexArray vertices_;
  std::array<GlBuffer, 2> buffers_;
  std::array<GlTexture, 2> textures_;
  std::array<GlBuffer, 2> texels_;
};

/// Light of one source on its way over a body to the head: what it makes of the three primaries.
glm::dmat3 follow(double heat, double intoBody, double intoHead, double solidAngle, const Switches& s) {
  const double doppler = intoBody * intoHead;
  if (s.colour && s.searchlight) return solidAngle * colourResponse(heat * doppler, intoHead);
  if (s.colour) return std::pow(doppler, -4.0) * colourResponse(heat * doppler, intoHead);
  const Vec3 white = colourResponse(heat, 1.0) * Vec3(1.0);
  const double power = s.searchlight ? solidAngle * std::pow(doppler, 4.0) : 1.0;
  return power * glm::dmat3(white.x, 0, 0, 0, white.y, 0, 0, 0, white.z);
}

/// A ray from one event to a later one along light, in the body's frame: its direction and frequency there.
struct Ray {
  Vec3 direction;
  double doppler;
};
Ray intoBody(const Vec3& way, const Vec3& u) {
  const Displacement light = Lorentz::boost(u, 1.0).inverse() * Displacement{glm::length(way), way};
  return {glm::normalize(light.dr_m), light.dt_s / glm::length(way)};
}

/// The share of slopes (x, y) = tan θ of the facets of a rough surface per unit of slopes, for Trowbridge and
/// Reitz: 1/(π α² (1 + tan² θ/α²)²).
double slopesShare(double tangent2) {
  const double a2 = kRoughness * kRoughness;
  return 1.0 / (std::numbers::pi * a2 * std::pow(1.0 + tangent2 / a2, 2));
}

/// The share of facets that the others leave in sight from this angle to the normal, 1/(1 + Λ) (Smith 1967):
/// Λ is the mean height by which facets rise towards the eye over its slope, here summed over slopes m,
///   Λ(μ) = 1/μ ∫_μ^∞ (m − μ) P(m) dm,   μ = cot θ,
/// with P the share of slopes along one direction: α²/(2 (α² + m²)^(3/2)).
double inSight(double cosine) {
  if (cosine >= 1.0) return 1.0;
  const double mu = cosine / std::sqrt(1.0 - cosine * cosine), a2 = kRoughness * kRoughness;
  double sum = 0.0;
  const double step = 1e-2;
  for (double x = 0.5 * step; x < 12.0; x += step) {  // m = μ + e^x − 1
    const double rise = std::exp(x) - 1.0, m = mu + rise;
    sum += rise * a2 / (2.0 * std::pow(a2 + m * m, 1.5)) * std::exp(x) * step;
  }
  return 1.0 / (1.0 + sum / mu);
}

/// Highlights of varnish as facets that mirror: their share by slopes, D = P(slopes)/cos⁴ θ, by how many of
/// them lamp and eye see, and what each mirrors.
double highlightByTheBook(const Vec3& normal, const Vec3& toLamp, const Vec3& toEye) {
  const Vec3 facet = glm::normalize(toLamp + toEye);
  const double toFacet = glm::dot(normal, facet), nl = glm::dot(normal, toLamp), ne = glm::dot(normal, toEye);
  if (nl <= 0.0 || ne <= 0.0) return 0.0;
  const double facets = slopesShare(1.0 / (toFacet * toFacet) - 1.0) / std::pow(toFacet, 4);
  const double mirrored = 0.04 + 0.96 * std::pow(1.0 - glm::dot(toEye, facet), 5);
  return std::numbers::pi * facets * mirrored * inSight(nl) * inSight(ne) / (4.0 * ne);
}

constexpr double kLampHeat = 0.848, kLampPower = 1.88;  // 5512 K, as bright as shaders/body_vert.glsl has it

/// For a body that does not turn.
Lit litByTheBook(const Case& c, const Switches& s) {
  const Emission emission = carom::emission(c.line, c.offset_m, c.eye, c.headFromBoard).value();
  const double toHead = emission.doppler;
  const Ray eyeRay = intoBody(c.eye.r_m - emission.event.r_m, emission.u);
  const Vec3 toEye = s.aberration ? eyeRay.direction : glm::normalize(c.eye.r_m - emission.event.r_m);
  const double hall = c.share.w * (0.32 + 0.34 * (0.5 + 0.5 * c.normal.z));
  // From direction n of the body's sky light has D = 1/(γ(1 − β·n)); the mean cosine to the normal is 2/3.
  const double hallToBody = 1.0 / (gammaFromU(emission.u) - glm::dot(emission.u, c.normal) * 2.0 / 3.0);
  Lit lit;
  lit.glow = follow(1.0, 1.0, toHead, 1.0, s);
  lit.light = hall * follow(1.0, hallToBody, toHead, 1.0, s);
  for (int i = 0; i < 3; ++i) {
    const Vec3& lamp_m = kLamps_m[static_cast<std::size_t>(i)];
    const Vec3 way = emission.event.r_m - lamp_m;
    const Ray ray = intoBody(way, emission.u);
    const Vec3 toLamp = -(s.aberration ? ray.direction : glm::normalize(way));
    const double strength = c.share[i] * 1.1 / (glm::dot(way, way) + 0.3);
    const double solidAngle = s.searchlight ? 1.0 / (ray.doppler * ray.doppler) : 1.0;
    const glm::dmat3 sent = kLampPower * strength * follow(kLampHeat, ray.doppler, toHead, solidAngle, s);
    const double facing = std::max(glm::dot(c.normal, toLamp), 0.0);
    lit.light += facing * sent;
    if (facing == 0.0) continue;
    lit.shine += highlightByTheBook(c.normal, toLamp, toEye) * (sent * Vec3(1.0));
  }
  if (!s.colour) lit.shine = Vec3(lit.shine.x);  // the fragment shader gives it the lamps' colour
  return lit;
}

/// As steps of a screen on which white in this light is white. Light colder than 750 K is dark beside a lamp
/// under any exposure: then what white shows at 750 K is white.
double screenSteps(const glm::dmat3& a, const glm::dmat3& b) {
  const Vec3 white = b * Vec3(1.0);
  const double scale =
      1.0 / std::max({white.x, white.y, white.z, (colourResponse(0.115, 1.0) * Vec3(1.0)).x});
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double steps = test::screenSteps(scale * a[i], scale * b[i]);
    worst = steps <= worst ? worst : steps;
    if (std::isnan(worst)) break;
  }
  return worst;
}

constexpr double kScreenSteps = 2.0;  // one for the table's bands (doppler_colour_test.cpp), one for floats

TEST(BodyShader, LightIsFollowedFromTheLampsToTheHead) {
  Graphics graphics;
  for (const Switches switches : {Switches{}, Switches{1, 1, 1, 1, 1}, Switches{1, 1, 1, 1, 0},
                                  Switches{1, 1, 1, 0, 1}, Switches{1, 1, 0, 0, 0}}) {
    BodyProgram program(Legs::one, switches);
    test::Random random(41);
    for (int i = 0; i < 200; ++i) {
      const Case c = randomCase(random, 0, 0.8);
      const Lit lit = program.run(c);
      const Lit expected = litByTheBook(c, switches);
      SCOPED_TRACE(testing::Message() << "case " << i << ", colour " << +switches.colour << ", searchlight "
                                      << +switches.searchlight << ", aberration " << +switches.aberration);
      ASSERT_LT(screenSteps(lit.light, expected.light), kScreenSteps);
      ASSERT_LT(screenSteps(lit.glow, expected.glow), kScreenSteps);
      const double brightest = glm::length(expected.light * Vec3(1.0));
      ASSERT_LT(glm::length(lit.shine - expected.shine), 0.02 * (brightest + glm::length(expected.shine)));
    }
  }
}

/// What the matter of a vertex sends by its heat: of each blow the news must have come, and the rest cools
/// for the own time of matter that went straight from there. Planck's law, wavelength by wavelength.
Vec3 glowByTheBook(const Case& c, const Switches& s) {
  const Emission emission = carom::emission(c.line, c.offset_m, c.eye, c.headFromBoard).value();
  double heat = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Displacement way = emission.event - c.blows[static_cast<std::size_t>(i)];
    const double beta = glm::length(way.dr_m) / (kC_m_s * way.dt_s);
    if (!(way.dt_s > 0.0 && beta < 1.0)) continue;
    heat += c.heats[i] * std::exp(-way.dt_s * std::sqrt(1.0 - beta * beta) / kCooling_s);
  }
  const double temperature_K = std::min(800.0 + 2400.0 * heat, 6500.0);
  const double d = s.colour ? emission.doppler : 1.0;
  double reference_cd_m2 = 0.0;
  for (double wavelength_nm = 360.0; wavelength_nm <= 830.0; wavelength_nm += 1.0)
    reference_cd_m2 += 683.002 * matchingFunctions(wavelength_nm).y *
                       blackBodyRadiance(wavelength_nm, kReferenceTemperature_K);
  const double power = std::pow(emission.doppler, s.searchlight ? 4.0 : 0.0) / std::pow(d, 4.0);
  return reference_cd_m2 / 2000.0 * power * test::seenOf([&](double wavelength_nm) {
           return std::pow(d, 5) * blackBodyRadiance(d * wavelength_nm, temperature_K);
         });
}

// Blows before and after the vertex's emission, some out of reach of their news.
TEST(BodyShader, HotMatterGlowsAsABlackBodyOnceTheNewsOfABlowHasCome) {
  Graphics graphics;
  int bright = 0, dark = 0;
  for (const Switches switches : {Switches{}, Switches{1, 1, 1, 1, 1}, Switches{1, 1, 1, 1, 0},
                                  Switches{1, 1, 1, 0, 1}, Switches{1, 1, 0, 0, 0}}) {
    BodyProgram program(Legs::one, switches, true);
    test::Random random(43);
    for (int i = 0; i < 200; ++i) {
      Case c = randomCase(random, 0, 0.6);
      const Event at = carom::emission(c.line, c.offset_m, c.eye, c.headFromBoard).value().event;
      for (int k = 0; k < 4; ++k) {
        c.blows[static_cast<std::size_t>(k)] = {at.t_s - random.in(-0.3, 4.0), at.r_m + random.inBox(1.5)};
        c.heats[k] = static_cast<float>(random.in(0.0, 0.8));
      }
      const Vec3 seen = program.run(c).heatGlow, expected = glowByTheBook(c, switches);
      const double scale = 1.0 / std::max({expected.x, expected.y, expected.z, 1e-4});
      ASSERT_LT(test::screenSteps(seen * scale, expected * scale), kScreenSteps)
          << "case " << i << ", colour " << +switches.colour << ", searchlight " << +switches.searchlight
          << ": " << seen.x << ' ' << seen.y << ' ' << seen.z << ", expected " << expected.x << ' '
          << expected.y << ' ' << expected.z;
      (expected.x > 1.0 ? bright : dark) += 1;
    }
  }
  EXPECT_GT(bright, 300);
  EXPECT_GT(dark, 20);
}

// Through bounces: D⁴, with the Doppler factor that the engine's own solve for meshes has.
TEST(BodyShader, DopplerFactorThroughBounces) {
  Graphics graphics;
  BodyProgram program(Legs::many, {1, 1, 1, 0, 1});
  test::Random random(42);
  for (int i = 0; i < 500; ++i) {
    const Case c = randomCase(random, i % 4, 0.9);
    BodyView view;
    viewBody(c.line, c.eye, c.headFromBoard, view);
    const std::array<glm::vec3, 1> offset{glm::vec3(c.offset_m)};
    glm::vec3 seen{0.0F};
    float doppler = 0.0F;
    seePoints(view, {{&offset[0].x, 1}, {&offset[0].y, 1}, {&offset[0].z, 1}},
              {{&seen.x, 1}, {&seen.y, 1}, {&seen.z, 1}, {&doppler, 1}, {}});
    const double expected = std::pow(doppler, 4.0);
    const double rounding = 1e-3;  // of floats: D cancels to 1/4γ² of its terms, to the fourth power
    ASSERT_LT(std::abs(program.run(c).glow[0][0] - expected), rounding * expected) << "case " << i;
  }
}

// Head on at 0.3 c: what approaches grows bluer, what recedes redder.
TEST(BodyShader, ApproachMakesBluerAndRecessionRedder) {
  Graphics graphics;
  BodyProgram program(Legs::one, {1, 1, 1, 1, 1});
  const auto blueness = [&](double beta) {
    const WorldLine line({{0.0, {0.0, 2.0, 0.0}}, uFromBeta({0.0, -beta, 0.0}), 0.0, {}, 0.0}, kC_m_s, 0.1);
    const Lit lit = program.run({line, Vec3(0.0), {0.0, -1.0, 0.0}, {0.0, Vec3(0.0)}, Lorentz(kC_m_s)});
    const Vec3 green = lit.glow * Vec3(0.0, 1.0, 0.0);
    return green.z - green.x;
  };
  EXPECT_GT(blueness(0.1), blueness(0.0) + 0.1);
  EXPECT_LT(blueness(-0.1), blueness(0.0) - 0.1);
  EXPECT_NEAR(blueness(0.0), 0.0, 0.01);
}

}  // namespace
}  // namespace carom
