#pragma once
// Draws charts. In the library that is loaded when it is used (app/report/report_library.h).

#include <string>

#include "app/report/chart.h"

namespace carom {

/// Returns the chart as SVG, with the letters of this file of a font. Throws std::runtime_error.
std::string svgOf(const Chart& chart, const std::string& fontFile);

/// Returns the picture of an SVG text as PNG. Throws std::runtime_error.
std::string pngOf(const std::string& svg, const glm::ivec2& size_px);

}  // namespace carom
