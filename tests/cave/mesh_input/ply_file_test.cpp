// Stanford PLY: points and faces in text and in both orders of bytes.
#include "cave/mesh_input/ply_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cave/mesh_input/polygons.h"
#include "engine/text/input_error.h"

namespace carom {
namespace {

/// The bytes of a number in one of the two orders.
template <typename Number>
std::string bytesOf(Number number, bool isBigEndian) {
  std::string raw(reinterpret_cast<const char*>(&number), sizeof number);
  if (isBigEndian) std::reverse(raw.begin(), raw.end());
  return raw;
}

std::string headerOf(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment element face 9\nelement vertex 4\nproperty uchar red\nproperty double z\n"
         "property short x\nproperty float32 y\nelement face 2\nproperty list uint8 uint vertex_index\n"
         "property list ushort int other\nend_header\n";
}

/// The faces of a mesh as lists of corners.
std::vector<std::vector<int>> facesOf(vtkPolyData& mesh) {
  std::vector<std::vector<int>> faces;
  forEachPolygon(*mesh.GetPolys(), [&](std::span<const vtkIdType> corners) {
    auto& face = faces.emplace_back();
    for (const vtkIdType corner : corners) face.push_back(static_cast<int>(corner));
  });
  return faces;
}

// Properties of all sizes in an order of their own; those that are no places or corners are passed over.
TEST(PlyFile, TextAndBothOrdersOfBytesGiveTheSameMesh) {
  struct Row {
    std::uint8_t red;
    double z;
    std::int16_t x;
    float y;
  };
  const std::array<Row, 4> rows{
      {{1, 0.5, -300, 0.25F}, {2, 1.5, 2, 0.0F}, {3, -2.0, 3, 1.0F}, {255, 0, 0, 0}}};
  std::string text = headerOf("ascii");
  for (const Row& row : rows) {
    text += std::to_string(row.red) + ' ' + std::to_string(row.z) + ' ' + std::to_string(row.x) + ' ' +
            std::to_string(row.y) + '\n';
  }
  text += "3 0 1 2 0\n4 3 2 1 0 2 -7 8\n";
  std::vector<std::string> contents{text};
  for (const bool isBig : {false, true}) {
    std::string content = headerOf(isBig ? "binary_big_endian" : "binary_little_endian");
    for (const Row& row : rows)
      content +=
          bytesOf(row.red, isBig) + bytesOf(row.z, isBig) + bytesOf(row.x, isBig) + bytesOf(row.y, isBig);
    const auto add = [&](std::uint8_t count, const std::vector<std::uint32_t>& corners,
                         const std::vector<std::int32_t>& others) {
      content += bytesOf(count, isBig);
      for (const std::uint32_t corner : corners) content += bytesOf(corner, isBig);
      content += bytesOf(static_cast<std::uint16_t>(others.size()), isBig);
      for (const std::int32_t other : others) content += bytesOf(other, isBig);
    };
    add(3, {0, 1, 2}, {});
    add(4, {3, 2, 1, 0}, {-7, 8});
    contents.push_back(content);
  }
  for (std::size_t i = 0; i < contents.size(); ++i) {
    SCOPED_TRACE(i);
    const auto mesh = readPly("a.ply", contents[i]);
    ASSERT_EQ(mesh->GetNumberOfPoints(), 4);
    for (vtkIdType k = 0; k < 4; ++k) {
      const Row& row = rows[static_cast<std::size_t>(k)];
      std::array<double, 3> place{};
      mesh->GetPoint(k, place.data());
      EXPECT_EQ(place, (std::array<double, 3>{static_cast<double>(row.x), row.y, row.z})) << k;
    }
    EXPECT_EQ(facesOf(*mesh), (std::vector<std::vector<int>>{{0, 1, 2}, {3, 2, 1, 0}}));
  }
}

TEST(PlyFile, FaultsHaveTheirPlace) {
  const std::string points = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string head = "ply\nformat ascii 1.0\n", rows = "0 0 0\n1 0 0\n0 1 0\n";
  for (const auto& [content, said] : std::vector<std::pair<std::string, std::string>>{
           {"plx\n", "1:1: this is no PLY file, expected ply"},
           {"ply\nformat octal 1.0\n", "2:8: 'octal' is wrong, expected ascii"},
           {"ply\nproperty float x\n", "2:1: a property of nothing, expected an element before"},
           {head + points, "7:1: the header does not end, expected end_header"},
           {head + points + faces + rows + "2 0 1\n", "13:1: a list of 2, expected 3 to 255"},
           {head + points + faces + rows + "3 0 1 -1\n", "13:7: corner -1 is none of the 3 points"},
           {head + points + faces + rows + "3 0 1\n", "14:1: something is missing here"},
           {head + points + faces + "0 0 0\n1 0 inf\n", "11:5: 'inf' is wrong, expected a finite number"},
           {head + points + faces + "0 0 0\n1 0 2e9\n0 1 0\n3 0 1 2\n", "1:1: point 1 is at (1, 0, "},
           {head + "element vertex 3\nend_header\n", "1:1: element vertex has no property"},
       }) {
    try {
      readPly("a.ply", content);
      ADD_FAILURE() << content;
    } catch (const InputError& fault) {
      EXPECT_TRUE(std::string_view(fault.what()).starts_with("a.ply:" + said))
          << fault.what() << "\nof " << content;
    }
  }
}

}  // namespace
}  // namespace carom
