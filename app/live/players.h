#pragma once
// The people in the room as players: their cues, their match, who has seen what, and the shots that are kept.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/live/announcements.h"
#include "app/live/decision.h"
#include "app/live/linked_room.h"
#include "app/live/player_inputs.h"
#include "app/live/sculpture_stand.h"
#include "app/live/task_run.h"
#include "app/operator/command.h"
#include "app/play/cue_interaction.h"
#include "app/play/game.h"
#include "app/play/hit_seen.h"
#include "app/play/match.h"
#include "app/play/shot_memory.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"

namespace carom {

/// What decides what the hands can do in a frame.
struct HandRules {
  const OperatorSettings& settings;
  bool asks = false;  ///< a lesson waits for an answer
  bool mayStrike =
      false;  ///< time passes, and the game is not that of a lesson, which is played again and again
  const World* world = nullptr;  ///< as it was shown
  LinkedRoom* link = nullptr;    ///< of a room that is linked with another
};

class Players {
 public:
  /// With `before`, the match goes on from that frame of an earlier session. `scenario` must outlive this
  /// object.
  Players(const Rig& rig, const Scenario& scenario, const std::optional<FrameRecord>& before);

  /// Begins to show the best shot again, or ends it; anything that a person does (`isInterrupted`) ends it as
  /// well.
  void showBestShot(std::span<const Command> commands, bool isInterrupted, Announcements& announcements,
                    Decision& decision);
  /// Returns the view of the best shot while it is shown again, or null.
  const ShotView* shot(double display_s) const { return replay_.view(shots_, display_s); }

  /// Lets hands feel what their strokes do, in the frame in which it is seen and time passes. Before `act`,
  /// which posts it to the devices.
  static void feel(const World& world, PlayerInputs& inputs, const FrameRecord& record);

  /// Puts the sculpture of spacetime into the record of a frame whose viewers are set.
  void placeSculpture(FrameRecord& record) { sculpture_.putInto(record); }

  /// Lets each hand act on the game: strokes, presses on buttons, answers.
  void act(const HandRules& rules, const Viewers& viewers, PlayerInputs& inputs, Game& game,
           Announcements& announcements, Decision& decision);

  /// Looks at what each viewer sees of the events in a frame in which time passes: counts a carom when the
  /// one who struck sees it, and says so; tells who saw a hit first; judges the task.
  void see(const World& world, const OperatorSettings& settings, Announcements& announcements,
           Decision& decision);

  /// Returns the earliest view that may be shown again, or that of the one who struck last.
  const ObserverView& earliest(const FrameRecord& record) {
    return shots_.earliest(record.viewers[striker_].observer, record.display_s);
  }

  std::size_t answeredBy() const { return answeredBy_; }  ///< the viewer whose hand gave the last command

 private:
  void act(std::size_t viewer, const HandRules& rules, const Viewers& viewers, PlayerInputs& inputs,
           Game& game, Announcements& announcements, Decision& decision);
  void struck(std::size_t viewer, const HandRules& rules, const CueInteraction::Outcome& outcome,
              Decision& decision);
  std::optional<HandForce::Holding> hold(std::size_t viewer, const HandInput& hand, const HandRules& rules,
                                         const FrameRecord& record);

  const Scenario* scenario_;
  std::vector<CueInteraction> cues_;  ///< of each viewer
  Match match_;
  HitSeen hit_;
  std::uint32_t strokes_ = 0;  ///< by hand in this game
  std::size_t striker_ = 0;    ///< the viewer who struck last, whose shot is kept
  ShotMemory shots_;
  ShotReplay replay_;
  TaskRun tasks_;
  SculptureStand sculpture_;
  std::size_t answeredBy_ = 0;
  std::array<std::optional<std::size_t>, kMostViewers> held_{};  ///< the puck that each viewer holds
};

}  // namespace carom
