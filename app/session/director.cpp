#include "app/session/director.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "app/operator/lesson.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"
#include "engine/text/log.h"

namespace carom {

FrameLeader::FrameLeader(FrameSource& source, KeysOf keys, const OperatorSettings& settings, DeskDevices desk,
                         std::optional<double> patience_s, const std::string& firstGame)
    : source_(source),
      keys_(keys),
      desk_(std::move(desk)),
      firstGame_(firstGame.empty() ? settings.playing : firstGame),
      programme_(firstGame_, settings.playlist, patience_s) {
  settings_ = settings;
}

/// Takes the next game, which somebody has chosen.
void FrameLeader::choose(NextGame next) {
  nextGame_ = std::move(next);
  awaitsShot_ = false;
}

/// Applies a command and notes it. In a live game nothing else changes the settings.
void FrameLeader::applyCommand(const Command& given, Decision& decision, std::size_t viewer) {
  // Where no lesson can go on, going on shows the best shot.
  const bool isShot =
      std::holds_alternative<AdvanceLesson>(given) && settings_.lesson.phase == LessonPhase::none;
  const bool isRefused = programme_.refuses(given);
  if (isRefused)
    log::note(fmt::format("study: {} is locked while people take part.", toString(given, settings_)));
  const Command command = isRefused ? Command(TellPerson{texts::message::kNoSuchKey})
                          : isShot  ? Command(ShowBestShot{})
                                    : given;
  if (!apply(command, settings_)) return;
  applied_.push_back(command);
  const auto* const language = std::get_if<SetLanguage>(&command);
  decision.inputs.push_back(
      {nameOf(command), valueOf(command, settings_), language ? language->viewer : viewer});
  log::note(toString(command, settings_));
  if (std::holds_alternative<ShowKeys>(command)) sayKeys(keys_);
  if (const auto* play = std::get_if<PlayScenario>(&command))
    choose({play->file, false, false, play->afresh, play->task, play->recordTo});
  if (std::holds_alternative<WelcomeNextVisitor>(command)) choose({firstGame_, true});
}

namespace {

/// Returns the middle between the viewers' heads: it moves when one of them does.
Vec3 meanPlaceOf(const Decision& decision) {
  Vec3 sum_m(0.0);
  for (std::size_t viewer = 0; viewer < decision.frame.record.viewerCount; ++viewer)
    sum_m += decision.heads[viewer].pose.position_m;
  return sum_m / static_cast<double>(decision.frame.record.viewerCount);
}

/// Returns whether one of the viewers draws the cue.
bool anyPulls(const FrameRecord& record) {
  const auto viewers = record.present();
  return std::any_of(viewers.begin(), viewers.end(),
                     [](const ViewerState& viewer) { return viewer.hand.pulling != 0; });
}

}  // namespace

/// Lets another game follow by itself, unless somebody has just chosen one. `acted`: somebody gave a command
/// or pressed a key.
void FrameLeader::followProgramme(bool acted, const DeskInput& desk, Decision& decision) {
  const bool mouseMoved = desk.mouse && (!mouseWas_ || desk.mouse->onWall_m != mouseWas_->onWall_m);
  mouseWas_ = desk.mouse;
  const FrameRecord& record = decision.frame.record;
  acted = acted || mouseMoved || desk.mouseHeld || desk.mouseTurns || desk.padHeld || decision.isHandled ||
          anyPulls(record);
  if (nextGame_.isForNextVisitor) return programme_.welcome();
  const NextGame next = programme_.look({record.display_s, acted, record.drive.mode == DriveMode::tour,
                                         meanPlaceOf(decision), settings_.lesson.phase == LessonPhase::asks},
                                        settings_.playing);
  askWhetherStillThere(decision);
  const bool isChosen = !nextGame_.file.empty() && !nextGame_.attracts && !awaitsShot_;
  if (next.isForNextVisitor && !isChosen) return applyCommand(WelcomeNextVisitor{}, decision);
  if (!nextGame_.file.empty() || next.file.empty()) return;
  nextGame_ = next;
  awaitsShot_ = !next.attracts;
  if (awaitsShot_) decision.commands.emplace_back(ShowBestShot{true});
}

/// Counts down on the walls before the visitors are taken to have gone.
void FrameLeader::askWhetherStillThere(Decision& decision) const {
  FrameRecord& record = decision.frame.record;
  const std::optional<int> left_s = programme_.countdown(record.display_s);
  if (!left_s) return;
  const Notice asks(texts::say(texts::message::kStillThere, *left_s));
  for (ViewerState& viewer : record.present()) viewer.notice = asks;
}

/// Shows the class on the walls, and hands its votes to the journal.
void FrameLeader::followClass(Decision& decision) {
  if (!classroom_) return;
  classroom_->follow(settings_.lesson);
  classroom_->takeVotes(decision.votes);
  std::erase_if(decision.answers, [](const LessonAnswer& given) {
    return given.answer == texts::lesson::kSkipped.english();
  });  // by phone
  for (const std::string& phase : classroom_->takePhases()) decision.notes.push_back({"class", phase});
  decision.frame.record.classroom = classroom_->view();
}

/// Ends this game if another was chosen: the walls go dark, after the best shot if the other follows by
/// itself.
void FrameLeader::endGame(Decision& decision) {
  const bool isShown = lastOf<ShowBestShot>(decision.commands) || decision.showsShot;
  if (nextGame_.file.empty() || (awaitsShot_ && isShown)) return;
  FrameRecord& record = decision.frame.record;
  if (!darkens_s_) darkens_s_ = record.display_s;
  const double darkness = std::min(1.0, (record.display_s - *darkens_s_) / kFade_s);
  record.fade = std::max(record.fade, darkness);
  if (darkness == 1.0) record.last = 1;
}

void FrameLeader::decide(const FrameTimes& times, const WindowInput& input, Decision& decision) {
  const auto begun = std::chrono::steady_clock::now();
  const FrameRecord& before = decision.frame.record;
  const bool choosing = offersChoices(settings_);
  decision.beginFrame();
  applied_.clear();
  if (classroom_) classroom_->command(settings_, inbox_);
  const bool acted = inbox_.size() > fromSource_ || !input.keys.empty();
  for (const Command& command : inbox_) applyCommand(command, decision);
  inbox_.clear();
  for (const HandCommand& given : handed_) applyCommand(given.command, decision, given.viewer);
  for (const Command& command : commandsOf(input, keys_, before.display_s, settings_))
    applyCommand(command, decision);
  const DeskInput desk = desk_ ? desk_(input, choosing) : DeskInput{};
  if (const auto command = lessonCommand(desk.answer, desk.onwards)) applyCommand(*command, decision);
  source_.next(times, {applied_, desk}, settings_, decision);
  followClass(decision);
  if (isLive(keys_)) followProgramme(acted, desk, decision);
  inbox_.insert(inbox_.end(), decision.commands.begin(), decision.commands.end());
  fromSource_ = decision.commands.size();
  handed_ = decision.handCommands;
  endGame(decision);
  for (const std::string& alarm : decision.alarms) log::note(alarm);
  decision.timing.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace carom
