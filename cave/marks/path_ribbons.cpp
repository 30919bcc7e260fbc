#include "cave/marks/path_ribbons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <vtk_glew.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/view_colours.h"
#include "engine/light/light_cone.h"
#include "shaders/path_frag.h"
#include "shaders/path_vert.h"

namespace carom {
namespace {

constexpr double kCell_m = 0.05;  // fine enough to bend as the cloth does
constexpr double kAhead_s = 4.0;  // the last leg is computed this far ahead, and anew when that is used up
constexpr double kShortest_m = 1e-3;  // a shorter path is none: the puck is at rest

/// Adds one straight leg, between two board times.
void addLeg(const Knot& knot, double from_s, double until_s, double base_s, double c_m_s,
            std::vector<PathRibbons::Corner>& corners) {
  const Vec3 start_m = motionOnLeg(knot, from_s, c_m_s).event.r_m;
  const double length_m = glm::length(motionOnLeg(knot, until_s, c_m_s).event.r_m - start_m);
  const double speed = glm::length(knot.u);
  if (!(length_m > kShortest_m) || !(speed > 0.0)) return;
  const glm::dvec2 along = glm::dvec2(knot.u) / speed;
  const glm::dvec2 aside = PathRibbons::kHalfWidth_m * glm::dvec2(-along.y, along.x);
  const int cells = std::max(1, static_cast<int>(std::ceil(length_m / kCell_m)));
  using Border = std::array<PathRibbons::Corner, 2>;
  const auto border = [&](int i) -> Border {
    const double t_s = from_s + (until_s - from_s) * i / cells;
    const Motion motion = motionOnLeg(knot, t_s, c_m_s);
    const glm::dvec2 place_m(motion.event.r_m);
    const auto time_s = static_cast<float>(t_s - base_s);
    const auto speed_m_s = static_cast<float>(c_m_s * glm::length(betaFromU(motion.u)));
    constexpr auto kHalf_m = static_cast<float>(PathRibbons::kHalfWidth_m);
    return {{{glm::vec2(place_m + aside), kHalf_m, time_s, speed_m_s},
             {glm::vec2(place_m - aside), -kHalf_m, time_s, speed_m_s}}};
  };
  Border last = border(0);
  for (int i = 1; i <= cells; ++i) {
    const Border next = border(i);
    for (const auto& corner : {last[0], last[1], next[0], next[0], last[1], next[1]})
      corners.push_back(corner);
    last = next;
  }
}

}  // namespace

void addWay(const WorldLine& puck, double from_s, double until_s, double base_s,
            std::vector<PathRibbons::Corner>& corners) {
  const auto knots = puck.knots();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double begin_s = std::max(from_s, knots[i].turn.t_s);
    const double end_s = std::min(until_s, i + 1 < knots.size() ? knots[i + 1].turn.t_s : until_s);
    if (end_s > begin_s) addLeg(knots[i], begin_s, end_s, base_s, puck.lightSpeed_m_s(), corners);
  }
}

PathRibbons::PathRibbons()
    : program_(makeProgram("path", shaders::path_vert, shaders::path_frag)),
      stream_(program_, {{"place_m", 2, offsetof(Corner, place_m)}, {"way", 3, offsetof(Corner, across_m)}}) {
}

bool PathRibbons::changed(std::span<const WorldLine> pucks, double now_s) const {
  if (ways_.size() != pucks.size() || !(now_s < madeUntil_s_) || now_s < base_s_) return true;
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const auto knots = pucks[i].knots();
    const Way& way = ways_[i];
    if (way.knots != knots.size() || way.firstTurn_s != knots.front().turn.t_s ||
        way.lastTurn_s != knots.back().turn.t_s)
      return true;
  }
  return false;
}

void PathRibbons::follow(std::span<const WorldLine> pucks, double now_s) {
  if (!changed(pucks, now_s)) return;
  base_s_ = std::floor(now_s - kAhead_s);  // in whole seconds: dots are counted from it
  madeUntil_s_ = now_s + kAhead_s;
  ways_.resize(pucks.size());
  corners_.clear();
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const auto knots = pucks[i].knots();
    Way& way = ways_[i];
    way = {static_cast<int>(corners_.size()),
           0,
           knots.size(),
           knots.front().turn.t_s,
           knots.back().turn.t_s,
           0,
           0};
    // The seen puck lags by the travel time of its light.
    const double seenFrom_s = now_s - kPast_s - kAhead_s - 20.0 / pucks[i].lightSpeed_m_s();
    addWay(pucks[i], seenFrom_s, madeUntil_s_, base_s_, corners_);
    way.count = static_cast<int>(corners_.size()) - way.first;
  }
  stream_.upload(corners_);
}

void PathRibbons::look(std::span<const WorldLine> pucks, const Event& observation, const Switches& switches,
                       double now_s) {
  eyeOnBoard_m_ = glm::vec3(observation.r_m);
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    ways_[i].seen_s = static_cast<float>(centreSeen(pucks[i], observation, switches).event.t_s - base_s_);
    const double known_s = std::max(now_s, pucks[i].knots().back().turn.t_s);
    ways_[i].known_s = static_cast<float>(std::min(known_s, madeUntil_s_) - base_s_);
  }
}

void PathRibbons::draw(const glm::mat4& clipFromDrawn, const glm::mat4& drawnFromBoard,
                       std::span<const glm::vec3> colours) const {
  glUseProgram(program_);
  stream_.bind();
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniformMatrix4fv(at("clipFromDrawn"), 1, GL_FALSE, glm::value_ptr(clipFromDrawn));
  glUniformMatrix4fv(at("drawnFromBoard"), 1, GL_FALSE, glm::value_ptr(drawnFromBoard));
  glUniform3fv(at("eyeOnBoard_m"), 1, glm::value_ptr(eyeOnBoard_m_));
  glUniform1f(at("above_m"), static_cast<float>(kAbove_m));
  glUniform1f(at("past_s"), static_cast<float>(kPast_s));
  const GLint colour = at("colour"), times = at("times_s");
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const Way& way = ways_[i];
    glUniform3fv(colour, 1, glm::value_ptr(codeOf(colours[i])));
    glUniform2f(times, way.seen_s, way.known_s);
    glDrawArrays(GL_TRIANGLES, way.first, way.count);
  }
}

}  // namespace carom
