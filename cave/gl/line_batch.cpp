#include "cave/gl/line_batch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <vtk_glew.h>
#include <glm/geometric.hpp>

#include "cave/gl/gl_program.h"
#include "shaders/line_frag.h"
#include "shaders/line_vert.h"

namespace carom {
namespace {

constexpr double kThinnest_px = 0.6;   // half of a width; thinner lines would have gaps
constexpr double kNearestLine = 1e-3;  // of clip w, the distance from the eye: metres

/// Returns how many pixels a metre across the line of sight has at w = 1: the part of the matrix's x row that
/// is not along the direction in which w grows.
double pixelsAcross(const glm::dmat4& clip, double half_px) {
  const glm::dvec3 x(clip[0][0], clip[1][0], clip[2][0]), w(clip[0][3], clip[1][3], clip[2][3]);
  return half_px * glm::length(x - w * (glm::dot(x, w) / glm::dot(w, w)));
}

}  // namespace

LineBatch::LineBatch()
    : program_(makeProgram("ribbon", shaders::line_vert, shaders::line_frag)),
      stream_(program_, {{"clip", 4, offsetof(Corner, clip)},
                         {"corner_px", 2, offsetof(Corner, across_px)},
                         {"ink", 4, offsetof(Corner, colour)}}) {}

/// Adds two triangles around the line on the picture, each end as wide as its distance makes it.
void LineBatch::add(const Ribbon& ribbon, const glm::dmat4& clipFromRoom, const glm::dvec2& half_px) {
  std::array<glm::dvec4, 2> ends{clipFromRoom * glm::dvec4(ribbon.from_m, 1.0),
                                 clipFromRoom * glm::dvec4(ribbon.to_m, 1.0)};
  if (!(std::max(ends[0].w, ends[1].w) > kNearestLine)) return;
  for (std::size_t i = 0; i < 2; ++i) {  // cuts off the part behind the eye
    const glm::dvec4& other = ends[1 - i];
    if (ends[i].w < kNearestLine)
      ends[i] += (other - ends[i]) * ((kNearestLine - ends[i].w) / (other.w - ends[i].w));
  }
  const auto onPicture = [&](const glm::dvec4& clip) { return glm::dvec2(clip) / clip.w * half_px; };
  const glm::dvec2 along_px = onPicture(ends[1]) - onPicture(ends[0]);
  const double length_px = glm::length(along_px);
  const glm::dvec2 along = length_px > 0.0 ? along_px / length_px : glm::dvec2(1.0, 0.0);
  const glm::dvec2 aside(-along.y, along.x);
  const double pixels = pixelsAcross(clipFromRoom, half_px.x);
  std::array<Corner, 4> quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec4& end = ends[i / 2];
    const double width_px = std::max(ribbon.halfWidth_m * pixels / end.w, kThinnest_px);
    const double across_px = (i % 2 == 0 ? 1.0 : -1.0) * (width_px + 1.0);
    const glm::dvec2 moved = across_px * aside / half_px * end.w;
    quad[i] = {glm::vec4(end + glm::dvec4(moved, 0.0, 0.0)), glm::vec2(across_px, width_px), ribbon.colour};
  }
  for (const std::size_t i : {0u, 1u, 2u, 2u, 1u, 3u}) corners_.push_back(quad[i]);
}

void LineBatch::draw(std::span<const Ribbon> ribbons, const glm::dmat4& clipFromRoom,
                     const glm::ivec2& size_px) {
  corners_.clear();
  for (const Ribbon& ribbon : ribbons) add(ribbon, clipFromRoom, 0.5 * glm::dvec2(size_px));
  if (corners_.empty()) return;
  stream_.upload(corners_);
  glUseProgram(program_);
  stream_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
}

}  // namespace carom
