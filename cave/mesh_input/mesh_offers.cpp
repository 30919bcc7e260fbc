// The one name by which the library is known to those that load it (cave/mesh_input/mesh_library.h).
#include "cave/mesh_input/mesh_library.h"

extern "C" const carom::MeshLibrary caromMeshLibrary{carom::triangleBytes,   carom::readTriangleBytes,
                                                     carom::cutToTriangles,  carom::transformed,
                                                     carom::longEdgesHalved, carom::vtpOf};
