#include "cave/gl/letter_batch.h"

#include <array>
#include <cstddef>

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/gl/letter_atlas.h"
#include "shaders/letter_frag.h"
#include "shaders/letter_vert.h"

namespace carom {
namespace {

constexpr double kNearest = 1e-3;  // of clip w, the distance from the eye: metres
// Of a cell, over the height of capitals, which stand in its middle.
constexpr double kUnit_px = kCapital_px;
const glm::dvec2 kCell(kLetterCell_px.x / kUnit_px, kLetterCell_px.y / kUnit_px);
constexpr double kBelow = 0.5 * (kLetterCell_px.y / kUnit_px - 1.0);

}  // namespace

void uploadLetters(const GlTexture& texture) {
  const LetterAtlas& atlas = letterAtlas();
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.size_px.x, atlas.size_px.y, 0, GL_RED, GL_UNSIGNED_BYTE,
               atlas.ink.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

LetterBatch::LetterBatch()
    : program_(makeProgram("letters", shaders::letter_vert, shaders::letter_frag)),
      stream_(program_, {{"clip", 4, offsetof(Corner, clip)},
                         {"on", 2, offsetof(Corner, on)},
                         {"ink", 4, offsetof(Corner, colour)}}) {}

void LetterBatch::draw(std::span<const SetLetter> letters, const glm::dmat4& clipFromRoom) {
  if (letters.empty()) return;
  if (!isRead_) uploadLetters(letters_);
  isRead_ = true;
  const glm::vec2 cells(kLetterColumns, letterAtlas().rows);
  corners_.clear();
  for (const SetLetter& letter : letters) {
    const glm::vec2 cell(letter.code % kLetterColumns, letter.code / kLetterColumns);
    std::array<Corner, 4> quad;
    bool isBefore = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec2 corner(i % 2, i / 2);
      const glm::dvec2 at = (corner - glm::dvec2(0.5, 0.0)) * kCell - glm::dvec2(0.0, kBelow);
      const glm::dvec3 place_m = letter.foot_m + at.x * letter.right_m + at.y * letter.up_m;
      quad[i] = {glm::vec4(clipFromRoom * glm::dvec4(place_m, 1.0)), (cell + glm::vec2(corner)) / cells,
                 letter.colour};
      isBefore = isBefore && quad[i].clip.w > kNearest;
    }
    if (!isBefore) continue;
    for (const std::size_t i : {0U, 1U, 2U, 2U, 1U, 3U}) corners_.push_back(quad[i]);
  }
  if (corners_.empty()) return;
  stream_.upload(corners_);
  glUseProgram(program_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, letters_);
  stream_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace carom
