#pragma once
// A line chart, as it is to be drawn.

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

struct ChartLine {
  enum class Style { solid, dashed, dotted, marks };
  std::string name;                ///< name in the legend; without one, the line is not listed
  std::vector<glm::dvec2> points;  ///< in the axes' units
  glm::vec3 colour{0.0F};          ///< sRGB, 0 … 1
  float width_px = 2.0F;           ///< for marks, their size
  Style style = Style::solid;
};

struct Chart {
  std::string title, xTitle, yTitle;
  glm::dvec2 xRange{0.0, 1.0}, yRange{0.0, 1.0};
  std::vector<ChartLine> lines;
  glm::ivec2 size_px{1000, 1000};
};

/// The margins of a chart; the axis ranges fill the rest of `size_px`. The legend is on the right.
inline constexpr int kChartLeft_px = 90, kChartRight_px = 280, kChartBottom_px = 80, kChartTop_px = 60;

}  // namespace carom
