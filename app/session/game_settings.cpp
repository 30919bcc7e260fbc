#include "app/session/game_settings.h"

#include "app/operator/lesson.h"
#include "app/operator/visitor_choices.h"
#include "app/play/task_judge.h"
#include "app/toml/config_folder.h"

namespace carom {
namespace {

bool isLesson(const Scenario& scenario) { return scenario.lesson.has_value(); }

/// Sets up the task with which a game begins: its number, the effects of its world, and the clocks where it
/// is about them.
void beginTask(const Scenario& scenario, std::size_t number, OperatorSettings& settings) {
  settings.task = number < scenario.tasks.size() ? number : 0;
  if (scenario.tasks.empty()) return;
  const Task& task = scenario.tasks[settings.task];
  settings.switches = switchesOf(task.world, settings.switches);
  settings.views.clocks = task.goal.kind == TaskGoal::Kind::clockReads ? 1 : 0;
}

/// Returns whether somebody can walk about the room: a head is followed, or there are several.
bool canWalk(const Rig& rig) {
  if (rig.byMouse || isHeadset(rig) || rig.viewers.size() > 1) return true;
  const std::size_t number = rig.viewers.front().head.sensor.tracker;
  if (number >= rig.trackers.size()) return false;
  const TrackerSetup& tracker = rig.trackers[number];
  return tracker.kind != TrackerKind::simulated || tracker.person != SimulatedMotion::still;
}

}  // namespace

OperatorSettings settingsAtStart(const Rig& rig, const Scenario& scenario) {
  OperatorSettings settings;
  settings.eyeSeparation_m = rig.viewers.front().head.eyeSeparation_m;
  settings.lightSpeed_m_s = scenario.billiard.lightSpeed_m_s;
  settings.canWalk = canWalk(rig);
  settings.walls.comfort = rig.comfort.aids ? 1 : 0;
  return settings;
}

OperatorSettings settingsOf(const Rig& rig, const Scenario& scenario, const std::string& file,
                            const Beginning& beginning) {
  OperatorSettings settings = settingsAtStart(rig, scenario);
  settings.switches = beginning.switches;
  settings.views = beginning.views;
  settings.playlist = beginning.playlist;
  settings.languages = beginning.languages;
  if (beginning.languages) settings.languageOf = beginning.languages->atStart;
  beginLesson(scenario, beginning.asks, settings);
  if (beginning.lesson && scenario.lesson) settings.lesson.phase = *beginning.lesson;
  explainInMotion(settings);
  beginTask(scenario, 0, settings);
  settings.playing = file;
  if (isLesson(scenario)) settings.lastLesson = file;
  return settings;
}

OperatorSettings settingsOfNext(const OperatorSettings& before, const NextGame& next, const Rig& rig,
                                const Scenario& scenario, const Beginning& beginning) {
  OperatorSettings settings = settingsOf(rig, scenario, next.file, beginning);
  settings.console = before.console;
  settings.bestOfTask_j = before.bestOfTask_j;
  if (next.isForNextVisitor || next.attracts) return settings;
  settings.languageOf = before.languageOf;
  settings.eyeSeparation_m = before.eyeSeparation_m;
  settings.walls = before.walls;
  if (!isLesson(scenario)) settings.lastLesson = before.lastLesson;
  if (next.afresh || !isSameFile(next.file, before.playing)) return settings;
  settings.switches = before.switches;
  settings.views = before.views;
  settings.views.frozen = 0;
  settings.lightSpeed_m_s = before.lightSpeed_m_s;
  if (before.lesson.phase == LessonPhase::shows) {
    settings.lesson = before.lesson;
    settings.lessonObserver = before.lessonObserver;
  }
  beginTask(scenario, next.task.value_or(before.task), settings);
  return settings;
}

}  // namespace carom
