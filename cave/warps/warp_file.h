#pragma once
// Warp files of all formats, told apart by their endings.

#include <array>
#include <filesystem>
#include <string_view>

#include <glm/vec2.hpp>

#include "cave/room/warp_mesh.h"

namespace carom {

inline constexpr std::array<std::string_view, 8> kWarpEndings{".pfm",    ".obj", ".csv",  ".xml",
                                                              ".simcad", ".sgc", ".data", ".vwf"};

/// Returns the mesh in a file (InputKind::warp; a .vwf InputKind::screenGrid). `window_px`: its window.
/// Throws std::runtime_error, "FILE:LINE:COLUMN: what is wrong, what was expected".
Warp readWarp(const std::filesystem::path& file, const glm::ivec2& window_px);

}  // namespace carom
