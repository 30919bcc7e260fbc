#pragma once
// The celerity of a tracked point from its noisy positions: an interacting-multiple-model Kalman filter
// (Blom and Bar-Shalom 1988; Bar-Shalom, Li and Kirubarajan 2001, 11.6). Each model holds another idea of how
// vigorously a head moves at present, from standing still to hurrying; every sample tells how likely each is,
// and the estimate is their mean.
//
// The models' values (celerity_filter.cpp) were found on six simulated heads and on twelve recorded ones (of
// an OptiTrack, a HoloLens, a Quest 2 and Pro and of TUM's camera), with 0.1 to 2 mm of noise added, at 60
// and 120 Hz, with the demand that none be far behind the best of four other filters. They are the same at
// every rate: they describe the head, not the tracker, whose noise is told from the samples
// (tracker_noise.h).
//
// What an error of celerity does to the eye depends on its direction (aberration_error.h), and the estimate
// needs not know: a mean has the least square error however components are weighted against each other.
// Theory: app/doc/physics.md, Aberration and cells.

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "devices/filter/tracker_noise.h"

namespace carom {

/// Causal, for uneven sampling, and the same in every orientation of the axes (noise and motion are taken as
/// isotropic, and the axes are judged together). Does not allocate; gives the same bits in every run.
class CelerityFilter {
 public:
  explicit CelerityFilter(double trackerSigma_m) : noise_(trackerSigma_m) {}

  /// Starts anew at a position, with nothing known of the motion.
  void start(double time_s, const glm::dvec3& position_m);

  /// Takes the next position, at a later time than the last.
  void update(double time_s, const glm::dvec3& position_m);

  /// Shifts the estimate by `offset_m`: the tracker shows all positions from here on elsewhere by that much,
  /// but the point has not moved.
  void moveBy(const glm::dvec3& offset_m);

  double time_s() const { return time_s_; }  ///< of the last position; the estimates below hold at that time
  const glm::dvec3& position_m() const { return mean_[0]; }
  const glm::dvec3& celerity_m_s() const { return mean_[1]; }
  glm::dmat3 celerityCovariance_m2_s2() const;

  /// Returns how late the celerity is while it grows evenly, at the present gains: the error of celerity for
  /// each m/s² of constant acceleration. It is the value of the moving models; a still head has no lag.
  double lag_s() const;

  /// Where the point is and how it moves.
  struct Course {
    glm::dvec3 position_m{0.0};
    glm::dvec3 celerity_m_s{0.0};
  };
  /// Returns the expected course `ahead_s` after the last position: the mean of the models, which all go on
  /// by themselves.
  Course predicted(double ahead_s) const;
  glm::dvec3 predictedPosition_m(double ahead_s) const { return predicted(ahead_s).position_m; }

  /// Returns the standard deviation (one component) of a position measured at that time if the point kept its
  /// celerity.
  double predictedSigma_m(double ahead_s) const;

  /// Returns the variance (one component) by which the celerity may have changed `ahead_s` after the last
  /// position.
  double celerityChange_m2_s2(double ahead_s) const;

  /// Returns the present estimate of the noise of the positions, at least 0.01 mm and at most 10 mm.
  double trackerSigma_m() const;
  /// Whether that noise was estimated from the samples and is not the initial value.
  bool isTrackerSigmaKnown() const { return noise_.isKnown(); }

  static constexpr int kModels = 7;

 private:
  /// Columns: position, celerity, acceleration and its drive (m, m/s, m/s², m/s³) of the point.
  using State = glm::dmat4x3;

  /// What one model believes. Gains depend on times alone, so one covariance of (position, celerity,
  /// acceleration, drive) serves all three axes.
  struct Belief {
    double probability = 0.0;
    State state{0.0};
    glm::dmat4 covariance{0.0};
    glm::dvec4 rampError{0.0};  // true − estimated state, had the point accelerated at 1 m/s² all the time
  };

  using Beliefs = std::array<Belief, kModels>;
  void mix(double interval_s);
  double correct(Belief& belief, const glm::dvec3& position_m) const;
  void average();

  double time_s_ = 0.0;
  Beliefs beliefs_;
  State mean_{0.0};
  TrackerNoise noise_;
};

}  // namespace carom
