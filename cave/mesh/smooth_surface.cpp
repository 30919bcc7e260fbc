#include "cave/mesh/smooth_surface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "cave/mesh_input/polygons.h"

namespace carom {
namespace {

using Face = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::vector<glm::vec3> placesOf(vtkPolyData& mesh) {
  std::vector<glm::vec3> places(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::array<double, 3> place{};
    mesh.GetPoint(static_cast<vtkIdType>(i), place.data());
    places[i] = {place[0], place[1], place[2]};
  }
  return places;
}

std::vector<Face> facesOf(vtkPolyData& mesh) {
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(mesh.GetNumberOfPolys()));
  forEachPolygon(*mesh.GetPolys(), [&](std::span<const vtkIdType> corners) {
    if (corners.size() != 3) return;
    faces.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                     static_cast<std::uint32_t>(corners[2])});
  });
  return faces;
}

vtkSmartPointer<vtkFloatArray> arrayOf(const std::vector<glm::vec3>& tuples) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  float* number = array->WritePointer(0, static_cast<vtkIdType>(3 * tuples.size()));
  for (const glm::vec3& tuple : tuples)
    for (int k = 0; k < 3; ++k) *number++ = tuple[k];
  return array;
}

vtkSmartPointer<vtkPolyData> meshOf(const std::vector<glm::vec3>& places, const std::vector<Face>& faces) {
  vtkNew<vtkPoints> points;
  points->SetData(arrayOf(places));
  vtkNew<vtkIdTypeArray> ends, corners;
  vtkIdType* end = ends->WritePointer(0, static_cast<vtkIdType>(faces.size() + 1));
  for (std::size_t i = 0; i <= faces.size(); ++i) *end++ = static_cast<vtkIdType>(3 * i);
  vtkIdType* corner = corners->WritePointer(0, static_cast<vtkIdType>(3 * faces.size()));
  for (const Face& face : faces)
    for (const std::uint32_t point : face) *corner++ = point;
  return surfaceOf(points, ends, corners);
}

/// Returns a number that is mostly different for different places, by two rounds of a multiplication and a
/// shift.
std::size_t hashOf(const glm::vec3& place) {
  constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;  // 2⁶⁴ over the golden ratio
  std::uint64_t hash =
      std::uint64_t{std::bit_cast<std::uint32_t>(place.x)} << 32U | std::bit_cast<std::uint32_t>(place.y);
  hash = (hash ^ hash >> 29U) * kOdd;
  hash = (hash ^ hash >> 32U ^ std::bit_cast<std::uint32_t>(place.z)) * kOdd;
  return hash ^ hash >> 32U;
}

/// Triangles, the triangles at each point and across each edge, and their turning.
class Surface {
 public:
  Surface(std::vector<glm::vec3> places, std::vector<Face> faces)
      : places_(std::move(places)), faces_(std::move(faces)) {
    listFacesOfPoints();
    findNeighbours();
  }

  void turnAlike() {
    std::vector<std::uint8_t> isReached(faces_.size());
    std::vector<std::uint32_t> toDo;
    for (std::uint32_t first = 0; first < faces_.size(); ++first) {
      if (isReached[first]) continue;
      isReached[first] = 1;
      toDo.push_back(first);
      while (!toDo.empty()) {
        const std::uint32_t face = toDo.back();
        toDo.pop_back();
        for (std::size_t side = 0; side < 3; ++side) {
          const std::uint32_t other = neighbours_[face][side];
          if (other == kNone || isReached[other]) continue;
          isReached[other] = 1;
          if (followsTheSameWay(other, faces_[face][side], faces_[face][(side + 1) % 3])) turn(other);
          toDo.push_back(other);
        }
      }
    }
  }

  /// Returns the surface with normals, as withNormals. The points that are split off come last.
  vtkSmartPointer<vtkPolyData> lit() {
    takeFaceNormals();
    std::vector<Face> corners(faces_.size(), Face{kNone, kNone, kNone});
    std::vector<glm::vec3> normals(places_.size(), glm::vec3(0.0F));
    const std::size_t points = places_.size();
    for (std::uint32_t point = 0; point < points; ++point) {
      std::uint32_t number = point;
      for (std::uint32_t k = firstFace_[point]; k < firstFace_[point + 1]; ++k) {
        if (corners[facesOfPoints_[k]][sideFrom(facesOfPoints_[k], point)] != kNone) continue;
        if (number == kNone) {
          number = static_cast<std::uint32_t>(places_.size());
          places_.push_back(places_[point]);
          normals.emplace_back(0.0F);
        }
        normals[number] = takeFan(facesOfPoints_[k], point, number, corners);
        number = kNone;
      }
    }
    for (glm::vec3& normal : normals)
      if (const float length = glm::length(normal); length > 0.0F) normal /= length;
    const auto mesh = meshOf(places_, corners);
    const auto array = arrayOf(normals);
    array->SetName("Normals");
    mesh->GetPointData()->SetNormals(array);
    return mesh;
  }

 private:
  void listFacesOfPoints() {
    firstFace_.assign(places_.size() + 1, 0);
    for (const Face& face : faces_)
      for (const std::uint32_t point : face) ++firstFace_[point + 1];
    for (std::size_t i = 1; i < firstFace_.size(); ++i) firstFace_[i] += firstFace_[i - 1];
    facesOfPoints_.resize(3 * faces_.size());
    std::vector<std::uint32_t> next(firstFace_.begin(), firstFace_.end() - 1);
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      for (const std::uint32_t point : faces_[face]) facesOfPoints_[next[point]++] = face;
  }

  /// Finds what lies across each edge that just two faces have. Each edge is looked at from its lower point.
  void findNeighbours() {
    struct Side {
      std::uint32_t to, face, side;
    };
    neighbours_.assign(faces_.size(), Face{kNone, kNone, kNone});
    std::vector<Side> sides;
    for (std::uint32_t point = 0; point < places_.size(); ++point) {
      sides.clear();
      for (std::uint32_t k = firstFace_[point]; k < firstFace_[point + 1]; ++k) {
        const std::uint32_t face = facesOfPoints_[k], side = sideFrom(face, point), before = (side + 2) % 3;
        if (const std::uint32_t to = faces_[face][(side + 1) % 3]; to > point)
          sides.push_back({to, face, side});
        if (const std::uint32_t to = faces_[face][before]; to > point) sides.push_back({to, face, before});
      }
      std::sort(sides.begin(), sides.end(),
                [](const Side& a, const Side& b) { return a.to != b.to ? a.to < b.to : a.face < b.face; });
      for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
        while (next < sides.size() && sides[next].to == sides[i].to) ++next;
        if (next - i != 2) continue;
        neighbours_[sides[i].face][sides[i].side] = sides[i + 1].face;
        neighbours_[sides[i + 1].face][sides[i + 1].side] = sides[i].face;
      }
    }
  }

  /// Returns which side of the face begins in the point.
  std::uint32_t sideFrom(std::uint32_t face, std::uint32_t point) const {
    return faces_[face][0] == point ? 0 : faces_[face][1] == point ? 1 : 2;
  }

  bool followsTheSameWay(std::uint32_t face, std::uint32_t from, std::uint32_t to) const {
    return faces_[face][(sideFrom(face, from) + 1) % 3] == to;
  }

  void turn(std::uint32_t face) {
    std::swap(faces_[face][1], faces_[face][2]);
    std::swap(neighbours_[face][0], neighbours_[face][2]);
  }

  void takeFaceNormals() {
    normals_.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto& [a, b, c] = faces_[i];
      const glm::dvec3 across = glm::cross(glm::dvec3(places_[b]) - glm::dvec3(places_[a]),
                                           glm::dvec3(places_[c]) - glm::dvec3(places_[a]));
      const double length = glm::length(across);
      normals_[i] = length > 0.0 ? glm::vec3(across / length) : glm::vec3(0.0F);
    }
  }

  /// Gives the number to the point in all faces that hang together there, beginning with one, without an edge
  /// between them at which they turn by more than 40°. Returns the sum of their normals.
  glm::vec3 takeFan(std::uint32_t first, std::uint32_t point, std::uint32_t number,
                    std::vector<Face>& corners) {
    static const auto kLeastCosine = static_cast<float>(std::cos(40.0 / 180.0 * std::numbers::pi));
    glm::vec3 sum(0.0F);
    fan_.assign(1, first);
    corners[first][sideFrom(first, point)] = number;
    while (!fan_.empty()) {
      const std::uint32_t face = fan_.back(), side = sideFrom(face, point);
      fan_.pop_back();
      sum += normals_[face];
      for (const std::uint32_t edge : {side, (side + 2) % 3}) {
        const std::uint32_t other = neighbours_[face][edge];
        if (other == kNone || glm::dot(normals_[face], normals_[other]) <= kLeastCosine) continue;
        std::uint32_t& corner = corners[other][sideFrom(other, point)];
        if (corner != kNone) continue;
        corner = number;
        fan_.push_back(other);
      }
    }
    return sum;
  }

  std::vector<glm::vec3> places_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> firstFace_, facesOfPoints_;  // of each point, one point's after the other
  std::vector<Face> neighbours_;                          // across the side that begins in each corner
  std::vector<glm::vec3> normals_;                        // of the faces
  std::vector<std::uint32_t> fan_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> withPointsMerged(vtkPolyData& mesh) {
  const std::vector<glm::vec3> places = placesOf(mesh);
  const std::size_t slots = std::bit_ceil(2 * places.size() + 1);
  std::vector<std::uint32_t> numberIn(slots, kNone), numbers(places.size());
  std::vector<glm::vec3> merged;
  merged.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::vec3 place = places[i] + 0.0F;  // makes −0 the same as 0
    std::size_t slot = hashOf(place) & (slots - 1);
    while (numberIn[slot] != kNone && merged[numberIn[slot]] != place) slot = (slot + 1) & (slots - 1);
    if (numberIn[slot] == kNone) {
      numberIn[slot] = static_cast<std::uint32_t>(merged.size());
      merged.push_back(place);
    }
    numbers[i] = numberIn[slot];
  }
  std::vector<Face> faces = facesOf(mesh);
  for (Face& face : faces)
    for (std::uint32_t& corner : face) corner = numbers[corner];
  std::erase_if(
      faces, [](const Face& face) { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; });
  return meshOf(merged, faces);
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData& triangles) {
  Surface surface(placesOf(triangles), facesOf(triangles));
  surface.turnAlike();
  return surface.lit();
}

}  // namespace carom
