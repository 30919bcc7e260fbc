#pragma once
// Reads ParaView's description of a CAVE (.pvx): one <Machine> per MPI rank, in their order. Keys and
// defaults are those of ParaView's vtkDisplayConfiguration.

#include <filesystem>

#include "app/room_checks/room.h"

namespace carom {

/// Reads the whole file. Faults of single values become findings and their walls are left out; values that
/// ParaView would ignore silently are reported. Throws InputErrors if the file cannot be read or is not XML.
Room readPvx(const std::filesystem::path& file);

}  // namespace carom
