#include "app/console_parts/console_study.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "app/class_server/study_desk.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

void drawStandings(const std::vector<StudyStanding>& standings) {
  heading(texts::console::kStudyPeople);
  if (standings.empty()) dim(texts::console::kStudyNobody);
  for (const StudyStanding& one : standings) {
    light(one.isUnwell ? kBad : one.isAsked ? kFair : one.isInRoom ? kGood : kDim);
    ImGui::SameLine();
    words(texts::format(texts::console::kStudyStanding, one.code, one.words));
  }
}

/// Draws the buttons for the person in the room, who says how they feel, or that they want to stop.
void drawUnwell(StudyDesk& study) {
  heading(texts::console::kStudyUnwell);
  for (int value = 0; value <= 10; ++value) {
    if (value > 0) ImGui::SameLine();
    if (ImGui::Button(std::to_string(value).c_str())) study.order(RateUnwell{value});
  }
  if (ImGui::Button(texts::console::kStudyStop)) study.order(StopInRoom{});
}

}  // namespace

void StudyPanel::draw(const ConsoleFrame& frame) {
  StudyDesk& study = *frame.study;
  heading(texts::console::kStudyCode);
  ImGui::SetNextItemWidth(12.0F * ImGui::GetFontSize());
  const bool isEntered =
      ImGui::InputText("##code", code_.data(), code_.size(),
                       ImGuiInputTextFlags_CharsUppercase | ImGuiInputTextFlags_EnterReturnsTrue);
  tip(texts::console::kStudyCodeTip);
  ImGui::SameLine();
  if (ImGui::Button(texts::console::kStudyLetIn) || isEntered) {
    study.order(CallCode{code_.data()});
    code_.fill('\0');
  }
  if (!study.said().empty()) words(study.said());
  const std::vector<StudyStanding>& standings = study.standings();
  drawStandings(standings);
  if (std::any_of(standings.begin(), standings.end(), [](const StudyStanding& one) { return one.isInRoom; }))
    drawUnwell(study);
}

}  // namespace carom::console
