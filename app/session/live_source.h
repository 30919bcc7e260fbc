#pragma once
// Frames of a game that is being played, for the person whose head is tracked.

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/journal/journal.h"
#include "app/play/cue_interaction.h"
#include "app/play/game.h"
#include "app/play/input_devices.h"
#include "app/session/frame_source.h"
#include "app/session/spoken.h"
#include "app/viewer/platform_motion.h"
#include "app/viewer/viewer.h"
#include "cave/frame/pacer.h"
#include "cave/process/termination.h"
#include "cave/room/room_boundary.h"
#include "devices/usb/rumble.h"

namespace carom {

/// How a session begins.
struct LiveStart {
  std::chrono::steady_clock::time_point sessionStart;  ///< where the session's clock reads zero
  std::unique_ptr<Clock> clock;
  bool swapsWait = false;               ///< of the display (cave/frame/pacer.h)
  std::optional<FrameRecord> before;    ///< the last frame of a session that goes on
  std::optional<std::uint64_t> frames;  ///< so many, then the end
  std::vector<Stroke> struck = {};      ///< by hands, in the session that goes on
};

class LiveSource : public FrameSource {
 public:
  /// Rig, scenario and world, that of rank 0's frames, are used as long as this lives. Throws InputError if a
  /// trace is at fault.
  LiveSource(const Rig& rig, const Scenario& scenario, const World& world, LiveStart start);
  ~LiveSource() override { keep(nullptr); }
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  /// Writes the session to this journal from now on; none: it is not written.
  void keep(std::unique_ptr<Journal> journal);

  /// There is another scenario, and its world, in the place of the first: from its beginning, in this
  /// journal.
  void playAnew(std::unique_ptr<Journal> journal);

  /// Is said in the room from the next frame on.
  void tell(const std::string& words) { told_ = words; }

  void next(const Controls& controls, FrameState& state) override;
  Deciding deciding() const override { return deciding_; }
  std::optional<std::uint64_t> end() const override;
  void drawn() override;
  void shown(const FrameState& state) override;
  void changed(std::uint64_t number, const ControlChange& change) override;
  void handled(const DeskInput& desk) override { desk_ = desk; }
  std::vector<TrackerReport> trackers() const override { return viewer_.trackers(); }
  void measured(std::span<const LatencyRow> rows) override;

 private:
  LessonState lessonAt(const Controls& controls, std::uint64_t number);
  ObserverView lived(const Controls& controls, const FrameTimes& times, double pace);
  void play(bool still, const FrameTimes& times, FrameRecord& record);
  void say(std::string_view words, const FrameTimes& times);
  void noteDeciding(double begin_s, std::chrono::steady_clock::time_point begun);

  const Rig& rig_;
  const Scenario& scenario_;
  const World& world_;
  std::unique_ptr<Clock> clock_;
  Pacer pacer_;
  Viewer viewer_;
  PlatformMotion platformMotion_;
  DriveMode driven_ = DriveMode::free;  ///< of the last frame
  std::optional<unsigned> tours_;       ///< of the last frame's controls
  Game game_;
  InputDevices hands_;
  Rumble rumble_;
  CueInteraction cueInteraction_;
  std::optional<Stroke> struck_;  ///< in the frame at hand
  std::unique_ptr<Journal> journal_;
  std::optional<ClosedOnLeaving> onLeaving_;  ///< of the journal
  std::optional<std::uint64_t> lastFrame_;    ///< its number
  bool begins_ = false;                       ///< another game, with the next frame
  DeskInput desk_;                            ///< of the frame before
  LessonState lesson_;                        ///< of the last frame
  RoomBoundary roomBoundary_;
  Spoken spoken_;
  std::string told_;                    ///< and not said yet
  std::optional<ObserverView> frozen_;  ///< the sight that is walked round
  Deciding deciding_;
  double newestSample_s_ = std::numeric_limits<double>::quiet_NaN();  ///< of the head, on the session's clock
};

}  // namespace carom
