#include "app/console/live_diagram.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {
namespace {

constexpr double kEvery_s = 0.1;        // update interval of the chart
constexpr double kShown_s = 5.0;        // shown below the present event
constexpr double kKept_s = 6.0;         // kept of the viewer's world line, board time
constexpr float kLeastTick_px = 40.0F;  // from one number of an axis to the next
constexpr float kLeftMargin_px = 60, kRightMargin_px = 270, kTopMargin_px = 40, kBottomMargin_px = 40;

ImU32 inkOf(const glm::vec3& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F});
}

/// A chart in a rectangle of a window: maps its axes' units to pixels.
class Paper {
 public:
  /// One metre in x and one metre of c t have the same length, so that light is at 45°; both ranges of the
  /// chart are in sight.
  Paper(const Chart& chart, ImDrawList& list, const ImVec2& origin, const ImVec2& size)
      : chart_(chart), list_(list), origin_(origin), size_(size) {
    const double wide_px = size.x - kLeftMargin_px - kRightMargin_px,
                 high_px = size.y - kTopMargin_px - kBottomMargin_px;
    px_m_ =
        std::min(wide_px / (chart.xRange.y - chart.xRange.x), high_px / (chart.yRange.y - chart.yRange.x));
    const double middle_m = (chart.xRange.x + chart.xRange.y) / 2;
    xRange_ = {middle_m - wide_px / (2 * px_m_), middle_m + wide_px / (2 * px_m_)};
    top_m_ = chart.yRange.x + high_px / px_m_;
    while (tick_m_ * px_m_ < kLeastTick_px) tick_m_ *= 2.0;
  }

  void draw() const {
    const ImVec2 end{origin_.x + size_.x, origin_.y + size_.y};
    list_.PushClipRect(origin_, end, true);
    list_.AddRectFilled(origin_, end, IM_COL32_WHITE);
    text({origin_.x + kLeftMargin_px, origin_.y + 8}, chart_.title);
    drawAxes();
    list_.PushClipRect({origin_.x + kLeftMargin_px, origin_.y + kTopMargin_px},
                       {end.x - kRightMargin_px, end.y - kBottomMargin_px}, true);
    for (const ChartLine& line : chart_.lines) drawLine(line);
    list_.PopClipRect();
    drawLegend();
    list_.PopClipRect();
  }

 private:
  ImVec2 at(const glm::dvec2& point) const {
    return {origin_.x + kLeftMargin_px + static_cast<float>((point.x - xRange_.x) * px_m_),
            origin_.y + size_.y - kBottomMargin_px - static_cast<float>((point.y - chart_.yRange.x) * px_m_)};
  }

  void text(const ImVec2& where, const std::string& words) const {
    list_.AddText(where, IM_COL32(30, 30, 30, 255), words.c_str());
  }

  /// Returns the multiples of the ticks' distance in a range.
  std::pair<int, int> ticksIn(double from_m, double until_m) const {
    return {static_cast<int>(std::ceil(from_m / tick_m_)), static_cast<int>(std::floor(until_m / tick_m_))};
  }

  /// Draws grid lines with their numbers.
  void drawAxes() const {
    const ImU32 grey = IM_COL32(225, 225, 225, 255);
    const auto [left, right] = ticksIn(xRange_.x, xRange_.y);
    for (int tick = left; tick <= right; ++tick) {
      const double x = tick * tick_m_;
      list_.AddLine(at({x, chart_.yRange.x}), at({x, top_m_}), grey);
      const ImVec2 foot = at({x, chart_.yRange.x});
      text({foot.x - 6, foot.y + 4}, std::to_string(static_cast<int>(x)));
    }
    const auto [low, high] = ticksIn(chart_.yRange.x, top_m_);
    for (int tick = low; tick <= high; ++tick) {
      const double y = tick * tick_m_;
      list_.AddLine(at({xRange_.x, y}), at({xRange_.y, y}), grey);
      const ImVec2 foot = at({xRange_.x, y});
      text({foot.x - 32, foot.y - 9}, std::to_string(static_cast<int>(y)));
    }
    text({origin_.x + size_.x - kRightMargin_px - 40, origin_.y + size_.y - kBottomMargin_px + 18},
         chart_.xTitle);
    text({origin_.x + 8, origin_.y + kTopMargin_px - 24}, chart_.yTitle);
  }

  /// Draws a dashed line; dots are short dashes. Draws only what lies in the rectangle, because axes are
  /// kilometres long.
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
    keepWithin(from.x - origin_.x, step.x, size_.x);
    keepWithin(from.y - origin_.y, step.y, size_.y);
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
    float y = origin_.y + kTopMargin_px;
    for (const ChartLine& line : chart_.lines) {
      if (line.name.empty()) continue;
      const float x = origin_.x + size_.x - kRightMargin_px + 12;
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
  ImVec2 origin_, size_;
  double px_m_ = 1.0;
  double tick_m_ = 1.0;     // from one number of an axis to the next
  double top_m_ = 0.0;      // of c t
  glm::dvec2 xRange_{0.0};  // shown by the rectangle
};

}  // namespace

void LiveDiagram::play(const Scenario& scenario) {
  subject_ = subjectOf(scenario);
  chart_ = {};
}

void LiveDiagram::follow(const FrameRecord& record) {
  const Event& here = record.viewers.front().observer.middle.observation;
  carom::follow(subject_, record, viewers_);
  const auto isOld = [&](const Event& event) { return event.t_s < here.t_s - kKept_s; };
  std::erase_if(subject_.mine, isOld);
  for (OtherObserver& other : subject_.others) std::erase_if(other.line, isOld);
}

void LiveDiagram::make(const FrameRecord& record, const World& world) {
  const Event& here = record.viewers.front().observer.middle.observation;
  if (subject_.mine.empty()) return;
  subject_.lines.assign(world.histories.begin() + 1, world.histories.end());
  followTold(subject_, world.people, here.t_s - kKept_s);
  subject_.events = world.events;
  subject_.knownUntil_s = here.t_s;
  chart_ = spacetimeChart(subject_, {'x', here.t_s - kShown_s});
}

void LiveDiagram::draw(const FrameRecord& record, const World& world, ImDrawList& list,
                       const glm::vec2& origin_px, const glm::vec2& size_px) {
  if (std::abs(record.display_s - made_s_) >= kEvery_s) {
    make(record, world);
    made_s_ = record.display_s;
  }
  constexpr float kLeastWidth_px = 400.0F, kLeastHeight_px = 140.0F;  // a smaller one has no room for axes
  if (chart_.lines.empty() || !(size_px.x >= kLeastWidth_px && size_px.y >= kLeastHeight_px)) return;
  Paper(chart_, list, {origin_px.x, origin_px.y}, {size_px.x, size_px.y}).draw();
}

}  // namespace carom
