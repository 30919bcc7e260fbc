#include "devices/filter/head_filter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/base/limits.h"

namespace carom {
namespace {

constexpr double kSlew_m_s = 1.0;        // how fast the pose comes over to where samples came back
constexpr double kFadeIn_s = 0.5;        // in which celerity grows where fadeInFrom asks for it
constexpr double kRounding_m_s = 1e-12;  // what remains of the celerity of a head at rest; it would move, and
                                         // with it every pixel be drawn anew
constexpr double kFadesBack_s = 0.2;     // in which celerity grows after it has faded
constexpr double kSlew_rad_s = 3.0;
constexpr double kTurnMemory_s = 0.03;  // of the orientation filter
constexpr double kUnknown_m_s = 1.0;    // standard deviation of a celerity nothing is known of

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// The rotation vector (axis × angle, angle ≤ π) of a rotation, and back.
glm::dvec3 rotationVector(glm::dquat q) {
  if (q.w < 0.0) q = -q;
  const glm::dvec3 v(q.x, q.y, q.z);
  const double sine = glm::length(v);
  if (sine < 1e-12) return 2.0 * v;
  return v * (2.0 * std::atan2(sine, q.w) / sine);
}

glm::dquat rotation(const glm::dvec3& vector_rad) {
  const double angle_rad = glm::length(vector_rad);
  if (angle_rad < 1e-12) return glm::normalize(glm::dquat(1.0, 0.5 * vector_rad));
  return glm::angleAxis(angle_rad, vector_rad / angle_rad);
}

// Which part of the fade is over so long after the last sample.
double fadedAfter(double ahead_s) { return std::clamp((ahead_s - kTrackCoasts_s) / kTrackFades_s, 0.0, 1.0); }

// Which share of the celerity is left then.
double leftAfter(double ahead_s) {
  const double u = fadedAfter(ahead_s);
  return 1.0 - u * u * (3.0 - 2.0 * u);
}

// How long a head that goes on as before would take for the way that one takes whose celerity fades by the
// share 1 − u²(3 − 2u): the integral of that share, u − u³ + u⁴/2 in units of the fade.
double coasted_s(double ahead_s) {
  const double u = fadedAfter(ahead_s);
  return std::min(ahead_s, kTrackCoasts_s) + kTrackFades_s * u * (1.0 - u * u * (1.0 - 0.5 * u));
}

// A vector made shorter by a length, not below nothing.
glm::dvec3 shortened(const glm::dvec3& v, double by) {
  const double length = glm::length(v);
  return length <= by ? glm::dvec3(0.0) : v * (1.0 - by / length);
}

}  // namespace

const char* toString(Known known) {
  switch (known) {
    case Known::measured:
      return "measured";
    case Known::predicted:
      return "predicted";
    case Known::held:
      return "held";
    case Known::lost:
      return "lost";
  }
  return "";
}

HeadFilter::HeadFilter(double trackerSigma_m) : celerity_(trackerSigma_m) {}

SampleUse HeadFilter::add(double time_s, const Pose& roomFromHead) {
  const double norm = glm::length(roomFromHead.orientation);
  if (!std::isfinite(time_s) || !isFinite(roomFromHead.position_m) || !std::isfinite(norm) || norm < 0.5) {
    return SampleUse::unusable;
  }
  const Pose measured{roomFromHead.position_m, roomFromHead.orientation / norm};
  if (!started_) {
    start(time_s, measured);
    started_ = true;
    return SampleUse::used;
  }
  const double newestSeen_s = judge_.doubts() ? judge_.doubted_s() : time_s_;
  if (time_s <= newestSeen_s) return SampleUse::unusable;
  const Jump jump = judge_.judge(celerity_, time_s, measured.position_m);
  if (jump == Jump::doubted) {
    doubted_ = {time_s, measured};
    return SampleUse::glitch;
  }

  const double interval_s = time_s - time_s_;
  const bool returned = interval_s > kTrackPredicted_s || jump == Jump::elsewhere || jump == Jump::shifted;
  const Pose shown = returned ? shownPose(time_s) : Pose{};
  if (jump == Jump::elsewhere || interval_s > kTrackLost_s) {
    before_m_s_ = shownCelerity_m_s(time_s);
    share_ = 0.0;
    start(time_s, measured);
  } else {
    takeOverFade(time_s);
    if (interval_s <= kTrackCoasts_s) {
      share_ = std::min(1.0, share_ + std::min(interval_s, kTrackPredicted_s) / kFadesBack_s);
    }
    if (jump == Jump::quick) use(doubted_.time_s, doubted_.roomFromHead);
    if (jump == Jump::shifted) celerity_.moveBy(judge_.offset_m());
    use(time_s, measured);
  }
  if (returned) {
    returned_s_ = time_s;
    const Pose filtered = filteredPose(time_s);
    offset_m_ = shown.position_m - filtered.position_m;
    offset_rad_ = rotationVector(shown.orientation * glm::conjugate(filtered.orientation));
  }
  return SampleUse::used;
}

void HeadFilter::use(double time_s, const Pose& measured) {
  judge_.use(celerity_, time_s, measured.position_m);
  celerity_.update(time_s, measured.position_m);
  turn(time_s - time_s_, measured.orientation);
  time_s_ = time_s;
}

void HeadFilter::start(double time_s, const Pose& roomFromHead) {
  celerity_.start(time_s, roomFromHead.position_m);
  time_s_ = time_s;
  judge_.start(roomFromHead.position_m);
  orientation_ = roomFromHead.orientation;
  angularVelocity_rad_s_ = glm::dvec3(0.0);
}

// A critically damped α-β filter in the tangent space: q⁺ = exp(αδ) q⁻, ω⁺ = ω⁻ + βδ/T with q⁻ the
// prediction, δ the rotation vector from it to the measurement, α = 1 − θ², β = (1 − θ)², θ = e^(−T/τ).
void HeadFilter::turn(double interval_s, const glm::dquat& orientation) {
  const double theta = std::exp(-interval_s / kTurnMemory_s);
  const glm::dquat predicted = rotation(angularVelocity_rad_s_ * interval_s) * orientation_;
  const glm::dvec3 delta_rad = rotationVector(orientation * glm::conjugate(predicted));
  orientation_ = glm::normalize(rotation((1.0 - theta * theta) * delta_rad) * predicted);
  angularVelocity_rad_s_ += (1.0 - theta) * (1.0 - theta) / interval_s * delta_rad;
}

Pose HeadFilter::filteredPose(double time_s) const {
  const double ahead_s = std::max(0.0, time_s - time_s_);
  const double turns_s = std::min(ahead_s, kTrackPredicted_s);
  return {celerity_.predictedPosition_m(coasted_s(ahead_s)),
          rotation(angularVelocity_rad_s_ * turns_s) * orientation_};
}

Pose HeadFilter::shownPose(double time_s) const {
  const double since_s = std::max(0.0, time_s - returned_s_);
  const Pose filtered = filteredPose(time_s);
  const glm::dvec3 offset_m = shortened(offset_m_, kSlew_m_s * since_s);
  const glm::dvec3 offset_rad = shortened(offset_rad_, kSlew_rad_s * since_s);
  return {filtered.position_m + offset_m, glm::normalize(rotation(offset_rad) * filtered.orientation)};
}

glm::dvec3 HeadFilter::shownCelerity_m_s(double time_s) const {
  const double ahead_s = std::max(0.0, time_s - time_s_);
  const glm::dvec3 expected_m_s =
      celerity_.predicted(std::max(0.0, ahead_s - kTrackPredicted_s)).celerity_m_s;
  return leftAfter(ahead_s) * (share_ * expected_m_s + (1.0 - share_) * before_m_s_);
}

// Of a celerity that has faded to the share l, shown = l (share estimated + (1 − share) before), samples are
// back: the estimate's share is l share from there on.
void HeadFilter::takeOverFade(double time_s) {
  const double left = leftAfter(time_s - time_s_), share = left * share_;
  if (left == 1.0) return;
  before_m_s_ *= left * (1.0 - share_) / (1.0 - share);
  share_ = share;
}

HeadEstimate HeadFilter::at(double time_s) const {
  HeadEstimate head;
  head.time_s = time_s;
  const double ahead_s = started_ ? std::max(0.0, time_s - time_s_) : kTrackLost_s;
  glm::dmat3& covariance = head.celerityCovariance_m2_s2;
  if (!started_ || ahead_s > kTrackLost_s) {
    covariance = glm::dmat3(kUnknown_m_s * kUnknown_m_s);
  } else {
    // Errors of the estimate, of what changed since, and of what of it is not shown.
    head.celerity_m_s = shownCelerity_m_s(time_s);
    const glm::dvec3 hidden_m_s = celerity_.celerity_m_s() - head.celerity_m_s;
    covariance = celerity_.celerityCovariance_m2_s2() + glm::dmat3(celerity_.celerityChange_m2_s2(ahead_s)) +
                 glm::outerProduct(hidden_m_s, hidden_m_s);
    head.known = ahead_s == 0.0                 ? Known::measured
                 : ahead_s <= kTrackPredicted_s ? Known::predicted
                                                : Known::held;
  }
  head.sigma_m_s = std::sqrt(std::max({covariance[0][0], covariance[1][1], covariance[2][2]}));
  if (started_) {
    head.pose = shownPose(time_s);
    head.lag_s = celerity_.lag_s() + ahead_s;
  }
  head.celerity_m_s *= std::clamp((time_s - fadesInFrom_s_) / kFadeIn_s, 0.0, 1.0);
  if (glm::length(head.celerity_m_s) < kRounding_m_s) head.celerity_m_s = glm::dvec3(0.0);
  return head;
}

}  // namespace carom
