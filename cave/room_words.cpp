#include "cave/room_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/gl_program.h"
#include "cave/off_axis.h"
#include "cave/plain_state.h"
#include "cave/view_colours.h"
#include "engine/lorentz.h"
#include "shaders/stereo_vert.h"
#include "shaders/words_frag.h"

namespace carom {
namespace {

constexpr double kCapitalOfLetters = 0.72;  // height of a capital, of the letters' nominal height
constexpr double kLine = 1.5;               // from line to line, of that height
constexpr double kSmallest_px = 9.0;        // letters lower than this cannot be read at all
constexpr double kMostOfWall = 0.6;         // of its width, for the panel
constexpr std::array<std::uint8_t, 4> kGround{12, 14, 18, 175};  // dark; half of the picture shows through
constexpr std::uint8_t kWhite = 235;
constexpr glm::vec3 kSeenMark(0.92F);

/// Lines one after the other into memory that is used again.
class Lines {
 public:
  explicit Lines(std::vector<RoomLine>& lines) : lines_(lines) {}
  ~Lines() { lines_.resize(count_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  template <typename... Values>
  void add(const std::optional<glm::vec3>& mark, fmt::format_string<Values...> words, Values&&... values) {
    if (count_ == lines_.size()) lines_.emplace_back();
    RoomLine& line = lines_[count_++];
    line.mark = mark;
    line.text.clear();
    fmt::format_to(std::back_inserter(line.text), words, std::forward<Values>(values)...);
  }

 private:
  std::vector<RoomLine>& lines_;
  std::size_t count_ = 0;
};

void addClocks(const FrameRecord& record, Lines& lines) {
  const Vec3 u = record.observer.headFromBoard.inverse().u();
  lines.add({}, "my clock  {:.1f} s", std::floor(10.0 * record.observer.properTime_s) / 10.0);
  lines.add({}, "my speed  {:.2f} c   gamma {:.2f}", glm::length(betaFromU(u)), gammaFromU(u));
  lines.add({}, "light  {:.2f} m/s", record.lightSpeed_m_s);
}

}  // namespace

std::optional<Wall> frontWall(const RoomFacts& room) {
  for (const Wall& wall : room.walls) {
    const glm::dvec3 normal =
        glm::normalize(glm::cross(wall.lowerRight_m - wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m));
    if (-glm::dot(normal, room.forward) > std::sqrt(0.5)) return wall;
  }
  return std::nullopt;
}

void describe(const FrameRecord& record, std::vector<RoomLine>& words) {
  const TimeViews& views = record.views;
  Lines lines(words);
  if (views.boardNow || views.myNow || views.split) lines.add(kSeenMark, "as seen");
  if (views.boardNow) lines.add(kBoardNowColour, "now on the board");
  if (views.myNow) lines.add(kMyNowColour, "my now");
  if (views.split && views.beside == kNoSwitches) {
    lines.add({}, "left: Einstein, right: Newton");
  } else if (views.split) {
    lines.add({}, "left: as chosen, right: otherwise");
  }
  if (views.frozen) lines.add({}, "frozen");
  if (views.clocks) addClocks(record, lines);
  if (record.controls.trackerCross) lines.add({}, "of the two bars the right one is nearer");
}

RoomWords::RoomWords() : program_(makeProgram("words", shaders::stereo_vert, shaders::words_frag)) {
  glGenVertexArrays(1, &vertexArray_);
  glGenTextures(1, &texture_);
}

RoomWords::~RoomWords() {
  glDeleteTextures(1, &texture_);
  glDeleteVertexArrays(1, &vertexArray_);
  glDeleteProgram(program_);
}

void RoomWords::set(const std::vector<RoomLine>& lines) {
  if (lines.size() != lines_.size()) written_ = false;
  lines_.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == lines_[i].line) continue;
    lines_[i].line = lines[i];
    lines_[i].ink = {};
    written_ = false;
  }
}

void RoomWords::follow(const FrameRecord& record) {
  const auto tenths_s = static_cast<std::int64_t>(std::floor(10.0 * record.display_s));
  if (tenths_s == tenths_s_ && record.views == views_ && record.controls == controls_) return;
  tenths_s_ = tenths_s;
  views_ = record.views;
  controls_ = record.controls;
  describe(record, described_);
  set(described_);
}

void RoomWords::write(const glm::ivec2& picture_px, const glm::dvec2& size_m) {
  int height_px = static_cast<int>(
      std::lround(std::max(kSmallest_px, kCapital_m / kCapitalOfLetters * picture_px.y / size_m.y)));
  const auto widest_px = [&] {
    int widest = 0;
    for (Written& written : lines_) {
      if (height_px != height_px_ || written.ink.size_px.x == 0)
        written.ink = ink(written.line.text, height_px);
      widest = std::max(widest, written.ink.size_px.x);
    }
    height_px_ = height_px;
    return widest;
  };
  // A small wall has small words.
  const int room_px = static_cast<int>(kMostOfWall * picture_px.x) - 3 * height_px;
  if (const int wide_px = widest_px(); wide_px > room_px && room_px > 0) {
    height_px = std::max(1, height_px * room_px / wide_px);
    widest_px();
  }
}

/// The ground, the marks and the ink as one picture.
void RoomWords::upload(const glm::ivec2& size_px, int height_px) {
  size_px_ = size_px;
  rgba_.resize(4 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
  for (std::size_t i = 0; i < rgba_.size(); ++i) rgba_[i] = kGround[i % 4];
  const auto cover = [&](const glm::ivec2& at, const glm::vec3& colour, int alpha) {
    if (at.x < 0 || at.y < 0 || at.x >= size_px.x || at.y >= size_px.y || alpha == 0) return;
    std::uint8_t* pixel =
        &rgba_[4 * (static_cast<std::size_t>(at.y) * size_px.x + static_cast<std::size_t>(at.x))];
    for (int i = 0; i < 3; ++i) {
      pixel[i] =
          static_cast<std::uint8_t>((pixel[i] * (255 - alpha) + static_cast<int>(colour[i]) * alpha) / 255);
    }
    pixel[3] = std::max(pixel[3], static_cast<std::uint8_t>(alpha));
  };
  const int line_px = static_cast<int>(kLine * height_px), text_px = 2 * height_px;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto& [line, ink] = lines_[i];
    const int foot_px = size_px.y - height_px / 2 - static_cast<int>(i + 1) * line_px;
    for (int y = 0; y < ink.size_px.y; ++y) {
      for (int x = 0; x < ink.size_px.x; ++x) {
        cover({text_px + x, foot_px + ink.below_px + y}, glm::vec3(kWhite),
              ink.alpha[static_cast<std::size_t>(y * ink.size_px.x + x)]);
      }
    }
    const int mark_px = 3 * height_px / 4;
    for (int y = 0; line.mark && y < mark_px; ++y) {
      for (int x = 0; x < mark_px; ++x)
        cover({2 * height_px / 3 + x, foot_px + height_px / 4 + y}, 255.0F * *line.mark, 255);
    }
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_px.x, size_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void RoomWords::draw(const Wall& wall, const WallPicture& picture) {
  if (lines_.empty()) return;
  const PlainState state(picture.framebuffer(), picture.size_px());
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  if (!written_ || picture_px_ != picture.size_px()) {
    if (picture_px_ != picture.size_px()) height_px_ = 0;
    write(picture.size_px(), sizeOf_m(wall));
    int widest_px = 0;
    for (const Written& written : lines_) widest_px = std::max(widest_px, written.ink.size_px.x);
    widest_px += height_px_ - widest_px % height_px_;  // so that it does not tremble with its digits
    upload({widest_px + 3 * height_px_,
            static_cast<int>(kLine * height_px_) * static_cast<int>(lines_.size()) + height_px_},
           height_px_);
    written_ = true;
    picture_px_ = picture.size_px();
  }
  // Pixel on pixel, but for pixels that are not square.
  const glm::ivec2 from_px = glm::dvec2(kMargin_m) * pxPerM;
  blendOver();
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glUniform1i(glGetUniformLocation(program_, "words"), 0);
  glViewport(from_px.x, from_px.y, static_cast<int>(std::lround(size_px_.x * pxPerM.x / pxPerM.y)),
             size_px_.y);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace carom
