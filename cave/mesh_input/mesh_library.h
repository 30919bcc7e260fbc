#pragma once
// The library with VTK's readers, filters and writers of meshes. It is loaded when one of them is wanted: it
// takes longer to load than most commands take to run.

#include "cave/mesh_input/mesh_filters.h"

namespace carom {

struct MeshLibrary {
  decltype(&carom::triangleBytes) triangleBytes;
  decltype(&carom::readTriangleBytes) readTriangleBytes;
  decltype(&carom::cutToTriangles) cutToTriangles;
  decltype(&carom::transformed) transformed;
  decltype(&carom::longEdgesHalved) longEdgesHalved;
  decltype(&carom::vtpOf) vtpOf;
};

/// Returns what the library offers, and loads it at the first call (cave/process/loaded_library.h). Throws
/// std::runtime_error that names the file and its fault.
const MeshLibrary& meshLibrary();

}  // namespace carom
