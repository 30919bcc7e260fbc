#include "cave/mesh_files/obj_file.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"

namespace carom {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view content, const ObjWishes& wishes) : lines_(content), wishes_(wishes) {}

  ObjFile read() {
    while (lines_.next()) {
      const std::string_view keyword = lines_.word();
      if (keyword == "v") {
        point();
      } else if (keyword == "vt") {
        const double s = lines_.number(wishes_.farthestInPicture);
        file_.inPicture.emplace_back(s, lines_.number(wishes_.farthestInPicture));
        refuseMany(file_.inPicture.size(), "vt");
      } else if (keyword == "f") {
        face();
      } else if (!keyword.empty() && !keyword.starts_with('#') && !isPassedOver(keyword)) {
        lines_.wrong(keyword, "v, vt, f or another word of OBJ");
      }
    }
    check();
    return std::move(file_);
  }

 private:
  static bool isPassedOver(std::string_view keyword) {
    constexpr std::array<std::string_view, 10> kOthers{"vn",     "vp", "l", "p", "mtllib",
                                                       "usemtl", "o",  "g", "s", "cstype"};
    return std::find(kOthers.begin(), kOthers.end(), keyword) != kOthers.end();
  }
  void refuseMany(std::size_t count, std::string_view what) const {
    if (count > wishes_.mostPoints)
      meshFault(lines_.lineNumber(), 1,
                fmt::format("there are more than {} {}, expected a coarser mesh", wishes_.mostPoints, what));
  }
  void point() {
    glm::dvec3 at(0.0);
    for (int i = 0; i < wishes_.coordinates; ++i) at[i] = lines_.number(wishes_.farthest);
    file_.points.push_back(at);
    refuseMany(file_.points.size(), "v");
  }
  /// Returns the indices of a corner. Whether it is among the points is checked at the end of the file.
  ObjCorner corner(std::string_view text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::string_view point = text.substr(0, slash);
    const std::string_view rest = text.substr(std::min(slash + 1, text.size()));
    std::string_view inPicture = rest.substr(0, rest.find('/'));
    const auto indexOf = [&](std::string_view index) {
      const auto number = countIn(index);
      if (!number || *number == 0 || *number > wishes_.mostPoints)
        lines_.wrong(text, "a corner, counted from 1");
      return *number;
    };
    const std::size_t pointIndex = indexOf(point);
    if (inPicture.empty() && !wishes_.isPaired)
      lines_.wrong(text, "both v and vt, as in 1/1: where the corner is, and where in the window");
    if (inPicture.empty()) inPicture = point;
    if (wishes_.isPaired && inPicture != point)
      lines_.wrong(text, "the same number for v and vt: they go together");
    const std::size_t pictureIndex = indexOf(inPicture);
    note(largest_, pointIndex);
    note(largestInPicture_, pictureIndex);
    return {static_cast<std::uint32_t>(pointIndex - 1), static_cast<std::uint32_t>(pictureIndex - 1)};
  }
  /// The largest index so far, and its line.
  struct Largest {
    std::size_t index = 0, line = 1;
  };
  void note(Largest& largest, std::size_t index) const {
    if (index > largest.index) largest = {index, lines_.lineNumber()};
  }
  void face() {
    const ObjCorner first = corner(lines_.word());
    ObjCorner last = corner(lines_.word());
    std::string_view text = lines_.word();
    do {
      const ObjCorner next = corner(text);
      file_.triangles.push_back({first, last, next});
      if (file_.triangles.size() / 2 > wishes_.mostPoints) refuseMany(wishes_.mostPoints + 1, "pairs of f");
      last = next;
      text = lines_.word();
    } while (!text.empty());
  }
  void check() const {
    if (wishes_.isPaired && file_.points.size() != file_.inPicture.size()) {
      meshFault(1, 1,
                fmt::format("there are {} v and {} vt, expected one vt for each v", file_.points.size(),
                            file_.inPicture.size()));
    }
    if (file_.triangles.empty()) meshFault(1, 1, "there is no f, expected a triangle at least");
    for (const auto& [largest, count] :
         {std::pair(largest_, file_.points.size()), std::pair(largestInPicture_, file_.inPicture.size())}) {
      if (largest.index > count)
        meshFault(
            largest.line, 1,
            fmt::format("corner {} is none of the {} points, expected one of them", largest.index, count));
    }
  }

  MeshLines lines_;
  const ObjWishes& wishes_;
  ObjFile file_;
  Largest largest_, largestInPicture_;
};

}  // namespace

ObjFile parseObj(std::string_view content, const ObjWishes& wishes) {
  return ObjReader(content, wishes).read();
}

}  // namespace carom
