#include "app/live/task_run.h"

#include <fmt/format.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/operator/visitor_choices.h"
#include "cave/frame/bodies.h"
#include "cave/record/hand_view.h"
#include "cave/texts/saying.h"
#include "cave/texts/texts.h"

namespace carom {

int starsFor(const Task& task, double energy_j) {
  return energy_j <= task.stars_j[0] ? 3 : energy_j <= task.stars_j[1] ? 2 : 1;
}

double energyOf_j(const Stroke& stroke, const BilliardSetup& setup) {
  const double mass_kg = setup.pucks[stroke.puck].mass_kg, c_m_s = setup.lightSpeed_m_s;
  return costOf(glm::length(stroke.momentum_kg_m_s) / (mass_kg * c_m_s)) * mass_kg * c_m_s * c_m_s;
}

void TaskRun::struck(std::size_t viewer, const Stroke& stroke, double arrives_s) {
  if (!judge_ || state_ >= State::done) return;
  viewer_ = viewer;
  energy_j_ += energyOf_j(stroke, scenario_->billiard);
  judge_->struck(stroke.puck, arrives_s);
  state_ = State::tried;
  struckAt_s_.reset();
}

void TaskRun::note(const char* event, int stars, Decision& decision) const {
  decision.tasks.push_back({scenario_->tasks[number_].name, viewer_, event, stars, energy_j_});
}

void TaskRun::begin(const OperatorSettings& settings, Announcements& announcements, Decision& decision) {
  number_ = std::min(settings.task, scenario_->tasks.size() - 1);
  const Task& task = scenario_->tasks[number_];
  judge_.emplace(task, scenario_->billiard.lightSpeed_m_s);
  state_ = State::waits;
  texts::Saying words = texts::say(texts::task::kText, number_ + 1, scenario_->tasks.size(), task.text);
  const auto best = settings.bestOfTask_j.find({settings.playing, number_});
  if (best != settings.bestOfTask_j.end()) words += texts::say(texts::task::kBest, best->second);
  announcements.keep(words);
  note("begun", 0, decision);
}

void TaskRun::judge(const World& world, Announcements& announcements, Decision& decision) {
  const FrameRecord& record = decision.frame.record;
  const ObserverView& observer = record.viewers[viewer_].observer;
  const Task& task = scenario_->tasks[number_];
  const auto pucks = std::span(world.histories).subspan(kFirstPuck, scenario_->billiard.pucks.size());
  const bool isDone = judge_->look(world.events, pucks, observer, record.boardFromRoom);
  if (state_ != State::tried) return;
  if (isDone) {
    const int stars = starsFor(task, energy_j_);
    state_ = State::done;
    doneAt_s_ = record.display_s;
    note("solved", stars, decision);
    announcements.say(texts::say(texts::task::kSolved, stars, energy_j_), decision);
    decision.commands.emplace_back(KeepTaskBest{number_, energy_j_});
    return;
  }
  if (!struckAt_s_) struckAt_s_ = observer.properTime_s;
  if (observer.properTime_s - *struckAt_s_ < kTry_s) return;
  state_ = State::waits;
  note("failed", 0, decision);
  announcements.say(texts::task::kNotYet, decision);
}

void TaskRun::look(const OperatorSettings& settings, const World& world, Announcements& announcements,
                   Decision& decision) {
  if (scenario_->tasks.empty()) return;
  if (state_ == State::begins) begin(settings, announcements, decision);
  if (state_ < State::done) judge(world, announcements, decision);
  if (state_ != State::done || decision.frame.record.display_s - doneAt_s_ < kAfter_s) return;
  state_ = State::left;
  decision.commands.push_back(nextTask(settings));
}

}  // namespace carom
