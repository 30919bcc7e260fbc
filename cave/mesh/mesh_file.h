#pragma once
// Meshes from files, which are hostile until read: whatever is wrong is named with its place.

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace carom {

/// Endings that can be read, for messages.
inline constexpr const char* kMeshEndings = ".obj, .stl, .ply, .vtk, .vtp, .vtu, .gltf or .glb";

/// The surface in a file, by its ending; z is up (glTF, whose y is up, is turned). Points and polygons only:
/// at least one polygon, every corner a point, every coordinate finite, not all points the same. Throws
/// InputError; nothing is printed.
vtkSmartPointer<vtkPolyData> readMeshFile(const std::string& path);

}  // namespace carom
