#include "app/console_parts/console_class.h"

#include <array>
#include <numeric>

#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

void drawJoining(const ClassInvitation& invitation) {
  heading(texts::console::kClassJoin);
  words(invitation.address);
  words(texts::format(texts::classroom::kRoom, invitation.word));
  heading(texts::console::kClassTeacher);
  words(texts::format(texts::console::kClassPage, invitation.address));
  words(texts::format(texts::console::kClassPin, invitation.pin));
  tip(texts::console::kClassTeacherTip);
}

/// Draws how often each answer was given, vote beside vote, once that may be seen.
void drawCounts(const ClassView& view) {
  constexpr float kColumn_em = 7.0F;
  const auto isShown = [&](std::size_t vote) {
    return std::accumulate(view.counts[vote].begin(), view.counts[vote].end(), std::uint64_t{0}) > 0;
  };
  if (!isShown(0) && !isShown(1)) return;
  for (std::size_t answer = 0; answer < view.choices; ++answer) {
    words(kAnswerNumbers.at(answer));
    for (std::size_t vote = 0; vote < kVotes; ++vote) {
      if (!isShown(vote)) continue;
      ImGui::SameLine(kColumn_em * ImGui::GetFontSize() * static_cast<float>(vote + 1));
      words(texts::format(texts::console::kClassCounted, texts::classroom::kVotes.at(vote),
                          view.counts[vote][answer]));
    }
    if (view.right == answer + 1) {
      ImGui::SameLine();
      words(texts::classroom::kRight);
    }
  }
}

}  // namespace

void drawClass(const ConsoleFrame& frame) {
  ClassDesk& desk = *frame.classroom;
  const ClassView& view = frame.record.classroom;
  ClassFlow flow;
  flow.resume(view.phase, view.round);
  heading(nameOf(view.phase, view.round).c_str());
  words(texts::format(texts::console::kClassCount, view.phones, view.answered));
  const ImGuiStyle& style = ImGui::GetStyle();
  const float right_px = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const auto widthOf = [&](std::size_t step) {
    return ImGui::CalcTextSize(texts::phone::kSteps.at(step)).x + 2.0F * style.FramePadding.x;
  };
  for (std::size_t i = 0; i < kClassSteps.size(); ++i) {
    const auto step = static_cast<ClassStep>(i);
    if (i > 0 && ImGui::GetItemRectMax().x + style.ItemSpacing.x + widthOf(i) <= right_px) ImGui::SameLine();
    ImGui::BeginDisabled(!flow.may(step) || (view.choices == 0 && step != ClassStep::next));
    if (ImGui::Button(texts::phone::kSteps.at(i))) desk.ask(step);
    ImGui::EndDisabled();
  }
  drawCounts(view);
  drawJoining(desk.invitation());
}

}  // namespace carom::console
