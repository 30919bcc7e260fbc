#include "app/console/console_trackers.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

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
      return "being looked for";
    case TrackerHealth::State::delivering:
      return "delivers";
    case TrackerHealth::State::silent:
      return "silent";
    case TrackerHealth::State::failed:
      return "needs help";
  }
  return "";
}

void number(double value, const char* unit, int digits = 0) {
  ImGui::TableNextColumn();
  if (std::isfinite(value)) words(fmt::format("{:.{}f}{}", value, digits, unit));
}

struct Column {
  const char* name;
  float width_em;
  const char* tip;
};
constexpr std::array<Column, 10> kColumns{
    {{"", 1.2F, ""},
     {"tracker", 8.0F, "Its name in the rig's file."},
     {"follows", 5.0F, "What of the person it tells of."},
     {"state", 7.5F, "Whether its samples come."},
     {"rate", 5.0F, "Samples a second, of the last second."},
     {"age", 5.0F, "Of the newest sample, when the frame began."},
     {"samples", 6.0F, "That have come so far."},
     {"gaps", 4.0F, "Samples that the device numbered and that never came."},
     {"late", 4.0F, "Came after a later one, or much too late."},
     {"refused", 5.0F, "Packets that were not understood."}}};

void drawReport(const TrackerReport& report) {
  const TrackerHealth& health = report.health;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  light(colourOf(report));
  for (const char* text : {report.name.c_str(), report.use.c_str(), wordOf(health.state)}) {
    ImGui::TableNextColumn();
    words(text);
  }
  number(report.rate_hz, " Hz");
  number(1e3 * report.age_s, " ms");
  for (const std::uint64_t count : {health.samples, health.gaps, health.late, health.refused}) {
    ImGui::TableNextColumn();
    words(std::to_string(count));
  }
}

void drawHead(const TrackerReport& report) {
  if (!report.known) return;
  heading("The head, as the filter knows it");
  words(headWords(report));
  tip("measured: at a sample; predicted: a little after it; held: kept where the prediction ended, because "
      "samples are "
      "overdue or the picture is shown long after the newest one; lost: none for long. The speed turns what "
      "is seen: "
      "its uncertainty should stay below a few hundredths of light's speed.");
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
    dim(frame.keys == KeysOf::session ? "No tracker has been heard of."
                                      : "The head is a recorded one: no tracker is asked.");
    return;
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg;
  if (ImGui::BeginTable("trackers", kColumns.size(), kFlags)) {
    for (const Column& column : kColumns) {
      ImGui::TableSetupColumn(column.name, ImGuiTableColumnFlags_WidthFixed,
                              column.width_em * ImGui::GetFontSize());
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const Column& column : kColumns) {
      ImGui::TableNextColumn();
      dim(column.name);
      tip(column.tip);
    }
    for (const TrackerReport& report : frame.status.trackers) drawReport(report);
    ImGui::EndTable();
  }
  for (const TrackerReport& report : frame.status.trackers) {
    if (report.health.message.empty()) continue;
    ImGui::PushStyleColor(ImGuiCol_Text, colourOf(report));
    ImGui::TextWrapped("%s: %s", report.name.c_str(), report.health.message.c_str());
    ImGui::PopStyleColor();
  }
  for (const TrackerReport& report : frame.status.trackers) drawHead(report);
}

}  // namespace carom::console
