#pragma once
// Writes line charts as SVG or PNG files, drawn by VTK without a display.

#include <filesystem>

#include "app/report/chart.h"

namespace carom {

/// Writes the chart completely or not at all; `file` ends in .svg or .png. Throws std::runtime_error that
/// names the file and the error.
void writeChart(const Chart& chart, const std::filesystem::path& file);

}  // namespace carom
