#pragma once
// Reads meshes from files, which are not trusted: every fault is reported with its place in the file.

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "engine/text/input_error.h"

namespace carom {

/// A mesh takes more time or memory than its reader may use (cave/process/subprocess.h).
class MeshTooLarge : public InputError {
 public:
  using InputError::InputError;
};

/// Returns the surface in a file, whose ending gives the format; z is up (glTF, whose y is up, is turned). It
/// has points and polygons only: at least one polygon, every corner a point, every coordinate finite, and not
/// all points the same. Throws InputError; nothing is printed.
vtkSmartPointer<vtkPolyData> readMeshFile(const std::string& path);

/// Reads a file as `readMeshFile` does and keeps the surface for the next call of `readMeshFile`, which has
/// it at once if the file is still the same. Both are for one thread.
void openMeshFile(const std::string& path);

}  // namespace carom
