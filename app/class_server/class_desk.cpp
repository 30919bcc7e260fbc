#include "app/class_server/class_desk.h"

#include <utility>

#include <fmt/format.h>

#include "app/operator/visitor_choices.h"

namespace carom {
namespace {

/// Returns the command that brings the lesson from its phase to where the class wants it, or none if it is
/// there.
std::optional<Command> commandFor(LessonWish wish, const OperatorSettings& settings) {
  constexpr bool kAfresh = true;
  const LessonPhase phase = settings.lesson.phase;
  const auto onwards = [](bool wanted) {
    return wanted ? std::optional<Command>(AdvanceLesson{}) : std::nullopt;
  };
  switch (wish) {
    case LessonWish::ask:
      if (phase == LessonPhase::asks) return {};
      return PlayScenario{settings.playing, kAfresh};
    case LessonWish::show:
      return onwards(phase == LessonPhase::asks || phase == LessonPhase::explains);
    case LessonWish::explain:
      return onwards(phase == LessonPhase::shows);
    case LessonWish::next:
      return commandOf(Choice::lessons, settings);
  }
  return {};
}

}  // namespace

std::string nameOf(ClassPhase phase, int round) {
  const char* const name = kClassPhases.at(static_cast<std::size_t>(phase));
  return round > 0 ? fmt::format("{} {}", name, round) : name;
}

void ClassDesk::play(const Lesson* lesson, const std::string& file) {
  begins_.emplace();
  begins_->file = file;
  if (!lesson) return;
  begins_->lesson = lesson->words.title;
  begins_->question = lesson->words.question;
  begins_->answers = lesson->words.answers;
  begins_->right = lesson->words.right;
}

void ClassDesk::command(const OperatorSettings& settings, Commands& commands) {
  server_.wishes().takeAll([&](LessonWish wish) {
    if (const auto command = commandFor(wish, settings)) commands.push_back(*command);
  });
}

void ClassDesk::follow(const LessonState& lesson) {
  if (begins_ || lesson.phase != told_) {
    told_ = lesson.phase;
    server_.tell({std::exchange(begins_, {}), lesson.phase});
  }
  server_.views().takeAll([this](const ClassView& view) {
    if (view.phase != view_.phase || view.round != view_.round)
      phases_.push_back(nameOf(view.phase, view.round));
    view_ = view;
  });
}

void ClassDesk::takeVotes(std::vector<ClassVote>& votes) {
  server_.votes().takeAll([&](ClassVote&& vote) { votes.push_back(std::move(vote)); });
}

}  // namespace carom
