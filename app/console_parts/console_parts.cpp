#include "app/console_parts/console_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

constexpr float kTipWidth_em = 26.0F;

ImVec4 shade(float grey) { return {0.92F * grey, 0.97F * grey, 1.08F * grey, 1.0F}; }

}  // namespace

void setStyle() {
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {12.0F, 10.0F};
  style.FramePadding = {8.0F, 3.0F};
  style.ItemSpacing = {8.0F, 4.0F};
  style.CellPadding = {6.0F, 3.0F};
  style.WindowRounding = 0.0F;
  style.ChildRounding = style.PopupRounding = 6.0F;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 4.0F;
  style.WindowBorderSize = style.ChildBorderSize = 0.0F;
  style.FrameBorderSize = 1.0F;
  style.ItemInnerSpacing = {8.0F, 4.0F};
  style.ScrollbarSize = 12.0F;
  ImVec4* colours = style.Colors;
  colours[ImGuiCol_Text] = kBright;
  colours[ImGuiCol_TextDisabled] = kDim;
  colours[ImGuiCol_WindowBg] = shade(0.10F);
  colours[ImGuiCol_ChildBg] = shade(0.135F);
  colours[ImGuiCol_PopupBg] = shade(0.17F);
  colours[ImGuiCol_FrameBg] = shade(0.21F);
  colours[ImGuiCol_FrameBgHovered] = colours[ImGuiCol_FrameBgActive] = shade(0.27F);
  colours[ImGuiCol_Button] = shade(0.24F);
  colours[ImGuiCol_ButtonHovered] = shade(0.31F);
  colours[ImGuiCol_ButtonActive] = shade(0.38F);
  colours[ImGuiCol_CheckMark] = colours[ImGuiCol_SliderGrab] = colours[ImGuiCol_SliderGrabActive] = kAccent;
  colours[ImGuiCol_Tab] = colours[ImGuiCol_TabUnfocused] = shade(0.17F);
  colours[ImGuiCol_TabHovered] = shade(0.31F);
  colours[ImGuiCol_TabActive] = colours[ImGuiCol_TabUnfocusedActive] = {0.18F, 0.34F, 0.46F, 1.0F};
  colours[ImGuiCol_Header] = {0.18F, 0.34F, 0.46F, 1.0F};
  colours[ImGuiCol_HeaderHovered] = colours[ImGuiCol_HeaderActive] = {0.22F, 0.40F, 0.53F, 1.0F};
  colours[ImGuiCol_TableHeaderBg] = shade(0.18F);
  colours[ImGuiCol_TableRowBgAlt] = shade(0.16F);
  colours[ImGuiCol_Border] = colours[ImGuiCol_Separator] = shade(0.30F);
}

void heading(const char* words) {
  ImGui::Dummy({0.0F, 2.0F});
  ImGui::TextColored(kAccent, "%s", words);
  ImGui::Separator();
}

void words(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void dim(std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, kDim);
  words(text);
  ImGui::PopStyleColor();
}

void tip(std::string_view text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTipWidth_em * ImGui::GetFontSize());
  words(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void light(const ImVec4& colour) {
  const float em = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({em, em});
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + em / 2, at.y + em / 2 + 1.0F}, 0.34F * em,
                                              ImGui::GetColorU32(colour));
}

void keyAtRight(std::string_view key) {
  const float width = ImGui::CalcTextSize(key.data(), key.data() + key.size()).x;
  ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width, ImGui::GetCursorPosX()));
  dim(key);
}

float widthOf(std::initializer_list<const char*> words, float least_px) {
  for (const char* each : words) least_px = std::max(least_px, ImGui::CalcTextSize(each).x);
  return least_px;
}

void sameLineFor(float width_px) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width_px) ImGui::NewLine();
}

void seconds(double value_s) { words(texts::format(texts::console::kSeconds, value_s)); }

bool tick(const char* label, bool on) { return ImGui::Checkbox(label, &on); }

bool PatientSlider::draw(const char* label, double& value, double least, double most, const char* format,
                         ImGuiSliderFlags flags) {
  if (!isHeld_) held_ = static_cast<float>(value);
  ImGui::SliderFloat(label, &held_, static_cast<float>(least), static_cast<float>(most), format,
                     flags | ImGuiSliderFlags_AlwaysClamp);
  isHeld_ = ImGui::IsItemActive();
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  value = std::clamp(static_cast<double>(held_), least, most);
  return true;
}

}  // namespace carom::console
