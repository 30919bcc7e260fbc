#include "app/console_parts/console_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/frame/clock_time.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"
#include "engine/spacetime/lorentz.h"

namespace carom::console {
namespace {

constexpr double kStep_s = 1.0;
constexpr std::array<double, 5> kRates{0.25, 0.5, 1.0, 2.0, 4.0};

constexpr float kBeside_px = 6.0F, kApart_px = 24.0F;

/// Draws clocks beside one another, and below where there is no room.
class Clocks {
 public:
  explicit Clocks(float width_px) : width_px_(width_px) {}

  void draw(const char* name, const std::string& value, const char* meaning) {
    const float clock_px = ImGui::CalcTextSize(name).x + kBeside_px + ImGui::CalcTextSize(value.c_str()).x;
    if (drawn_px_ > 0.0F && drawn_px_ + kApart_px + clock_px <= width_px_) {
      ImGui::SameLine(0.0F, kApart_px);
      drawn_px_ += kApart_px;
    } else {
      drawn_px_ = 0.0F;
    }
    drawn_px_ += clock_px;
    ImGui::BeginGroup();
    dim(name);
    ImGui::SameLine(0.0F, kBeside_px);
    words(value);
    ImGui::EndGroup();
    tip(meaning);
  }

 private:
  float width_px_, drawn_px_ = 0.0F;
};

/// Formats a time as the clocks in the room do.
std::string shown(double time_s) { return texts::format(texts::console::kClock, shownTime_s(time_s)); }

void goTo(const ConsoleFrame& frame, double session_s) {
  frame.commands.emplace_back(Seek{std::max(session_s, 0.0)});
}

}  // namespace

void SessionClocks::follow(const FrameRecord& record) {
  constexpr double kMean_s = 0.5;
  const double past_s = record.display_s - from_.display_s;
  if (past_s >= 0.0 && past_s < kMean_s) return;
  for (std::size_t i = 0; i < record.viewerCount; ++i) {
    const double own_s = record.viewers[i].observer.properTime_s;
    paces_[i] = past_s > 0.0 ? (own_s - from_.own_s[i]) / past_s : 0.0;
    from_.own_s[i] = own_s;
  }
  from_.display_s = record.display_s;
}

void SessionClocks::draw(const ConsoleFrame& frame, float width_px) const {
  Clocks clocks(width_px);
  const FrameRecord& record = frame.record;
  const double platform = glm::length(betaFromU(record.boardFromRoom.u()));
  const double person = glm::length(betaFromU(record.viewers.front().observer.headFromBoard.inverse().u()));
  clocks.draw(texts::console::kSession, shown(record.display_s), texts::console::kSessionTip);
  if (record.viewerCount == 1)
    clocks.draw(texts::console::kProperTime, shown(record.viewers.front().observer.properTime_s),
                texts::console::kProperTimeTip);
  for (std::size_t i = 0;
       i < std::min<std::size_t>(record.viewerCount, viewers_.size()) && record.viewerCount > 1; ++i)
    clocks.draw(viewers_[i].c_str(),
                texts::format(texts::console::kOwnTimeAndPace, shown(record.viewers[i].observer.properTime_s),
                              paces_[i]),
                texts::console::kOwnTimeTip);
  clocks.draw(texts::console::kTableTime, shown(record.viewers.front().observer.middle.observation.t_s),
              texts::console::kTableTimeTip);
  clocks.draw(
      texts::console::kRoomSpeed,
      platform < 1e-9 ? texts::console::kAtRest.words() : texts::format(texts::console::kSpeed3, platform),
      texts::console::kRoomSpeedTip);
  clocks.draw(texts::console::kObserverSpeed, texts::format(texts::console::kSpeed2, person),
              texts::console::kObserverSpeedTip);
  clocks.draw(texts::console::kLight, texts::format(texts::console::kLightSpeed, record.lightSpeed_m_s),
              texts::console::kLightTip);
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
