#include "app/console_parts/console_effects.h"
#include "cave/texts/format.h"
#include "cave/texts/key_names.h"
#include "cave/texts/language_names.h"
#include "cave/texts/texts.h"
#include "engine/base/limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace carom::console {
namespace {

constexpr float kBesideSlider_em = 7.5F;            // width left beside a slider
constexpr float kTicks_em = 3.0F, kKeys_em = 2.0F;  // columns of the effects

/// Returns the width that the words beside the sliders need.
float besideSlider_px() {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float light_px = widthOf({texts::console::kLight}, 0.0F) + widthOf({texts::console::kUsual}, 0.0F) +
                         2.0F * (style.ItemSpacing.x + style.FramePadding.x);
  const float eyes_px = widthOf({texts::console::kBetweenEyes}, 0.0F) + style.ItemInnerSpacing.x;
  return std::max({kBesideSlider_em * ImGui::GetFontSize(), light_px, eyes_px});
}

void drawKey(const std::string& key) {
  if (!key.empty()) keyAtRight(key);
}

}  // namespace

EffectsPanel::EffectsPanel(KeysOf keys, std::vector<std::string> viewers)
    : keys_(keys), viewers_(std::move(viewers)) {
  nameKeys();
}

/// Names the keys of effects and views as the keyboard has them.
void EffectsPanel::nameKeys() {
  keysNamed_ = texts::keyNames.changes();
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    const std::string name = kNamedSwitches[i].name;
    switchKeys_[i] = fmt::format("{} {}", keyFor(keys_, name).keys, keyFor(keys_, "beside: " + name).keys);
  }
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    viewKeys_[i] = keyFor(keys_, kNamedViews[i].name).keys;
  }
}

float EffectsPanel::width_px(float least_px) const {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float em = ImGui::GetFontSize(), sides_px = 2.0F * style.WindowPadding.x;
  const float box_px = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x;
  const auto keep = [&](const char* name, float beside_px) {
    least_px = std::max(least_px, sides_px + widthOf({name}, 0.0F) + beside_px);
  };
  const auto keepTicked = [&](const char* name, const std::string& key) {
    keep(name, box_px + style.ItemSpacing.x + widthOf({key.c_str()}, 0.0F));
  };
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) keepTicked(kNamedViews[i].words, viewKeys_[i]);
  const KeyLine comfort = keyFor(keys_, "comfort");  // the longest of the walls' names
  keepTicked(comfort.does.c_str(), comfort.keys);
  for (const NamedSwitch& effect : kNamedSwitches)
    keep(effect.words, 2.0F * kTicks_em * em + kKeys_em * em + 8.0F * style.CellPadding.x);
  return least_px;
}

void EffectsPanel::drawSwitches(const ConsoleFrame& frame) const {
  const OperatorSettings& settings = frame.settings;
  heading(texts::console::kEffects);
  if (!ImGui::BeginTable("##switches", 4)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("##name", ImGuiTableColumnFlags_WidthStretch);
  for (const char* column : {"##on", "##right"})
    ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, kTicks_em * em);
  ImGui::TableSetupColumn("##keys", ImGuiTableColumnFlags_WidthFixed, kKeys_em * em);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  dim(settings.views.split ? texts::console::kLeft : texts::console::kOn);
  ImGui::TableNextColumn();
  dim(texts::console::kRight);
  tip(texts::console::kRightTip);
  ImGui::TableNextColumn();
  dim(texts::console::kKeyColumn);
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    const NamedSwitch& effect = kNamedSwitches[i];
    ImGui::PushID(effect.name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    words(effect.words);
    tip(effect.tip);
    ImGui::TableNextColumn();
    const bool on = settings.switches.*effect.value, beside = settings.views.beside.*effect.value;
    if (tick("##here", on)) frame.commands.emplace_back(SetSwitch{effect.value, false, !on});
    tip(effect.tip);
    ImGui::TableNextColumn();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, settings.views.split ? 1.0F : 0.45F);
    if (tick("##beside", beside)) frame.commands.emplace_back(SetSwitch{effect.value, true, !beside});
    ImGui::PopStyleVar();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    dim(switchKeys_[i]);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void EffectsPanel::drawLight(const ConsoleFrame& frame, double usual_m_s) {
  heading(texts::console::kLightAndEyes);
  ImGui::BeginDisabled(!isLive(keys_));
  ImGui::SetNextItemWidth(-besideSlider_px());
  double light_m_s = frame.settings.lightSpeed_m_s;
  if (light_.draw("##light", light_m_s, kLeastLightSpeed_m_s, kMostLightSpeed_m_s,
                  texts::console::kLightSlider, ImGuiSliderFlags_Logarithmic)) {
    frame.commands.emplace_back(SetLightSpeed{light_m_s});
  }
  tip(texts::format(texts::console::kLightSliderTip, usual_m_s));
  ImGui::SameLine();
  words(texts::console::kLight);
  ImGui::SameLine();
  if (ImGui::SmallButton(texts::console::kUsual)) frame.commands.emplace_back(SetLightSpeed{usual_m_s});
  tip(texts::console::kUsualTip);
  double apart_mm = 1e3 * frame.settings.eyeSeparation_m;
  ImGui::SetNextItemWidth(-besideSlider_px());
  if (eyes_.draw(texts::console::kBetweenEyes, apart_mm, 0.0, 1e3 * kMostEyeSeparation_m,
                 texts::console::kEyesSlider)) {
    // Rounded to a tenth of a millimetre, as with the keys.
    frame.commands.emplace_back(SetEyeSeparation{std::round(10.0 * apart_mm) / 1e4});
  }
  tip(texts::console::kBetweenEyesTip);
  ImGui::EndDisabled();
  if (!isLive(keys_)) tip(texts::console::kRecordedTip);
}

void EffectsPanel::drawViews(const ConsoleFrame& frame) const {
  heading(texts::console::kViews);
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    const NamedView& view = kNamedViews[i];
    const bool on = frame.settings.views.*view.value;
    if (tick(view.words, on)) frame.commands.emplace_back(SetView{view.value, !on});
    tip(view.tip);
    drawKey(viewKeys_[i]);
  }
}

void EffectsPanel::drawWalls(const ConsoleFrame& frame) const {
  const WallControls& walls = frame.settings.walls;
  heading(texts::console::kWalls);
  for (std::size_t i = 0; i < texts::console::kShown.size(); ++i) {
    const float width_px = ImGui::GetFrameHeight() + widthOf({texts::console::kShown[i]}, 0.0F);
    if (i > 0) sameLineFor(ImGui::GetStyle().ItemInnerSpacing.x + width_px);
    if (keys_ == KeysOf::patterns && i == 0) continue;
    if (ImGui::RadioButton(texts::console::kShown[i], walls.shown == static_cast<Shown>(i)))
      frame.commands.emplace_back(ShowOnWalls{static_cast<Shown>(i)});
    tip(texts::console::kShownTips[i]);
  }
  drawKey(keyFor(keys_, "shown").keys);
  using Box = std::pair<std::uint8_t WallControls::*, const char*>;
  for (const auto& [value, what] :
       {Box{&WallControls::eyesSwapped, "eyes"}, Box{&WallControls::trackerCross, "tracker cross"},
        Box{&WallControls::latency, "latency"}, Box{&WallControls::comfort, "comfort"}}) {
    const KeyLine key = keyFor(keys_, what);
    if (key.does.empty()) continue;  // not available in this kind of session
    const bool on = walls.*value;
    if (tick(key.does.c_str(), on)) frame.commands.emplace_back(SetWalls{value, !on});
    drawKey(key.keys);
  }
}

/// Draws, for each viewer, a choice of the session's languages, if there are several.
void EffectsPanel::drawLanguages(const ConsoleFrame& frame) const {
  const SessionLanguages* const languages = frame.settings.languages.get();
  if (!isLive(keys_) || !languages || languages->all.size() < 2) return;
  const auto viewers = static_cast<std::size_t>(frame.record.viewerCount);
  for (std::size_t viewer = 0; viewer < viewers; ++viewer) {
    if (viewers == 1) {
      heading(texts::console::kLanguage);
    } else {
      heading(texts::format(texts::console::kLanguageOf, viewers_.at(viewer)).c_str());
    }
    if (viewer == 0) drawKey("F9");
    ImGui::PushID(static_cast<int>(viewer));
    for (std::size_t i = 0; i < languages->all.size(); ++i) {
      const auto language = static_cast<std::uint8_t>(i);
      if (i > 0) ImGui::SameLine();
      if (ImGui::RadioButton(texts::ownNameOf(languages->all[i]).c_str(),
                             frame.settings.languageOf[viewer] == language))
        frame.commands.emplace_back(SetLanguage{viewer, language});
    }
    ImGui::PopID();
  }
}

void EffectsPanel::draw(const ConsoleFrame& frame, double usual_m_s) {
  if (keysNamed_ != texts::keyNames.changes()) nameKeys();
  drawSwitches(frame);
  drawLight(frame, usual_m_s);
  drawViews(frame);
  drawWalls(frame);
  drawLanguages(frame);
}

}  // namespace carom::console
