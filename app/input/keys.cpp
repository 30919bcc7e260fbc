#include "app/input/keys.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/operator/lesson.h"
#include "engine/base/limits.h"
#include "engine/base/log.h"

namespace carom {
namespace {

constexpr double kEyeSeparationStep_m = 0.001;
constexpr double kLightSpeedSteps = 12.0;  // from one light speed to twice it
constexpr double kScrub_s = 1.0;           // an arrow's way through a recording
constexpr double kMostRate = 16.0;

constexpr unsigned kInSession = 1, kInReplay = 2, kInPatterns = 4;
constexpr unsigned kEverywhere = kInSession | kInReplay | kInPatterns;
constexpr unsigned kWithGame = kInSession | kInReplay;

struct Pressed {
  KeysOf place;
  double now_s;
};

void turn(std::uint8_t& value) { value = value ? 0 : 1; }

void showNext(Controls& controls, const Pressed& pressed) {
  auto next = (static_cast<unsigned>(controls.walls.shown) + 1) % 3;
  if (next == 0 && pressed.place == KeysOf::patterns) next = 1;
  controls.walls.shown = static_cast<Shown>(next);
}

void setEyesApart(Controls& controls, int steps) {
  // To a tenth of a millimetre, so that steps there and back end where they began.
  const double set_m = std::round((controls.eyeSeparation_m + steps * kEyeSeparationStep_m) * 1e4) / 1e4;
  controls.eyeSeparation_m = std::clamp(set_m, 0.0, kMostEyeSeparation_m);
}

void setLightSpeed(Controls& controls, int steps) {
  const double set_m_s = controls.lightSpeed_m_s * std::exp2(steps / kLightSpeedSteps);
  controls.lightSpeed_m_s = std::clamp(set_m_s, kLeastLightSpeed_m_s, kMostLightSpeed_m_s);
}

void goTo(Controls& controls, double session_s) {
  ++controls.playback.jumps;
  controls.playback.goTo_s = std::max(session_s, 0.0);
}

void setRate(Controls& controls, double rate) {
  const double fast = std::clamp(std::abs(rate), 1.0 / kMostRate, kMostRate);
  controls.playback.rate = std::copysign(fast, rate);
}

struct Key {
  int key;       // GLFW's
  int otherKey;  // does the same; 0: none
  const char* label;
  unsigned where;
  const char* does;  // null: told by the line before
  void (*act)(Controls&, const Pressed&);
};

constexpr std::array kKeys{
    Key{GLFW_KEY_1, 0, "1", kWithGame, "retardation",
        [](Controls& c, const Pressed&) { turn(c.switches.retardation); }},
    Key{GLFW_KEY_2, 0, "2", kWithGame, "contraction",
        [](Controls& c, const Pressed&) { turn(c.switches.contraction); }},
    Key{GLFW_KEY_3, 0, "3", kWithGame, "aberration",
        [](Controls& c, const Pressed&) { turn(c.switches.aberration); }},
    Key{GLFW_KEY_4, 0, "4", kWithGame, "colour",
        [](Controls& c, const Pressed&) { turn(c.switches.colour); }},
    Key{GLFW_KEY_5, 0, "5", kWithGame, "searchlight",
        [](Controls& c, const Pressed&) { turn(c.switches.searchlight); }},
    Key{GLFW_KEY_N, 0, "N", kWithGame, "ghosts: now on the board",
        [](Controls& c, const Pressed&) { turn(c.views.boardNow); }},
    Key{GLFW_KEY_M, 0, "M", kWithGame, "ghosts: my now",
        [](Controls& c, const Pressed&) { turn(c.views.myNow); }},
    Key{GLFW_KEY_P, 0, "P", kWithGame, "paths", [](Controls& c, const Pressed&) { turn(c.views.paths); }},
    Key{GLFW_KEY_E, 0, "E", kWithGame, "events", [](Controls& c, const Pressed&) { turn(c.views.events); }},
    Key{GLFW_KEY_C, 0, "C", kWithGame, "clocks", [](Controls& c, const Pressed&) { turn(c.views.clocks); }},
    Key{GLFW_KEY_U, 0, "U", kWithGame, "ruler", [](Controls& c, const Pressed&) { turn(c.views.ruler); }},
    Key{GLFW_KEY_O, 0, "O", kWithGame, "angles", [](Controls& c, const Pressed&) { turn(c.views.angles); }},
    Key{GLFW_KEY_V, 0, "V", kWithGame, "Newton beside Einstein",
        [](Controls& c, const Pressed&) { turn(c.views.split); }},
    Key{GLFW_KEY_6, 0, "6", kWithGame, "in the right half: retardation",
        [](Controls& c, const Pressed&) { turn(c.views.beside.retardation); }},
    Key{GLFW_KEY_7, 0, "7", kWithGame, "in the right half: contraction",
        [](Controls& c, const Pressed&) { turn(c.views.beside.contraction); }},
    Key{GLFW_KEY_8, 0, "8", kWithGame, "in the right half: aberration",
        [](Controls& c, const Pressed&) { turn(c.views.beside.aberration); }},
    Key{GLFW_KEY_9, 0, "9", kWithGame, "in the right half: colour",
        [](Controls& c, const Pressed&) { turn(c.views.beside.colour); }},
    Key{GLFW_KEY_0, 0, "0", kWithGame, "in the right half: searchlight",
        [](Controls& c, const Pressed&) { turn(c.views.beside.searchlight); }},
    Key{GLFW_KEY_F, 0, "F", kWithGame, "freeze the sight and walk round it",
        [](Controls& c, const Pressed&) { turn(c.views.frozen); }},
    Key{GLFW_KEY_LEFT_BRACKET, 0, "[ ]", kInSession, "slower and faster light",
        [](Controls& c, const Pressed&) { setLightSpeed(c, -1); }},
    Key{GLFW_KEY_RIGHT_BRACKET, 0, "]", kInSession, nullptr,
        [](Controls& c, const Pressed&) { setLightSpeed(c, 1); }},
    Key{GLFW_KEY_SPACE, 0, "Space", kInReplay, "pause",
        [](Controls& c, const Pressed&) { c.playback.paused = !c.playback.paused; }},
    Key{GLFW_KEY_LEFT, 0, "← →", kInReplay, "a second back, a second on",
        [](Controls& c, const Pressed& pressed) { goTo(c, pressed.now_s - kScrub_s); }},
    Key{GLFW_KEY_RIGHT, 0, "→", kInReplay, nullptr,
        [](Controls& c, const Pressed& pressed) { goTo(c, pressed.now_s + kScrub_s); }},
    Key{GLFW_KEY_UP, 0, "↑ ↓", kInReplay, "twice as fast, half as fast",
        [](Controls& c, const Pressed&) { setRate(c, 2.0 * c.playback.rate); }},
    Key{GLFW_KEY_DOWN, 0, "↓", kInReplay, nullptr,
        [](Controls& c, const Pressed&) { setRate(c, 0.5 * c.playback.rate); }},
    Key{GLFW_KEY_R, 0, "R", kInReplay, "backwards and forwards",
        [](Controls& c, const Pressed&) { c.playback.rate = -c.playback.rate; }},
    Key{GLFW_KEY_HOME, 0, "Home", kInReplay, "from the beginning",
        [](Controls& c, const Pressed&) { goTo(c, 0.0); }},
    Key{GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER, "Enter", kInSession, "the lesson goes on",
        [](Controls& c, const Pressed&) { c.lesson = advance(c.lesson, c.lessonAnswers, 0, true); }},
    Key{GLFW_KEY_Y, 0, "Y", kInSession, "this game from its beginning",
        [](Controls& c, const Pressed&) { c.play = c.playing; }},
    Key{GLFW_KEY_G, 0, "G", kInSession, "set out on the scenario's tour",
        [](Controls& c, const Pressed&) { ++c.tours; }},
    Key{GLFW_KEY_T, 0, "T", kEverywhere, "patterns", showNext},
    Key{GLFW_KEY_B, 0, "B", kEverywhere, "black walls",
        [](Controls& c, const Pressed&) { turn(c.walls.blank); }},
    Key{GLFW_KEY_X, 0, "X", kEverywhere, "swapped eyes",
        [](Controls& c, const Pressed&) { turn(c.walls.eyesSwapped); }},
    Key{GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD, "+ -", kInSession, "eye separation",  // + without Shift is =
        [](Controls& c, const Pressed&) { setEyesApart(c, 1); }},
    Key{GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT, "-", kInSession, nullptr,
        [](Controls& c, const Pressed&) { setEyesApart(c, -1); }},
    Key{GLFW_KEY_K, 0, "K", kInSession, "crosses where the trackers' sensors are",
        [](Controls& c, const Pressed&) { turn(c.walls.trackerCross); }},
    Key{GLFW_KEY_L, 0, "L", kEverywhere, "latency of every node",
        [](Controls& c, const Pressed&) { turn(c.walls.latency); }},
};

constexpr std::array<int, 2> kEndKeys{GLFW_KEY_ESCAPE, GLFW_KEY_Q};
constexpr std::array<int, 2> kMapKeys{GLFW_KEY_H, GLFW_KEY_F1};

template <std::size_t count>
bool pressedOneOf(const WindowInput& input, const std::array<int, count>& keys) {
  return std::any_of(input.keys.begin(), input.keys.end(), [&](const KeyInput& key) {
    return key.pressed && std::find(keys.begin(), keys.end(), key.key) != keys.end();
  });
}

bool means(const Key& key, KeysOf place) { return (key.where & (1U << static_cast<unsigned>(place))) != 0; }

std::optional<int> digitOf(int key) {
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return key - GLFW_KEY_0;
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return key - GLFW_KEY_KP_0;
  return {};
}

/// While a lesson asks, the digits are its answers, and nothing else.
bool answers(int key, KeysOf place, Controls& controls) {
  const std::optional<int> digit = digitOf(key);
  if (!digit || place != KeysOf::session || controls.lesson.phase != LessonPhase::asks) return false;
  controls.lesson = advance(controls.lesson, controls.lessonAnswers, *digit, false);
  return true;
}

}  // namespace

bool wantsToEnd(const WindowInput& input) { return input.closeRequested || pressedOneOf(input, kEndKeys); }

bool asksForKeys(const WindowInput& input) { return pressedOneOf(input, kMapKeys); }

void obeyKeys(const WindowInput& input, KeysOf place, double now_s, Controls& controls) {
  for (const KeyInput& pressed : input.keys) {
    if (!pressed.pressed || pressed.key == 0 || answers(pressed.key, place, controls)) continue;
    const unsigned jumps = controls.playback.jumps;
    for (const Key& key : kKeys) {
      if (means(key, place) && (pressed.key == key.key || pressed.key == key.otherKey)) {
        key.act(controls, {place, now_s});
      }
    }
    if (controls.playback.jumps != jumps)
      now_s = controls.playback.goTo_s;  // the next key goes on from there
  }
}

std::vector<KeyLine> keyMap(KeysOf place) {
  std::vector<KeyLine> lines;
  for (const Key& key : kKeys) {
    if (means(key, place) && key.does) lines.push_back({key.label, key.does});
  }
  if (place == KeysOf::session) {
    lines.push_back({"W A S D", "steer: forward, left, back, right"});
    lines.push_back({"Space", "brake"});
    lines.push_back({"Home", "go home"});
    lines.push_back({"Mouse", "point to a puck; hold, draw back, let go: strike it"});
    lines.push_back({"1 to 4", "while a lesson asks: the answer"});
  }
  lines.push_back({"H", "this list"});
  lines.push_back({"Escape Q", "the end"});
  return lines;
}

KeyLine keyFor(KeysOf place, std::string_view what) {
  const Controls before;
  for (const Key& key : kKeys) {
    if (!means(key, place) || !key.does) continue;
    Controls after = before;
    key.act(after, {place, 0.0});
    const std::vector<ControlChange> changes = changesOf(before, after);
    if (changes.size() == 1 && changes.front().what == what) return {key.label, key.does};
  }
  return {};
}

void sayKeys(KeysOf place) {
  std::string all;
  for (const KeyLine& line : keyMap(place)) all += (all.empty() ? "" : ", ") + line.keys + " " + line.does;
  log::note(fmt::format("Keys: {}.", all));
}

}  // namespace carom
