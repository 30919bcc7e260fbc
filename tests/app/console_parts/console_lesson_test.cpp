// The presenter's page of a lesson: what it says in each phase, and what its buttons order.

#include "app/console_parts/console_lesson.h"

#include <gtest/gtest.h>

#include <string>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/operator/visitor_choices.h"
#include "app/scenario/scenario.h"

namespace carom::console {
namespace {

/// A window without a screen, in which the page is drawn.
class ConsoleLesson : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {900.0F, 600.0F};
    io.DeltaTime = 0.05F;
    io.IniFilename = nullptr;
    unsigned char* alpha = nullptr;
    int wide = 0, high = 0;
    io.Fonts->GetTexDataAsAlpha8(&alpha, &wide, &high);
  }
  void TearDown() override { ImGui::DestroyContext(); }

  /// Returns everything that the page says. `pressed`: the name of a button that is pressed in this frame.
  std::string page(const LessonCourse& course, const char* pressed = nullptr) {
    std::string said;
    for (int frame = 0; frame < 2; ++frame) {  // a press is taken by the frame after it
      commands_.clear();
      ImGui::NewFrame();
      ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
      ImGui::Begin("page");
      ImGui::LogToBuffer();
      drawLesson(*game_.lesson, course, commands_);
      said = ImGui::GetCurrentContext()->LogBuffer.c_str();
      ImGui::LogFinish();
      if (pressed != nullptr && frame == 0) ImGui::ActivateItem(ImGui::GetID(pressed));
      ImGui::End();
      ImGui::EndFrame();
    }
    return said;
  }

  const Scenario game_ = readScenario(fileOfGame("two-cushions"));
  const LessonWords& words_ = game_.lesson->words;
  Commands commands_;
};

LessonCourse course(LessonPhase phase, std::uint8_t answer = 0) {
  return {{phase, answer}, 0, PlayScenario{"next.toml"}};
}

/// Returns the line of the page that has these words.
std::string lineWith(const std::string& page, const std::string& words) {
  const std::size_t at = page.find(words);
  if (at == std::string::npos) return {};
  const std::size_t begin = page.rfind('\n', at) + 1;
  return page.substr(begin, page.find('\n', at) - begin);
}

TEST_F(ConsoleLesson, TellsThePresenterEverythingInEachPhase) {
  ASSERT_FALSE(words_.predictedWrongly.empty());
  ASSERT_FALSE(words_.goOnWith.empty());
  for (const LessonPhase phase :
       {LessonPhase::none, LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    const std::string said = page(course(phase));
    for (const std::string& text : {words_.question, words_.todo, words_.notice, words_.number,
                                    words_.predictedWrongly, words_.goOnWith, words_.answers.back()})
      EXPECT_NE(said.find(text), std::string::npos) << said;
  }
}

TEST_F(ConsoleLesson, MarksTheRightAnswerAndTheOneThatWasGiven) {
  const std::size_t given = words_.right == 0 ? 1 : 0;
  const std::string said = page(course(LessonPhase::shows, static_cast<std::uint8_t>(given + 1)));
  EXPECT_NE(lineWith(said, words_.answers[words_.right]).find("right"), std::string::npos) << said;
  EXPECT_EQ(lineWith(said, words_.answers[words_.right]).find("answered"), std::string::npos) << said;
  EXPECT_NE(lineWith(said, words_.answers[given]).find("answered"), std::string::npos) << said;
}

TEST_F(ConsoleLesson, TakesARightAnswerThatIsNotTold) {
  Lesson hidden = *game_.lesson;
  hidden.words.right = hidden.words.answers.size();
  ImGui::NewFrame();
  ImGui::Begin("page");
  ImGui::LogToBuffer();
  drawLesson(hidden, course(LessonPhase::explains), commands_);
  EXPECT_EQ(std::string(ImGui::GetCurrentContext()->LogBuffer.c_str()).find(" right\n"), std::string::npos);
  ImGui::LogFinish();
  ImGui::End();
  ImGui::EndFrame();
}

TEST_F(ConsoleLesson, ItsButtonsAnswerGoOnAndPlayTheNextLesson) {
  const std::string second = "2  " + words_.answers[1];
  page(course(LessonPhase::asks), second.c_str());
  EXPECT_EQ(commands_, Commands{ChooseInLesson{2}});
  page(course(LessonPhase::shows), second.c_str());
  EXPECT_TRUE(commands_.empty());
  page(course(LessonPhase::asks), "Skip the question");
  EXPECT_EQ(commands_, Commands{AdvanceLesson{}});
  page(course(LessonPhase::shows), "Next");
  EXPECT_EQ(commands_, Commands{AdvanceLesson{}});
  page(course(LessonPhase::shows), "Next lesson");
  EXPECT_EQ(commands_, Commands{PlayScenario{"next.toml"}});
  const std::string& velocity = game_.lesson->plan.observers.at(1).name;
  page(course(LessonPhase::shows), velocity.c_str());
  EXPECT_EQ(commands_, Commands{ChooseInLesson{2}});
}

TEST_F(ConsoleLesson, HasNoButtonsInAReplay) {
  LessonCourse replay = course(LessonPhase::shows);
  replay.next.reset();
  EXPECT_EQ(page(replay).find("Next lesson"), std::string::npos);
}

}  // namespace
}  // namespace carom::console
