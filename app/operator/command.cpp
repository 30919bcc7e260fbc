#include "app/operator/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/operator/lesson.h"

namespace carom {
namespace {

constexpr std::array<const char*, 3> kShownNames{"the session", "test patterns", "seam pattern"};

struct WallOption {
  std::uint8_t WallControls::*option;
  const char *name, *on, *off;
};
constexpr std::array<WallOption, 5> kWallOptions{
    {{&WallControls::blank, "walls", "black", "lit"},
     {&WallControls::eyesSwapped, "eyes", "swapped", "as in the rig"},
     {&WallControls::trackerCross, "tracker cross", "on", "off"},
     {&WallControls::latency, "latency", "on", "off"},
     {&WallControls::comfort, "comfort", "on", "off"}}};

const WallOption& wallOption(std::uint8_t WallControls::*option) {
  return *std::find_if(kWallOptions.begin(), kWallOptions.end(),
                       [&](const WallOption& known) { return known.option == option; });
}

/// Returns the name of a member in kNamedSwitches or kNamedViews.
template <typename Named, typename Member>
const char* nameIn(const Named& named, Member member) {
  return std::find_if(named.begin(), named.end(), [&](const auto& known) { return known.value == member; })
      ->name;
}

std::string onOrOff(bool on) { return on ? "on" : "off"; }

std::string lessonWords(const OperatorSettings& settings) {
  const LessonState& lesson = settings.lesson;
  constexpr std::array<const char*, 4> kPhases{"none", "asks", "shows", "explains"};
  const char* phase = kPhases[static_cast<std::size_t>(lesson.phase)];
  std::string words = lesson.answer == 0 ? phase : fmt::format("{}, answered {}", phase, lesson.answer);
  if (settings.lessonObservers > 0) words += fmt::format(", velocity {}", settings.lessonObserver + 1);
  return words;
}

/// Sets the value. Returns whether it changes.
template <typename T, typename Value>
bool set(T& value, const Value& to) {
  const T before = value;
  value = static_cast<T>(to);
  return value != before;
}

struct Apply {
  OperatorSettings& settings;

  bool operator()(const SetSwitch& c) {
    Switches& switches = c.beside ? settings.views.beside : settings.switches;
    return set(switches.*c.effect, c.on);
  }
  bool operator()(const SetView& c) { return set(settings.views.*c.view, c.on); }
  bool operator()(const SetWalls& c) { return set(settings.walls.*c.option, c.on); }
  bool operator()(const ShowOnWalls& c) { return set(settings.walls.shown, c.shown); }
  bool operator()(const ShowKeys& c) { return set(settings.keysShown, c.on); }
  bool operator()(const ShowConsole& c) {
    if (settings.console == ConsoleState::none) return false;
    return set(settings.console, c.on ? ConsoleState::shown : ConsoleState::waits);
  }
  bool operator()(const SetEyeSeparation& c) { return set(settings.eyeSeparation_m, c.apart_m); }
  bool operator()(const SetLightSpeed& c) { return set(settings.lightSpeed_m_s, c.speed_m_s); }
  bool operator()(const ChooseInLesson& c) { return choose(settings, c.choice); }
  bool operator()(const AdvanceLesson&) { return goOn(settings); }
  bool operator()(const StartTour&) { return true; }
  bool operator()(const PlayScenario& c) { return !c.file.empty(); }
  bool operator()(const WelcomeNextVisitor&) { return true; }
  bool operator()(const KeepTaskBest& c) {
    const auto [best, isFirst] = settings.bestOfTask_j.try_emplace({settings.playing, c.task}, c.energy_j);
    if (!isFirst && best->second <= c.energy_j) return false;
    best->second = c.energy_j;
    return true;
  }
  bool operator()(const ShowBestShot&) { return true; }
  bool operator()(const SetLanguage& c) {
    if (!settings.languages || c.viewer >= kMostViewers || c.language >= settings.languages->all.size())
      return false;
    return set(settings.languageOf[c.viewer], c.language);
  }
  bool operator()(const TellPerson&) { return true; }
  bool operator()(const SetLinked&) { return true; }
  bool operator()(const Pause& c) { return set(settings.playback.paused, c.on); }
  bool operator()(const SetRate& c) { return set(settings.playback.rate, c.rate); }
  bool operator()(const Seek&) { return true; }
};

struct NameOf {
  std::string operator()(const SetSwitch& c) {
    return (c.beside ? "beside: " : "") + std::string(nameIn(kNamedSwitches, c.effect));
  }
  std::string operator()(const SetView& c) { return nameIn(kNamedViews, c.view); }
  std::string operator()(const SetWalls& c) { return wallOption(c.option).name; }
  std::string operator()(const ShowOnWalls&) { return "shown"; }
  std::string operator()(const ShowKeys&) { return "keys"; }
  std::string operator()(const ShowConsole&) { return "console"; }
  std::string operator()(const SetEyeSeparation&) { return "eye separation"; }
  std::string operator()(const SetLightSpeed&) { return "light speed"; }
  std::string operator()(const ChooseInLesson&) { return "lesson"; }
  std::string operator()(const AdvanceLesson&) { return "lesson"; }
  std::string operator()(const StartTour&) { return "tour"; }
  std::string operator()(const PlayScenario&) { return "scenario"; }
  std::string operator()(const WelcomeNextVisitor&) { return "visitor"; }
  std::string operator()(const KeepTaskBest&) { return "best of task"; }
  std::string operator()(const ShowBestShot&) { return "best shot"; }
  std::string operator()(const SetLanguage&) { return "language"; }
  std::string operator()(const TellPerson&) { return "refused"; }
  std::string operator()(const SetLinked&) { return "link"; }
  std::string operator()(const Pause&) { return "playback"; }
  std::string operator()(const SetRate&) { return "playback rate"; }
  std::string operator()(const Seek&) { return "playback"; }
};

struct ValueOf {
  const OperatorSettings& settings;

  std::string operator()(const SetSwitch& c) { return onOrOff(c.on); }
  std::string operator()(const SetView& c) { return onOrOff(c.on); }
  std::string operator()(const SetWalls& c) {
    const WallOption& option = wallOption(c.option);
    return c.on ? option.on : option.off;
  }
  std::string operator()(const ShowOnWalls& c) { return kShownNames[static_cast<std::size_t>(c.shown)]; }
  std::string operator()(const ShowKeys& c) { return onOrOff(c.on); }
  std::string operator()(const ShowConsole& c) { return c.on ? "shown" : "hidden"; }
  std::string operator()(const SetEyeSeparation& c) { return fmt::format("{:.1f} mm", c.apart_m * 1e3); }
  std::string operator()(const SetLightSpeed& c) { return fmt::format("{:.3g} m/s", c.speed_m_s); }
  std::string operator()(const ChooseInLesson&) { return lessonWords(settings); }
  std::string operator()(const AdvanceLesson&) { return lessonWords(settings); }
  std::string operator()(const StartTour&) { return "asked for"; }
  std::string operator()(const PlayScenario& c) { return c.file; }
  std::string operator()(const WelcomeNextVisitor&) { return "the next one"; }
  std::string operator()(const KeepTaskBest& c) {
    return fmt::format("{}: {:.3g} J", c.task + 1, c.energy_j);
  }
  std::string operator()(const ShowBestShot& c) { return c.isKept ? "kept as a picture" : "asked for"; }
  std::string operator()(const SetLanguage& c) {
    return settings.languages ? settings.languages->all.at(c.language) : std::string(kEnglish);
  }
  std::string operator()(const TellPerson& c) { return c.words.english(); }
  std::string operator()(const SetLinked& c) { return onOrOff(c.on); }
  std::string operator()(const Pause& c) { return c.on ? "paused" : "goes on"; }
  std::string operator()(const SetRate& c) { return fmt::format("{:g}", c.rate); }
  std::string operator()(const Seek& c) { return fmt::format("from {:.2f} s", c.session_s); }
};

}  // namespace

bool apply(const Command& command, OperatorSettings& settings) {
  return std::visit(Apply{settings}, command);
}

std::optional<Command> lessonCommand(int choice, bool onwards) {
  if (choice > 0) return ChooseInLesson{choice};
  if (onwards) return AdvanceLesson{};
  return {};
}

std::string nameOf(const Command& command) { return std::visit(NameOf{}, command); }

std::string valueOf(const Command& command, const OperatorSettings& settings) {
  return std::visit(ValueOf{settings}, command);
}

std::string toString(const Command& command, const OperatorSettings& settings) {
  return fmt::format("{}: {}", nameOf(command), valueOf(command, settings));
}

}  // namespace carom
