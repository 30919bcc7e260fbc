#include "app/input/keys.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/operator/visitor_choices.h"
#include "cave/texts/key_names.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"
#include "engine/base/limits.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kEyeSeparationStep_m = 0.001;
constexpr double kLightSpeedSteps = 12.0;  // steps per doubling of the light speed
constexpr double kScrub_s = 1.0;           // one press of an arrow key in a recording
constexpr double kMostRate = 16.0;

constexpr unsigned kInSession = 1 | 8, kInReplay = 2, kInPatterns = 4;  // bits by KeysOf
constexpr unsigned kEverywhere = kInSession | kInReplay | kInPatterns;
constexpr unsigned kWithGame = kInSession | kInReplay;

struct Pressed {
  KeysOf place;
  double now_s;
};

bool isOff(std::uint8_t value) { return value == 0; }

template <std::size_t row>
Command turnSwitch(const OperatorSettings& now, const Pressed&) {
  const auto effect = kNamedSwitches[row].value;
  return SetSwitch{effect, false, isOff(now.switches.*effect)};
}

template <std::size_t row>
Command turnBeside(const OperatorSettings& now, const Pressed&) {
  const auto effect = kNamedSwitches[row].value;
  return SetSwitch{effect, true, isOff(now.views.beside.*effect)};
}

template <std::size_t row>
Command turnView(const OperatorSettings& now, const Pressed&) {
  const auto view = kNamedViews[row].value;
  return SetView{view, isOff(now.views.*view)};
}

template <std::uint8_t WallControls::*option>
Command turnWalls(const OperatorSettings& now, const Pressed&) {
  return SetWalls{option, isOff(now.walls.*option)};
}

Command showNext(const OperatorSettings& now, const Pressed& pressed) {
  auto next = (static_cast<unsigned>(now.walls.shown) + 1) % 3;
  if (next == 0 && pressed.place == KeysOf::patterns) next = 1;
  return ShowOnWalls{static_cast<Shown>(next)};
}

template <int steps>
Command setEyesApart(const OperatorSettings& now, const Pressed&) {
  // Rounded to a tenth of a millimetre, so that steps back and forth end at the initial value.
  const double set_m = std::round((now.eyeSeparation_m + steps * kEyeSeparationStep_m) * 1e4) / 1e4;
  return SetEyeSeparation{std::clamp(set_m, 0.0, kMostEyeSeparation_m)};
}

template <int steps>
Command setLightSpeed(const OperatorSettings& now, const Pressed&) {
  const double set_m_s = now.lightSpeed_m_s * std::exp2(steps / kLightSpeedSteps);
  return SetLightSpeed{std::clamp(set_m_s, kLeastLightSpeed_m_s, kMostLightSpeed_m_s)};
}

Command goTo(double session_s) { return Seek{std::max(session_s, 0.0)}; }

Command setRate(double rate) {
  const double fast = std::clamp(std::abs(rate), 1.0 / kMostRate, kMostRate);
  return SetRate{std::copysign(fast, rate)};
}

/// Chooses a velocity of the observer. While the lesson asks, its numbers are answers, so none is chosen.
template <int choice>
Command chooseInLesson(const OperatorSettings& now, const Pressed&) {
  if (now.lesson.phase == LessonPhase::asks) return TellPerson{texts::message::kAnswerFirst};
  if (now.lessonObservers == 0) return TellPerson{texts::message::kNoVelocities};
  return ChooseInLesson{choice};
}

template <Choice choice>
Command choose(const OperatorSettings& now, const Pressed&) {
  return commandOf(choice, now);
}

/// What is printed on a key: signs, or a word of the catalogue; nothing: its letter or digit.
struct KeyLabel {
  constexpr KeyLabel(const char* printed) : signs(printed) {}        // NOLINT(google-explicit-constructor)
  constexpr KeyLabel(const texts::Text& printed) : word(printed) {}  // NOLINT(google-explicit-constructor)

  const char* signs = nullptr;
  texts::Text word;
};

struct Key {
  int key;       // GLFW key code
  int otherKey;  // second key with the same effect; 0 if none
  KeyLabel label;
  unsigned where;
  texts::Text does;  // none: described by the previous line
  Command (*command)(const OperatorSettings&, const Pressed&);
};

// GLFW's numbers of letters and digits are theirs. Effects and views of time have their keys in their rows.
template <std::size_t... row>
constexpr auto effectKeys(std::index_sequence<row...>) {
  return std::array{
      Key{kNamedSwitches[row].key, 0, nullptr, kWithGame, kNamedSwitches[row].words, turnSwitch<row>}...};
}
template <std::size_t... row>
constexpr auto rightEffectKeys(std::index_sequence<row...>) {
  return std::array{Key{kNamedSwitches[row].rightKey, 0, nullptr, kWithGame, kNamedSwitches[row].rightWords,
                        turnBeside<row>}...};
}
template <std::size_t... row>
constexpr auto viewKeys(std::index_sequence<row...>) {
  return std::array{Key{kNamedViews[row].key, 0, kNamedViews[row].key == kKeyF11 ? "F11" : nullptr, kWithGame,
                        kNamedViews[row].words, turnView<row>}...};
}
static_assert(kKeyF11 == GLFW_KEY_F11);
constexpr auto kEffectKeys = effectKeys(std::make_index_sequence<kNamedSwitches.size()>());
constexpr auto kRightKeys = rightEffectKeys(std::make_index_sequence<kNamedSwitches.size()>());
constexpr auto kViewKeys = viewKeys(std::make_index_sequence<kNamedViews.size()>());

constexpr std::array kOtherKeys{
    Key{GLFW_KEY_LEFT_BRACKET, 0, "[ ]", kInSession, texts::keys::kLight, setLightSpeed<-1>},
    Key{GLFW_KEY_RIGHT_BRACKET, 0, "]", kInSession, {}, setLightSpeed<1>},
    Key{GLFW_KEY_SPACE, 0, texts::keys::kSpaceKey, kInReplay, texts::keys::kPause,
        [](const OperatorSettings& now, const Pressed&) -> Command { return Pause{!now.playback.paused}; }},
    Key{GLFW_KEY_LEFT, 0, "← →", kInReplay, texts::keys::kSecond,
        [](const OperatorSettings&, const Pressed& pressed) -> Command {
          return goTo(pressed.now_s - kScrub_s);
        }},
    Key{GLFW_KEY_RIGHT,
        0,
        "→",
        kInReplay,
        {},
        [](const OperatorSettings&, const Pressed& pressed) -> Command {
          return goTo(pressed.now_s + kScrub_s);
        }},
    Key{GLFW_KEY_UP, 0, "↑ ↓", kInReplay, texts::keys::kRate,
        [](const OperatorSettings& now, const Pressed&) -> Command {
          return setRate(2.0 * now.playback.rate);
        }},
    Key{GLFW_KEY_DOWN,
        0,
        "↓",
        kInReplay,
        {},
        [](const OperatorSettings& now, const Pressed&) -> Command {
          return setRate(0.5 * now.playback.rate);
        }},
    Key{GLFW_KEY_R, 0, "R", kInReplay, texts::keys::kBackwards,
        [](const OperatorSettings& now, const Pressed&) -> Command { return SetRate{-now.playback.rate}; }},
    Key{GLFW_KEY_HOME, 0, texts::keys::kHomeKey, kInReplay, texts::keys::kBeginning,
        [](const OperatorSettings&, const Pressed&) -> Command { return Seek{0.0}; }},
    Key{GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER, texts::keys::kEnterKey, kInSession, texts::keys::kOnwards,
        [](const OperatorSettings&, const Pressed&) -> Command { return AdvanceLesson{}; }},
    Key{GLFW_KEY_F2, 0, texts::keys::kVelocityKeys, kInSession, texts::keys::kVelocities, chooseInLesson<1>},
    Key{GLFW_KEY_F3, 0, "F3", kInSession, {}, chooseInLesson<2>},
    Key{GLFW_KEY_F4, 0, "F4", kInSession, {}, chooseInLesson<3>},
    Key{GLFW_KEY_Y, 0, "Y", kInSession, texts::keys::kRestart,
        [](const OperatorSettings& now, const Pressed&) -> Command { return PlayScenario{now.playing}; }},
    Key{GLFW_KEY_F5, 0, "F5", kInSession, texts::keys::kShowMe, choose<Choice::showMe>},
    Key{GLFW_KEY_F6, 0, "F6", kInSession, texts::keys::kLessons, choose<Choice::lessons>},
    Key{GLFW_KEY_F7, 0, "F7", kInSession, texts::keys::kPlay, choose<Choice::play>},
    Key{GLFW_KEY_F8, 0, "F8", kInSession, texts::keys::kNextVisitor,
        [](const OperatorSettings&, const Pressed&) -> Command { return WelcomeNextVisitor{}; }},
    Key{GLFW_KEY_F9, 0, "F9", kInSession, texts::keys::kNextLanguage,
        [](const OperatorSettings& now, const Pressed&) { return nextLanguage(now, 0); }},
    Key{GLFW_KEY_G, 0, "G", kInSession, texts::keys::kFlight,
        [](const OperatorSettings&, const Pressed&) -> Command { return StartTour{}; }},
    Key{GLFW_KEY_T, 0, "T", kEverywhere, texts::keys::kPatterns, showNext},
    Key{GLFW_KEY_B, 0, "B", kEverywhere, texts::keys::kBlack, turnWalls<&WallControls::blank>},
    Key{GLFW_KEY_X, 0, "X", kEverywhere, texts::keys::kSwapEyes, turnWalls<&WallControls::eyesSwapped>},
    Key{GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD, "+ -", kInSession, texts::keys::kEyesApart,  // + without Shift is =
        setEyesApart<1>},
    Key{GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT, "-", kInSession, {}, setEyesApart<-1>},
    Key{GLFW_KEY_K, 0, "K", kInSession, texts::keys::kSensors, turnWalls<&WallControls::trackerCross>},
    Key{GLFW_KEY_J, 0, "J", kInSession, texts::keys::kComfort, turnWalls<&WallControls::comfort>},
    Key{GLFW_KEY_L, 0, "L", kEverywhere, texts::keys::kLatency, turnWalls<&WallControls::latency>},
    Key{GLFW_KEY_F10, 0, "F10", kWithGame, texts::keys::kConsole,
        [](const OperatorSettings& now, const Pressed&) -> Command {
          if (now.console == ConsoleState::none) return TellPerson{texts::message::kNoConsole};
          return ShowConsole{now.console != ConsoleState::shown};
        }},
    Key{GLFW_KEY_H,
        GLFW_KEY_F1,
        "H",
        kEverywhere,
        {},
        [](const OperatorSettings& now, const Pressed&) -> Command { return ShowKeys{!now.keysShown}; }},
};

/// The keys in the order in which they are listed.
const std::vector<Key> kKeys = [] {
  std::vector<Key> keys(kEffectKeys.begin(), kEffectKeys.end());
  keys.insert(keys.end(), kViewKeys.begin(), kViewKeys.end());
  keys.insert(keys.end(), kRightKeys.begin(), kRightKeys.end());
  keys.insert(keys.end(), kOtherKeys.begin(), kOtherKeys.end());
  return keys;
}();

/// Returns the names of a key, or of the keys that a line tells of together, as the keyboard has them.
std::string labelOf(const Key& key) {
  if (key.label.word) return key.label.word.words();
  const char letter = static_cast<char>(key.key);
  return texts::inLayout(key.label.signs ? std::string_view(key.label.signs) : std::string_view(&letter, 1));
}

bool means(const Key& key, KeysOf place) { return (key.where & (1U << static_cast<unsigned>(place))) != 0; }

std::optional<int> digitOf(int key) {
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return key - GLFW_KEY_0;
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return key - GLFW_KEY_KP_0;
  return {};
}

/// Returns the answer for a digit: while a lesson asks, digits have no other meaning.
std::optional<Command> answerOf(int key, KeysOf place, const OperatorSettings& now) {
  const std::optional<int> digit = digitOf(key);
  if (!digit || !isLive(place) || now.lesson.phase != LessonPhase::asks) return {};
  return ChooseInLesson{*digit};
}

bool isArrow(int key) { return key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP; }

/// Returns whether somebody who presses this key in a session expects something of it: letters, function keys
/// and arrows; not those that steer, end, open the lock, or belong to the desktop.
bool isExpectedToDo(int key) {
  constexpr std::array kOthers{GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q};
  const bool isLetter = key >= GLFW_KEY_A && key <= GLFW_KEY_Z &&
                        std::find(kOthers.begin(), kOthers.end(), key) == kOthers.end();
  return isLetter || (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F11) || isArrow(key);
}

std::optional<Command> commandOf(int pressed, const OperatorSettings& now, const Pressed& where) {
  if (const auto answer = answerOf(pressed, where.place, now)) return answer;
  for (const Key& key : kKeys) {
    if (means(key, where.place) && (pressed == key.key || pressed == key.otherKey))
      return key.command(now, where);
  }
  const bool walks = where.place == KeysOf::dryRun && isArrow(pressed);
  if (isLive(where.place) && !walks && isExpectedToDo(pressed)) return TellPerson{texts::message::kNoSuchKey};
  return {};
}

}  // namespace

Commands commandsOf(const WindowInput& input, KeysOf place, double now_s, const OperatorSettings& settings) {
  Commands commands;
  std::optional<OperatorSettings> then;  // settings as each key finds them, copied only if a key is pressed
  for (const KeyInput& pressed : input.keys) {
    if (!pressed.pressed || pressed.key == 0) continue;
    if (!then) then = settings;
    const std::optional<Command> command = commandOf(pressed.key, *then, {place, now_s});
    if (!command) continue;
    apply(*command, *then);
    if (const auto* seek = std::get_if<Seek>(&*command))
      now_s = seek->session_s;  // the next key continues from there
    commands.push_back(*command);
  }
  return commands;
}

std::vector<KeyLine> keyMap(KeysOf place) {
  std::vector<KeyLine> lines;
  const auto add = [&lines](std::string_view keys, const texts::Text& does) {
    lines.push_back({std::string(keys), does.words()});
  };
  for (const Key& key : kKeys) {
    if (means(key, place) && key.does) add(labelOf(key), key.does);
  }
  if (place == KeysOf::dryRun) {
    add("← ↑ → ↓", texts::keys::kWalk);
    add(texts::keys::kPageKeys, texts::keys::kHeadHeight);
    add(texts::keys::kLookKeys, texts::keys::kLook);
  }
  if (isLive(place)) {
    add(texts::inLayout("W A S D"), texts::keys::kSteer);
    add(texts::keys::kSpaceKey, texts::keys::kBrake);
    add(texts::keys::kHomeKey, texts::keys::kHome);
    add(texts::keys::kMouse, texts::keys::kStrike);
    add(texts::keys::kRightButton, texts::keys::kTurn);
    add(texts::keys::kAnswerKeys, texts::keys::kAnswer);
  }
  add(texts::inLayout("H"), texts::keys::kList);
  add(texts::inLayout(texts::keys::kQuitKeys), texts::keys::kQuit);
  return lines;
}

const std::vector<KeyLine>& KeyList::in(std::uint8_t language) {
  const Made now{true, language, texts::keyNames.changes()};
  if (made_ == now) return lines_;
  made_ = now;
  lines_ = keyMap(place_);
  return lines_;
}

KeyLine keyFor(KeysOf place, std::string_view what) {
  const OperatorSettings any;
  for (const Key& key : kKeys) {
    if (means(key, place) && key.does && nameOf(key.command(any, {place, 0.0})) == what)
      return {labelOf(key), key.does.words()};
  }
  return {};
}

void sayKeys(KeysOf place) {
  std::string all;
  const texts::InLanguage english(nullptr);
  for (const KeyLine& line : keyMap(place)) all += (all.empty() ? "" : ", ") + line.keys + " " + line.does;
  log::note(fmt::format("Keys: {}.", all));
}

}  // namespace carom
