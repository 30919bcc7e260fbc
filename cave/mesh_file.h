#pragma once
// Meshes from files, which are hostile until read: whatever is wrong is named with its place.

#include <stdexcept>
#include <string>
#include <utility>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace carom {

/// A mesh file at fault. `what()` is "FILE:LINE:COLUMN: what is wrong, what was expected"; 1:1 where the
/// format has no lines.
class MeshFault : public std::runtime_error {
 public:
  MeshFault(std::string file, int line, int column, std::string message)
      : std::runtime_error(file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message),
        file_(std::move(file)),
        line_(line),
        column_(column),
        message_(std::move(message)) {}

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  int column() const { return column_; }
  const std::string& message() const { return message_; }

 private:
  std::string file_;
  int line_;
  int column_;
  std::string message_;
};

/// Endings that can be read, for messages.
inline constexpr const char* kMeshEndings = ".obj, .stl, .ply, .vtk, .vtp, .vtu, .gltf or .glb";

/// The surface in a file, by its ending; z is up (glTF, whose y is up, is turned). Points and polygons only:
/// at least one polygon, every corner a point, every coordinate finite, not all points the same. Throws
/// MeshFault; nothing is printed.
vtkSmartPointer<vtkPolyData> readMeshFile(const std::string& path);

}  // namespace carom
