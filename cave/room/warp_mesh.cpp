#include "cave/room/warp_mesh.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "engine/base/outside_file.h"

namespace carom {
namespace {

constexpr float kFarthest =
    16.0F;  // in window or picture widths: anything beyond is in another unit, or not a number

[[noreturn]] void fault(std::size_t line, std::size_t column, const std::string& message) {
  throw std::runtime_error(fmt::format("{}:{}: {}", line, column, message));
}

/// Returns the beginning of a text in printable form.
std::string shown(std::string_view text) {
  std::string printable(text.substr(0, 40));
  std::replace_if(
      printable.begin(), printable.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return printable;
}

template <typename Number>
std::optional<Number> whole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || stop != text.data() + text.size()) return {};
  return value;
}

bool isNear(float value) { return std::abs(value) <= kFarthest; }  // false for NaN

/// Reads the words of a text file, line by line.
class Lines {
 public:
  explicit Lines(std::string_view content) : left_(content) {}

  bool next() {
    if (left_.empty()) return false;
    const std::size_t end = std::min(left_.find('\n'), left_.size());
    line_ = left_.substr(0, end);
    left_.remove_prefix(std::min(end + 1, left_.size()));
    ++number_;
    at_ = 0;
    return true;
  }
  /// Returns the line's next word, or an empty one at its end.
  std::string_view word() {
    constexpr std::string_view kBlanks = " \t\r\f\v";
    wordAt_ = std::min(line_.find_first_not_of(kBlanks, at_), line_.size());
    at_ = std::min(line_.find_first_of(kBlanks, wordAt_), line_.size());
    return line_.substr(wordAt_, at_ - wordAt_);
  }
  float number() {
    const std::string_view text = word();
    const auto value = whole<float>(text);
    if (!value || !isNear(*value)) wrong(text, fmt::format("a number from {} to {}", -kFarthest, kFarthest));
    return *value;
  }
  /// Throws a fault at the last word.
  [[noreturn]] void wrong(std::string_view text, const std::string& expected) const {
    fault(number_, wordAt_ + 1,
          text.empty() ? "something is missing here, expected " + expected
                       : fmt::format("'{}' is wrong, expected {}", shown(text), expected));
  }
  std::size_t lineNumber() const { return number_; }
  /// Returns the text after the lines read so far.
  std::string_view rest() const { return left_; }

 private:
  std::string_view left_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::size_t at_ = 0;
  std::size_t wordAt_ = 0;
};

class ObjReader {
 public:
  explicit ObjReader(std::string_view content) : lines_(content) {}

  WarpMesh read() {
    while (lines_.next()) {
      const std::string_view keyword = lines_.word();
      if (keyword == "v") {
        window_.push_back((pair() + 1.0F) * 0.5F);  // z is not used: the window is flat
      } else if (keyword == "vt") {
        picture_.push_back(pair());
      } else if (keyword == "f") {
        face();
      } else if (!keyword.empty() && !keyword.starts_with('#') && !isPassedOver(keyword)) {
        lines_.wrong(keyword, "v, vt, f or another word of OBJ");
      }
    }
    return mesh();
  }

 private:
  static bool isPassedOver(std::string_view keyword) {
    constexpr std::array<std::string_view, 10> kOthers{"vn",     "vp", "l", "p", "mtllib",
                                                       "usemtl", "o",  "g", "s", "cstype"};
    return std::find(kOthers.begin(), kOthers.end(), keyword) != kOthers.end();
  }
  glm::vec2 pair() {
    const float x = lines_.number();
    return {x, lines_.number()};
  }
  /// Returns the index of a corner, whose number counts from 1. Whether it is among the points is checked at
  /// the end of the file.
  std::uint32_t corner(std::string_view text) {
    const auto kMost = static_cast<std::uint32_t>(limitOf(InputKind::warp).most_MiB
                                                  << 20U);  // a point takes more than one byte
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::string_view vertex = text.substr(0, slash);
    const std::string_view rest = text.substr(std::min(slash + 1, text.size()));
    const std::string_view texture = rest.substr(0, rest.find('/'));
    const auto index = whole<std::uint32_t>(vertex);
    if (!index || *index == 0 || *index > kMost) lines_.wrong(text, "a corner, counted from 1");
    if (!texture.empty() && texture != vertex) {
      lines_.wrong(text, "the same number for v and vt: they go together");
    }
    if (*index > largest_) {
      largest_ = *index;
      largestLine_ = lines_.lineNumber();
    }
    return *index - 1;
  }
  void face() {
    const std::uint32_t first = corner(lines_.word());
    std::uint32_t last = corner(lines_.word());
    std::string_view text = lines_.word();
    do {
      const std::uint32_t next = corner(text);
      triangles_.push_back({first, last, next});
      last = next;
      text = lines_.word();
    } while (!text.empty());
  }
  WarpMesh mesh() {
    if (window_.size() != picture_.size()) {
      fault(1, 1,
            fmt::format("there are {} v and {} vt, expected one vt for each v", window_.size(),
                        picture_.size()));
    }
    if (largest_ > window_.size()) {
      fault(
          largestLine_, 1,
          fmt::format("corner {} is none of the {} points, expected one of them", largest_, window_.size()));
    }
    if (triangles_.empty()) fault(1, 1, "there is no f, expected a triangle at least");
    WarpMesh mesh;
    for (std::size_t i = 0; i < window_.size(); ++i)
      mesh.points.push_back({.inWindow = window_[i], .inPicture = picture_[i]});
    mesh.triangles = std::move(triangles_);
    return mesh;
  }

  Lines lines_;
  std::vector<glm::vec2> window_, picture_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::uint32_t largest_ = 0;
  std::size_t largestLine_ = 1;
};

/// The grid of floats in a PFM.
struct FloatGrid {
  std::size_t columns = 0, rows = 0;
  bool bigEndian = false;
  std::string_view bytes;
  std::size_t at = 0;  ///< of `bytes` in the file

  float value(std::size_t column, std::size_t row, std::size_t part) const {
    const std::size_t from = 4 * (3 * (row * columns + column) + part);
    std::array<char, 4> raw{};
    std::memcpy(raw.data(), bytes.data() + from, raw.size());
    if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    const auto value = std::bit_cast<float>(raw);
    if (isNear(value)) return value;
    fault(1, 1,
          fmt::format(
              "point ({}, {}) has {} for its {} in the window, at byte {}, expected a number from {} to {}",
              column, row, value, part == 0 ? "x" : "y", at + from, -kFarthest, kFarthest));
  }
};

/// Reads "PF", columns and rows, and the scale, on one line each, then the grid, which must end the file.
FloatGrid gridOf(std::string_view content) {
  const std::size_t kMost = (limitOf(InputKind::warp).most_MiB << 20U) / 12;
  Lines lines(content);
  const auto line = [&] {
    if (!lines.next()) fault(lines.lineNumber() + 1, 1, "the header ends early, expected three lines");
  };
  const auto endLine = [&] {
    if (const std::string_view more = lines.word(); !more.empty()) lines.wrong(more, "the line's end");
  };
  FloatGrid grid;
  line();
  if (const std::string_view magic = lines.word(); magic != "PF") {
    lines.wrong(magic, magic == "Pf" ? "PF, three floats a point" : "a PFM, which begins with PF");
  }
  endLine();
  line();
  for (std::size_t* count : {&grid.columns, &grid.rows}) {
    const std::string_view text = lines.word();
    const auto value = whole<std::size_t>(text);
    const bool isColumns = count == &grid.columns;
    const std::size_t least = isColumns ? 4 : 2;  // two in each direction for each of the two eyes
    if (!value || *value < least || *value > kMost || (isColumns && *value % 2 != 0)) {
      lines.wrong(text, isColumns ? "an even number of columns from 4, half of them for each eye"
                                  : "a number of rows from 2");
    }
    *count = *value;
  }
  endLine();
  line();
  const std::string_view text = lines.word();
  const auto scale = whole<double>(text);
  if (!scale || !std::isfinite(*scale) || *scale == 0.0) {
    lines.wrong(text, "a scale: negative where the lowest byte comes first");
  }
  endLine();
  grid.bigEndian = *scale > 0.0;
  grid.bytes = lines.rest();
  grid.at = content.size() - grid.bytes.size();
  // The product cannot overflow: each factor is at most kMost, under 2^24.
  if (const std::size_t needed = 12 * grid.columns * grid.rows; grid.bytes.size() != needed) {
    fault(1, 1,
          fmt::format("{} × {} points take {} bytes behind the header, but there are {}, expected it whole",
                      grid.columns, grid.rows, needed, grid.bytes.size()));
  }
  return grid;
}

/// Returns one eye's part of the grid as a mesh, with two triangles per cell.
WarpMesh meshOf(const FloatGrid& grid, std::size_t firstColumn) {
  const std::size_t columns = grid.columns / 2, rows = grid.rows;
  WarpMesh mesh;
  mesh.points.reserve(columns * rows);
  mesh.triangles.reserve(2 * (columns - 1) * (rows - 1));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const glm::vec2 inPicture((static_cast<float>(column) + 0.5F) / static_cast<float>(columns),
                                1.0F - (static_cast<float>(row) + 0.5F) / static_cast<float>(rows));
      const std::size_t at = firstColumn + column;
      mesh.points.push_back(
          {.inWindow = {grid.value(at, row, 0), grid.value(at, row, 1)}, .inPicture = inPicture});
    }
  }
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const auto upper = static_cast<std::uint32_t>(row * columns + column);
      const auto lower = static_cast<std::uint32_t>(upper + columns);
      mesh.triangles.push_back({upper, lower, upper + 1});
      mesh.triangles.push_back({upper + 1, lower, lower + 1});
    }
  }
  return mesh;
}

}  // namespace

Warp straightWarp() {
  WarpMesh mesh;
  for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
    mesh.points.push_back({.inWindow = corner, .inPicture = corner});
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  return {mesh, mesh};
}

Warp skewWarp(const SkewedScreen& screen) {
  const glm::dmat3 pictureOf = pictureFromWindow(screen);
  Warp warp = straightWarp();
  for (WarpMesh* mesh : {&warp.left, &warp.right}) {
    for (WarpPoint& point : mesh->points) {
      const glm::dvec3 place = pictureOf * glm::dvec3(glm::dvec2(point.inWindow), 1.0);
      point.inPicture = glm::vec2(glm::dvec2(place) / place.z);
      point.weight = static_cast<float>(place.z);
    }
  }
  return warp;
}

Warp parseObjWarp(std::string_view content) {
  const WarpMesh mesh = ObjReader(content).read();
  return {mesh, mesh};
}

Warp parsePfmWarp(std::string_view content) {
  const FloatGrid grid = gridOf(content);
  return {meshOf(grid, 0), meshOf(grid, grid.columns / 2)};
}

Warp readWarp(const std::filesystem::path& file) {
  const std::string name = file.string();
  try {
    if (const std::string refusal = refusalOf(file, InputKind::warp); !refusal.empty()) fault(1, 1, refusal);
    const std::string content = contentOf(file, InputKind::warp);
    if (file.extension() == ".obj") return parseObjWarp(content);
    if (file.extension() == ".pfm") return parsePfmWarp(content);
    fault(1, 1, "is of a kind that cannot be read, expected a file ending in .pfm or .obj");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + ":" + error.what());
  }
}

}  // namespace carom
