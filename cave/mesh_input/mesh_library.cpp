#include "cave/mesh_input/mesh_library.h"

#include "cave/process/loaded_library.h"

namespace carom {

const MeshLibrary& meshLibrary() {
  static const auto& library = *static_cast<const MeshLibrary*>(
      loadedLibrary("libcarom_meshes.so", "caromMeshLibrary", "reads and divides meshes"));
  return library;
}

}  // namespace carom
