#include "app/console_parts/console_trackers.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

const ImVec4& colourOf(const TrackerReport& report) {
  switch (lampOf(report)) {
    case TrackerLamp::well:
      break;
    case TrackerLamp::doubtful:
      return kFair;
    case TrackerLamp::bad:
      return kBad;
  }
  return kGood;
}

const char* wordOf(TrackerHealth::State state) {
  switch (state) {
    case TrackerHealth::State::connecting:
      return texts::console::kConnecting;
    case TrackerHealth::State::untouched:
      return texts::console::kUntouched;
    case TrackerHealth::State::delivering:
      return texts::console::kDelivering;
    case TrackerHealth::State::silent:
      return texts::console::kSilent;
    case TrackerHealth::State::failed:
      return texts::console::kFailed;
  }
  return "";
}

void number(texts::CheckedText<double> format, double value) {
  ImGui::TableNextColumn();
  if (std::isfinite(value)) words(texts::format(format, value));
}

void drawReport(const TrackerReport& report) {
  const TrackerHealth& health = report.health;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  light(colourOf(report));
  for (const char* text : {report.name.c_str(), report.use.c_str(), wordOf(health.state)}) {
    ImGui::TableNextColumn();
    words(text);
  }
  number(texts::console::kHertz, report.rate_hz);
  number(texts::console::kMilliseconds, 1e3 * report.age_s);
  for (const std::uint64_t count : {health.samples, health.gaps, health.late, health.refused}) {
    ImGui::TableNextColumn();
    words(std::to_string(count));
  }
}

/// `several`: the heads of several people are tracked.
void drawHead(const TrackerReport& report, bool several) {
  if (!report.known) return;
  heading(several ? fmt::format("{} ({})", texts::console::kHeadFilter, report.use).c_str()
                  : texts::console::kHeadFilter);
  words(headWords(report));
  tip(texts::console::kHeadFilterTip);
}

}  // namespace

const ImVec4& lightOfTrackers(const ConsoleFrame& frame) {
  const ImVec4* worst = &kGood;
  for (const TrackerReport& report : frame.status.trackers) {
    const ImVec4& colour = colourOf(report);
    if (&colour == &kBad || (&colour == &kFair && worst == &kGood)) worst = &colour;
  }
  return frame.status.trackers.empty() ? kDim : *worst;
}

void drawTrackers(const ConsoleFrame& frame) {
  if (frame.status.trackers.empty()) {
    dim(isLive(frame.keys) ? texts::console::kNoTracker : texts::console::kRecordedHead);
    return;
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg;
  constexpr float kLightWidth_em = 1.2F;
  constexpr std::array<float, texts::console::kTrackerColumns.size()> kWidths_em{8.0F, 5.0F, 7.5F, 5.0F, 5.0F,
                                                                                 6.0F, 4.0F, 4.0F, 5.0F};
  if (ImGui::BeginTable("##trackers", 1 + static_cast<int>(kWidths_em.size()), kFlags)) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, kLightWidth_em * ImGui::GetFontSize());
    for (std::size_t i = 0; i < kWidths_em.size(); ++i) {
      ImGui::TableSetupColumn(texts::console::kTrackerColumns[i], ImGuiTableColumnFlags_WidthFixed,
                              kWidths_em[i] * ImGui::GetFontSize());
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < kWidths_em.size(); ++i) {
      ImGui::TableNextColumn();
      dim(texts::console::kTrackerColumns[i]);
      tip(texts::console::kTrackerColumnTips[i]);
    }
    for (const TrackerReport& report : frame.status.trackers) drawReport(report);
    ImGui::EndTable();
  }
  for (const TrackerReport& report : frame.status.trackers) {
    if (report.health.message.empty()) continue;
    ImGui::PushStyleColor(ImGuiCol_Text, colourOf(report));
    ImGui::TextWrapped(
        "%s", texts::format(texts::console::kTrackerMessage, report.name, report.health.message).c_str());
    ImGui::PopStyleColor();
  }
  for (const TrackerReport& report : frame.status.trackers) drawHead(report, frame.record.viewerCount > 1);
}

}  // namespace carom::console
