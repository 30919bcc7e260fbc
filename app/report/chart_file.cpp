#include "app/report/chart_file.h"

#include <fmt/format.h>

#include <stdexcept>

#include "app/report/report_library.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/texts/texts.h"
#include "engine/text/whole_file.h"

namespace carom {

void writeChart(const Chart& chart, const std::filesystem::path& file) {
  const std::string kind = file.extension().string();
  if (kind != ".svg" && kind != ".png") {
    throw std::runtime_error(
        fmt::format("{}: a chart of this kind cannot be written, expected .svg or .png", file.string()));
  }
  WholeFile out(file);
  const ReportLibrary& library = reportLibrary();
  // A font that has the letters of the language in use, and Greek ones.
  const std::string svg = library.svgOf(chart, fontFileOf(texts::diagram::kMe.words()));
  out.commit(kind == ".svg" ? svg : library.pngOf(svg, chart.size_px));
}

}  // namespace carom
