#include "app/operator/wall_commands.h"

#include "app/operator/visitor_choices.h"
#include "cave/record/effects.h"

namespace carom {

std::optional<Command> commandOf(const WallAction& action, const OperatorSettings& settings,
                                 std::size_t viewer) {
  switch (action.kind) {
    case WallAction::Kind::none:
    case WallAction::Kind::home:
      break;
    case WallAction::Kind::choice:
      return commandOf(static_cast<Choice>(action.number), settings);
    case WallAction::Kind::choose:
      return ChooseInLesson{action.number};
    case WallAction::Kind::goOn:
      return AdvanceLesson{};
    case WallAction::Kind::effect: {
      const auto effect = kNamedSwitches.at(action.number).value;
      return SetSwitch{effect, false, settings.switches.*effect == 0};
    }
    case WallAction::Kind::keepShot:
      return ShowBestShot{.isKept = true};
    case WallAction::Kind::again:
      return PlayScenario{settings.playing};
    case WallAction::Kind::unfreeze:
      return SetView{&TimeViews::frozen, false};
    case WallAction::Kind::tasks:
      return beginTasks(settings);
    case WallAction::Kind::nextTask:
      return nextTask(settings);
    case WallAction::Kind::spacetime:
      return SetView{&TimeViews::spacetime, settings.views.spacetime == 0};
    case WallAction::Kind::language:
      return SetLanguage{viewer, action.number};
    case WallAction::Kind::keys:
      return ShowKeys{!settings.keysShown};
  }
  return {};
}

}  // namespace carom
