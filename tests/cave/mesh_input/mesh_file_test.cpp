#include "cave/mesh_input/mesh_file.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "cave/bumpy_sphere.h"
#include "engine/text/input_error.h"

namespace carom {
namespace {

/// A file of its own for as long as it lives.
class MeshFile {
 public:
  MeshFile(const std::string& ending, const std::string& content)
      : path_(std::filesystem::temp_directory_path() / ("carom_mesh_" + std::to_string(getpid()) + ending)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~MeshFile() { std::filesystem::remove(path_); }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// What is wrong with it, behind the file's name; empty if nothing is.
std::string faultOfFile(const std::string& ending, const std::string& content) {
  const MeshFile file(ending, content);
  try {
    readMeshFile(file.path());
  } catch (const InputError& fault) {
    const std::string text = fault.what();
    EXPECT_EQ(text.rfind(file.path() + ":", 0), 0U) << text;
    return text.substr(file.path().size());
  }
  return {};
}

template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

// One tetrahedron with corners 0, x, y, z: volume 1/6.
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 -1\n";
const std::string kObjSlashed =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nf 1/1/1 2/1/1 4/1/1\n"
    "f 1/1/1 4/1/1 3/1/1\nf 2/1/1 3/1/1 -1/-1/-1\n";
const std::string kStl =
    "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid "
    "t\n";
const std::string kPlyHeader =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
    "property list uchar int vertex_indices\nend_header\n";
const std::string kPly = "ply\nformat ascii 1.0\n" + kPlyHeader +
                         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string kVtk =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string kVtu =
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 "
    "1</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" "
    "format=\"ascii\">10</DataArray></Cells>\n</Piece></UnstructuredGrid></VTKFile>\n";
const std::string kVtp =
    "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
    "NumberOfPolys=\"4\">\n"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 "
    "1</DataArray>"
    "</Points>\n<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 0 3 2 1 "
    "2 3</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray></Polys>\n"
    "</Piece></PolyData></VTKFile>\n";

std::string binaryPly() {
  std::string text = "ply\nformat binary_little_endian 1.0\n" + kPlyHeader;
  text += bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (const auto& face : {std::vector{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    text += '\3' + bytesOf(face);
  return text;
}

std::string binaryStl() {
  std::string text(80, ' ');
  text += bytesOf<std::uint32_t>({4});
  const std::vector<std::vector<float>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& face : {std::vector{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    text += bytesOf<float>({0, 0, 0});
    for (const int corner : face) text += bytesOf(corners[static_cast<std::size_t>(corner)]);
    text += std::string(2, '\0');
  }
  return text;
}

/// glTF stores its buffers apart; here within, as base 64: the four corners and the four triangles.
std::string gltf() {
  const std::string buffer = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
                             bytesOf<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string base64;
  for (std::size_t i = 0; i < buffer.size(); i += 3) {  // 72 bytes: no rest
    const auto byte = [&](std::size_t k) {
      return static_cast<unsigned>(static_cast<unsigned char>(buffer[i + k]));
    };
    const unsigned bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) base64 += digits[bits >> shift & 63U];
  }
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,2,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,)" +
         base64 + "\"}]}\n";
}

TEST(MeshFile, EveryKindGivesTheSameTetrahedron) {
  const std::vector<std::pair<std::string, std::string>> kinds{
      {".obj", kObj},        {".OBJ", kObjSlashed}, {".stl", kStl}, {".stl", binaryStl()}, {".ply", kPly},
      {".ply", binaryPly()}, {".vtk", kVtk},        {".vtp", kVtp}, {".vtu", kVtu},        {".gltf", gltf()}};
  for (const auto& [ending, content] : kinds) {
    const MeshFile file(ending, content);
    const auto mesh = readMeshFile(file.path());
    EXPECT_EQ(mesh->GetNumberOfPolys(), 4) << ending;
    vtkNew<vtkMassProperties> mass;
    mass->SetInputData(mesh);
    EXPECT_NEAR(mass->GetVolume(), 1.0 / 6.0, 1e-6) << ending;
    if (ending == ".gltf") {  // its y points up: there are 2 m between floor and mesh
      EXPECT_NEAR(mesh->GetBounds()[4], 2.0, 1e-6);
      EXPECT_NEAR(mesh->GetBounds()[2], -1.0, 1e-6);
    }
  }
}

struct Fault {
  std::string ending, content, place, word;
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  text.replace(text.find(what), what.size(), with);
  return text;
}

TEST(MeshFile, FaultsAreNamedWithTheirPlaces) {
  const std::vector<Fault> faults{
      {".obj", replaced(kObj, "v 1 0 0", "v 1 nan 0"), ":2:5: ", "'nan'"},
      {".obj", replaced(kObj, "v 1 0 0", "v 1 0/05 0"), ":2:5: ", "finite number"},
      {".obj", replaced(kObj, "v 1 0 0", "v 1 0"), ":2:6: ", "missing"},
      {".obj", replaced(kObj, "f 1 2 4", "f 1 2 9"), ":6:7: ", "9"},
      {".obj", replaced(kObj, "f 1 2 4", "f 1 0 4"), ":6:5: ", "from 1"},
      {".obj", replaced(kObj, "f 1 2 4", "f 1 2/7 4"), ":6:7: ", "7"},
      {".obj", replaced(kObj, "f 1 2 4", "f 1 2"), ":6:6: ", "missing"},
      {".obj", replaced(kObjSlashed, "f 1/1/1 3/1/1", "f 1/1/1 3/1"), ":7:1: ", "7"},
      {".obj", "this is no mesh\n", ":1:1: ", "no surface"},
      {".obj", "", ":1:1: ", "no surface"},
      {".obj", "v 0 0 0\nv 1 0 0\n", ":1:1: ", "no surface"},
      {".obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", ":1:1: ", "extent"},
      {".obj", "v 1e300 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", ":1:1: ", "1e9"},
      {".stl", replaced(kStl, "vertex 0 1 0", "vertex 0 inf 0"), ":5:10: ", "inf"},
      {".stl", replaced(kStl, "vertex 0 1 0\n", ""), ":7:1: ", "2 vertices"},
      {".stl", replaced(kStl, "endsolid t\n", ""), ":30:1: ", "whole"},
      {".stl", binaryStl().substr(0, 200), ":1:1: ", "4 triangles"},
      {".ply", replaced(kPly, "3 0 1 3", "3 0 1 4"), ":15:7: ", "4"},
      {".ply", replaced(kPly, "1 0 0", "1 x 0"), ":11:3: ", "'x'"},
      {".ply", replaced(kPly, "vertex 4", "vertex 4000000"), ":3:16: ", "room"},
      {".ply", replaced(kPly, "property float x", "property real x"), ":4:10: ", "type"},
      {".ply", binaryPly().substr(0, binaryPly().size() - 5), ":1:1: ", "whole"},
      {".vtk", replaced(kVtk, "3 0 1 3", "3 0 1 4"), ":12:7: ", "4"},
      {".vtk", replaced(kVtk, "POINTS 4", "POINTS 999999"), ":5:8: ", "room"},
      {".vtk", replaced(kVtk, "1 0 0", "1 nan 0"), ":7:3: ", "nan"},
      {".vtk", "x", ":1:1: ", "# vtk"},
      {".vtp", replaced(kVtp, "</Piece>", "<Piece>"), ":6:10: ", "mismatched tag"},
      {".vtp", replaced(kVtp, "1 2 3</DataArray>", "1 2 30</DataArray>"), ":1:1: ", "30"},
      {".gltf", replaced(gltf(), "\"min\":[", "\"min\":"), ":3:", "expected"},
      {".blend", "x", ":1:1: ", "expected .obj"},
  };
  for (const Fault& fault : faults) {
    const std::string said = faultOfFile(fault.ending, fault.content);
    EXPECT_EQ(said.rfind(fault.place, 0), 0U) << fault.ending << " said " << said << " of\n" << fault.content;
    EXPECT_NE(said.find(fault.word), std::string::npos) << said;
    EXPECT_NE(said.find("expected"), std::string::npos) << said;
  }
  EXPECT_THROW(readMeshFile("/no/such.obj"), InputError);
  EXPECT_THROW(readMeshFile("/tmp"), InputError);
}

// Files cut short or scribbled on are read or refused, and nothing is printed; a crash would end the test.
TEST(MeshFile, DamagedFilesAreReadOrRefused) {
  const std::vector<std::pair<std::string, std::string>> kinds{{".obj", kObj},        {".stl", binaryStl()},
                                                               {".ply", binaryPly()}, {".vtk", kVtk},
                                                               {".vtp", kVtp},        {".gltf", gltf()}};
  std::mt19937 random(3);
  int refused = 0;
  testing::internal::CaptureStderr();
  for (int i = 0; i < 240; ++i) {
    const auto& [ending, whole] = kinds[static_cast<std::size_t>(i) % kinds.size()];
    std::string content = whole;
    const std::size_t at = random() % content.size();
    if (i % 2 == 0) {
      content.resize(at);
    } else {
      content[at] = static_cast<char>(random());
    }
    refused += faultOfFile(ending, content).empty() ? 0 : 1;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, 60);
}

// A binary PLY in which every number has to be where it belongs: the volume of a sphere of radius 0.5 with
// bumps of 0.01 is that of the sphere within 2 %, and every corner is one of the points.
TEST(MeshFile, AMeshOfManyTrianglesIsWhole) {
  constexpr int kRings = 60;
  const MeshFile file(".ply", test::bumpySphere(kRings));
  const vtkSmartPointer<vtkPolyData> surface = readMeshFile(file.path());
  EXPECT_EQ(surface->GetNumberOfPoints(), (kRings + 1) * 2 * kRings);
  EXPECT_EQ(surface->GetNumberOfPolys(), 4 * kRings * kRings);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  const double sphere_m3 = 4.0 / 3.0 * std::numbers::pi * 0.125;
  EXPECT_NEAR(mass->GetVolume(), sphere_m3, 0.02 * sphere_m3);
}

TEST(MeshFile, AnOpenedMeshIsReadOnceUnlessItsFileChanges) {
  const MeshFile file(".ply", test::bumpySphere(4));
  openMeshFile(file.path());
  const vtkSmartPointer<vtkPolyData> opened = readMeshFile(file.path());
  EXPECT_EQ(opened->GetNumberOfPolys(), 64);
  EXPECT_NE(readMeshFile(file.path()).Get(), opened.Get()) << "kept for one reading";

  openMeshFile(file.path());
  std::ofstream(file.path(), std::ios::binary) << test::bumpySphere(5);
  EXPECT_EQ(readMeshFile(file.path())->GetNumberOfPolys(), 100);
  openMeshFile(file.path());
  std::ofstream(file.path(), std::ios::binary) << "ply";
  EXPECT_THROW(readMeshFile(file.path()), InputError);
}

}  // namespace
}  // namespace carom
