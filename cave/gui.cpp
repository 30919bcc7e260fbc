#include "cave/gui.h"

#include <imgui.h>
// Of this folder alone: its loader of OpenGL must not meet GLEW's.
#include <backends/imgui_impl_opengl3.h>

#include <filesystem>

namespace carom {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";  // fonts-dejavu-core

/// Letters of Europe and Greek ones.
constexpr ImWchar kLetters[] = {0x20, 0x24F, 0x370, 0x3FF, 0x2010, 0x205E, 0x2190, 0x21FF, 0};

}  // namespace

Gui::Gui(float text_px) : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is kept
  io.LogFilename = nullptr;
  if (std::filesystem::exists(kFont)) io.Fonts->AddFontFromFileTTF(kFont, text_px, nullptr, kLetters);
  ImGui::StyleColorsDark();
  ImGui_ImplOpenGL3_Init("#version 150");
}

Gui::~Gui() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Gui::begin(const glm::ivec2& window_px) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().DisplaySize = {static_cast<float>(window_px.x), static_cast<float>(window_px.y)};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Gui::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace carom
