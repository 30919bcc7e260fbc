#pragma once
// From tracker samples of the eye midpoint to the two things a session needs of a head:
//
//  * where it will be when the light leaves the wall: a pose, lightly filtered and predicted, and
//  * how fast it moves: its celerity, filtered on its own, and predicted only where samples are overdue.
//
// A sample's time is the user's own time, so the estimate is dx/dτ = γv, the celerity, which has no
// upper limit. An error of celerity turns the whole sky by about δw/c, so this channel must be quiet when
// the user is still and quick when they move: an interacting-multiple-model Kalman filter
// (celerity_filter.h).

#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "devices/filter/celerity_filter.h"
#include "devices/filter/jump_judge.h"
#include "engine/base/pose.h"

namespace carom {

/// How a head pose is known.
enum class Known {
  measured,   ///< at the time of the newest sample
  predicted,  ///< a little after the newest sample, from its motion
  held,       ///< samples are overdue: the head goes on as before, then comes to rest
  lost,       ///< no samples for long, or none yet: kept, and not to be trusted
};

/// Returns the name for people: "measured", "predicted", "held" or "lost".
const char* toString(Known known);

/// The head at one time. Axes and origin are those of the poses given to the filter.
struct HeadEstimate {
  double time_s = 0.0;
  Known known = Known::lost;
  Pose pose;                     ///< roomFromHead, metres
  glm::dvec3 celerity_m_s{0.0};  ///< dx/dτ of the eye midpoint
  glm::dmat3 celerityCovariance_m2_s2{0.0};
  double sigma_m_s = 0.0;  ///< largest standard deviation of a celerity component
  double lag_s = 0.0;      ///< delay of the celerity: how late it is at constant acceleration
};

/// How the filter has used a sample.
enum class SampleUse {
  used,
  glitch,    ///< too far away for a head by that time; used only if the next sample confirms it
  unusable,  ///< not after the last sample, or not finite: not used
};

/// Filters the samples of one head. No allocation, the same bits in every run.
///
/// Samples where no head gets are glitches of the tracker and count as loss (jump_judge.h). Where no usable
/// sample comes, because somebody has lifted an arm, the head goes on as its models expect it, by their mean
/// and covariance, for 0.5 s. A sample that comes back by then is taken by the models as any other: the
/// longer the gap, the less the estimate counts beside it (the prediction of a Kalman filter over a missing
/// measurement; Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation,
/// 2001, 5.2 and 11.6). Nothing is begun anew, and nothing fades.
///
/// From 0.5 s on the head comes to rest: the share of its celerity that is shown falls as 1 − u²(3 − 2u),
/// smooth at both ends, and is zero a second after the last sample. The pose goes on at the shown celerity
/// and stops with it. Samples that return then are taken by the models, too, and the share grows again over
/// 0.2 s. After a whole second nothing is known of the motion, and celerity is estimated anew and fades in
/// likewise.
///
/// The celerity of a recent sample is not predicted: what it gains by its acceleration counts from 0.1 s
/// after the sample on. The orientation goes on turning for 0.1 s and stops, since turns of the head are
/// brief.
///
/// When samples come back after more than 0.1 s, the pose slides to the new place at 1 m/s and 3 rad/s,
/// beside the user's own motion: where the prediction was off by 3 cm, as is usual after 0.3 s, in 30 ms. A
/// step of the tracker is slid over in the same way; the celerity ignores it. Glitches that follow one
/// another for 0.3 s are the head's new place, and so is a place to which no head gets from its course within
/// a gap of over 0.3 s: celerity is estimated anew, and within 0.2 s the estimate takes the place of the
/// celerity shown before.
///
/// That slide is a motion of the shown pose and none of the celerity. The observer's world line follows it
/// (engine/spacetime/observer.h) and stays timelike at any light speed: an eye that was put elsewhere instead
/// could see events run back. So board time goes on by sqrt(1 + (1 m/s)²/c²) seconds a second at most while
/// it lasts, 22 % fast at 1.42 m/s, and has no jump. The sky, which the celerity turns, takes no part: the
/// user has not moved.
///
/// The poses are of the eyes, not of the sensor, so that turning the head about a sensor that is far from
/// them is motion, ω × lever arm, and the sensor's noise of rotation is noise of position: the estimate of
/// the tracker's noise is made of these same positions and holds both.
class HeadFilter {
 public:
  /// `trackerSigma_m`: standard deviation of the tracker's noise per axis to begin with; it is then
  /// estimated from the samples.
  explicit HeadFilter(double trackerSigma_m = 0.0003);

  /// Takes the next sample: the pose of the eye midpoint (roomFromSensor * sensorFromEyes) at a time.
  SampleUse add(double time_s, const Pose& roomFromHead);

  /// Returns the head at a time at or after the newest used sample (an earlier time counts as that of the
  /// sample).
  HeadEstimate at(double time_s) const;

  /// Returns whether a sample has been used.
  bool hasStarted() const { return started_; }

  /// Lets the celerity grow from nothing to its full size over the 0.5 s after this time. From its first
  /// samples the filter cannot tell noise from motion, so the scene would jump when a session begins.
  void fadeInFrom(double time_s) { fadesInFrom_s_ = time_s; }

  /// Returns the present estimate of the tracker's noise: standard deviation per axis, metres.
  double trackerSigma_m() const { return celerity_.trackerSigma_m(); }

 private:
  struct Doubted {
    double time_s = 0.0;
    Pose roomFromHead;
  };

  void use(double time_s, const Pose& measured);
  void start(double time_s, const Pose& roomFromHead);
  void turn(double interval_s, const glm::dquat& orientation);
  Pose filteredPose(double time_s) const;
  Pose shownPose(double time_s) const;
  glm::dvec3 shownCelerity_m_s(double time_s) const;
  void takeOverFade(double time_s);

  CelerityFilter celerity_;
  bool started_ = false;
  double fadesInFrom_s_ = -std::numeric_limits<double>::infinity();
  double time_s_ = 0.0;                         // of the newest used sample
  glm::dquat orientation_{1.0, 0.0, 0.0, 0.0};  // filtered
  glm::dvec3 angularVelocity_rad_s_{0.0};
  double share_ = 1.0;          // of the estimated celerity in the one that is shown
  glm::dvec3 before_m_s_{0.0};  // the rest: the celerity that was shown when samples came back
  JumpJudge judge_;
  Doubted doubted_;  // the newest doubted sample

  // Shown pose − filtered pose when samples came back; it shrinks to nothing.
  double returned_s_ = 0.0;
  glm::dvec3 offset_m_{0.0};
  glm::dvec3 offset_rad_{0.0};
};

}  // namespace carom
