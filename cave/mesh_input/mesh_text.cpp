#include "cave/mesh_input/mesh_text.h"

#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "cave/mesh_input/mesh_words.h"

namespace carom {
namespace {

/// Checks Wavefront OBJ: v x y z …, vt, vn, and f with corners v, v/vt, v//vn or v/vt/vn, which count from 1
/// or, if negative, back from the latest.
class ObjCheck {
 public:
  ObjCheck(const std::string& path, std::string_view content) : words_(path, content) {}

  void run() {
    for (; !words_.atEnd(); words_.skipLine()) {
      const Word keyword = words_.nextInLine();
      if (keyword.text == "v") coordinates(0, 3);
      if (keyword.text == "vt") coordinates(1, 1);
      if (keyword.text == "vn") coordinates(2, 3);
      if (keyword.text == "f") corners(3);
      if (keyword.text == "l") corners(2);
      if (keyword.text == "p") corners(1);
    }
    for (int kind = 0; kind < 3; ++kind) {
      if (largest_[kind] > counts_[kind]) {
        words_.fault(largestAt_[kind],
                     fmt::format("'{}' names one of {} that there are, expected an index that exists",
                                 shown(largestAt_[kind].text), counts_[kind]));
      }
    }
  }

 private:
  void coordinates(int kind, int least) {
    ++counts_[kind];
    for (int i = 0;; ++i) {
      const Word word = words_.nextInLine();
      if (word.text.empty() && i >= least) return;
      words_.number(word);
    }
  }
  void corners(int least) {
    for (int i = 0;; ++i) {
      const Word corner = words_.nextInLine();
      if (corner.text.empty() && i >= least) return;
      corner_(corner);
    }
  }
  void corner_(const Word& corner) {
    std::size_t from = 0;
    for (int kind = 0; kind < 3 && from <= corner.text.size(); ++kind) {
      const std::size_t slash = std::min(corner.text.find('/', from), corner.text.size());
      const Word part{corner.text.substr(from, slash - from), corner.at + from};
      from = slash + 1;
      if (kind > 0 && part.text.empty()) continue;
      index(part, kind);
    }
    if (from <= corner.text.size())
      words_.fault(corner, fmt::format("'{}' is no corner, expected v, v/vt or v/vt/vn", shown(corner.text)));
  }
  void index(const Word& part, int kind) {
    constexpr long long kMost = 1LL << 31;
    const long long index = words_.integer(part, -counts_[kind], kMost, "an index");
    if (index == 0) words_.fault(part, "index 0 is wrong, expected one from 1");
    if (index > largest_[kind]) {
      largest_[kind] = index;
      largestAt_[kind] = part;
    }
  }

  Words words_;
  long long counts_[3] = {0, 0, 0};  // of v, vt, vn
  long long largest_[3] = {0, 0, 0};
  Word largestAt_[3];
};

/// Checks STL. Binary: 80 bytes, a count, 50 bytes per triangle. Text: facets of three vertices.
void checkStl(const std::string& path, std::string_view content) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  const std::size_t triangles = content.size() >= kHeader ? numberAt<std::uint32_t>(content, 80) : 0;
  if (content.size() >= kHeader && content.size() == kHeader + kTriangle * triangles) return;
  Words words(path, content);
  const bool isText =
      content.starts_with("solid") && content.substr(0, 1024).find("facet") != std::string_view::npos;
  if (!isText) {
    words.fault(
        {},
        fmt::format("this STL says it has {} triangles, {} bytes, and is {} bytes long, expected it whole",
                    triangles, kHeader + kTriangle * triangles, content.size()));
  }
  words.skipLine();  // "solid" and a name
  int vertices = 0;
  Word word = words.next();
  for (; !word.text.empty() && word.text != "endsolid"; word = words.next()) {
    if (word.text == "normal") {
      for (int i = 0; i < 3; ++i) words.next();  // an unused normal: some files have no numbers here
    } else if (word.text == "vertex") {
      for (int i = 0; i < 3; ++i) words.number(words.next());
      ++vertices;
    } else if (word.text == "endfacet") {
      if (vertices != 3) words.fault(word, fmt::format("this facet has {} vertices, expected 3", vertices));
      vertices = 0;
    } else if (word.text != "facet" && word.text != "outer" && word.text != "loop" &&
               word.text != "endloop") {
      words.fault(word, fmt::format("'{}' is wrong, expected facet, outer loop, vertex, endloop or endfacet",
                                    shown(word.text)));
    }
  }
  if (word.text.empty()) words.fault(word, "this STL ends before its endsolid, expected it whole");
}

/// Checks VTK legacy files: the counts and, in text files, the points and polygons.
void checkVtk(const std::string& path, std::string_view content) {
  Words words(path, content);
  if (!content.starts_with("# vtk DataFile"))
    words.fault({}, "this is no VTK file, expected # vtk DataFile Version");
  words.skipLine();
  words.skipLine();  // title
  const Word coding = words.next();
  if (coding.text != "ASCII" && coding.text != "BINARY")
    words.fault(coding, fmt::format("'{}' is wrong, expected ASCII or BINARY", shown(coding.text)));
  const bool isText = coding.text == "ASCII";
  std::size_t points = 0;
  for (Word word = words.next(); !word.text.empty(); word = words.next()) {
    if (word.text == "POINTS") {
      points = words.count(words.next());
      words.next();  // type
      for (std::size_t i = 0; isText && i < 3 * points; ++i) words.number(words.next());
    } else if (word.text == "POLYGONS" || word.text == "TRIANGLE_STRIPS" || word.text == "CELLS") {
      const std::size_t rows = words.count(words.next());
      const std::size_t numbers = words.count(words.next());
      Words ahead = words;
      if (!isText || ahead.next().text == "OFFSETS") continue;
      std::size_t read = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        const auto size =
            words.integer(words.next(), 1, static_cast<long long>(numbers), "a number of corners");
        for (long long i = 0; i < size; ++i)
          words.integer(words.next(), 0, static_cast<long long>(points) - 1, "the index of a point");
        read += static_cast<std::size_t>(size) + 1;
      }
      if (read != numbers)
        words.fault(word, fmt::format("{} rows hold {} numbers, expected {}", rows, read, numbers));
    } else if (word.text == "CONNECTIVITY" && isText) {
      words.next();  // type
      for (Words ahead = words;; words = ahead) {
        const Word corner = ahead.next();
        if (corner.text.empty() || std::isalpha(static_cast<unsigned char>(corner.text.front()))) break;
        words.integer(corner, 0, static_cast<long long>(points) - 1, "the index of a point");
      }
    } else if (word.text == "POINT_DATA" || word.text == "CELL_DATA") {
      return;  // not used
    }
  }
}

}  // namespace

void checkMeshText(const std::string& path, std::string_view ending, std::string_view content) {
  if (ending == ".obj") ObjCheck(path, content).run();
  if (ending == ".stl") checkStl(path, content);
  if (ending == ".vtk") checkVtk(path, content);
}

}  // namespace carom
