#include "app/console/console_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/frame/clock_time.h"
#include "cave/texts/texts.h"
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
std::string shown(double time_s) { return fmt::format(texts::console::kClock, shownTime_s(time_s)); }

void goTo(const ConsoleFrame& frame, double session_s) {
  frame.commands.emplace_back(Seek{std::max(session_s, 0.0)});
}

}  // namespace

void drawClocks(const ConsoleFrame& frame) {
  const FrameRecord& record = frame.record;
  const double platform = glm::length(betaFromU(record.boardFromRoom.u()));
  const double person = glm::length(betaFromU(record.observer.headFromBoard.inverse().u()));
  clock(texts::console::kSession, shown(record.display_s), texts::console::kSessionTip);
  clock(texts::console::kProperTime, shown(record.observer.properTime_s), texts::console::kProperTimeTip);
  clock(texts::console::kTableTime, shown(record.observer.middle.observation.t_s),
        texts::console::kTableTimeTip);
  clock(texts::console::kRoomSpeed,
        platform < 1e-9 ? texts::console::kAtRest : fmt::format(texts::console::kSpeed3, platform),
        texts::console::kRoomSpeedTip);
  clock(texts::console::kObserverSpeed, fmt::format(texts::console::kSpeed2, person),
        texts::console::kObserverSpeedTip);
  clock(texts::console::kLight, fmt::format(texts::console::kLightSpeed, record.lightSpeed_m_s),
        texts::console::kLightTip);
  ImGui::NewLine();
}

void Playing::draw(const ConsoleFrame& frame) {
  const Playback& playback = frame.settings.playback;
  const double now_s = frame.record.display_s;
  if (ImGui::Button(texts::console::kBeginning)) goTo(frame, 0.0);
  tip(texts::console::kBeginningTip);
  ImGui::SameLine();
  if (ImGui::Button(texts::console::kSecondBack)) goTo(frame, now_s - kStep_s);
  ImGui::SameLine();
  if (ImGui::Button(playback.paused ? texts::console::kContinue : texts::console::kPause,
                    {5.0F * ImGui::GetFontSize(), 0.0F}))
    frame.commands.emplace_back(Pause{!playback.paused});
  tip(texts::console::kPauseTip);
  ImGui::SameLine();
  if (ImGui::Button(texts::console::kSecondOn)) goTo(frame, now_s + kStep_s);
  const auto& span_s = frame.status.span_s;
  if (span_s) {
    ImGui::SameLine();
    if (ImGui::Button(texts::console::kEnd)) goTo(frame, span_s->second);
  }
  ImGui::SameLine(0.0F, 20.0F);
  dim(texts::console::kRate);
  for (const double rate : kRates) {
    ImGui::SameLine();
    const bool chosen = std::abs(playback.rate) == rate;
    if (ImGui::RadioButton(fmt::format("{:g}", rate).c_str(), chosen))
      frame.commands.emplace_back(SetRate{std::copysign(rate, playback.rate)});
  }
  ImGui::SameLine(0.0F, 20.0F);
  bool backwards = playback.rate < 0.0;
  if (ImGui::Checkbox(texts::console::kBackwards, &backwards))
    frame.commands.emplace_back(SetRate{-playback.rate});
  if (!span_s) return;
  double place_s = now_s;
  ImGui::SetNextItemWidth(-1.0F);
  if (slider_.draw("##place", place_s, span_s->first, span_s->second, texts::console::kPlaceSlider))
    goTo(frame, place_s);
  tip(texts::console::kPlaceTip);
}

}  // namespace carom::console
