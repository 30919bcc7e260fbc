#include "cave/overlay/latency_overlay.h"

#include "cave/gl/gui.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

const ImVec4 kGood{0.35F, 0.75F, 0.45F, 1.0F}, kBad{0.95F, 0.35F, 0.25F, 1.0F};
const ImVec4 kWaits{0.35F, 0.45F, 0.6F, 1.0F};  // colour of waits, which cost nothing
constexpr float kBar_em = 16.0F;                // length of one display period
constexpr float kBars_periods = 1.25F;          // a bar's greatest length

bool isWait(FramePart part) { return part == FramePart::wait || part == FramePart::share; }

void number_ms(float value_s) {
  ImGui::TableNextColumn();
  if (std::isnan(value_s)) return;
  const double value_ms = std::round(1e5 * static_cast<double>(value_s)) / 100.0;
  ImGui::Text("%8.2f", value_ms + 0.0);  // avoids −0.00
}

/// Draws the median as a bar and the 99th percentile as a line; another line marks the display's period.
void bar(const PartStatistics& part, float period_s, bool waits) {
  const float em = ImGui::GetFontSize(), perSecond = kBar_em * em / period_s;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float bottom = from.y + em, limit = kBars_periods * kBar_em * em;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto at = [&](float value_s) { return from.x + std::clamp(value_s * perSecond, 0.0F, limit); };
  ImGui::Dummy({limit, em});
  list.AddLine({at(period_s), from.y - 2.0F}, {at(period_s), bottom + 3.0F}, IM_COL32(255, 255, 255, 160));
  if (part.frames == 0) return;
  const ImVec4 colour = waits ? kWaits : part.p99_s > period_s ? kBad : kGood;
  list.AddRectFilled({from.x, from.y + 1.0F}, {std::max(at(part.median_s), from.x + 1.0F), bottom},
                     ImGui::GetColorU32(colour));
  list.AddLine({at(part.p99_s), from.y}, {at(part.p99_s), bottom}, ImGui::GetColorU32(colour), 2.0F);
}

void drawParts(const LatencyView& view) {
  const float period_s = static_cast<float>(1.0 / view.display_hz);
  if (!ImGui::BeginTable("##parts", 5, ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* name : texts::latency::kPartColumns) {
    ImGui::TableSetupColumn(name);
  }
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < kFrameParts.size(); ++i) {
    const PartStatistics& part = view.parts[i];
    if (part.frames == 0) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(texts::latency::kParts[i]);
    number_ms(part.median_s);
    number_ms(part.p99_s);
    number_ms(part.jitter_s);
    ImGui::TableNextColumn();
    bar(part, period_s, isWait(static_cast<FramePart>(i)));
  }
  ImGui::EndTable();
}

ImVec4 colourOf(LockState lock) {
  if (lock == LockState::joined) return kGood;
  if (lock == LockState::lost) return kBad;
  return ImGui::GetStyle().Colors[ImGuiCol_Text];
}

void drawNodes(const LatencyView& view) {
  if (view.nodes.size() < 2 || !ImGui::BeginTable("##nodes", 5, ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* name : texts::latency::kNodeColumns) {
    ImGui::TableSetupColumn(name);
  }
  ImGui::TableHeadersRow();
  for (const LatencyView::Node& node : view.nodes) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(node.name.c_str());
    number_ms(node.late.median_s);
    number_ms(node.late.p99_s);
    number_ms(node.late.jitter_s);
    ImGui::TableNextColumn();
    ImGui::TextColored(colourOf(node.lock), "%s",
                       texts::latency::kLockStates[static_cast<std::size_t>(node.lock)].words());
  }
  ImGui::EndTable();
}

/// Draws a row for each wall; a driver without timer queries leaves the times empty.
void drawWalls(std::span<const WallTime> walls) {
  if (walls.empty()) return;
  if (!ImGui::BeginTable("##walls", 3, ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* name : texts::latency::kWallColumns) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  for (const WallTime& wall : walls) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(wall.wall);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(fmt::format("{:>11}", wall.triangles).c_str());
    number_ms(wall.drawn_s);
  }
  ImGui::EndTable();
}

}  // namespace

void drawLatencyNumbers(const LatencyView& view) {
  ImGui::TextUnformatted(
      texts::format(texts::latency::kNode, view.node, view.frame, view.display_hz).c_str());
  ImGui::TextUnformatted(texts::latency::kFrameLock);
  ImGui::SameLine();
  ImGui::TextColored(colourOf(view.lock), "%s",
                     texts::latency::kLockStates[static_cast<std::size_t>(view.lock)].words());
  if (!view.lockWhyNot.empty()) {
    ImGui::SameLine();
    ImGui::TextColored(kBad, "(%s)", view.lockWhyNot.c_str());
  }
  drawParts(view);
  drawNodes(view);
}

void drawLatency(const LatencyView& view, std::span<const WallTime> walls) {
  overCorner("##latency", [&] {
    drawLatencyNumbers(view);
    drawWalls(walls);
  });
}

}  // namespace carom
