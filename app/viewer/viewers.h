#pragma once
// The viewers in the room: their tracked heads and hands, and their world lines.

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/head_tracking.h"
#include "app/viewer/platform_motion.h"
#include "app/viewer/shared_trackers.h"
#include "cave/frame/pacer.h"
#include "cave/record/frame_state.h"
#include "engine/spacetime/observers.h"

namespace carom {

/// What the viewers of a rig see by, in its order.
using ObserverViews = std::array<ObserverView, kMostViewers>;

class Viewers {
 public:
  /// Starts at the scenario's initial state or, with `before`, at the observation events of an earlier
  /// session's last frame. `sessionStart` is where the session clock reads zero. Throws InputError if a
  /// recorded trace is invalid.
  Viewers(const Rig& rig, const Scenario& scenario, std::chrono::steady_clock::time_point sessionStart,
          const std::optional<FrameRecord>& before = {})
      : Viewers(rig, scenario, SharedTrackers(rig, sessionStart), before) {}
  /// Does the same with trackers that are not followed yet.
  Viewers(const Rig& rig, const Scenario& scenario, SharedTrackers trackers,
          const std::optional<FrameRecord>& before = {});

  /// Puts the eyes of the first viewer where the headset has them, if one is worn, for the views from now on.
  /// The first time, before time has passed for anybody, the head is put there as well. Returns what the
  /// frame's record keeps of it.
  const HeadsetState& putOn(const std::optional<HeadsetFrame>& headset);

  /// From now on the heads stay where they are, whatever the trackers say; or they move again.
  void hold(bool on);

  /// Restarts in the initial state of another scenario, with proper time zero. The trackers continue.
  void startIn(const Rig& rig, const Scenario& scenario);

  /// Restarts at board time `board_s` on the way of a room that moves as `start` says and is there at board
  /// time 0, with proper time zero. The trackers continue.
  void startAt(const Rig& rig, const Scenario& scenario, const ObserverStart& start, double board_s);

  /// Advances the world lines to the frame's display time and returns the eyes there. The first viewer's are
  /// `eyeSeparation_m` apart, those of the others in the rig's proportion to it. `pace` is the number of game
  /// seconds per second of the viewer who moves fastest.
  ObserverViews at(const FrameTimes& times, double eyeSeparation_m, double pace = 1.0);
  /// Does the same on a platform that is driven by viewer `steering`.
  ObserverViews at(const FrameTimes& times, double eyeSeparation_m, double pace, const DriveWish& wish,
                   PlatformMotion& drive, std::size_t steering = 0);

  /// Does the same at the first of these paces whose views are allowed. If none are, the people do not live
  /// on, and nothing is returned.
  std::optional<ObserverViews> atOneOf(std::span<const double> paces,
                                       const std::function<bool(const ObserverViews&)>& isAllowed,
                                       const FrameTimes& times, double eyeSeparation_m, const DriveWish& wish,
                                       PlatformMotion& drive, std::size_t steering);

  /// Returns views that stay at their events in `sight` while the heads, as they were tracked last, move in
  /// the room without effect. The people do not live on.
  ObserverViews standingView(const ObserverViews& sight, double eyeSeparation_m) const;

  /// Returns the views after `step_s` of the fastest viewer's proper time, however long the frame takes. The
  /// heads' motion has no relativistic effect meanwhile (Observers::moveUnseen).
  ObserverViews slowView(const FrameTimes& times, double eyeSeparation_m, double pace, double step_s,
                         const DriveWish& wish, PlatformMotion& drive, std::size_t steering = 0);

  /// Lives on until board time `board_s` of the first, with the heads at rest in the room.
  void runTo(double board_s, PlatformMotion& drive);

  /// Frozen mode: each view stays at one observation event while the head moves. `sight` are the views at
  /// those events.
  ObserverViews frozenView(const ObserverViews& sight, const FrameTimes& times, double eyeSeparation_m);

  /// Returns the views when the room's time is advanced, or set back, by `roomTime_s`. The heads' motion has
  /// no relativistic effect meanwhile (Observers::moveUnseen).
  ObserverViews freeView(const FrameTimes& times, double eyeSeparation_m, double roomTime_s);

  /// Follows the heads to the frame. The people do not live on.
  void follow(const FrameTimes& times) { track(times); }
  /// Returns the views at the observers' present events.
  ObserverViews now(double eyeSeparation_m) const { return views(eyeSeparation_m); }

  const Observers& observers() const { return observers_; }
  std::size_t size() const { return observers_.size(); }
  /// The head at that display time, and the tracker data for it.
  const HeadEstimate& head(std::size_t viewer = 0) const { return heads_[viewer]; }
  double board_s(std::size_t viewer = 0) const { return observers_.headEvent(viewer).t_s; }
  double room_s() const { return observers_.room_s(); }
  Tracked tracked(std::size_t viewer = 0) const { return trackings_[viewer]->tracked(); }
  const HandDevices& hand(std::size_t viewer = 0) const { return trackings_[viewer]->hand(); }
  std::vector<TrackerReport> trackers() const;
  std::vector<std::string> takeAlarms();
  const Lorentz& boardFromRoom() const { return observers_.boardFromRoom(); }
  /// Returns the samples of all sensors of a head's tracker for that frame.
  std::span<const TrackerSample> samples(std::size_t viewer = 0) const {
    return trackings_[viewer]->samples();
  }
  /// Adds the same of all heads' trackers, each once.
  void samplesInto(std::vector<TrackerSamples>& samples) const;

  /// Writes what the frame's record holds of the viewers, except their eyes, hands and messages.
  void putInto(FrameRecord& record) const;

 private:
  using Heads = std::array<Head, kMostViewers>;

  void track(const FrameTimes& times);
  Heads heads() const;
  Heads headsAtRest() const;
  std::span<const Head> used(const Heads& heads) const { return std::span(heads).first(trackings_.size()); }
  Observers startOf(const Rig& rig, const Scenario& scenario, const std::optional<FrameRecord>& before) const;
  ObserverViews views(double eyeSeparation_m) const { return viewsOf(observers_, eyeSeparation_m); }
  ObserverViews viewsOf(const Observers& observers, double eyeSeparation_m) const;

  SharedTrackers shared_;
  std::vector<std::unique_ptr<HeadTracking>> trackings_;  ///< of each viewer
  std::vector<std::string> names_;
  std::array<double, kMostViewers> eyeSeparations_m_{};  ///< as in the rig
  /// Of a headset: from the head to the left and the right eye, in the room's axes.
  std::optional<std::array<Vec3, 2>> worn_m_;
  HeadsetState worn_;                                 ///< as it was last worn
  std::array<std::size_t, kMostViewers> trackers_{};  ///< of the heads, indices of the rig's trackers
  std::array<HeadEstimate, kMostViewers> heads_;
  std::optional<std::array<Pose, kMostViewers>> held_;  ///< where the heads stay
  Observers observers_;
};

}  // namespace carom
