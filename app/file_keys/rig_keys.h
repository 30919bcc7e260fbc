#pragma once
// The keys of rigs.

#include <array>
#include <string_view>

#include "app/file_keys/file_key.h"
#include "app/file_keys/length_units.h"

namespace carom {

/// The most of each in a room. Every two walls are compared with each other.
inline constexpr int kMostRanks = 4096;
inline constexpr std::size_t kMostWalls = 512, kMostTrackers = 256;

/// In the order of StereoMode and of Flip (cave/room/wall.h).
inline constexpr std::array<std::string_view, 10> kStereoModes{
    "mono",       "left",     "right",      "quad-buffer",  "side-by-side",
    "top-bottom", "anaglyph", "interlaced", "checkerboard", "anaglyph-grey"};
inline constexpr std::array<std::string_view, 4> kFlips{"none", "horizontal", "vertical", "both"};

const FileKey& rigKeys();

}  // namespace carom
