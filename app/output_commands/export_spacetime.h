#pragma once
// `carom export --spacetime`: a game as a body in spacetime, for Blender, the web or a printer. Needs no
// display.

#include <filesystem>
#include <optional>

#include "engine/spacetime/event.h"

namespace carom {

struct ExportSpacetimeOptions {
  std::filesystem::path source;           ///< session file or scenario
  std::optional<std::size_t> game;        ///< of a session, from 1; by default the newest
  std::filesystem::path out;              ///< .glb, .stl or .3mf
  std::optional<double> from_s, until_s;  ///< board times; by default the last 10 s
  Vec3 beta{0.0};                         ///< velocity on the board of the frame in which it is shown
  double size_m = 0.15;                   ///< of the longest side
};

/// Returns the exit status. Throws InputErrors or std::runtime_error.
int runExportSpacetime(const ExportSpacetimeOptions& options);

}  // namespace carom
