#include "cave/mesh/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkDataSetReader.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFloatArray.h>
#include <vtkGLTFReader.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkSTLReader.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "cave/mesh/mesh_buffers.h"
#include "cave/mesh/mesh_text.h"
#include "cave/mesh/ply_file.h"
#include "cave/mesh/polygons.h"
#include "cave/process/subprocess.h"
#include "engine/base/input_error.h"
#include "engine/base/outside_file.h"

namespace carom {
namespace {

/// Collects VTK's error messages, which would otherwise go to the terminal.
class Complaints : public vtkOutputWindow {
 public:
  static Complaints* New() { return new Complaints; }
  void DisplayText(const char* text) override { take(text); }
  void DisplayErrorText(const char* text) override { take(text); }
  void DisplayWarningText(const char* text) override { take(text); }
  void DisplayGenericWarningText(const char* text) override { take(text); }
  void DisplayDebugText(const char*) override {}

  /// Returns the first message on one line, without the source file and the object it came from.
  std::string first() const {
    std::string text = text_.substr(0, text_.find("\n\n"));
    if (const std::size_t after = text.find("): "); after != std::string::npos) text = text.substr(after + 3);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, ' ');
    return text.substr(0, 200);
  }

 private:
  void take(const char* text) {
    if (text_.empty()) text_ = text;
  }
  std::string text_;
};

template <typename Reader>
vtkSmartPointer<vtkPolyData> readSurface(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Reads the outer surface of a file that may hold volumes.
template <typename Reader>
vtkSmartPointer<vtkPolyData> readOutside(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!reader->GetOutput()) return nullptr;
  vtkNew<vtkDataSetSurfaceFilter> outside;
  outside->SetInputData(reader->GetOutput());
  outside->Update();
  return outside->GetOutput();
}

/// Reads glTF 2.0 (section 3.4: y is up, metres): all meshes of the scene, each in its place.
vtkSmartPointer<vtkPolyData> readGltf(const std::string& path) {
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkCompositeDataGeometryFilter> together;
  together->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkTransform> upright;
  upright->RotateX(90.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(together->GetOutputPort());
  turned->SetTransform(upright);
  turned->Update();
  return turned->GetOutput();
}

/// Coordinates and corners as plain numbers.
struct Triangles {
  std::vector<float> places_m;        // x, y, z of each point
  std::vector<std::int32_t> corners;  // three per triangle
};

/// Returns the triangles of a surface, without its other polygons; their corners are points. Throws, without
/// the file's name, if a point is too far away.
Triangles trianglesOf(vtkPolyData& surface) {
  Triangles triangles;
  const vtkIdType points = surface.GetNumberOfPoints();
  triangles.places_m.reserve(3 * static_cast<std::size_t>(points));
  for (vtkIdType i = 0; i < points; ++i) {
    std::array<double, 3> p{};
    surface.GetPoint(i, p.data());
    constexpr double kFurthest = 1e9;
    for (const double coordinate_m : p) {
      if (!(std::abs(coordinate_m) <= kFurthest)) {
        throw std::runtime_error(
            fmt::format("point {} is at ({}, {}, {}), expected numbers up to 1e9", i, p[0], p[1], p[2]));
      }
      triangles.places_m.push_back(static_cast<float>(coordinate_m));
    }
  }
  triangles.corners.reserve(3 * static_cast<std::size_t>(surface.GetNumberOfPolys()));
  forEachPolygon(*surface.GetPolys(), [&](std::span<const vtkIdType> corners) {
    if (corners.size() != 3) return;
    for (const vtkIdType corner : corners) triangles.corners.push_back(static_cast<std::int32_t>(corner));
  });
  return triangles;
}

/// Returns whether every cell is a triangle.
bool hasOnlyTriangles(vtkPolyData& surface) {
  return surface.GetNumberOfStrips() == 0 && surface.GetPolys()->IsHomogeneous() == 3;
}

/// Checks that there are points and that all corners are among them, before polygons and strips are divided
/// into triangles.
void checkCorners(vtkPolyData& read) {
  for (vtkCellArray* cells : {read.GetPolys(), read.GetStrips()}) {
    forEachPolygon(*cells, [&](std::span<const vtkIdType> corners) {
      const auto wrong = std::find_if(corners.begin(), corners.end(),
                                      [&](vtkIdType id) { return id < 0 || id >= read.GetNumberOfPoints(); });
      if (wrong == corners.end()) return;
      throw std::runtime_error(fmt::format("a polygon has corner {}, expected one of the {} points", *wrong,
                                           read.GetNumberOfPoints()));
    });
  }
}

using Reader = std::function<vtkSmartPointer<vtkPolyData>(const std::string&)>;

/// Reads a file in a process of its own, since VTK's readers trust their files. Returns the number of points,
/// their coordinates and the corners of the triangles, as bytes.
std::string readApart(const Reader& reader, const std::string& path) {
  vtkNew<Complaints> complaints;
  vtkOutputWindow::SetInstance(complaints);
  vtkSmartPointer<vtkPolyData> read;
  try {
    read = reader(path);
  } catch (const std::length_error&) {  // of a count that no file can hold
    throw std::runtime_error("it has a count that is wrong, expected a file that is whole");
  }
  if (!read || read->GetNumberOfPoints() == 0 || read->GetNumberOfPolys() + read->GetNumberOfStrips() == 0) {
    const std::string said = complaints->first();
    throw std::runtime_error((said.empty() ? "holds no surface" : said) + ", expected polygons");
  }
  checkCorners(*read);
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(read->GetPoints());
  bare->SetPolys(read->GetPolys());
  bare->SetStrips(read->GetStrips());
  vtkNew<vtkTriangleFilter> cut;
  if (!hasOnlyTriangles(*bare)) {
    cut->SetInputData(bare);
    cut->Update();
  }
  const Triangles triangles = trianglesOf(hasOnlyTriangles(*bare) ? *bare : *cut->GetOutput());
  const std::uint64_t points = triangles.places_m.size() / 3;
  std::string bytes(reinterpret_cast<const char*>(&points), sizeof points);
  bytes.reserve(sizeof points + 4 * (triangles.places_m.size() + triangles.corners.size()));
  bytes.append(reinterpret_cast<const char*>(triangles.places_m.data()),
               triangles.places_m.size() * sizeof(float));
  bytes.append(reinterpret_cast<const char*>(triangles.corners.data()),
               triangles.corners.size() * sizeof(std::int32_t));
  return bytes;
}

vtkSmartPointer<vtkPolyData> surfaceFrom(const std::string& bytes) {
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data(), sizeof count);
  const char* places = bytes.data() + sizeof count;
  const char* corners = places + 3 * count * sizeof(float);
  const std::size_t triangles =
      static_cast<std::size_t>(bytes.data() + bytes.size() - corners) / (3 * sizeof(std::int32_t));
  vtkNew<vtkFloatArray> coordinates_m;
  coordinates_m->SetNumberOfComponents(3);
  std::memcpy(coordinates_m->WritePointer(0, static_cast<vtkIdType>(3 * count)), places,
              3 * count * sizeof(float));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates_m);
  vtkNew<vtkIdTypeArray> ends, ids;
  vtkIdType* end = ends->WritePointer(0, static_cast<vtkIdType>(triangles + 1));
  for (std::size_t i = 0; i <= triangles; ++i) end[i] = static_cast<vtkIdType>(3 * i);
  vtkIdType* id = ids->WritePointer(0, static_cast<vtkIdType>(3 * triangles));
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    std::int32_t corner = 0;
    std::memcpy(&corner, corners + i * sizeof corner, sizeof corner);
    id[i] = corner;
  }
  return surfaceOf(points, ends, ids);
}

/// Returns the line and column that a reader's message names (of XML, with columns from 0, and of JSON),
/// otherwise 1, 1.
std::pair<int, int> placeIn(const std::string& message) {
  static const std::regex kXml("at line ([0-9]{1,8}), column ([0-9]{1,8})");
  static const std::regex kJson("Line ([0-9]{1,8}), Column ([0-9]{1,8})");
  static const std::regex kObj("(?:near line |points L\\.)([0-9]{1,8})");
  std::smatch found;
  if (std::regex_search(message, found, kObj)) return {std::stoi(found[1]), 1};
  if (std::regex_search(message, found, kXml)) return {std::stoi(found[1]), std::stoi(found[2]) + 1};
  if (std::regex_search(message, found, kJson)) return {std::stoi(found[1]), std::stoi(found[2])};
  return {1, 1};
}

/// Returns the triangles of what `reader` reads, in a process of its own.
vtkSmartPointer<vtkPolyData> cutApart(const Reader& reader, const std::string& path) {
  try {
    return surfaceFrom(runInSubprocess([&] { return readApart(reader, path); }));
  } catch (const JobTooLarge& lost) {
    throw MeshTooLarge(path, 1, 1, std::string(lost.what()) + ", expected a smaller mesh");
  } catch (const SubprocessFailed& lost) {
    throw InputError(path, 1, 1, std::string(lost.what()) + ", expected a file that is whole");
  } catch (const std::runtime_error& error) {
    const auto [line, column] = placeIn(error.what());
    throw InputError(path, line, column, error.what());
  }
}

/// Checks the parts of a file that VTK's readers trust.
void checkContent(const std::string& path, std::string_view ending) {
  const std::string content = contentOf(path, InputKind::mesh);
  checkMeshText(path, ending, content);
  checkMeshParts(path, content);
}

vtkSmartPointer<vtkPolyData> readNow(const std::string& path) {
  static const std::map<std::string, Reader> kReaders{
      {".obj", readSurface<vtkOBJReader>},
      {".stl", readSurface<vtkSTLReader>},
      {".vtk", readOutside<vtkDataSetReader>},
      {".vtp", readSurface<vtkXMLPolyDataReader>},
      {".vtu", readOutside<vtkXMLUnstructuredGridReader>},
      {".gltf", readGltf},
      {".glb", readGltf},
  };
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto known = kReaders.find(ending);
  if (known == kReaders.end() && ending != ".ply") {
    throw InputError(path, 1, 1, fmt::format("is of no known kind, expected {}", kMeshEndings));
  }
  vtkSmartPointer<vtkPolyData> surface;
  if (ending == ".ply") {
    surface = readPly(path, contentOf(path, InputKind::mesh));
    if (!hasOnlyTriangles(*surface)) surface = cutApart([&](const std::string&) { return surface; }, path);
  } else {
    checkContent(path, ending);
    surface = cutApart(known->second, path);
  }
  if (!(surface->GetLength() > 0.0)) {
    throw InputError(path, 1, 1, "all points are one, expected a mesh that has extent");
  }
  return surface;
}

/// A mesh that was opened and not read yet, and the file's last change and size then.
struct OpenedMesh {
  std::filesystem::file_time_type changed;
  std::uintmax_t bytes = 0;
  vtkSmartPointer<vtkPolyData> surface;
};

std::map<std::string, OpenedMesh>& openedMeshes() {
  static std::map<std::string, OpenedMesh> opened;
  return opened;
}

OpenedMesh stateOf(const std::string& path) {
  std::error_code failed;
  return {std::filesystem::last_write_time(path, failed), std::filesystem::file_size(path, failed), {}};
}

}  // namespace

void openMeshFile(const std::string& path) {
  OpenedMesh opened = stateOf(path);
  opened.surface = readNow(path);
  openedMeshes()[path] = opened;
}

vtkSmartPointer<vtkPolyData> readMeshFile(const std::string& path) {
  const auto opened = openedMeshes().extract(path);
  if (opened.empty()) return readNow(path);
  const OpenedMesh now = stateOf(path);
  const bool isSame = opened.mapped().changed == now.changed && opened.mapped().bytes == now.bytes;
  return isSame ? opened.mapped().surface : readNow(path);
}

}  // namespace carom
