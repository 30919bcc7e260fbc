#include "cave/gl/gui.h"

#include <vtk_glew.h>

#include <imgui.h>
// Include this in no other folder: its OpenGL loader conflicts with GLEW.
#include <backends/imgui_impl_opengl3.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

#include "cave/gl/glyph_bitmap.h"

namespace carom {
namespace {

constexpr std::size_t kMostHeard = 256;
const ImVec2 kNowhere{-1e9F, -1e9F};

struct KeyMeaning {
  ImGuiKey meaning;
  unsigned key;  // of GLFW
};
constexpr std::array<KeyMeaning, 15> kKeys{{{ImGuiKey_Tab, GLFW_KEY_TAB},
                                            {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                            {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                            {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                            {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                            {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                            {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                            {ImGuiKey_Home, GLFW_KEY_HOME},
                                            {ImGuiKey_End, GLFW_KEY_END},
                                            {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                            {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                            {ImGuiKey_Space, GLFW_KEY_SPACE},
                                            {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                            {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                            {ImGuiKey_A, GLFW_KEY_A}}};

#if IMGUI_VERSION_NUM >= 18700  // of Debian 13

void nameKeys(ImGuiIO& /*io*/) {}

void pressKey(ImGuiIO& io, unsigned key, bool down) {
  for (const KeyMeaning& known : kKeys) {
    if (known.key == key) io.AddKeyEvent(known.meaning, down);
  }
}

void holdModifiers(ImGuiIO& io, bool control, bool shift, bool alt) {
  io.AddKeyEvent(ImGuiMod_Ctrl, control);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
}

#else  // of Debian 12

void nameKeys(ImGuiIO& io) {
  for (const KeyMeaning& known : kKeys) io.KeyMap[known.meaning] = static_cast<int>(known.key);
}

void pressKey(ImGuiIO& io, unsigned key, bool down) { io.KeysDown[key] = down; }

void holdModifiers(ImGuiIO& io, bool control, bool shift, bool alt) {
  io.KeyCtrl = control;
  io.KeyShift = shift;
  io.KeyAlt = alt;
}

#endif

/// European and Greek letters, raised and lowered digits, arrows and the signs of mathematics.
constexpr ImWchar kLetters[] = {0x20,   0x24F,  0x370,  0x3FF,  0x2010, 0x209C, 0x2100,
                                0x214F, 0x2190, 0x22FF, 0x2713, 0x2713, 0};

/// The ranges of more letters, of each font of the chain behind the first. Dear ImGui reads them when it
/// draws the letters, at the first frame.
using Ranges = std::vector<ImWchar>;
std::vector<Ranges>& moreLetters() {
  static std::vector<Ranges> ranges;
  return ranges;
}

bool isInEveryFont(char32_t letter) {
  for (std::size_t i = 0; kLetters[i] != 0; i += 2) {
    if (letter >= kLetters[i] && letter <= kLetters[i + 1]) return true;
  }
  return letter < kLetters[0];
}

void addFonts(ImFontAtlas& atlas, float height_px) {
  if (!std::filesystem::exists(kLettersFile)) return;
  atlas.AddFontFromFileTTF(kLettersFile, height_px, nullptr, kLetters);
  for (std::size_t i = 0; i < moreLetters().size(); ++i) {
    const Ranges& ranges = moreLetters()[i];
    if (ranges.empty()) continue;
    ImFontConfig merged;
    merged.MergeMode = true;
    atlas.AddFontFromFileTTF(letterFonts()[i].file, height_px, &merged, ranges.data());
  }
}

}  // namespace

void Gui::setLetters(std::u32string_view letters) {
  std::vector<Ranges>& all = moreLetters();
  all.assign(letterFonts().size(), {});
  std::u32string sorted(letters);
  std::sort(sorted.begin(), sorted.end());
  for (const char32_t letter : sorted) {
    const std::optional<std::size_t> font = isInEveryFont(letter) ? std::nullopt : fontOf(letter);
    if (!font || letter > std::numeric_limits<ImWchar>::max()) continue;
    Ranges& ranges = all[*font];
    const auto sign = static_cast<ImWchar>(letter);
    if (ranges.empty() || ranges.back() + 1 < sign) {
      ranges.insert(ranges.end(), {sign, sign});
    } else {
      ranges.back() = sign;
    }
  }
  for (Ranges& ranges : all) {
    if (!ranges.empty()) ranges.push_back(0);
  }
}

Gui::Gui(float text_px, float heading_px) : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // no settings are saved
  io.LogFilename = nullptr;
  for (const float height_px : {text_px, heading_px}) {
    if (height_px > 0.0F) addFonts(*io.Fonts, height_px);
  }
  io.UserData = this;
  nameKeys(io);
  io.MousePos = kNowhere;
  events_.reserve(kMostHeard);
  ImGui::StyleColorsDark();
  ImGui_ImplOpenGL3_Init("#version 150");
}

Gui::~Gui() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Gui::hear(const GuiEvent& heard) {
  const auto points = [](const GuiEvent& any) { return any.kind == GuiEvent::Kind::pointer; };
  if (!events_.empty() && points(heard) && points(events_.back())) {  // only the latest place counts
    events_.back() = heard;
    return;
  }
  if (events_.size() == kMostHeard) events_.clear();  // nothing has read the input
  events_.push_back(heard);
}

bool Gui::isPressed() const {
  return took_ || std::any_of(events_.begin(), events_.end(),
                              [](const GuiEvent& heard) { return heard.kind != GuiEvent::Kind::pointer; });
}

void Gui::takeHeard() {
  using Kind = GuiEvent::Kind;
  ImGuiIO& io = ImGui::GetIO();
  pressedKey_.reset();
  bool changed = false, moved = false;  // a button or a key has changed; the pointer has come elsewhere
  const auto waits = [&](const GuiEvent& heard) {
    if (heard.kind == Kind::wheel || heard.kind == Kind::letter) return false;
    if (changed || (moved && heard.kind == Kind::button && heard.down)) return true;
    changed = heard.kind != Kind::pointer;
    moved = moved || heard.kind == Kind::pointer;
    return false;
  };
  const auto end = std::find_if(events_.begin(), events_.end(), waits);
  for (auto heard = events_.begin(); heard != end; ++heard) {
    switch (heard->kind) {
      case Kind::pointer:
        io.MousePos = {heard->at.x, heard->at.y};
        break;
      case Kind::button:
        io.MouseDown[heard->code] = heard->down;
        break;
      case Kind::wheel:
        io.MouseWheelH += heard->at.x;
        io.MouseWheel += heard->at.y;
        break;
      case Kind::key:
        keysDown_[heard->code] = heard->down;
        if (heard->down) pressedKey_ = heard->code;
        pressKey(io, heard->code, heard->down);
        break;
      case Kind::letter:
        io.AddInputCharacter(heard->code);
        break;
    }
  }
  took_ = std::any_of(events_.begin(), end,
                      [](const GuiEvent& heard) { return heard.kind != GuiEvent::Kind::pointer; });
  events_.erase(events_.begin(), end);
  holdModifiers(io, keysDown_[GLFW_KEY_LEFT_CONTROL] || keysDown_[GLFW_KEY_RIGHT_CONTROL],
                keysDown_[GLFW_KEY_LEFT_SHIFT] || keysDown_[GLFW_KEY_RIGHT_SHIFT],
                keysDown_[GLFW_KEY_LEFT_ALT] || keysDown_[GLFW_KEY_RIGHT_ALT]);
}

void Gui::claim() {
  const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  static_cast<Gui*>(ImGui::GetIO().UserData)
      ->claims_.push_back({{from.x, from.y}, {from.x + size.x, from.y + size.y}});
}

bool Gui::isClaimed(const glm::vec2& at_px) const {
  return std::any_of(claims_.begin(), claims_.end(), [&](const Claim& claim) {
    return at_px.x >= claim.from_px.x && at_px.y >= claim.from_px.y && at_px.x < claim.to_px.x &&
           at_px.y < claim.to_px.y;
  });
}

void Gui::begin(const glm::ivec2& window_px) {
  claims_.clear();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(window_px.x), static_cast<float>(window_px.y)};
  const auto now = std::chrono::steady_clock::now();
  io.DeltaTime = std::max(1e-4F, std::chrono::duration<float>(now - begun_).count());
  begun_ = now;
  takeHeard();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Gui::end() {
  wantsKeys_ = ImGui::GetIO().WantCaptureKeyboard || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  ImGui::Render();
  // Mesa 22.3's llvmpipe paints some rectangles with the places in their pictures as colours, on a fast path
  // for windows without depth; it does not take that path while pixels are counted.
  glBeginQuery(GL_SAMPLES_PASSED, drawn_);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glEndQuery(GL_SAMPLES_PASSED);
}

bool isKeyPressed(int key) {
  return static_cast<const Gui*>(ImGui::GetIO().UserData)->pressedKey() == static_cast<unsigned>(key);
}

bool isTilePressed(const char* name) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x - 8.0F, size.y - 8.0F}, ImGuiCond_Always, {1.0F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{18.0F, 10.0F});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize);
  const bool isPressed = ImGui::Button(name);
  Gui::claim();
  ImGui::End();
  ImGui::PopStyleVar(2);
  return isPressed;
}

bool isSheetPressed(const char* name, const std::function<void()>& draw) {
  ImGui::SetNextWindowPos({8.0F, 8.0F});
  ImGui::SetNextWindowBgAlpha(1.0F);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize);
  draw();
  const bool isPressed = ImGui::IsWindowHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  Gui::claim();
  ImGui::End();
  return isPressed;
}

void overCorner(const char* name, const std::function<void()>& draw) {
  ImGui::SetNextWindowPos({8.0F, 8.0F});
  ImGui::SetNextWindowBgAlpha(0.8F);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize);
  draw();
  ImGui::End();
}

}  // namespace carom
