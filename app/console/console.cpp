#include "app/console/console.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "app/console_parts/console_class.h"
#include "app/console_parts/console_lesson.h"
#include "app/console_parts/console_link.h"
#include "app/operator/visitor_choices.h"
#include "app/rig/rig_viewers.h"
#include "cave/texts/format.h"
#include "cave/texts/key_names.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"

namespace carom {

using namespace console;

namespace {

constexpr float kText_px = 16.0F, kHeading_px = 21.0F;
constexpr std::chrono::milliseconds kEvery(50);
constexpr int kRest = 4;  // idle time as a multiple of the drawing time
constexpr std::size_t kMostSaid = 200;
// Layout of the console's parts.
constexpr float kTop_px = 84.0F, kLeft_px = 366.0F, kSaid_px = 104.0F, kWalls_px = 250.0F, kGap_px = 8.0F;
constexpr float kButton_px = 150.0F, kButtonHigh_px = 60.0F;
// A narrow console has its buttons in a row of their own.
constexpr float kNarrow_px = 1100.0F, kRow_px = 44.0F;

void useHeadingFont() {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  ImGui::PushFont(fonts.Size > 1 ? fonts[1] : fonts[0]);
}

/// Begins a part of the console; end it with ImGui::EndChild.
void part(const char* name, const ImVec2& at, const ImVec2& size) {
  ImGui::SetCursorPos(at);
  ImGui::BeginChild(name, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
}

/// Returns the width of the buttons at the top, the same of all.
float button_px() {
  using namespace texts::console;
  const float sides_px = 2.0F * ImGui::GetStyle().FramePadding.x;
  return sides_px +
         widthOf({kHide, kNextVisitor, kKeysButton, kLightWalls, kBlackWalls}, kButton_px - sides_px);
}

/// Returns whether the names of all tabs fit in this width.
bool tabsFitIn(float width_px, bool hasLesson, const ConsoleFrame& frame) {
  using namespace texts::console;
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto take = [&](const char* tab) {
    width_px -= ImGui::CalcTextSize(tab).x + 2.0F * style.FramePadding.x + style.ItemInnerSpacing.x + 1.0F;
  };
  for (const char* tab : {kGamesTab, kTrackersTab, kLatencyTab, kEventsTab, kDiagramTab, kRecordingTab})
    take(tab);
  if (hasLesson) take(kLessonTab);
  if (frame.classroom) take(kClassTab);
  if (frame.study) take(kStudyTab);
  if (frame.status.link) take(texts::link::kTab);
  return width_px >= 0.0F;
}

}  // namespace

Console::Console(Graphics& graphics, const WindowPlacement& place, const Rig& rig, const Cluster& cluster,
                 KeysOf keys, const Scenario& scenario, const Scene& scene, bool waits)
    : window_(graphics, texts::title::kConsole.words(), place),
      keys_(keys),
      waits_(waits),
      keyMap_(keys),
      scenario_(&scenario),
      panels_{console::WallsPanel(graphics, rig, cluster),
              console::EffectsPanel(keys, namesOf(rig.viewers)),
              {},
              {},
              {},
              {}},
      clocks_(namesOf(rig.viewers)),
      diagram_(scenario, namesOf(rig.viewers)) {
  window_.listen(kText_px, kHeading_px);
  setStyle();
  if (waits) window_.setVisible(false);
  play(scenario, scene);
}

void Console::play(const Scenario& scenario, const Scene& scene) {
  opens_.lesson = scenario.lesson.has_value();
  scenario_ = &scenario;
  title_ = scenario.title;
  file_.clear();
  panels_.games.play(scenario, file_);
  panels_.walls.play(scene, scenario.billiard.lightSpeed_m_s);
  panels_.events.play(scenario);
  diagram_.play(scenario);
  say(scenario.title);
}

void Console::say(const std::string& line) { say({now_s_, line, {}}); }

void Console::say(Line line) {
  log_.lines.push_front(std::move(line));
  if (log_.lines.size() > kMostSaid) log_.lines.pop_back();
}

void Console::show(const ConsoleFrame& frame) {
  now_s_ = frame.record.display_s;
  if (const Notice& notice = frame.record.viewers.front().notice; notice != log_.latest) {
    log_.latest = notice;
    if (!notice.empty()) say({now_s_, {}, notice});
  }
  panels_.events.follow(frame.world);
  clocks_.follow(frame.record);
  diagram_.follow(frame.record);
  const bool isShown = frame.settings.console != ConsoleState::waits;
  if (isShown != window_.isVisible()) window_.setVisible(isShown);
  if (!isShown) return;
  const Clock::time_point begun = Clock::now();
  if (begun < (window_.isPressed() ? next_.earliest : next_.due) || window_.isIconified()) return;
  if (file_ != frame.settings.playing) {
    file_ = frame.settings.playing;
    panels_.games.play(*scenario_, file_);
  }
  const texts::InLanguage reads(texts::ofSession(frame.settings.languageOf[0]));
  panels_.walls.prepare(frame);
  window_.show({}, [&] { drawAll(frame); });
  window_.swap();
  next_.earliest = begun + kEvery;
  next_.due = std::max(next_.earliest, begun + (kRest + 1) * (Clock::now() - begun));
}

void Console::drawAll(const ConsoleFrame& frame) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0.0F, 0.0F});
  ImGui::Begin("##console", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const float left = kGap_px, left_px = panels_.effects.width_px(kLeft_px), right = left_px + 2 * kGap_px;
  const float width = size.x - right - kGap_px;
  const bool isNarrow = size.x < kNarrow_px + (waits_ ? button_px() + kGap_px : 0.0F);
  const float top_px = kTop_px + (isNarrow ? kRow_px : 0.0F), top = top_px + kGap_px;
  const float bottom = size.y - kSaid_px - 2 * kGap_px;
  part("##top", {0.0F, 0.0F}, {size.x, top_px});
  drawTop(frame, isNarrow);
  ImGui::EndChild();
  part("##effects", {left, top}, {left_px, size.y - kGap_px - top});
  panels_.effects.draw(frame, scenario_->billiard.lightSpeed_m_s);
  ImGui::EndChild();
  part("##walls", {right, top}, {width, kWalls_px});
  panels_.walls.draw(frame);
  ImGui::EndChild();
  float below = top + kWalls_px + kGap_px;
  if (keys_ == KeysOf::replay) {
    const float height = 2 * ImGui::GetFrameHeightWithSpacing() + 16.0F;
    part("##playing", {right, below}, {width, height});
    playing_.draw(frame);
    ImGui::EndChild();
    below += height + kGap_px;
  }
  part("##tabs", {right, below}, {width, bottom - below});
  drawTabs(frame);
  ImGui::EndChild();
  part("##said", {right, bottom + kGap_px}, {width, kSaid_px});
  drawSaid();
  ImGui::EndChild();
  drawKeys(frame.settings.languageOf[0]);
  ImGui::End();
}

void Console::drawTop(const ConsoleFrame& frame, bool isNarrow) {
  const float width = ImGui::GetContentRegionMax().x;
  const int count = (isLive(keys_) ? 3 : 2) + (waits_ ? 1 : 0);
  const float buttons = width - static_cast<float>(count) * (button_px() + kGap_px) + kGap_px;
  const ImVec2 at = ImGui::GetWindowPos();
  const float words_px = isNarrow ? width : buttons - kGap_px;
  ImGui::PushClipRect(at, {at.x + words_px, at.y + ImGui::GetWindowHeight()}, true);
  useHeadingFont();
  words(texts::other(title_));
  ImGui::PopFont();
  ImGui::SameLine(0.0F, 30.0F);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 4.0F);
  panels_.recording.drawLight(frame);
  ImGui::SameLine(0.0F, 24.0F);
  light(lightOfTrackers(frame));
  ImGui::SameLine(0.0F, 4.0F);
  words(texts::console::kTrackers);
  tip(texts::console::kTrackersTip);
  ImGui::SetCursorPosY(38.0F);
  clocks_.draw(frame, words_px - kGap_px);
  ImGui::PopClipRect();
  ImGui::SetCursorPos({isNarrow ? kGap_px : buttons, isNarrow ? kTop_px : 12.0F});
  drawButtons(frame, {button_px(), isNarrow ? kRow_px - kGap_px : kButtonHigh_px});
}

void Console::drawButtons(const ConsoleFrame& frame, const ImVec2& size) {
  if (waits_) {
    if (ImGui::Button(texts::console::kHide, size)) frame.commands.emplace_back(ShowConsole{false});
    tip(texts::console::kHideTip);
    ImGui::SameLine(0.0F, kGap_px);
  }
  if (isLive(keys_)) {
    if (ImGui::Button(texts::console::kNextVisitor, size)) frame.commands.emplace_back(WelcomeNextVisitor{});
    tip(texts::console::kNextVisitorTip);
    ImGui::SameLine(0.0F, kGap_px);
  }
  if (ImGui::Button(texts::withKeyInLayout(texts::console::kKeysButton).c_str(), size)) opens_.keys = true;
  ImGui::SameLine(0.0F, kGap_px);
  const bool blank = frame.settings.walls.blank != 0;
  ImGui::PushStyleColor(ImGuiCol_Button, blank ? kFair : ImVec4{0.42F, 0.20F, 0.19F, 1.0F});
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blank ? kFair : ImVec4{0.55F, 0.25F, 0.23F, 1.0F});
  ImGui::PushStyleColor(ImGuiCol_Text, blank ? ImVec4{0.1F, 0.1F, 0.1F, 1.0F} : kBright);
  const std::string_view black = blank ? texts::console::kLightWalls : texts::console::kBlackWalls;
  if (ImGui::Button(texts::withKeyInLayout(black).c_str(), size))
    frame.commands.emplace_back(SetWalls{&WallControls::blank, !blank});
  ImGui::PopStyleColor(3);
  tip(texts::console::kBlackTip);
}

void Console::drawTabs(const ConsoleFrame& frame) {
  constexpr ImGuiTabBarFlags kListed =
      ImGuiTabBarFlags_FittingPolicyScroll | ImGuiTabBarFlags_TabListPopupButton;
  const bool fits = tabsFitIn(ImGui::GetContentRegionAvail().x, scenario_->lesson.has_value(), frame);
  if (!ImGui::BeginTabBar("##parts", fits ? ImGuiTabBarFlags_None : kListed)) return;
  const auto tab = [](const char* name, const auto& draw, ImGuiTabItemFlags flags = 0) {
    if (!ImGui::BeginTabItem(name, nullptr, flags)) return;
    ImGui::BeginChild("##tab");
    draw();
    ImGui::EndChild();
    ImGui::EndTabItem();
  };
  // The first, so that its name fits where not all do.
  if (frame.classroom) tab(texts::console::kClassTab, [&] { drawClass(frame); });
  const bool bringsLesson = std::exchange(opens_.lesson, false) && !frame.classroom;
  if (scenario_->lesson)
    tab(
        texts::console::kLessonTab, [&] { drawLessonOf(frame); },
        bringsLesson ? ImGuiTabItemFlags_SetSelected : 0);
  if (frame.study) tab(texts::console::kStudyTab, [&] { panels_.study.draw(frame); });
  if (frame.status.link) tab(texts::link::kTab, [&] { drawLink(frame); });
  tab(texts::console::kGamesTab, [&] { panels_.games.draw(frame); });
  tab(texts::console::kTrackersTab, [&] { drawTrackers(frame); });
  tab(texts::console::kLatencyTab, [&] { drawLatencyNumbers(frame.latency); });
  tab(texts::console::kEventsTab, [&] { panels_.events.draw(frame.record); });
  tab(texts::console::kDiagramTab, [&] { drawDiagram(frame); });
  tab(texts::console::kRecordingTab, [&] { panels_.recording.draw(frame); });
  ImGui::EndTabBar();
}

void Console::drawLessonOf(const ConsoleFrame& frame) const {
  LessonCourse course{frame.record.lesson, frame.settings.lessonObserver, {}};
  if (isLive(keys_)) course.next = commandOf(Choice::lessons, frame.settings);
  drawLesson(*scenario_->lesson, course, frame.commands);
}

void Console::drawDiagram(const ConsoleFrame& frame) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  diagram_.draw(frame.record, frame.world, *ImGui::GetWindowDrawList(), {at.x, at.y}, {size.x, size.y});
}

/// Draws the log, newest line first.
void Console::drawSaid() const {
  for (const Line& line : log_.lines) {
    dim(texts::format(texts::console::kSaidAt, line.said_s));
    ImGui::SameLine();
    words(line.notice.empty() ? texts::other(line.words) : line.notice.words());
  }
}

void Console::drawKeys(std::uint8_t language) {
  constexpr const char* kName = "##keys";
  if (opens_.keys) {
    ImGui::OpenPopup(kName);
    opens_.keys = false;
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::BeginPopup(kName)) return;
  useHeadingFont();
  words(texts::console::kKeys);
  ImGui::PopFont();
  dim(texts::console::kKeysWhere);
  ImGui::Spacing();
  drawKeyTable(keyMap_.in(language));
  if (ImGui::Button(texts::console::kClose) || isKeyPressed(GLFW_KEY_ESCAPE) || isKeyPressed(GLFW_KEY_H) ||
      isKeyPressed(GLFW_KEY_F1)) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace carom
