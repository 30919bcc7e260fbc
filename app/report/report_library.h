#pragma once
// The library that draws charts and writes sculptures. It is loaded when one of them is wanted: VTK's charts,
// librsvg and assimp take longer to load than most commands take to run.

#include "app/report/chart_drawing.h"
#include "app/report/sculpture_export.h"

namespace carom {

struct ReportLibrary {
  decltype(&carom::svgOf) svgOf;
  decltype(&carom::pngOf) pngOf;
  decltype(&carom::exportSculpture) exportSculpture;
};

/// Returns what the library offers, and loads it at the first call (cave/process/loaded_library.h). Throws
/// std::runtime_error that names the file and its fault.
const ReportLibrary& reportLibrary();

}  // namespace carom
