#include "cave/marks/mark_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <vtk_glew.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/frame/clock_time.h"
#include "cave/gl/gl_program.h"
#include "cave/gl/letter_atlas.h"
#include "cave/gl/letter_batch.h"
#include "shaders/mark_frag.h"
#include "shaders/mark_vert.h"

namespace carom {
namespace {

// The styles of shaders/mark_frag.glsl, and the encoding of a plate.
constexpr float kFlat = 0.0F;
constexpr float kGlow = -1.0F;
constexpr float kDisc = -2.0F;
constexpr int kShape = 16;
constexpr std::array<double, 3> kMargins{0.12, 0.30, 0.20};  // on either side, for each shape
constexpr std::size_t kLettersInAFloat = 3;                  // of 8 bits: as many as it holds exactly

glm::vec4 packed(const PlateText& text) {
  glm::vec4 in(0.0F);
  for (std::size_t i = 0; i < text.letters.size(); ++i)
    in[static_cast<int>(i / kLettersInAFloat)] =
        256.0F * in[static_cast<int>(i / kLettersInAFloat)] + text.letters[i];
  return in;
}

/// Returns the shader of marks, for the picture of letters as it is.
std::string markShader() {
  return fmt::format("#version 150\nconst vec2 kCells = vec2({}.0, {}.0);\n", kLetterColumns,
                     letterAtlas().rows) +
         shaders::mark_frag;
}

}  // namespace

PlateText plateText(std::string_view words) {
  PlateText text;
  while (!words.empty() && static_cast<std::size_t>(text.places) < text.letters.size())
    text.letters[static_cast<std::size_t>(text.places++)] = takeLetter(words);
  return text;
}

namespace {

template <typename Value>
PlateText numberOnPlate(fmt::string_view format, Value value) {
  std::array<char, 64> text{};
  const auto end =
      fmt::vformat_to_n(text.data(), text.size(), format, fmt::make_format_args(texts::localized(value)));
  return plateText({text.data(), std::min(end.size, text.size())});
}

}  // namespace

PlateText wholeNumber(std::uint64_t number) { return numberOnPlate("{}", number % 1'000'000'000'000); }

PlateText tenthsOf(double time_s) {
  const double tenths = std::clamp(std::floor(10.0 * time_s), -10.0 * kMostShown_s, 10.0 * kMostShown_s);
  return numberOnPlate("{:.1f}", tenths / 10.0);
}

PlateText hundredthsOf(double time_s) {
  const double hundredths = std::clamp(std::round(100.0 * time_s), -99999.0, 99999.0);
  return numberOnPlate("{:.2f}", hundredths / 100.0 + 0.0);  // a zero without a sign
}

PlateText measured(const texts::Text& words, double value) {
  return written(words, std::clamp(value, 0.0, 9999.0));
}

double placesAcross(const PlateText& text, PlateShape shape) {
  return text.places + 2.0 * kMargins[static_cast<std::size_t>(shape)];
}

void MarkBuffer::addStrip(std::span<const glm::dvec3> left_m, std::span<const glm::dvec3> right_m,
                          const glm::vec4& colour) {
  for (std::size_t i = 0; i + 1 < left_m.size(); ++i) {
    for (const glm::dvec3& place :
         {left_m[i], left_m[i + 1], right_m[i], right_m[i], left_m[i + 1], right_m[i + 1]})
      corners_.push_back({glm::vec3(place), colour, {}, kFlat, {}, {}});
  }
}

void MarkBuffer::addLine(std::span<const glm::dvec3> drawn_m, const glm::vec4& colour, double halfWidth_rad) {
  // The direction across both the line of sight and the line. Every part of the line has some length, so
  // neither vanishes for long.
  const std::size_t last = drawn_m.size() - 1;
  const bool isClosed = last > 1 && drawn_m.front() == drawn_m.back();
  const auto aside = [&](std::size_t i) {
    const bool isSeam = isClosed && (i == 0 || i == last);
    const glm::dvec3 way =
        isSeam ? drawn_m[1] - drawn_m[last - 1] : drawn_m[std::min(i + 1, last)] - drawn_m[i > 0 ? i - 1 : 0];
    const glm::dvec3 across = glm::cross(way, drawn_m[i]);
    const double length = glm::length(across);
    return length > 0.0 ? across * (halfWidth_rad * glm::length(drawn_m[i]) / length) : glm::dvec3(0.0);
  };
  for (std::size_t i = 0; i + 1 < drawn_m.size(); ++i) {
    const std::array<glm::dvec3, 2> left{drawn_m[i] + aside(i), drawn_m[i + 1] + aside(i + 1)};
    const std::array<glm::dvec3, 2> right{drawn_m[i] - aside(i), drawn_m[i + 1] - aside(i + 1)};
    addStrip(left, right, colour);
  }
}

void MarkBuffer::addPlate(std::span<const glm::dvec3> lower_m, std::span<const glm::dvec3> upper_m,
                          const PlateText& text, PlateShape shape, const glm::vec4& colour) {
  const auto what = static_cast<float>(text.places + kShape * static_cast<int>(shape));
  const glm::vec4 letters = packed(text);
  const glm::dvec3 middle_m = 0.5 * (lower_m.front() + upper_m.back());
  const glm::vec4 plate(middle_m, 0.5 * glm::distance(lower_m.front(), upper_m.back()));
  const float step = static_cast<float>(placesAcross(text, shape)) / static_cast<float>(lower_m.size() - 1);
  const int first = static_cast<int>(corners_.size()), count = static_cast<int>(6 * (lower_m.size() - 1));
  const bool goesOn = !plates_.empty() && plates_.back().first + plates_.back().count == first;
  if (goesOn) {
    plates_.back().count += count;
  } else {
    plates_.push_back({first, count});
  }
  for (std::size_t i = 0; i + 1 < lower_m.size(); ++i) {
    const float from = step * static_cast<float>(i), to = step * static_cast<float>(i + 1);
    const MarkCorner a{glm::vec3(lower_m[i]), colour, {from, 0.0F}, what, letters, plate};
    const MarkCorner b{glm::vec3(lower_m[i + 1]), colour, {to, 0.0F}, what, letters, plate};
    const MarkCorner c{glm::vec3(upper_m[i]), colour, {from, 1.0F}, what, letters, plate};
    const MarkCorner d{glm::vec3(upper_m[i + 1]), colour, {to, 1.0F}, what, letters, plate};
    for (const MarkCorner& corner : {a, b, c, c, b, d}) corners_.push_back(corner);
  }
}

void MarkBuffer::addGlow(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour) {
  addRound(drawn_m, radius_m, colour, kGlow);
}

void MarkBuffer::addDisc(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour) {
  addRound(drawn_m, radius_m, colour, kDisc);
}

void MarkBuffer::addRound(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour, float style) {
  const double distance_m = glm::length(drawn_m);
  if (!(distance_m > 0.0)) return;
  const glm::dvec3 sight = drawn_m / distance_m;
  const glm::dvec3 other = std::abs(sight.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = radius_m * glm::normalize(glm::cross(sight, other));
  const glm::dvec3 up = glm::cross(right, sight);
  const auto corner = [&](double u, double v) {
    return MarkCorner{glm::vec3(drawn_m + u * right + v * up), colour, glm::vec2(u, v), style, {}, {}};
  };
  for (const MarkCorner& c :
       {corner(-1, -1), corner(1, -1), corner(-1, 1), corner(-1, 1), corner(1, -1), corner(1, 1)})
    corners_.push_back(c);
}

MarkDrawer::MarkDrawer()
    : program_(makeProgram("mark", shaders::mark_vert, markShader())),
      stream_(program_, {{"drawn_m", 3, offsetof(MarkCorner, drawn_m)},
                         {"ink", 4, offsetof(MarkCorner, colour)},
                         {"on", 2, offsetof(MarkCorner, on)},
                         {"what", 1, offsetof(MarkCorner, style)},
                         {"words", 4, offsetof(MarkCorner, text)},
                         {"plate", 4, offsetof(MarkCorner, plate)}}),
      clipAt_(glGetUniformLocation(program_, "clipFromDrawn")),
      cutAt_(glGetUniformLocation(program_, "cutAt")) {
  uploadLetters(letters_);
}

void MarkDrawer::Runs::add(int first, int end) {
  if (end == first) return;
  firsts.push_back(first);
  counts.push_back(end - first);
}

void MarkDrawer::Runs::draw() const {
  glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), static_cast<int>(firsts.size()));
}

void MarkDrawer::upload(const MarkBuffer& batch) {
  for (Runs* runs : {&flat_, &plates_}) {
    runs->firsts.clear();
    runs->counts.clear();
  }
  if (batch.corners().empty()) return;
  stream_.upload(batch.corners());
  int end = 0;
  for (const auto& [first, count] : batch.plates()) {
    flat_.add(end, first);
    end = first + count;
    plates_.add(first, end);
  }
  flat_.add(end, static_cast<int>(batch.corners().size()));
}

void MarkDrawer::draw(const glm::mat4& clipFromDrawn, float cutAt) const {
  if (flat_.firsts.empty() && plates_.firsts.empty()) return;
  glUseProgram(program_);
  stream_.bind();
  glUniformMatrix4fv(clipAt_, 1, GL_FALSE, glm::value_ptr(clipFromDrawn));
  glUniform1f(cutAt_, cutAt);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, letters_);
  flat_.draw();
  plates_.draw();
}

}  // namespace carom
