#include "app/console/console_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/frame/clock_time.h"
#include "engine/spacetime/lorentz.h"

namespace carom::console {
namespace {

constexpr double kStep_s = 1.0;
constexpr std::array<double, 5> kRates{0.25, 0.5, 1.0, 2.0, 4.0};

void clock(const char* name, const std::string& value, const char* meaning) {
  ImGui::BeginGroup();
  dim(name);
  ImGui::SameLine(0.0F, 6.0F);
  words(value);
  ImGui::EndGroup();
  tip(meaning);
  ImGui::SameLine(0.0F, 24.0F);
}

/// Formats a time as the clocks in the room do.
std::string shown(double time_s) { return fmt::format("{:7.1f} s", shownTime_s(time_s)); }

void goTo(const ConsoleFrame& frame, double session_s) {
  frame.commands.emplace_back(Seek{std::max(session_s, 0.0)});
}

}  // namespace

void drawClocks(const ConsoleFrame& frame) {
  const FrameRecord& record = frame.record;
  const double platform = glm::length(betaFromU(record.boardFromRoom.u()));
  const double person = glm::length(betaFromU(record.observer.headFromBoard.inverse().u()));
  clock("session", shown(record.display_s), "Since the session began, by the clock on the wall.");
  clock("observer's proper time", shown(record.observer.properTime_s),
        "What the observer's own clock shows.");
  clock("table time", shown(record.observer.middle.observation.t_s),
        "What the table's clocks show where the observer is. It runs ahead of the observer's proper time "
        "while they move.");
  clock("room speed", platform < 1e-9 ? "at rest" : fmt::format("{:.3f} c", platform),
        "Speed of the room relative to the table.");
  clock("observer's speed", fmt::format("{:.2f} c", person),
        "Speed of the observer relative to the table, the room's motion included.");
  clock("light", fmt::format("{:.2f} m/s", record.lightSpeed_m_s), "The speed of light.");
  ImGui::NewLine();
}

void Playing::draw(const ConsoleFrame& frame) {
  const Playback& playback = frame.settings.playback;
  const double now_s = frame.record.display_s;
  if (ImGui::Button("Beginning")) goTo(frame, 0.0);
  tip("From the beginning (Home).");
  ImGui::SameLine();
  if (ImGui::Button("- 1 s")) goTo(frame, now_s - kStep_s);
  ImGui::SameLine();
  if (ImGui::Button(playback.paused ? "Continue" : "Pause", {5.0F * ImGui::GetFontSize(), 0.0F}))
    frame.commands.emplace_back(Pause{!playback.paused});
  tip("Space does the same.");
  ImGui::SameLine();
  if (ImGui::Button("+ 1 s")) goTo(frame, now_s + kStep_s);
  const auto& span_s = frame.status.span_s;
  if (span_s) {
    ImGui::SameLine();
    if (ImGui::Button("End")) goTo(frame, span_s->second);
  }
  ImGui::SameLine(0.0F, 20.0F);
  dim("speed");
  for (const double rate : kRates) {
    ImGui::SameLine();
    const bool chosen = std::abs(playback.rate) == rate;
    if (ImGui::RadioButton(fmt::format("{:g}", rate).c_str(), chosen))
      frame.commands.emplace_back(SetRate{std::copysign(rate, playback.rate)});
  }
  ImGui::SameLine(0.0F, 20.0F);
  bool backwards = playback.rate < 0.0;
  if (ImGui::Checkbox("backwards", &backwards)) frame.commands.emplace_back(SetRate{-playback.rate});
  if (!span_s) return;
  double place_s = now_s;
  ImGui::SetNextItemWidth(-1.0F);
  if (slider_.draw("##place", place_s, span_s->first, span_s->second, "%.2f s")) goTo(frame, place_s);
  tip("Drag to where you want to be in the session.");
}

}  // namespace carom::console
