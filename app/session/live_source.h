#pragma once
// Decides the frames of a live game, for the viewers whose heads are tracked.

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/play/cue_interaction.h"
#include "app/play/game.h"
#include "app/play/hit_seen.h"
#include "app/play/input_devices.h"
#include "app/play/match.h"
#include "app/play/mouse_people.h"
#include "app/play/shot_memory.h"
#include "app/session/frame_source.h"
#include "app/session/status_message.h"
#include "app/session/wall_presses.h"
#include "app/viewer/platform_motion.h"
#include "app/viewer/viewers.h"
#include "cave/room/room_boundary.h"
#include "devices/usb/rumble.h"

namespace carom {

/// How a live session starts.
struct LiveStart {
  std::chrono::steady_clock::time_point sessionStart;  ///< where the session clock reads zero
  std::optional<FrameRecord> before;                   ///< last frame of the session that is continued
  std::optional<std::uint64_t> frames;                 ///< number of frames to show; unlimited if empty
  std::vector<Stroke> struck = {};                     ///< strokes by hand in the session that is continued
  const HeadsetFrame* headset =
      nullptr;  ///< of the frame that is decided; null: the rig's trackers are followed

  std::uint64_t firstFrame() const { return before ? before->number + 1 : 0; }
};

/// A live game with all state that is reset for each new game.
struct Play {
  /// Starts the game. `begins` is true for a new game and false for one that continues an earlier session;
  /// `struck` are the strokes by hand in that session.
  Play(const Scenario& scenario, const RoomAxes& axes, bool begins, std::span<const Stroke> struck = {})
      : drive(scenario, axes, begins),
        game(scenario, struck),
        cues(kMostViewers, CueInteraction(scenario)),
        isNew(begins) {}

  PlatformMotion drive;
  Game game;
  std::vector<CueInteraction> cues;  ///< of each viewer
  Match match;
  HitSeen hit;
  std::size_t striker = 0;  ///< the viewer who struck last, whose shot is kept
  ShotMemory shots;
  ShotReplay replay;
  bool saidStill = false;                            ///< why steering does nothing was said
  std::array<StatusMessage, kMostViewers> messages;  ///< of each viewer
  LessonState lesson;                                ///< in the previous frame
  std::size_t answeredBy = 0;                        ///< the viewer whose hand gave the last command
  std::size_t lessonObserver = 0;                    ///< the lesson's velocity in the previous frame
  bool explained = false;                            ///< the lesson's moment was held in the previous frame
  std::optional<double> passEnded_s;                 ///< display time at which a pass of the lesson ended
  DriveMode driven = DriveMode::free;                ///< in the previous frame
  std::optional<ObserverViews> frozen;               ///< the last views before time was frozen
  std::size_t captions = 0;                          ///< that have begun
  std::optional<std::tuple<Switches, Switches>> effects;  ///< shown in the previous frame: left, right
  bool isNew;  ///< its first frame is still to come: no time passes for the viewer while a game is loaded
};

class LiveSource : public FrameSource {
 public:
  /// Starts a live game on `world`, that of rank 0's frames. `rig`, `scenario` and `world` must outlive this
  /// object. Throws InputError if a recorded trace is invalid.
  LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start);

  /// Starts a new game after scenario and world, which are held by reference, have been replaced.
  /// The walls come out of black.
  void playAnew();

  /// Shows a message in the room with the next frame.
  void announce(const std::string& words) { pendingMessage_ = words; }

  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;
  SourceStatus status() const override;

 private:
  void advanceLesson(const LessonState& lesson, Decision& decision);
  void beginPass(std::size_t observer);
  ObserverViews lessonView(const OperatorSettings& settings, const FrameTimes& times);
  void see(const OperatorSettings& settings, const FrameTimes& times, bool still, Decision& decision);
  std::optional<Command> press(std::size_t viewer, const WallAction& action, const OperatorSettings& settings,
                               Decision& decision);
  void putInto(FrameRecord& record, const ObserverViews& views) const;
  void begin(const DeskInput& desk, bool asks);
  void strike(std::size_t viewer, bool still, const FrameTimes& times, const OperatorSettings& settings,
              Decision& decision);
  void count(Decision& decision);
  void tellWhoSawFirst(std::span<const HitSeen::Seen> seen, Decision& decision);
  void forget(Decision& decision);
  void tellWhoseShot(bool isEnd, Decision& decision);
  void showAgain(const FrameInput& input, double now_s, Decision& decision);
  DriveWish eased(double step_s);
  void sayWhyStill(const OperatorSettings& settings, Decision& decision);
  void say(std::string_view words, Decision& decision);
  void sayTo(std::size_t viewer, std::string_view words, Decision& decision);
  void tellChanges(std::span<const Command> commands, Decision& decision);
  std::size_t captionsBegunAt(double own_s) const;
  void showCaption(Decision& decision);
  double sampleAge_s(double begin_s);

  const Rig& rig_;
  const Scenario& scenario_;
  const World& world_;
  const HeadsetFrame* headset_;
  std::unique_ptr<MousePeople> people_;  ///< of a dry run
  Viewers viewers_;
  Play play_;
  std::vector<InputDevices> hands_;  ///< of each viewer
  std::size_t atDesk_ = 0;  ///< the viewer to whom mouse and keys belong: over whose walls the mouse was last
  int padStep_ = 0;         ///< by which the gamepad goes on among the buttons of the front wall
  std::size_t steering_ = 0;  ///< the viewer who steered last
  DriveWish wish_;            ///< of this frame
  double onset_ = 0.0;        ///< share of the steered thrust: it sets in softly
  double fade_s_ = 0.0;       ///< how long the walls still come out of black
  Rumble rumble_;
  std::vector<Wall> standing_;                                        ///< the walls that can be left behind
  std::vector<RoomBoundary> roomBoundaries_;                          ///< of each viewer
  std::vector<WallPresses> presses_;                                  ///< of each viewer
  std::optional<std::uint64_t> lastFrame_;                            ///< number of the last frame
  std::string pendingMessage_;                                        ///< message still to be shown
  double newestSample_s_ = std::numeric_limits<double>::quiet_NaN();  ///< newest head sample, session clock
};

}  // namespace carom
