#pragma once
// Frames of a game that is being played, for the person whose head is tracked.

#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/play/cue_interaction.h"
#include "app/play/game.h"
#include "app/play/input_devices.h"
#include "app/session/frame_source.h"
#include "app/session/status_message.h"
#include "app/viewer/platform_motion.h"
#include "app/viewer/viewer.h"
#include "cave/room/room_boundary.h"
#include "devices/usb/rumble.h"

namespace carom {

/// How a session begins.
struct LiveStart {
  std::chrono::steady_clock::time_point sessionStart;  ///< where the session's clock reads zero
  std::optional<FrameRecord> before;                   ///< the last frame of a session that goes on
  std::optional<std::uint64_t> frames;                 ///< so many, then the end
  std::vector<Stroke> struck = {};                     ///< by hands, in the session that goes on

  std::uint64_t firstFrame() const { return before ? before->number + 1 : 0; }
};

/// A game as it is played, and all that begins anew with another one.
struct Play {
  /// `begins`: from the scenario's beginning. `struck`: by hands, in a session that goes on.
  Play(const Scenario& scenario, const RoomAxes& axes, bool begins, std::span<const Stroke> struck = {})
      : drive(scenario, axes, begins), game(scenario, struck), hands(scenario), isNew(begins) {}

  PlatformMotion drive;
  Game game;
  CueInteraction hands;
  StatusMessage message;
  LessonState lesson;                  ///< of the last frame
  DriveMode driven = DriveMode::free;  ///< in the last frame
  std::optional<ObserverView> frozen;  ///< the sight that is walked round
  bool isNew;  ///< its first frame is still to come: nobody lives while a game is loaded
};

class LiveSource : public FrameSource {
 public:
  /// Rig, scenario and world, that of rank 0's frames, are used as long as this lives. Throws InputError if a
  /// trace is at fault.
  LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start);

  /// There is another scenario, and its world, in the place of the first: from its beginning.
  void playAnew();

  /// Is said in the room from the next frame on.
  void announce(const std::string& words) { pendingMessage_ = words; }

  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;
  SourceStatus status() const override;

 private:
  void advanceLesson(const LessonState& lesson, Decision& decision);
  void see(const OperatorSettings& settings, const FrameTimes& times, bool still, Decision& decision);
  void strike(bool still, const FrameTimes& times, Decision& decision);
  void say(std::string_view words, Decision& decision);
  double sampleAge_s(double begin_s);

  const Rig& rig_;
  const Scenario& scenario_;
  const World& world_;
  Viewer viewer_;
  Play play_;
  InputDevices hands_;
  Rumble rumble_;
  RoomBoundary roomBoundary_;
  std::optional<std::uint64_t> lastFrame_;                            ///< its number
  std::string pendingMessage_;                                        ///< and not said yet
  double newestSample_s_ = std::numeric_limits<double>::quiet_NaN();  ///< of the head, on the session's clock
};

}  // namespace carom
