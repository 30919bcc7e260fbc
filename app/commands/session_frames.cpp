#include "app/commands/session_frames.h"

#include "app/stage/all_ranks.h"

namespace carom {

void OperatorWindows::play(const Stage& stage) {
  if (diagram) diagram->play(stage.scenario);
  if (console) console->play(stage.scenario, stage.scene);
}

OperatorWindows openWindows(Cluster& cluster, Stage& stage, bool diagram, bool console, KeysOf keys) {
  OperatorWindows windows;
  onAllRanks(cluster, [&] {
    if (cluster.rank() > 0) return;
    if (diagram) windows.diagram = std::make_unique<DiagramWindow>(*stage.graphics, stage.scenario);
    if (!console) return;
    windows.console =
        std::make_unique<Console>(*stage.graphics, stage.rig, cluster, keys, stage.scenario, stage.scene);
  });
  return windows;
}

std::unique_ptr<Sounds> soundsFor(const Stage& stage, bool silent) {
  const RoomAxes& axes = stage.rig.axes;
  if (silent || !stage.realTime) return nullptr;
  return std::make_unique<Sounds>(SoundAxes{axes.right, axes.up, axes.forward});
}

OperatorSettings settingsAtStart(const Stage& stage) {
  OperatorSettings settings;
  settings.eyeSeparation_m = stage.rig.head.eyeSeparation_m;
  settings.lightSpeed_m_s = stage.scenario.billiard.lightSpeed_m_s;
  return settings;
}

SessionFrames::SessionFrames(Cluster& cluster, Stage& stage, FramePacer& pacer, const Lead* lead, KeysOf keys)
    : statistics_(cluster, stage.lock, stage.rig.display_hz, stage.realTime),
      walls_(*stage.walls, statistics_, lead ? lead->leader : follower_, keys),
      drawingEnd_(*stage.walls, statistics_, stage.realTime),
      recording_(*stage.recording, *stage.walls, stage.outside.get()),
      context_{cluster,     *stage.graphics, stage.world,   pacer, lead ? lead->leader : follower_,
               statistics_, {&walls_},       {&statistics_}} {
  if (stage.outside) context_.views.push_back(&outside_.emplace(*stage.outside, *stage.walls));
  if (lead && lead->windows.diagram) context_.views.push_back(lead->windows.diagram.get());
  context_.views.push_back(&drawingEnd_);
  if (lead && lead->sounds) context_.listeners.push_back(&sounds_.emplace(*lead->sounds, stage.world));
  context_.listeners.push_back(&recording_);
  if (lead) listen(stage, *lead, keys);
}

void SessionFrames::listen(Stage& stage, const Lead& lead, KeysOf keys) {
  std::vector<FrameListener*>& listeners = context_.listeners;
  if (lead.journal) {
    lead.journal->measureBy(&statistics_);
    listeners.push_back(lead.journal);
  }
  if (lead.windows.console) {
    listeners.push_back(
        &console_.emplace(*lead.windows.console, stage, statistics_, lead.source, lead.leader, keys));
  }
  if (!stage.realTime) listeners.push_back(&progress_.emplace(lead.source));
}

}  // namespace carom
