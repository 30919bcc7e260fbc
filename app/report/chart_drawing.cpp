// Part of the library that is loaded when a chart is written: charts by VTK, their pictures by librsvg.
#include "app/report/chart_drawing.h"

#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace carom {
namespace {

unsigned char byteOf(float channel) { return static_cast<unsigned char>(channel * 255.0F + 0.5F); }

/// Scale of the plot. VTK 9.1 rounds SVG coordinates to whole units of the axes, so VTK's axes count quarters
/// of a pixel, and the tick labels are set by this program.
constexpr double kUnits_px = 4.0;

glm::dvec2 plotSize(const Chart& chart) {
  return kUnits_px * glm::dvec2(chart.size_px.x - kChartLeft_px - kChartRight_px,
                                chart.size_px.y - kChartBottom_px - kChartTop_px);
}

glm::dvec2 toUnits(const Chart& chart, const glm::dvec2& point) {
  const glm::dvec2 from(chart.xRange.x, chart.yRange.x), to(chart.xRange.y, chart.yRange.y);
  return (point - from) / (to - from) * plotSize(chart);
}

/// Clips a..b to 0 … `size` (Liang and Barsky). Returns false if nothing is left.
bool clip(glm::dvec2& a, glm::dvec2& b, const glm::dvec2& size) {
  double from = 0.0, to = 1.0;
  const glm::dvec2 d = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    for (const auto& [p, q] : {std::pair(-d[axis], a[axis]), std::pair(d[axis], size[axis] - a[axis])}) {
      if (p == 0.0 && q < 0.0) return false;
      if (p < 0.0) from = std::max(from, q / p);
      if (p > 0.0) to = std::min(to, q / p);
    }
  }
  if (!(from <= to)) return false;
  b = a + to * d;
  a = a + from * d;
  return true;
}

/// Appends the visible piece of a..b, separated by NaN from the previous one unless it continues it.
void addPiece(std::vector<glm::dvec2>& points, glm::dvec2 a, glm::dvec2 b, const glm::dvec2& size) {
  if (!clip(a, b, size)) return;
  if (points.empty() || points.back() != a) {
    if (!points.empty()) points.emplace_back(std::numeric_limits<double>::quiet_NaN());
    points.push_back(a);
  }
  points.push_back(b);
}

/// Returns the visible part of the line, in units: the line, or a ring around each of its marks.
std::vector<glm::dvec2> visible(const Chart& chart, const ChartLine& line) {
  std::vector<glm::dvec2> points;
  const glm::dvec2 size = plotSize(chart);
  if (line.style != ChartLine::Style::marks) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      addPiece(points, toUnits(chart, line.points[i - 1]), toUnits(chart, line.points[i]), size);
    }
    return points;
  }
  const double radius = kUnits_px * line.width_px / 2.0;
  for (const glm::dvec2& mark : line.points) {
    const glm::dvec2 centre = toUnits(chart, mark);
    const auto at = [&](int i) {
      const double angle = i * std::numbers::pi / 12.0;
      return centre + radius * glm::dvec2(std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < 24; ++i) addPiece(points, at(i), at(i + 1), size);
  }
  return points;
}

void addLine(vtkChartXY& chart, const Chart& what, const ChartLine& line) {
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName(line.name.c_str());
  std::vector<glm::dvec2> points = visible(what, line);
  // A line that is not seen keeps its name in the legend. VTK skips NaN and complains of no points.
  if (points.empty()) points.assign(2, glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
  for (const glm::dvec2& point : points) {
    x->InsertNextValue(point.x);
    y->InsertNextValue(point.y);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* plot = chart.AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(line.name);
  plot->SetLegendVisibility(!line.name.empty());
  plot->SetColor(byteOf(line.colour.r), byteOf(line.colour.g), byteOf(line.colour.b), 255);
  plot->SetWidth(line.style == ChartLine::Style::marks ? 2.0F : line.width_px);
  if (line.style == ChartLine::Style::dashed) plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
  if (line.style == ChartLine::Style::dotted) plot->GetPen()->SetLineType(vtkPen::DOT_LINE);
}

/// Sets a font of a file; VTK's own have no letters beyond the English ones.
void useFont(vtkTextProperty& text, const std::string& file, int size) {
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
  text.SetFontSize(size);
  text.SetBold(false);
}

/// Returns a tick step of 1, 2 or 5 times a power of ten that divides the range into about eight parts.
double tickStep(const glm::dvec2& range) {
  const double rough = (range.y - range.x) / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= rough) return step * power;
  }
  return 10.0 * power;
}

void setAxis(vtkChartXY& chart, int which, const std::string& title, const glm::dvec2& range, double length,
             const std::string& font) {
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> figures;
  const double step = tickStep(range);
  for (double at = std::ceil(range.x / step); at <= range.y / step; ++at) {
    places->InsertNextValue((at * step - range.x) / (range.y - range.x) * length);
    figures->InsertNextValue(fmt::format("{:.6g}", at * step));
  }
  vtkAxis* axis = chart.GetAxis(which);
  axis->SetCustomTickPositions(places, figures);
  axis->SetTitle(title);
  axis->SetRange(0.0, length);
  axis->SetBehavior(vtkAxis::FIXED);
  useFont(*axis->GetTitleProperties(), font, 16);
  useFont(*axis->GetLabelProperties(), font, 14);
}

/// Corrects two faults of VTK 9.1: plots are clipped in the wrong frame, and the dash lengths are taken to be
/// in units of the axes.
void mend(vtkXMLDataElement& element, bool inPlot = false) {
  element.RemoveAttribute("clip-path");
  if (const char* dashes = element.GetAttribute("stroke-dasharray"); inPlot && dashes) {
    element.SetAttribute("stroke-dasharray", dashes == std::string_view("8") ? "32" : "6,14");
  }
  inPlot = inPlot || (element.GetName() == std::string_view("g") && element.GetAttribute("transform"));
  for (int i = 0; i < element.GetNumberOfNestedElements(); ++i) mend(*element.GetNestedElement(i), inPlot);
}

/// Sets up axes, lines and legend.
void fill(vtkChartXY& drawn, const Chart& chart, const std::string& font) {
  drawn.SetTitle(chart.title);
  useFont(*drawn.GetTitleProperties(), font, 18);
  drawn.SetAutoSize(false);
  drawn.SetSize({kChartLeft_px, kChartBottom_px,
                 static_cast<float>(chart.size_px.x - kChartLeft_px - kChartRight_px),
                 static_cast<float>(chart.size_px.y - kChartBottom_px - kChartTop_px)});
  drawn.SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  setAxis(drawn, vtkAxis::BOTTOM, chart.xTitle, chart.xRange, plotSize(chart).x, font);
  setAxis(drawn, vtkAxis::LEFT, chart.yTitle, chart.yRange, plotSize(chart).y, font);
  for (const ChartLine& line : chart.lines) addLine(drawn, chart, line);
  drawn.SetShowLegend(true);
  useFont(*drawn.GetLegend()->GetLabelProperties(), font, 14);
  drawn.GetLegend()->SetHorizontalAlignment(vtkChartLegend::CUSTOM);
  drawn.GetLegend()->SetVerticalAlignment(vtkChartLegend::CUSTOM);
  const auto named = std::count_if(chart.lines.begin(), chart.lines.end(),
                                   [](const ChartLine& line) { return !line.name.empty(); });
  drawn.GetLegend()->SetPoint(static_cast<float>(chart.size_px.x - kChartRight_px + 15),
                              static_cast<float>(chart.size_px.y - kChartTop_px - 10 - 20 * named));
  drawn.GetLegend()->GetBrush()->SetColor(255, 255, 255, 220);
}

/// Makes `root` an SVG page of white paper.
void makePage(vtkXMLDataElement& root, const glm::ivec2& size_px) {
  root.SetName("svg");
  root.SetAttribute("xmlns", "http://www.w3.org/2000/svg");
  root.SetAttribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
  root.SetIntAttribute("width", size_px.x);
  root.SetIntAttribute("height", size_px.y);
  vtkNew<vtkXMLDataElement> paper;
  paper->SetName("rect");
  paper->SetAttribute("width", "100%");
  paper->SetAttribute("height", "100%");
  paper->SetAttribute("fill", "#ffffff");
  root.AddNestedElement(paper);
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string svgOf(const Chart& chart, const std::string& fontFile) {
  // VTK's charts need a renderer for its size; it renders nothing.
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(chart.size_px.x, chart.size_px.y);
  vtkNew<vtkContextScene> scene;
  scene->SetRenderer(renderer);
  scene->SetGeometry(chart.size_px.x, chart.size_px.y);

  vtkNew<vtkChartXY> drawn;
  scene->AddItem(drawn);
  fill(*drawn, chart, fontFile);

  vtkNew<vtkXMLDataElement> root, page, definitions;
  makePage(*root, chart.size_px);
  page->SetName("g");
  page->SetAttribute("fill", "none");
  definitions->SetName("defs");
  vtkNew<vtkSVGContextDevice2D> device;
  device->SetSVGContext(page, definitions);
  device->SetEmbedFonts(false);
  device->Begin(renderer);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  scene->Paint(context);
  context->End();
  device->GenerateDefinitions();
  device->End();
  mend(*page);
  root->AddNestedElement(page);
  std::ostringstream text;
  root->PrintXML(text, vtkIndent());
  return text.str();
}

std::string pngOf(const std::string& svg, const glm::ivec2& size_px) {
  GError* fault = nullptr;
  const std::unique_ptr<RsvgHandle, void (*)(void*)> picture(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &fault),
      g_object_unref);
  if (!picture) throw std::runtime_error(fmt::format("the chart cannot be drawn: {}", fault->message));
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, size_px.x, size_px.y), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, void (*)(cairo_t*)> canvas(cairo_create(surface.get()), cairo_destroy);
  const RsvgRectangle whole{0.0, 0.0, static_cast<double>(size_px.x), static_cast<double>(size_px.y)};
  if (!rsvg_handle_render_document(picture.get(), canvas.get(), &whole, &fault)) {
    throw std::runtime_error(fmt::format("the chart cannot be drawn: {}", fault->message));
  }
  std::string png;
  cairo_surface_write_to_png_stream(surface.get(), append, &png);
  return png;
}

}  // namespace carom
