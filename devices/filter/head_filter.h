#pragma once
// From tracker samples of the eye midpoint to the two things a session needs of a head:
//
//  * where it will be when the light leaves the wall: a pose, lightly filtered and predicted, and
//  * how fast it moves: its celerity, filtered on its own and never predicted.
//
// A sample's time is the user's own time, so what is estimated is dx/dτ = γv, the celerity, which has no
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
  held,       ///< samples are overdue: kept where the prediction ended
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
/// sample comes, the pose is predicted for 0.1 s and then held, and the celerity fades to zero until 0.3 s
/// after the last sample. When samples come back, celerity is estimated anew and fades in over 0.2 s, and the
/// pose slides to the new place at 1 m/s and 3 rad/s, beside the user's own motion. A step of the tracker is
/// slid over in the same way; the celerity ignores it. Glitches that follow one another for 0.3 s are the
/// head's new place.
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

  /// Lets the celerity grow from nothing to its full size over the 0.5 s after this time. From its first samples
  /// the filter cannot tell noise from motion, so the scene would jump when a session begins.
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
  double shownShare(double time_s) const;

  CelerityFilter celerity_;
  bool started_ = false;
  double fadesInFrom_s_ = -std::numeric_limits<double>::infinity();
  double time_s_ = 0.0;                         // of the newest used sample
  glm::dquat orientation_{1.0, 0.0, 0.0, 0.0};  // filtered
  glm::dvec3 angularVelocity_rad_s_{0.0};
  double share_ = 1.0;  // of the estimated celerity that is shown then
  JumpJudge judge_;
  Doubted doubted_;  // the newest doubted sample

  // Shown pose − filtered pose when samples came back; it shrinks to nothing.
  double returned_s_ = 0.0;
  glm::dvec3 offset_m_{0.0};
  glm::dvec3 offset_rad_{0.0};
};

}  // namespace carom
