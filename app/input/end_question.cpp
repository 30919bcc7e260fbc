#include "app/input/end_question.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "cave/gl/gui.h"
#include "cave/texts/texts.h"
#include "engine/text/log.h"

namespace carom {

void EndQuestion::take(const KeyInput& key, Clock::time_point now) {
  if (!key.pressed) return;
  if (key.key != GLFW_KEY_ESCAPE && key.key != GLFW_KEY_Q) return asked_.reset();
  ends_ = ends_ || asked_.has_value();
  if (!asked_) log::note(texts::ending::kAgain.english());
  asked_ = now;
}

bool EndQuestion::take(const WindowInput& input, Clock::time_point now) {
  for (const KeyInput& key : input.keys) take(key, now);
  if (asked_ && now - *asked_ >= kStands) asked_.reset();
  return ends_ || input.closeRequested;
}

void EndQuestion::draw() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{24.0F, 18.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{22.0F, 12.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{16.0F, 14.0F});
  ImGui::Begin("##end", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::SetWindowFocus();  // above the console's own parts
  ImGui::TextUnformatted(texts::ending::kAgain);
  if (ImGui::Button(texts::ending::kEnd)) ends_ = true;
  ImGui::SameLine();
  if (ImGui::Button(texts::ending::kGoOn)) asked_.reset();
  Gui::claim();
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace carom
