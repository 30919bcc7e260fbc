#include "cave/mesh_input/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include "cave/mesh_input/mesh_words.h"
#include "cave/mesh_input/polygons.h"

namespace carom {
namespace {

class PlyFile {
 public:
  PlyFile(const std::string& path, std::string_view content) : words_(path, content), content_(content) {}

  vtkSmartPointer<vtkPolyData> read() {
    header();
    words_.skipLine();
    at_ = words_.at();
    for (const Element& element : elements_) {
      for (std::size_t row = 0; row < element.rows; ++row) {
        for (const Property& property : element.properties) value(property);
      }
    }
    return surface();
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
    bool isCorners = false;
    std::vector<float>* places = nullptr;  // of x, y or z of a point
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
    const Word name = words_.nextInLine();
    const std::string_view element = elements_.back().name;
    property.isCorners = property.countType && element == "face" && name.text.starts_with("vertex_ind");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (property.countType || element != "vertex" || name.text != std::string_view("xyz").substr(axis, 1))
        continue;
      property.places = &places_m_[axis];
    }
    elements_.back().properties.push_back(property);
  }

  void value(const Property& property) {
    if (!property.countType) {
      const double number = scalar(*property.type);
      if (property.places) property.places->push_back(static_cast<float>(number));
      return;
    }
    constexpr double kMostCorners = 255.0;
    const Word at = here();
    const double count = scalar(*property.countType);
    if (!(count >= (property.isCorners ? 3.0 : 0.0) && count <= kMostCorners))
      words_.fault(at, fmt::format("a list of {}, expected {} to {}", count, property.isCorners ? 3 : 0,
                                   kMostCorners));
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const Word where = here();
      const double index = scalar(*property.type);
      if (!property.isCorners) continue;
      if (!(index >= 0.0 && index < static_cast<double>(points_)))
        words_.fault(where, fmt::format("corner {} is none of the {} points, expected an index from 0", index,
                                        points_));
      corners_.push_back(static_cast<vtkIdType>(index));
    }
    if (property.isCorners) ends_.push_back(static_cast<vtkIdType>(corners_.size()));
  }

  vtkSmartPointer<vtkPolyData> surface() const {
    if (places_m_[0].size() != points_ || places_m_[1].size() != points_ || places_m_[2].size() != points_)
      words_.fault({}, "its points have no x, y and z, expected all three once");
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(static_cast<vtkIdType>(points_));
    auto* place_m = static_cast<float*>(points->GetVoidPointer(0));
    const auto& [x_m, y_m, z_m] = places_m_;
    for (std::size_t i = 0; i < points_; ++i) {
      constexpr float kFarthest_m = 1e9F;
      for (const float coordinate_m : {x_m[i], y_m[i], z_m[i]}) {
        if (!(std::abs(coordinate_m) <= kFarthest_m))
          words_.fault({}, fmt::format("point {} is at ({}, {}, {}), expected numbers up to 1e9", i, x_m[i],
                                       y_m[i], z_m[i]));
        *place_m++ = coordinate_m;
      }
    }
    vtkNew<vtkIdTypeArray> ends, corners;
    std::copy(ends_.begin(), ends_.end(), ends->WritePointer(0, static_cast<vtkIdType>(ends_.size())));
    std::copy(corners_.begin(), corners_.end(),
              corners->WritePointer(0, static_cast<vtkIdType>(corners_.size())));
    return surfaceOf(points, ends, corners);
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
  std::array<std::vector<float>, 3> places_m_;  // x, y, z of each point
  std::vector<vtkIdType> corners_, ends_{0};    // of each face one after the other, and where each ends
};

}  // namespace

vtkSmartPointer<vtkPolyData> readPly(const std::string& path, std::string_view content) {
  return PlyFile(path, content).read();
}

}  // namespace carom
