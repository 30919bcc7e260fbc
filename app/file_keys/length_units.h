#pragma once
// The units of lengths in files.

#include <array>
#include <cstddef>
#include <string_view>

namespace carom {

/// Units of lengths, and what they are in metres.
inline constexpr std::array<std::string_view, 5> kLengthUnits{"mm", "cm", "in", "ft", "m"};
inline constexpr std::array<double, 5> kMetresPerUnit{1e-3, 1e-2, 0.0254, 0.3048, 1.0};
inline constexpr std::size_t kFoot = 3, kMetre = 4;

}  // namespace carom
