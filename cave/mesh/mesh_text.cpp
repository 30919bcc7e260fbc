#include "cave/mesh/mesh_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "engine/base/input_error.h"

namespace carom {
namespace {

/// A word of the file; empty beyond its end.
struct Word {
  std::string_view text;
  std::size_t at = 0;  ///< byte in the file
};

/// Returns the beginning of a word in printable form.
std::string shown(std::string_view text) {
  std::string printable(text.substr(0, 40));
  std::replace_if(
      printable.begin(), printable.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return printable;
}

/// Reads a file word by word or line by line.
class Words {
 public:
  Words(const std::string& path, std::string_view content) : path_(path), content_(content) {}

  /// Returns the next word, on any line.
  Word next() {
    while (at_ < content_.size() && isBlank(content_[at_])) ++at_;
    return take();
  }
  /// Returns the next word of this line, or an empty one at its end.
  Word nextInLine() {
    while (at_ < content_.size() && content_[at_] != '\n' && isBlank(content_[at_])) ++at_;
    return take();
  }
  void skipLine() {
    while (at_ < content_.size() && content_[at_] != '\n') ++at_;
    if (at_ < content_.size()) ++at_;
  }
  bool atEnd() const { return at_ >= content_.size(); }
  std::size_t at() const { return at_; }
  std::size_t left() const { return content_.size() - at_; }

  [[noreturn]] void fault(const Word& word, const std::string& message) const {
    const std::string_view before = content_.substr(0, std::min(word.at, content_.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    throw InputError(path_, static_cast<int>(lines) + 1, static_cast<int>(before.size() - lineStart) + 1,
                     message);
  }

  double number(const Word& word) const {
    double value = 0.0;
    if (!whole(word, value) || !std::isfinite(value)) fault(word, wrong(word, "a finite number"));
    return value;
  }
  long long integer(const Word& word, long long least, long long most, const char* what) const {
    long long value = 0;
    if (!whole(word, value) || value < least || value > most) {
      fault(word, wrong(word, fmt::format("{} from {} to {}", what, least, most)));
    }
    return value;
  }
  /// Returns a count of items that take at least one byte each.
  std::size_t count(const Word& word) const {
    return static_cast<std::size_t>(
        integer(word, 0, static_cast<long long>(content_.size()), "a count that this file has room for,"));
  }

 private:
  static bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
  }
  Word take() {
    const std::size_t from = at_;
    while (at_ < content_.size() && !isBlank(content_[at_])) ++at_;
    return {content_.substr(from, at_ - from), from};
  }
  template <typename Number>
  static bool whole(const Word& word, Number& value) {
    std::string_view text = word.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && stop == text.data() + text.size();
  }
  static std::string wrong(const Word& word, const std::string& expected) {
    if (word.text.empty()) return "something is missing here, expected " + expected;
    return fmt::format("'{}' is wrong, expected {}", shown(word.text), expected);
  }

  std::string path_;
  std::string_view content_;
  std::size_t at_ = 0;
};

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

template <typename Number>
Number numberAt(std::string_view content, std::size_t at, bool bigEndian = false) {
  std::array<char, sizeof(Number)> bytes{};
  std::memcpy(bytes.data(), content.data() + at, sizeof(Number));
  if (bigEndian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

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

/// Checks Stanford PLY: a header that says which elements follow and how many, then their rows, as text or
/// binary.
class PlyCheck {
 public:
  PlyCheck(const std::string& path, std::string_view content) : words_(path, content), content_(content) {}

  void run() {
    header();
    words_.skipLine();
    at_ = words_.at();
    for (const Element& element : elements_) {
      for (std::size_t row = 0; row < element.rows; ++row) {
        for (const Property& property : element.properties) value(element, property);
      }
    }
  }

 private:
  struct Type {
    std::string_view names;
    std::size_t bytes;
    bool isFloating, isUnsigned;
  };
  struct Property {
    const Type* type = nullptr;
    const Type* countType = nullptr;  // none for a single value
    std::string_view name;
  };
  struct Element {
    std::string_view name;
    std::size_t rows = 0;
    std::vector<Property> properties;
  };

  const Type* type(const Word& word) const {
    static constexpr std::array<Type, 8> kTypes{{{" char int8 ", 1, false, false},
                                                 {" uchar uint8 ", 1, false, true},
                                                 {" short int16 ", 2, false, false},
                                                 {" ushort uint16 ", 2, false, true},
                                                 {" int int32 ", 4, false, false},
                                                 {" uint uint32 ", 4, false, true},
                                                 {" float float32 ", 4, true, false},
                                                 {" double float64 ", 8, true, false}}};
    const std::string name = fmt::format(" {} ", word.text);
    const auto found = std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& type) {
      return !word.text.empty() && type.names.find(name) != std::string_view::npos;
    });
    if (found == kTypes.end())
      words_.fault(word,
                   fmt::format("'{}' is no type, expected one such as float or uchar", shown(word.text)));
    return found;
  }

  void header() {
    if (const Word ply = words_.next(); ply.text != "ply")
      words_.fault(ply, "this is no PLY file, expected ply");
    for (words_.skipLine();; words_.skipLine()) {
      const Word keyword = words_.nextInLine();
      if (keyword.text == "end_header") break;
      if (keyword.text.empty() && words_.atEnd())
        words_.fault(keyword, "the header does not end, expected end_header");
      if (keyword.text == "format") format();
      if (keyword.text == "element") {
        const Word name = words_.nextInLine();
        elements_.push_back({name.text, words_.count(words_.nextInLine()), {}});
      }
      if (keyword.text == "property") property(keyword);
    }
    for (const Element& element : elements_) {
      if (element.rows > 0 && element.properties.empty())
        words_.fault({},
                     fmt::format("element {} has no property, expected one at least", shown(element.name)));
      if (element.name == "vertex") points_ = element.rows;
    }
  }
  void format() {
    const Word name = words_.nextInLine();
    isText_ = name.text == "ascii";
    bigEndian_ = name.text == "binary_big_endian";
    if (!isText_ && !bigEndian_ && name.text != "binary_little_endian")
      words_.fault(name,
                   fmt::format("'{}' is wrong, expected ascii, binary_little_endian or binary_big_endian",
                               shown(name.text)));
  }
  void property(const Word& keyword) {
    if (elements_.empty()) words_.fault(keyword, "a property of nothing, expected an element before");
    Property property;
    Word first = words_.nextInLine();
    if (first.text == "list") {
      property.countType = type(words_.nextInLine());
      first = words_.nextInLine();
    }
    property.type = type(first);
    property.name = words_.nextInLine().text;
    elements_.back().properties.push_back(property);
  }

  void value(const Element& element, const Property& property) {
    if (!property.countType) {
      scalar(*property.type);
      return;
    }
    const bool corners = element.name == "face" && property.name.starts_with("vertex_ind");
    constexpr double kMostCorners = 255.0;
    const Word at = here();
    const double count = scalar(*property.countType);
    if (!(count >= (corners ? 3.0 : 0.0) && count <= kMostCorners))
      words_.fault(at, fmt::format("a list of {}, expected {} to {}", count, corners ? 3 : 0, kMostCorners));
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const Word where = here();
      const double index = scalar(*property.type);
      if (corners && !(index >= 0.0 && index < static_cast<double>(points_)))
        words_.fault(where, fmt::format("corner {} is none of the {} points, expected an index from 0", index,
                                        points_));
    }
  }

  /// Returns the place of the next value, or none in a binary row.
  Word here() const {
    if (!isText_) return {};
    Words ahead = words_;
    return ahead.next();
  }

  double scalar(const Type& type) {
    if (isText_) return words_.number(words_.next());
    const std::size_t at = at_;
    if (content_.size() - at_ < type.bytes)
      words_.fault({}, "this PLY ends before its last row, expected it whole");
    at_ += type.bytes;
    const auto as = [&]<typename Number>(Number) {
      return static_cast<double>(numberAt<Number>(content_, at, bigEndian_));
    };
    if (type.isFloating) return type.bytes == 4 ? as(float()) : as(double());
    if (type.bytes == 1) return type.isUnsigned ? as(std::uint8_t()) : as(std::int8_t());
    if (type.bytes == 2) return type.isUnsigned ? as(std::uint16_t()) : as(std::int16_t());
    return type.isUnsigned ? as(std::uint32_t()) : as(std::int32_t());
  }

  Words words_;
  std::string_view content_;
  std::vector<Element> elements_;
  std::size_t points_ = 0, at_ = 0;
  bool isText_ = true, bigEndian_ = false;
};

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
  if (ending == ".ply") PlyCheck(path, content).run();
  if (ending == ".vtk") checkVtk(path, content);
}

}  // namespace carom
