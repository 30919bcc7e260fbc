#include "app/diagram_window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

const WindowPlacement kPlace{.size_px = {1000, 820}};
constexpr double kEvery_s = 0.1;      // the chart is made anew
constexpr double kShown_s = 5.0;      // below the present event
constexpr double kKept_s = 6.0;       // of my world line, board time
constexpr double kLeastWay_s = 0.25;  // before there is anything to show
constexpr float kLeft_px = 60, kRight_px = 270, kTop_px = 40, kBottom_px = 40;

ImU32 inkOf(const glm::vec3& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F});
}

/// A chart within a window: its axes' units to pixels.
class Paper {
 public:
  /// A metre of way and a metre of light's way are equally long: so light goes at 45°.
  Paper(const Chart& chart, const ImVec2& size)
      : chart_(chart),
        list_(*ImGui::GetBackgroundDrawList()),
        size_(size),
        px_m_((size.y - kTop_px - kBottom_px) / (chart.yRange.y - chart.yRange.x)) {
    const double middle_m = (chart.xRange.x + chart.xRange.y) / 2;
    const double half_m = (size.x - kLeft_px - kRight_px) / (2 * px_m_);
    xRange_ = {middle_m - half_m, middle_m + half_m};
  }

  void draw() const {
    list_.AddRectFilled({0, 0}, size_, IM_COL32_WHITE);
    text({kLeft_px, 8}, chart_.title);
    drawAxes();
    list_.PushClipRect({kLeft_px, kTop_px}, {size_.x - kRight_px, size_.y - kBottom_px});
    for (const ChartLine& line : chart_.lines) drawLine(line);
    list_.PopClipRect();
    drawLegend();
  }

 private:
  ImVec2 at(const glm::dvec2& point) const {
    return {kLeft_px + static_cast<float>((point.x - xRange_.x) * px_m_),
            size_.y - kBottom_px - static_cast<float>((point.y - chart_.yRange.x) * px_m_)};
  }

  void text(const ImVec2& where, const std::string& words) const {
    list_.AddText(where, IM_COL32(30, 30, 30, 255), words.c_str());
  }

  /// A line at every metre.
  void drawAxes() const {
    const ImU32 grey = IM_COL32(225, 225, 225, 255);
    for (double x = std::ceil(xRange_.x); x <= xRange_.y; x += 1.0) {
      list_.AddLine(at({x, chart_.yRange.x}), at({x, chart_.yRange.y}), grey);
      const ImVec2 foot = at({x, chart_.yRange.x});
      text({foot.x - 6, foot.y + 4}, std::to_string(static_cast<int>(x)));
    }
    for (double y = std::ceil(chart_.yRange.x); y <= chart_.yRange.y; y += 1.0) {
      list_.AddLine(at({xRange_.x, y}), at({xRange_.y, y}), grey);
      const ImVec2 foot = at({xRange_.x, y});
      text({foot.x - 32, foot.y - 9}, std::to_string(static_cast<int>(y)));
    }
    text({size_.x - kRight_px - 40, size_.y - kBottom_px + 18}, chart_.xTitle);
    text({8, kTop_px - 24}, chart_.yTitle);
  }

  /// Dots are short dashes. Only what lies in the window is drawn: axes go on for kilometres.
  void drawDashes(const ImVec2& from, const ImVec2& to, ImU32 ink, float width, float dash_px) const {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.0F)) return;
    const ImVec2 step{(to.x - from.x) / length, (to.y - from.y) / length};
    float begin = 0.0F, end = length;
    const auto keepWithin = [&](float start, float slope, float most) {
      if (slope == 0.0F) return;
      const float one = -start / slope, other = (most - start) / slope;
      begin = std::max(begin, std::min(one, other));
      end = std::min(end, std::max(one, other));
    };
    keepWithin(from.x, step.x, size_.x);
    keepWithin(from.y, step.y, size_.y);
    for (float s = begin; s < end; s += 2.0F * dash_px) {
      const float stop = std::min(s + dash_px, end);
      list_.AddLine({from.x + step.x * s, from.y + step.y * s},
                    {from.x + step.x * stop, from.y + step.y * stop}, ink, width);
    }
  }

  void drawLine(const ChartLine& line) const {
    using Style = ChartLine::Style;
    const ImU32 ink = inkOf(line.colour);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const ImVec2 here = at(line.points[i]);
      if (line.style == Style::marks) list_.AddCircleFilled(here, line.width_px / 2, ink);
      if (line.style == Style::marks || i == 0) continue;
      const ImVec2 before = at(line.points[i - 1]);
      if (line.style == Style::solid) list_.AddLine(before, here, ink, line.width_px);
      if (line.style == Style::dashed) drawDashes(before, here, ink, line.width_px, 8.0F);
      if (line.style == Style::dotted) drawDashes(before, here, ink, line.width_px, 3.0F);
    }
  }

  void drawLegend() const {
    float y = kTop_px;
    for (const ChartLine& line : chart_.lines) {
      if (line.name.empty()) continue;
      const float x = size_.x - kRight_px + 12;
      if (line.style == ChartLine::Style::marks) {
        list_.AddCircleFilled({x + 13, y + 9}, line.width_px / 2, inkOf(line.colour));
      } else {
        drawDashes({x, y + 9}, {x + 26, y + 9}, inkOf(line.colour), line.width_px,
                   line.style == ChartLine::Style::solid    ? 26.0F
                   : line.style == ChartLine::Style::dashed ? 8.0F
                                                            : 3.0F);
      }
      text({x + 34, y}, line.name);
      y += 24;
    }
  }

  const Chart& chart_;
  ImDrawList& list_;
  ImVec2 size_;
  double px_m_;
  glm::dvec2 xRange_{0.0};  // that the window shows
};

}  // namespace

DiagramWindow::DiagramWindow(Graphics& graphics, const Scenario& scenario)
    : window_(graphics, "Carom: spacetime diagram", kPlace), subject_(subjectOf(scenario)) {}

void DiagramWindow::follow(const FrameRecord& record, const World& world) {
  const Event& here = record.observer.eyes[2].observation;
  std::vector<Event>& mine = subject_.mine;
  if (!mine.empty() && here.t_s < mine.back().t_s) mine.clear();  // a recording that was gone back in
  mine.push_back(here);
  std::erase_if(mine, [&](const Event& event) { return event.t_s < here.t_s - kKept_s; });
  if (here.t_s - mine.front().t_s < kLeastWay_s) return;
  subject_.beta = betaFromU(record.observer.headFromBoard.inverse().u());
  subject_.lines.assign(world.histories.begin() + 1, world.histories.end());
  subject_.events = world.events;
  subject_.knownUntil_s = here.t_s;
  chart_ = spacetimeChart(subject_, {'x', here.t_s - kShown_s});
}

void DiagramWindow::show(const FrameRecord& record, const World& world) {
  if (std::abs(record.display_s - drawn_s_) >= kEvery_s) {
    follow(record, world);
    drawn_s_ = record.display_s;
  }
  window_.show({}, [this] {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (!chart_.lines.empty()) Paper(chart_, size).draw();
  });
}

}  // namespace carom
