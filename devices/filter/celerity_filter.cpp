#include "devices/filter/celerity_filter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace carom {
namespace {

// Ideas of how a head moves. Its acceleration wanders smoothly about zero, as muscles do not switch: white
// noise after two low-passes (one of them alone is Singer's model of 1970). That of someone who stands or
// sways does not carry them away, as celerity dies out too:
//
//   dx/dt = v     dv/dt = a − v/stopTau     da/dt = j − a/kAccelerationTau     dj/dt = −j/kDriveTau + noise
//
// with a of standard deviation sigma. A model lasts for `dwell_s` on average; then any other follows, one by
// `share` as likely as a usual one.
constexpr double kAccelerationTau_s = 0.185;
constexpr double kDriveTau_s = 0.0185;
constexpr double kNever = std::numeric_limits<double>::infinity();
struct Model {
  double sigma_m_s2;  // of one component
  double stopTau_s;
  double dwell_s;
  double share = 1.0;
};
constexpr std::array<Model, CelerityFilter::kModels> kModelTable = {{
    {0.0008, 0.07, 20.0},
    {0.0007, 0.333, 0.38},
    {0.0107, kNever, 1.0, 0.3},
    {0.143, kNever, 0.38},
    {0.56, kNever, 0.38},
    {1.2, kNever, 0.38},
    {4.3, kNever, 0.583, 0.04},
}};
constexpr int kMoving = 2;  // the models from here on
constexpr double kShares = [] {
  double sum = 0.0;
  for (const Model& model : kModelTable) sum += model.share;
  return sum;
}();

// What a sample says for or against a model counts by this power. The models' innovations are no independent
// witnesses, as the update takes them to be: after mixing they share most of their past, and a movement that
// no model foresees surprises them all for many samples on end.
constexpr double kTrust = 0.36;

constexpr double kLeastSigma_m = 0.00001;
constexpr double kMostSigma_m = 0.01;
constexpr double kFirstCelerity_m_s = 0.5;  // standard deviation at the start, when it is not known

// 1 − exp(−t/tau), exact for t ≪ tau.
double decayed(double time_s, double tau_s) { return -std::expm1(-time_s / tau_s); }

// What share of each has decayed after a time: 1 − exp(−t/τ).
struct Decay {
  double time_s, acceleration, drive;
  double stopTau_s = kNever, celerity = 0.0;
};

Decay decayAfter(double time_s) {
  return {time_s, decayed(time_s, kAccelerationTau_s), decayed(time_s, kDriveTau_s)};
}

// The same where celerity dies out, too.
Decay stopping(const Decay& decay, double stopTau_s) {
  return {decay.time_s, decay.acceleration, decay.drive, stopTau_s, decayed(decay.time_s, stopTau_s)};
}

// (position, celerity, acceleration, drive) some time after a unit celerity: (t, 1, 0, 0) or, where it dies
// out with T = stopTau, (T(1 − e), e, 0, 0), e = exp(−t/T).
glm::dvec4 afterCelerity(const Decay& after) {
  if (after.stopTau_s == kNever) return {after.time_s, 1.0, 0.0, 0.0};
  return {after.stopTau_s * after.celerity, 1.0 - after.celerity, 0.0, 0.0};
}

// The same after a unit acceleration that decays with τ, d being its decayed share: (τ(t − τd), τd, 1 − d,
// 0); where celerity dies out, with D = 1 − exp(−t/T) and k = Tτ/(T − τ): (k(TD − τd), k(d − D), 1 − d, 0).
glm::dvec4 afterDecaying(double tau_s, double d, const Decay& after) {
  if (after.stopTau_s == kNever) return {tau_s * (after.time_s - tau_s * d), tau_s * d, 1.0 - d, 0.0};
  const double k_s = after.stopTau_s * tau_s / (after.stopTau_s - tau_s);
  return {k_s * (after.stopTau_s * after.celerity - tau_s * d), k_s * (d - after.celerity), 1.0 - d, 0.0};
}
glm::dvec4 afterAcceleration(const Decay& after) {
  return afterDecaying(kAccelerationTau_s, after.acceleration, after);
}

// The same after a unit drive: it makes an acceleration of k(exp(−t/τ) − exp(−t/τ')), k = ττ'/(τ − τ'), which
// are two that decay.
glm::dvec4 afterDrive(const Decay& after) {
  constexpr double k_s = kAccelerationTau_s * kDriveTau_s / (kAccelerationTau_s - kDriveTau_s);
  glm::dvec4 state = k_s * (afterAcceleration(after) - afterDecaying(kDriveTau_s, after.drive, after));
  state[3] = 1.0 - after.drive;
  return state;
}

// How a state goes on by itself for a time, Φ, and the covariance that it gains where its acceleration has a
// standard deviation of 1 m/s², Q.
struct Motion {
  glm::dmat4 phi;
  glm::dmat4 noise;
};

// What decays within an interval, and until each of three moments in it, the nodes of Gauss-Legendre.
struct Interval {
  static constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
  explicit Interval(double time_s)
      : whole(decayAfter(time_s)),
        nodes{decayAfter((0.5 - 0.5 * kNode) * time_s), decayAfter(0.5 * time_s),
              decayAfter((0.5 + 0.5 * kNode) * time_s)} {}
  Decay whole;
  std::array<Decay, 3> nodes;
};

// Q = 2(τ + τ')/(ττ')² ∫₀ᵀ g(s) g(s)ᵀ ds with g the response to the drive, by Gauss-Legendre: the closed form
// cancels to nothing for T ≪ τ.
glm::dmat4 unitNoise(const Interval& interval, double stopTau_s) {
  constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  constexpr double kProduct_s2 = kAccelerationTau_s * kDriveTau_s;
  constexpr double kDensity = 2.0 * (kAccelerationTau_s + kDriveTau_s) / (kProduct_s2 * kProduct_s2);
  glm::dmat4 integral(0.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4 response = afterDrive(stopping(interval.nodes[i], stopTau_s));
    integral += kWeights[i] * interval.whole.time_s * glm::outerProduct(response, response);
  }
  return kDensity * integral;
}

Motion motionOf(const Interval& interval, double stopTau_s) {
  const Decay after = stopping(interval.whole, stopTau_s);
  return {glm::dmat4(glm::dvec4(1.0, 0.0, 0.0, 0.0), afterCelerity(after), afterAcceleration(after),
                     afterDrive(after)),
          unitNoise(interval, stopTau_s)};
}

// Where nothing is known: any celerity, and acceleration as the model has it in the long run, of variance σ²,
// drive σ²(τ + τ')/(τ²τ'), their covariance σ²/τ.
glm::dmat4 firstCovariance(const Model& model, double position_m2) {
  const double variance = model.sigma_m_s2 * model.sigma_m_s2;
  glm::dmat4 covariance(0.0);
  covariance[0][0] = position_m2;
  covariance[1][1] = kFirstCelerity_m_s * kFirstCelerity_m_s;
  covariance[2][2] = variance;
  covariance[2][3] = covariance[3][2] = variance / kAccelerationTau_s;
  covariance[3][3] =
      variance * (kAccelerationTau_s + kDriveTau_s) / (kAccelerationTau_s * kAccelerationTau_s * kDriveTau_s);
  return covariance;
}

// Of a state (columns: position, celerity, acceleration, drive; rows: axes), the mean over the axes of the
// products of any two.
glm::dmat4 momentOverAxes(const glm::dmat4x3& state) { return 1.0 / 3.0 * (glm::transpose(state) * state); }

}  // namespace

void CelerityFilter::start(double time_s, const glm::dvec3& position_m) {
  time_s_ = time_s;
  noise_.interrupt();
  noise_.doubt();
  noise_.add(time_s, position_m);
  const double sigma_m = trackerSigma_m();
  for (int i = 0; i < kModels; ++i) {
    Belief& belief = beliefs_[i];
    belief.probability = 1.0 / kModels;
    belief.state = State(0.0);
    belief.state[0] = position_m;
    belief.covariance = firstCovariance(kModelTable[i], sigma_m * sigma_m);
    belief.rampError = {0.0, 0.0, 1.0, 1.0 / kAccelerationTau_s};
  }
  average();
}

void CelerityFilter::moveBy(const glm::dvec3& offset_m) {
  for (Belief& belief : beliefs_) belief.state[0] += offset_m;
  mean_[0] += offset_m;
  noise_.interrupt();
}

void CelerityFilter::update(double time_s, const glm::dvec3& position_m) {
  const double interval_s = time_s - time_s_;
  time_s_ = time_s;
  noise_.add(time_s, position_m);
  mix(interval_s);

  // An even acceleration needs a drive of 1/τ; it goes on where models let it decay.
  const glm::dvec4 ramp(0.5 * interval_s * interval_s, interval_s, 1.0, 1.0 / kAccelerationTau_s);
  std::array<double, kModels> logWeight{};
  const Interval interval(interval_s);
  Motion motion;
  for (int i = 0; i < kModels; ++i) {
    Belief& belief = beliefs_[i];
    const Model& model = kModelTable[i];
    if (i == 0 || model.stopTau_s != kModelTable[i - 1].stopTau_s) {
      motion = motionOf(interval, model.stopTau_s);
    }
    const glm::dmat4& phi = motion.phi;
    belief.state = belief.state * glm::transpose(phi);
    belief.covariance =
        phi * belief.covariance * glm::transpose(phi) + model.sigma_m_s2 * model.sigma_m_s2 * motion.noise;
    belief.rampError = phi * belief.rampError + (ramp - phi[2] - phi[3] / kAccelerationTau_s);
    logWeight[i] = std::log(belief.probability) + kTrust * correct(belief, position_m);
  }

  const double largest = *std::max_element(logWeight.begin(), logWeight.end());
  double sum = 0.0;
  for (int i = 0; i < kModels; ++i) sum += beliefs_[i].probability = std::exp(logWeight[i] - largest);
  for (Belief& belief : beliefs_) belief.probability /= sum;
  average();
}

// Mixing: each model goes on from what all models believe, weighted by the probability that they were
// the true one before it. P(i → j) = (1 − exp(−T/dwell_i)) share_j/Σ share, the sum over all but i: but for
// share_j, what comes from a model is the same for all others, so it is summed once, and each adds what
// stays.
void CelerityFilter::mix(double interval_s) {
  struct Sum {
    double weight = 0.0, movingWeight = 0.0;
    State state{0.0};
    glm::dmat4 moment{0.0};  // second moment about the mean of all, averaged over the axes
    glm::dvec4 rampError{0.0};
    void add(double by, const Sum& other) {
      weight += by * other.weight;
      movingWeight += by * other.movingWeight;
      state += by * other.state;
      moment += by * other.moment;
      rampError += by * other.rampError;
    }
  };
  Sum leaving;
  std::array<Sum, kModels> each;
  std::array<double, kModels> leaves;  // to a model of share 1
  for (int i = 0; i < kModels; ++i) {
    const Belief& belief = beliefs_[i];
    const double moving = i >= kMoving ? 1.0 : 0.0;
    each[i] = {1.0, moving, belief.state, belief.covariance + momentOverAxes(belief.state - mean_),
               moving * belief.rampError};
    leaves[i] = decayed(interval_s, kModelTable[i].dwell_s) / (kShares - kModelTable[i].share);
    leaving.add(belief.probability * leaves[i], each[i]);
  }
  for (int j = 0; j < kModels; ++j) {
    Belief& to = beliefs_[j];
    Sum sum;
    sum.add(kModelTable[j].share, leaving);
    sum.add(to.probability * (1.0 - leaves[j] * kShares), each[j]);
    to.probability = sum.weight;
    const double perWeight = 1.0 / sum.weight;
    to.state = perWeight * sum.state;
    to.covariance = perWeight * sum.moment - momentOverAxes(to.state - mean_);
    to.rampError = sum.rampError / sum.movingWeight;
  }
}

// The Kalman step for a measured position, all axes at once. Returns the logarithm of the likelihood,
// −(|ν|²/S + 3 ln S)/2 with innovation ν of variance S, up to a constant.
double CelerityFilter::correct(Belief& belief, const glm::dvec3& position_m) const {
  const double sigma_m = trackerSigma_m();
  const glm::dvec4 withPosition = belief.covariance[0];
  const double variance_m2 = withPosition[0] + sigma_m * sigma_m;
  const glm::dvec4 gain = withPosition / variance_m2;
  const glm::dvec3 innovation_m = position_m - belief.state[0];
  belief.state += glm::outerProduct(innovation_m, gain);
  belief.covariance -= glm::outerProduct(gain, withPosition);
  belief.rampError -= gain * belief.rampError[0];
  return -0.5 * (glm::dot(innovation_m, innovation_m) / variance_m2 + 3.0 * std::log(variance_m2));
}

void CelerityFilter::average() {
  mean_ = State(0.0);
  for (const Belief& belief : beliefs_) mean_ += belief.probability * belief.state;
}

glm::dmat3 CelerityFilter::celerityCovariance_m2_s2() const {
  glm::dmat3 covariance(0.0);
  for (const Belief& belief : beliefs_) {
    const glm::dvec3 apart_m_s = belief.state[1] - celerity_m_s();
    covariance +=
        belief.probability * (glm::dmat3(belief.covariance[1][1]) + glm::outerProduct(apart_m_s, apart_m_s));
  }
  return covariance;
}

double CelerityFilter::trackerSigma_m() const {
  return std::clamp(noise_.sigma_m(), kLeastSigma_m, kMostSigma_m);
}

double CelerityFilter::lag_s() const {
  double lag_s = 0.0, probability = 0.0;
  for (int i = kMoving; i < kModels; ++i) {
    lag_s += beliefs_[i].probability * beliefs_[i].rampError[1];
    probability += beliefs_[i].probability;
  }
  return lag_s / probability;
}

// The models that share a stopTau stand side by side, and what follows from a state is linear in it.
CelerityFilter::Course CelerityFilter::predicted(double ahead_s) const {
  if (ahead_s == 0.0) return {mean_[0], mean_[1]};
  const Decay ahead = decayAfter(ahead_s);
  Course course;
  for (int i = 0; i < kModels;) {
    const double stopTau_s = kModelTable[i].stopTau_s;
    State state(0.0);
    for (; i < kModels && kModelTable[i].stopTau_s == stopTau_s; ++i) {
      state += beliefs_[i].probability * beliefs_[i].state;
    }
    const Decay after = stopping(ahead, stopTau_s);
    const glm::dvec4 celerity = afterCelerity(after), acceleration = afterAcceleration(after),
                     drive = afterDrive(after);
    course.position_m += state[0] + celerity[0] * state[1] + acceleration[0] * state[2] + drive[0] * state[3];
    course.celerity_m_s += celerity[1] * state[1] + acceleration[1] * state[2] + drive[1] * state[3];
  }
  return course;
}

double CelerityFilter::predictedSigma_m(double ahead_s) const {
  const auto at = [ahead_s](const State& state) { return state[0] + ahead_s * state[1]; };
  const double sigma_m = trackerSigma_m();
  double variance_m2 = sigma_m * sigma_m;
  for (const Belief& belief : beliefs_) {
    const glm::dmat4& p = belief.covariance;
    const glm::dvec3 apart_m = at(belief.state) - at(mean_);
    variance_m2 += belief.probability * (p[0][0] + ahead_s * (2.0 * p[0][1] + ahead_s * p[1][1]) +
                                         glm::dot(apart_m, apart_m) / 3.0);
  }
  return std::sqrt(variance_m2);
}

// Of the integral of a wandering acceleration, whose correlation is (τ exp(−u/τ) − τ' exp(−u/τ'))/(τ − τ'):
// 2σ²(τF(τ) − τ'F(τ'))/(τ − τ') with F(τ) = τ(t − τd), d = 1 − exp(−t/τ). Of a celerity that dies out: no
// more than twice its variance, at most (σT)², which it reaches with T.
double CelerityFilter::celerityChange_m2_s2(double ahead_s) const {
  const auto f_s2 = [ahead_s](double tau_s) { return tau_s * (ahead_s - tau_s * decayed(ahead_s, tau_s)); };
  const double wandered_s2 =
      2.0 * (kAccelerationTau_s * f_s2(kAccelerationTau_s) - kDriveTau_s * f_s2(kDriveTau_s)) /
      (kAccelerationTau_s - kDriveTau_s);
  double change_m2_s2 = 0.0;
  for (int i = 0; i < kModels; ++i) {
    const Model& model = kModelTable[i];
    double perVariance_s2 = wandered_s2;
    if (model.stopTau_s < kNever) {
      const double bound_s2 = 2.0 * model.stopTau_s * model.stopTau_s * decayed(ahead_s, model.stopTau_s);
      perVariance_s2 = std::min(perVariance_s2, bound_s2);
    }
    change_m2_s2 += beliefs_[i].probability * model.sigma_m_s2 * model.sigma_m_s2 * perVariance_s2;
  }
  return change_m2_s2;
}

}  // namespace carom
