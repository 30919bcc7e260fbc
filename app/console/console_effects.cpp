#include "app/console/console_effects.h"
#include "engine/base/limits.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace carom::console {
namespace {

/// Tooltips, in the order of kNamedSwitches.
constexpr std::array<const char*, kNamedSwitches.size()> kSwitchTips{
    "Light takes its time: things are seen where they were when it left them. Off: they are drawn where they "
    "are "
    "now, and all clocks agree.",
    "What moves is shorter along its way. Off: it keeps the shape that it has at rest.",
    "Who moves sees directions swing towards where they go. Off: your own motion does not show.",
    "Light from what comes nearer is bluer, from what goes away redder, ultraviolet and infrared included. "
    "Off: "
    "surfaces keep their colours.",
    "Light from ahead is brighter for who moves. Off: brightness keeps."};

/// Tooltips, in the order of kNamedViews.
constexpr std::array<const char*, kNamedViews.size()> kViewTips{
    "Striped ghosts where things are at this moment by the board's clocks: their light is still on its way.",
    "Crossed ghosts where things are at your own moment, which is another one as soon as you move.",
    "The ways of the pucks over the cloth: gone solid, to come dashed.",
    "A numbered marker where something happened, from the moment you see it; and the light of a flash on its "
    "way.",
    "Each puck's own clock as you see it; your clock, your speed and light's.",
    "The right half of every wall without relativity, or with what is ticked under \"right\".",
    "Time stands still: walk round what you see at this moment.",
    "A metre on the cloth, with light's way along it.",
    "The angles between the ways of two pucks that met."};

constexpr float kBeside_em = 7.5F;  // width left beside a slider

void drawKey(const std::string& key) {
  if (!key.empty()) keyAtRight(key);
}

}  // namespace

EffectsPanel::EffectsPanel(KeysOf keys) : keys_(keys) {
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    const std::string name = kNamedSwitches[i].name;
    switchKeys_[i] = fmt::format("{} {}", keyFor(keys, name).keys, keyFor(keys, "beside: " + name).keys);
  }
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    views_[i] = keyFor(keys, kNamedViews[i].name);
    if (views_[i].does.empty()) views_[i].does = kNamedViews[i].name;
  }
}

void EffectsPanel::drawSwitches(const ConsoleFrame& frame) const {
  const OperatorSettings& settings = frame.settings;
  heading("Effects of relativity");
  if (!ImGui::BeginTable("switches", 4)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  for (const char* column : {"on", "right"})
    ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, 3 * em);
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 2 * em);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  dim(settings.views.split ? "left" : "on");
  ImGui::TableNextColumn();
  dim("right");
  tip("For the right half of every wall, when it is drawn otherwise (\"Newton beside Einstein\").");
  ImGui::TableNextColumn();
  dim("keys");
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    const NamedSwitch& effect = kNamedSwitches[i];
    ImGui::PushID(effect.name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    words(effect.name);
    tip(kSwitchTips[i]);
    ImGui::TableNextColumn();
    const bool on = settings.switches.*effect.value, beside = settings.views.beside.*effect.value;
    if (tick("##here", on)) frame.commands.emplace_back(SetSwitch{effect.value, false, !on});
    tip(kSwitchTips[i]);
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
  heading("Light and eyes");
  ImGui::BeginDisabled(keys_ != KeysOf::session);
  ImGui::SetNextItemWidth(-kBeside_em * ImGui::GetFontSize());
  double light_m_s = frame.settings.lightSpeed_m_s;
  if (light_.draw("##light", light_m_s, kLeastLightSpeed_m_s, kMostLightSpeed_m_s, "%.2f m/s",
                  ImGuiSliderFlags_Logarithmic)) {
    frame.commands.emplace_back(SetLightSpeed{light_m_s});
  }
  tip(fmt::format(
      "In metres of the room a second of yours (keys [ and ]). Nothing jumps: what changes is how many "
      "seconds of the game go by in one of yours. The game's own is {:.4g} m/s.",
      usual_m_s));
  ImGui::SameLine();
  words("light");
  ImGui::SameLine();
  if (ImGui::SmallButton("usual")) frame.commands.emplace_back(SetLightSpeed{usual_m_s});
  tip("As fast as the game's own.");
  double apart_mm = 1e3 * frame.settings.eyeSeparation_m;
  ImGui::SetNextItemWidth(-kBeside_em * ImGui::GetFontSize());
  if (eyes_.draw("between eyes", apart_mm, 0.0, 1e3 * kMostEyeSeparation_m, "%.1f mm")) {
    // Rounded to a tenth of a millimetre, as with the keys.
    frame.commands.emplace_back(SetEyeSeparation{std::round(10.0 * apart_mm) / 1e4});
  }
  tip("How far the person's eyes are apart (keys + and -). 0: without depth.");
  ImGui::EndDisabled();
  if (keys_ != KeysOf::session) tip("As they were when this was recorded.");
}

void EffectsPanel::drawViews(const ConsoleFrame& frame) const {
  heading("Views of time");
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    const auto view = kNamedViews[i].value;
    const bool on = frame.settings.views.*view;
    if (tick(views_[i].does.c_str(), on)) frame.commands.emplace_back(SetView{view, !on});
    tip(kViewTips[i]);
    drawKey(views_[i].keys);
  }
}

void EffectsPanel::drawWalls(const ConsoleFrame& frame) const {
  const WallControls& walls = frame.settings.walls;
  heading("Walls");
  constexpr std::array<const char*, 3> kShown{"the game", "test patterns", "seams"};
  constexpr std::array<const char*, 3> kShownTips{
      "What the person sees.",
      "A picture for each wall and eye: is it on the right wall, upright, in the right eye's colour, sharp?",
      "A grid that stands in the room and goes through the edges of the walls: do they meet?"};
  for (std::size_t i = 0; i < kShown.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    if (keys_ == KeysOf::patterns && i == 0) continue;
    if (ImGui::RadioButton(kShown[i], walls.shown == static_cast<Shown>(i)))
      frame.commands.emplace_back(ShowOnWalls{static_cast<Shown>(i)});
    tip(kShownTips[i]);
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

void EffectsPanel::draw(const ConsoleFrame& frame, double usual_m_s) {
  drawSwitches(frame);
  drawLight(frame, usual_m_s);
  drawViews(frame);
  drawWalls(frame);
}

}  // namespace carom::console
