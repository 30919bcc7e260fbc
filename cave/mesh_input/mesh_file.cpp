#include "cave/mesh_input/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include "cave/mesh_input/mesh_buffers.h"
#include "cave/mesh_input/mesh_library.h"
#include "cave/mesh_input/mesh_text.h"
#include "cave/mesh_input/ply_file.h"
#include "cave/mesh_input/polygons.h"
#include "cave/process/subprocess.h"
#include "engine/text/input_error.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::array<std::string_view, 8> kEndings{".obj", ".stl", ".ply",  ".vtk",
                                                   ".vtp", ".vtu", ".gltf", ".glb"};

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

/// Returns the surface of these triangles, which are found in a process of its own.
vtkSmartPointer<vtkPolyData> surfaceApart(const std::function<std::string()>& triangles,
                                          const std::string& path) {
  meshLibrary();  // loaded before that process begins
  try {
    return surfaceFrom(runInSubprocess(triangles));
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
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end())
    throw InputError(path, 1, 1,
                     fmt::format("is of no known kind, expected {} or {}",
                                 fmt::join(kEndings.begin(), kEndings.end() - 1, ", "), kEndings.back()));
  vtkSmartPointer<vtkPolyData> surface;
  if (ending == ".ply") {
    surface = readPly(path, contentOf(path, InputKind::mesh));
    const bool hasOnlyTriangles =
        surface->GetNumberOfStrips() == 0 && surface->GetPolys()->IsHomogeneous() == 3;
    if (!hasOnlyTriangles)
      surface = surfaceApart([&] { return meshLibrary().triangleBytes(*surface); }, path);
  } else {
    checkContent(path, ending);
    surface = surfaceApart([&] { return meshLibrary().readTriangleBytes(path, ending); }, path);
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
