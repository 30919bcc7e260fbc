#include "cave/mesh_input/mesh_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <vtkAdaptiveSubdivisionFilter.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkDataSetReader.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGLTFReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkSTLReader.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "cave/mesh_input/polygons.h"

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

/// Checks that all corners are points, before polygons and strips are divided into triangles.
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

using Reader = vtkSmartPointer<vtkPolyData> (*)(const std::string&);

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> kReaders{
      {".obj", readSurface<vtkOBJReader>},
      {".stl", readSurface<vtkSTLReader>},
      {".vtk", readOutside<vtkDataSetReader>},
      {".vtp", readSurface<vtkXMLPolyDataReader>},
      {".vtu", readOutside<vtkXMLUnstructuredGridReader>},
      {".gltf", readGltf},
      {".glb", readGltf},
  };
  return kReaders;
}

/// Returns the triangles of a surface, or throws what VTK said of it.
std::string bytesOf(vtkPolyData* read, const Complaints& complaints) {
  if (!read || read->GetNumberOfPoints() == 0 || read->GetNumberOfPolys() + read->GetNumberOfStrips() == 0) {
    const std::string said = complaints.first();
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

}  // namespace

std::string triangleBytes(vtkPolyData& surface) {
  vtkNew<Complaints> complaints;
  vtkOutputWindow::SetInstance(complaints);
  return bytesOf(&surface, *complaints);
}

std::string readTriangleBytes(const std::string& path, const std::string& ending) {
  vtkNew<Complaints> complaints;
  vtkOutputWindow::SetInstance(complaints);
  vtkSmartPointer<vtkPolyData> read;
  try {
    read = readers().at(ending)(path);
  } catch (const std::length_error&) {  // of a count that no file can hold
    throw std::runtime_error("it has a count that is wrong, expected a file that is whole");
  }
  return bytesOf(read, *complaints);
}

vtkSmartPointer<vtkPolyData> cutToTriangles(vtkPolyData& mesh) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(&mesh);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> transformed(vtkPolyData& mesh, vtkTransform& transform) {
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(&mesh);
  moved->SetTransform(&transform);
  moved->Update();
  return moved->GetOutput();
}

vtkSmartPointer<vtkPolyData> longEdgesHalved(vtkPolyData& mesh, double edge_m) {
  vtkNew<vtkAdaptiveSubdivisionFilter> halved;
  halved->SetInputData(&mesh);
  halved->SetMaximumEdgeLength(edge_m);
  halved->SetMaximumNumberOfPasses(1);
  halved->Update();
  return halved->GetOutput();
}

std::string vtpOf(vtkPolyData& mesh) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&mesh);
  writer->SetWriteToOutputString(true);
  writer->Write();
  return writer->GetOutputString();
}

}  // namespace carom
