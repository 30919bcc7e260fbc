#include "app/operator/controls.h"

#include <fmt/format.h>

#include <array>

namespace carom {
namespace {

constexpr std::array<const char*, 3> kShownNames{"the session", "test patterns", "seam pattern"};

const char* onOrOff(std::uint8_t value) { return value ? "on" : "off"; }

std::string wordsFor(const LessonState& lesson) {
  constexpr std::array<const char*, 4> kPhases{"none", "asks", "shows", "explains"};
  const char* phase = kPhases[static_cast<std::size_t>(lesson.phase)];
  return lesson.answer == 0 ? phase : fmt::format("{}, answered {}", phase, lesson.answer);
}

}  // namespace

std::vector<ControlChange> changesOf(const Controls& before, const Controls& after) {
  if (before == after) return {};
  std::vector<ControlChange> changes;
  const auto note = [&](std::string what, const auto& was, const auto& is, std::string value) {
    if (was != is) changes.push_back({std::move(what), std::move(value)});
  };
  const auto noteSwitches = [&](const char* where, const Switches& was, const Switches& is) {
    for (const NamedSwitch& s : kNamedSwitches) {
      note(std::string(where) + s.name, was.*s.value, is.*s.value, onOrOff(is.*s.value));
    }
  };
  noteSwitches("", before.switches, after.switches);
  for (const NamedView& view : kNamedViews) {
    note(view.name, before.views.*view.value, after.views.*view.value, onOrOff(after.views.*view.value));
  }
  noteSwitches("beside: ", before.views.beside, after.views.beside);
  const WallControls &was = before.walls, &is = after.walls;
  note("shown", was.shown, is.shown, kShownNames[static_cast<std::size_t>(is.shown)]);
  note("walls", was.blank, is.blank, is.blank ? "black" : "lit");
  note("eyes", was.eyesSwapped, is.eyesSwapped, is.eyesSwapped ? "swapped" : "as in the rig");
  note("tracker cross", was.trackerCross, is.trackerCross, onOrOff(is.trackerCross));
  note("latency", was.latency, is.latency, onOrOff(is.latency));
  note("eye separation", before.eyeSeparation_m, after.eyeSeparation_m,
       fmt::format("{:.1f} mm", after.eyeSeparation_m * 1e3));
  note("light speed", before.lightSpeed_m_s, after.lightSpeed_m_s,
       fmt::format("{:.3g} m/s", after.lightSpeed_m_s));
  const Playback &played = before.playback, &plays = after.playback;
  note("playback", played.paused, plays.paused, plays.paused ? "paused" : "goes on");
  note("playback rate", played.rate, plays.rate, fmt::format("{:g}", plays.rate));
  note("lesson", before.lesson, after.lesson, wordsFor(after.lesson));
  note("tour", before.tours, after.tours, "asked for");
  note("scenario", before.play, after.play, after.play);
  note("playback", played.jumps, plays.jumps, fmt::format("from {:.2f} s", plays.goTo_s));
  return changes;
}

}  // namespace carom
