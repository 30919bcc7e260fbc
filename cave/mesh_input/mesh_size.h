#pragma once
// How large a mesh file is, without reading it whole.

#include <cstdint>
#include <optional>
#include <string>

namespace carom {

/// Returns the number of faces that the header of a file promises (binary STL, PLY) or that its lines have
/// (OBJ, STL as text); none for kinds that tell it only when they are read, and for files that cannot be
/// read. Nothing is checked.
std::optional<std::uint64_t> facesIn(const std::string& path);

}  // namespace carom
