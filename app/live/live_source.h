#pragma once
// Decides the frames of a live game, for the viewers whose heads are tracked. Each stage of a frame is a
// class of its own: the inputs of the players, the room's motion, the lesson, what the players do and see,
// and who is told what.

#include <chrono>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/live/announcements.h"
#include "app/live/frame_source.h"
#include "app/live/lesson_run.h"
#include "app/live/player_inputs.h"
#include "app/live/players.h"
#include "app/play/game.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/room_motion.h"

namespace carom {

/// How a live session starts.
struct LiveStart {
  std::chrono::steady_clock::time_point sessionStart;  ///< where the session clock reads zero
  std::optional<FrameRecord> before;                   ///< last frame of the session that is continued
  std::optional<std::uint64_t> frames;                 ///< number of frames to show; unlimited if empty
  std::vector<Stroke> struck = {};                     ///< strokes by hand in the session that is continued
  LinkedRoom* link = nullptr;                          ///< with another room; must outlive the source

  std::uint64_t firstFrame() const { return before ? before->number + 1 : 0; }
};

class LiveSource : public FrameSource {
 public:
  /// Starts a live game on `world`, that of rank 0's frames. `rig`, `scenario` and `world` must outlive this
  /// object. Throws InputError if a recorded trace is invalid.
  LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start);

  /// Starts a new game after scenario and world, which are held by reference, have been replaced.
  /// The walls come out of black.
  void playAnew();
  /// From now on the heads stay where they are, or move again.
  void holdHeads(bool on) { room_.viewers().hold(on); }

  /// Shows a message in the room with the next frame.
  void announce(const texts::Saying& words) { announcements_.later(words); }

  /// Leaves the force devices at 0 N, and returns the notes of it, for the session's end.
  std::vector<Note> endForces() { return inputs_.endForces(); }

  void next(const FrameTimes& given, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;
  SourceStatus status() const override;

 private:
  void hear(std::span<const Command> commands, Decision& decision);
  FrameTimes begin(const FrameTimes& given, const OperatorSettings& settings, FrameRecord& record);
  DriveWish steer(const FrameInput& input, const OperatorSettings& settings, const FrameTimes& times,
                  Decision& decision);
  bool move(const RoomStep& step, const OperatorSettings& settings, bool still, const ShotView* shot,
            Decision& decision);
  const ShotView* shotAt(const FrameTimes& times, std::span<const Command> commands, Decision& decision);
  void act(const OperatorSettings& settings, bool timePasses, Decision& decision);
  void tell(std::span<const Command> commands, const OperatorSettings& settings, bool still,
            Decision& decision);
  void seeFromPlaces(const FrameRecord& record, const std::function<void(const ObserverView&)>& take) const;
  void playGame(const OperatorSettings& settings, FrameState& frame);
  void finish(const FrameTimes& given, Decision& decision);
  void put(const ObserverViews& views, FrameRecord& record) const;
  double sampleAge_s(double begin_s);

  const Rig& rig_;
  const Scenario& scenario_;
  const World& world_;
  PlayerInputs inputs_;
  RoomMotion room_;
  LessonRun lesson_;
  Game game_;
  Players players_;
  Announcements announcements_;
  LinkedRoom* link_;                     ///< null: with no other room
  std::optional<ObserverViews> frozen_;  ///< the last views before time was frozen
  bool isNew_;  ///< its first frame is still to come: no time passes for the viewer while a game is loaded
  double fade_s_ = 0.0;                     ///< how long the walls still come out of black
  std::optional<std::uint64_t> lastFrame_;  ///< number of the last frame
  /// Of the previous frame.
  struct Previous {
    DriveMode drive = DriveMode::free;
    double newestSample_s = std::numeric_limits<double>::quiet_NaN();  ///< of the head, session clock
  } previous_;
};

}  // namespace carom
