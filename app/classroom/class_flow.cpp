#include "app/classroom/class_flow.h"

#include <algorithm>

namespace carom {

std::optional<ClassStep> classStepNamed(std::string_view name) {
  const auto* found = std::find(kClassSteps.begin(), kClassSteps.end(), name);
  if (found == kClassSteps.end()) return {};
  return static_cast<ClassStep>(found - kClassSteps.begin());
}

/// Returns the phase to which a step leads, or none if it is not possible.
std::optional<ClassPhase> ClassFlow::after(ClassStep step) const {
  using Phase = ClassPhase;
  const auto from = [this](auto... phases) { return ((phase_ == phases) || ...); };
  const auto leads = [](bool isPossible, Phase to) { return isPossible ? std::optional(to) : std::nullopt; };
  switch (step) {
    case ClassStep::ask:
      return leads(from(Phase::idle), Phase::vote);
    case ClassStep::close:
      return leads(from(Phase::vote), Phase::closed);
    case ClassStep::discuss:
      return leads(from(Phase::closed) && round_ == 1, Phase::discuss);
    case ClassStep::again:
      return leads(from(Phase::discuss), Phase::vote);
    case ClassStep::show:
      return leads(from(Phase::idle, Phase::closed, Phase::discuss, Phase::explained), Phase::shown);
    case ClassStep::explain:
      return leads(from(Phase::shown), Phase::explained);
    case ClassStep::next:
      return leads(!from(Phase::vote), Phase::idle);
  }
  return {};
}

bool ClassFlow::take(ClassStep step) {
  const std::optional<ClassPhase> next = after(step);
  if (!next) return false;
  phase_ = *next;
  if (step == ClassStep::ask) round_ = 1;
  if (step == ClassStep::again) round_ = 2;
  if (step == ClassStep::next) round_ = 0;
  return true;
}

void ClassFlow::follow(LessonPhase lesson) {
  if (lesson == LessonPhase::shows) phase_ = ClassPhase::shown;
  if (lesson == LessonPhase::explains) phase_ = ClassPhase::explained;
  if (lesson == LessonPhase::asks && (phase_ == ClassPhase::shown || phase_ == ClassPhase::explained))
    begin();
}

}  // namespace carom
