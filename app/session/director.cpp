#include "app/session/director.h"

#include <chrono>

#include "app/operator/lesson.h"
#include "engine/base/log.h"

namespace carom {

FrameLeader::FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings,
                         const DisplayWalls* windows)
    : source_(source), keys_(keys), windows_(windows), desk_(keys) {
  settings_ = settings;
}

/// Applies a command and notes it. In a live game nothing else changes the settings.
void FrameLeader::obey(const Command& command, Decision& decision) {
  if (!apply(command, settings_)) return;
  obeyed_.push_back(command);
  decision.inputs.push_back({nameOf(command), valueOf(command, settings_)});
  log::note(toString(command, settings_));
  if (std::holds_alternative<ShowKeys>(command)) sayKeys(keys_);
  if (const auto* play = std::get_if<PlayScenario>(&command)) nextGame_ = play->file;
}

void FrameLeader::decide(const FrameTimes& times, const WindowInput& input, Decision& decision) {
  const auto begun = std::chrono::steady_clock::now();
  const FrameRecord& before = decision.frame.record;
  const bool choosing = offersChoices(settings_);
  decision.beginFrame();
  obeyed_.clear();
  for (const Command& command : inbox_) obey(command, decision);
  inbox_.clear();
  for (const Command& command : commandsOf(input, keys_, before.display_s, settings_))
    obey(command, decision);
  const DeskInput desk = windows_ ? desk_.gather(*windows_, input, choosing) : DeskInput{};
  if (const auto command = lessonCommand(desk.answer, desk.onwards)) obey(*command, decision);
  source_.next(times, {obeyed_, desk}, settings_, decision);
  inbox_.insert(inbox_.end(), decision.commands.begin(), decision.commands.end());
  if (!nextGame_.empty()) decision.frame.record.last = 1;  // ends this game
  for (const std::string& alarm : decision.alarms) log::note(alarm);
  decision.timing.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace carom
