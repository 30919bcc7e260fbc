#include "app/session/director.h"

#include <chrono>

#include "app/operator/lesson.h"
#include "engine/base/log.h"

namespace carom {

FrameLeader::FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings,
                         const DisplayWalls* windows, std::optional<double> patience_s)
    : source_(source),
      keys_(keys),
      windows_(windows),
      desk_(keys),
      firstGame_(settings.playing),
      idle_(patience_s) {
  settings_ = settings;
}

/// Applies a command and notes it. In a live game nothing else changes the settings.
void FrameLeader::obey(const Command& command, Decision& decision) {
  if (!apply(command, settings_)) return;
  obeyed_.push_back(command);
  decision.inputs.push_back({nameOf(command), valueOf(command, settings_)});
  log::note(toString(command, settings_));
  if (std::holds_alternative<ShowKeys>(command)) sayKeys(keys_);
  if (const auto* play = std::get_if<PlayScenario>(&command)) nextGame_ = {play->file};
  if (std::holds_alternative<WelcomeNextVisitor>(command)) nextGame_ = {firstGame_, true};
}

/// Returns whether nobody has given a sign of life for so long that the next visitor is to be welcomed. `acted`:
/// somebody gave a command or pressed a key.
bool FrameLeader::isAbandoned(bool acted, const DeskInput& desk, const Decision& decision) {
  const bool mouseMoved = desk.mouse && (!mouseWas_ || desk.mouse->onWall_m != mouseWas_->onWall_m);
  mouseWas_ = desk.mouse;
  acted = acted || mouseMoved || desk.mouseHeld || desk.mouseTurns || desk.padHeld || decision.isHandled ||
          decision.frame.record.hand.pulling;
  if (nextGame_.isForNextVisitor) {
    idle_.forget();
    return false;
  }
  if (decision.frame.record.drive.mode == DriveMode::tour) idle_.wait(decision.frame.record.display_s);
  return idle_.look(decision.frame.record.display_s, acted, decision.head.pose.position_m);
}

void FrameLeader::decide(const FrameTimes& times, const WindowInput& input, Decision& decision) {
  const auto begun = std::chrono::steady_clock::now();
  const FrameRecord& before = decision.frame.record;
  const bool choosing = offersChoices(settings_);
  decision.beginFrame();
  obeyed_.clear();
  const bool acted = inbox_.size() > fromSource_ || !input.keys.empty();
  for (const Command& command : inbox_) obey(command, decision);
  inbox_.clear();
  for (const Command& command : commandsOf(input, keys_, before.display_s, settings_))
    obey(command, decision);
  const DeskInput desk = windows_ ? desk_.gather(*windows_, input, choosing) : DeskInput{};
  if (const auto command = lessonCommand(desk.answer, desk.onwards)) obey(*command, decision);
  source_.next(times, {obeyed_, desk}, settings_, decision);
  inbox_.insert(inbox_.end(), decision.commands.begin(), decision.commands.end());
  fromSource_ = decision.commands.size();
  if (isAbandoned(acted, desk, decision)) obey(WelcomeNextVisitor{}, decision);
  if (!nextGame_.file.empty()) decision.frame.record.last = 1;  // ends this game
  for (const std::string& alarm : decision.alarms) log::note(alarm);
  decision.timing.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace carom
