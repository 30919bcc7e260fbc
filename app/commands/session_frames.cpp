#include "app/commands/session_frames.h"

#include <algorithm>

#include "app/rig/rig_viewers.h"
#include "app/stage/all_ranks.h"

namespace carom {

void OperatorWindows::play(const SessionSetup& setup) {
  if (diagram) diagram->play(setup.scenario);
  if (console) console->play(setup.scenario, setup.scene);
}

ConsoleState consoleAtStart(const DeskWindows& desk) {
  if (!desk.console) return ConsoleState::none;
  return desk.consoleWaits ? ConsoleState::waits : ConsoleState::shown;
}

OperatorWindows openWindows(Cluster& cluster, SessionSetup& setup, KeysOf keys) {
  OperatorWindows windows;
  onAllRanks(cluster, [&] {
    if (setup.desk.diagram)
      windows.diagram = std::make_unique<DiagramWindow>(*setup.graphics, *setup.desk.diagram, setup.scenario,
                                                        namesOf(setup.rig.viewers));
    if (!setup.desk.console) return;
    windows.console = std::make_unique<Console>(*setup.graphics, *setup.desk.console, setup.rig, cluster,
                                                keys, setup.scenario, setup.scene, setup.desk.consoleWaits);
  });
  return windows;
}

void rememberWindows(const SessionSetup& setup, const OperatorWindows& windows) {
  if (setup.wallMemory.empty()) return;
  const std::vector<Monitor> present = monitors();
  std::vector<RememberedWindow> lie;
  const auto add = [&](const std::string& name, const std::optional<ScreenPlace>& place) {
    const auto window = place ? remember(name, *place, present) : std::nullopt;
    if (window) lie.push_back(*window);
  };
  for (std::size_t i = 0; i < setup.wallMemory.size(); ++i)
    add(setup.wallMemory[i], setup.walls->placeOf(setup.rig.walls[i].name));
  if (windows.console && !setup.rig.console && !setup.desk.consoleWaits)
    add("console", windows.console->place());
  if (setup.outside) add("outside", setup.outside->place());
  if (windows.diagram) add("diagram", windows.diagram->place());
  writeWindowMemory(windowMemory(), lie);
}

std::unique_ptr<Sounds> soundsFor(const SessionSetup& setup, bool silent) {
  const RoomAxes& axes = setup.rig.axes;
  if (silent || !setup.realTime) return nullptr;
  return std::make_unique<Sounds>(SoundAxes{axes.right, axes.up, axes.forward});
}

std::unique_ptr<FramePacer> pacerFor(const SessionSetup& setup, Clock& clock, double lived_s,
                                     std::uint64_t firstFrame) {
  if (setup.headset) return std::make_unique<HeadsetPacer>(*setup.headset, lived_s, firstFrame);
  clock.sleepUntil(lived_s);
  return std::make_unique<Pacer>(clock, setup.rig.display_hz, setup.rig.displayLatency_s, setup.swapsWait,
                                 firstFrame);
}

namespace {

/// Returns whether the windows of the walls have a tile for the console: on a desk, where it has no room
/// beside them.
bool hasConsoleTile(const SessionSetup& setup) {
  return setup.desk.consoleWaits && std::any_of(setup.rig.walls.begin(), setup.rig.walls.end(),
                                                [](const Wall& wall) { return wall.window.border; });
}

}  // namespace

SessionFrames::SessionFrames(Cluster& cluster, SessionSetup& setup, FramePacer& pacer,
                             const LeaderParts* lead, KeysOf keys)
    : statistics_(cluster, setup.lock, setup.rig.display_hz, setup.realTime),
      walls_(*setup.walls, statistics_, lead ? lead->leader : follower_, keys,
             lead ? &lead->leader.inbox() : nullptr, lead && hasConsoleTile(setup)),
      drawingEnd_(*setup.walls, statistics_, setup.realTime),
      recording_(*setup.recording, *setup.walls, setup.outside.get()),
      context_{cluster,     *setup.graphics, setup.world,    pacer,    lead ? lead->leader : follower_,
               statistics_, {&walls_},       {&statistics_}, &noLock_, &ending_} {
  if (setup.headset) {
    context_.views.insert(context_.views.begin(), &headset_.emplace(*setup.headset, *setup.walls));
    if (lead) context_.listeners.push_back(&haptics_.emplace(*setup.headset));
  }
  if (setup.outside) context_.views.push_back(&outside_.emplace(*setup.outside, *setup.walls));
  if (lead && lead->windows.diagram) context_.views.push_back(lead->windows.diagram.get());
  context_.views.push_back(&drawingEnd_);
  if (lead && lead->sounds) context_.listeners.push_back(&sounds_.emplace(*lead->sounds, setup.world));
  context_.listeners.push_back(&recording_);
  if (lead) listen(setup, *lead, keys);
}

void SessionFrames::listen(SessionSetup& setup, const LeaderParts& lead, KeysOf keys) {
  std::vector<FrameListener*>& listeners = context_.listeners;
  if (lead.journal) {
    lead.journal->measureBy(&statistics_);
    listeners.push_back(lead.journal);
  }
  if (lead.status) {
    lead.status->watch(lead.source, statistics_);
    listeners.push_back(lead.status);
  }
  if (lead.windows.console) {
    listeners.push_back(&console_.emplace(*lead.windows.console, setup, statistics_, lead.source, lead.leader,
                                          keys, lead.classroom, lead.study ? &lead.study->desk() : nullptr));
  }
  if (lead.study) listeners.push_back(lead.study);
  if (lead.phones) listeners.push_back(lead.phones);
  if (!setup.realTime) listeners.push_back(&progress_.emplace(lead.source));
}

}  // namespace carom
