#pragma once
// ParaView's description of a CAVE (.pvx): one <Machine> for each MPI rank, in their order. Keys and defaults
// as in ParaView's vtkDisplayConfiguration.

#include <filesystem>

#include "app/room_import/room.h"

namespace carom {

/// Reads the whole file. Faults of single values become findings and their walls are left out; what ParaView
/// would pass over in silence is named. Throws InputErrors where the file cannot be read or is no XML.
Room readPvx(const std::filesystem::path& file);

}  // namespace carom
