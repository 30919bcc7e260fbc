#include "devices/celerity_filter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace carom {
namespace {

// Ideas of how a head moves: its acceleration wanders about zero (a first-order Gauss-Markov process; Singer
// 1970), and that of someone who stands still cannot carry them away, as celerity dies out too:
//
//   dx/dt = v      dv/dt = a − v/stopTau      da/dt = −a/tau + noise,   a of standard deviation sigma
//
// A model lasts for `dwell_s` on average, then any other follows. The values were found on simulated heads
// and the first seventeen seconds of a recorded one.
constexpr double kNever = std::numeric_limits<double>::infinity();
struct Model {
  double sigma_m_s2;  // of one component
  double tau_s;
  double stopTau_s;
  double dwell_s;
  constexpr bool isStill() const { return stopTau_s < kNever; }
};
constexpr std::array<Model, CelerityFilter::kModels> kModelTable = {{
    {0.0017, 0.100, 0.245, 3.0},
    {0.03, 0.300, kNever, 0.50},
    {0.13, 0.123, kNever, 0.50},
    {0.39, 0.173, kNever, 0.39},
    {0.89, 0.209, kNever, 0.66},
}};

constexpr double kFirstCelerity_m_s = 0.5;  // standard deviation of what is not known at the start

// 1 − exp(−t/tau), exact for t ≪ tau.
double decayed(double time_s, double tau_s) { return -std::expm1(-time_s / tau_s); }

// (position, celerity, acceleration) some time after a unit celerity: (t, 1, 0) or, where it dies out with
// T = stopTau, (T(1 − e), e, 0), e = exp(−t/T).
glm::dvec3 afterCelerity(const Model& model, double time_s) {
  if (!model.isStill()) return {time_s, 1.0, 0.0};
  const double d = decayed(time_s, model.stopTau_s);
  return {model.stopTau_s * d, 1.0 - d, 0.0};
}

// The same after a unit acceleration. With d = 1 − exp(−t/τ): (τ(t − τd), τd, 1 − d); where celerity dies
// out, with D = 1 − exp(−t/T) and k = Tτ/(T − τ): (k(TD − τd), k(d − D), 1 − d).
glm::dvec3 afterAcceleration(const Model& model, double time_s) {
  const double tau_s = model.tau_s;
  const double d = decayed(time_s, tau_s);
  if (!model.isStill()) return {tau_s * (time_s - tau_s * d), tau_s * d, 1.0 - d};
  const double stopTau_s = model.stopTau_s;
  const double stopped = decayed(time_s, stopTau_s);
  const double k_s = stopTau_s * tau_s / (stopTau_s - tau_s);
  return {k_s * (stopTau_s * stopped - tau_s * d), k_s * (d - stopped), 1.0 - d};
}

// Φ(T): how a state goes on by itself.
glm::dmat3 transition(const Model& model, double interval_s) {
  return {glm::dvec3(1.0, 0.0, 0.0), afterCelerity(model, interval_s), afterAcceleration(model, interval_s)};
}

// Q(T) = (2σ²/τ) ∫₀ᵀ g(s) g(s)ᵀ ds with g the response to acceleration, by Gauss-Legendre with three nodes:
// the closed form cancels to nothing for T ≪ τ.
glm::dmat3 processNoise(const Model& model, double interval_s) {
  constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
  constexpr std::array<double, 3> kNodes = {0.5 - 0.5 * kNode, 0.5, 0.5 + 0.5 * kNode};
  constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  glm::dmat3 integral(0.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 response = afterAcceleration(model, kNodes[i] * interval_s);
    integral += kWeights[i] * interval_s * glm::outerProduct(response, response);
  }
  return 2.0 * model.sigma_m_s2 * model.sigma_m_s2 / model.tau_s * integral;
}

}  // namespace

void CelerityFilter::start(double time_s, const glm::dvec3& position_m) {
  time_s_ = time_s;
  noise_.interrupt();
  noise_.add(time_s, position_m);
  const double sigma_m = noise_.sigma_m();
  for (int i = 0; i < kModels; ++i) {
    Belief& belief = beliefs_[i];
    const Model& model = kModelTable[i];
    belief.probability = 1.0 / kModels;
    belief.state = {position_m, glm::dvec3(0.0), glm::dvec3(0.0)};
    belief.covariance = glm::dmat3(0.0);
    belief.covariance[0][0] = sigma_m * sigma_m;
    belief.covariance[1][1] = kFirstCelerity_m_s * kFirstCelerity_m_s;
    belief.covariance[2][2] = model.sigma_m_s2 * model.sigma_m_s2;
    belief.rampError = {0.0, 0.0, 1.0};
  }
  average();
}

void CelerityFilter::update(double time_s, const glm::dvec3& position_m) {
  const double interval_s = time_s - time_s_;
  time_s_ = time_s;
  noise_.add(time_s, position_m);
  beliefs_ = mixed(beliefs_, interval_s);

  std::array<double, kModels> logWeight{};
  for (int i = 0; i < kModels; ++i) {
    Belief& belief = beliefs_[i];
    const Model& model = kModelTable[i];
    const glm::dmat3 phi = transition(model, interval_s);
    State& state = belief.state;
    state = {
        phi[0][0] * state.position_m + phi[1][0] * state.celerity_m_s + phi[2][0] * state.acceleration_m_s2,
        phi[1][1] * state.celerity_m_s + phi[2][1] * state.acceleration_m_s2,
        phi[2][2] * state.acceleration_m_s2};
    belief.covariance = phi * belief.covariance * glm::transpose(phi) + processNoise(model, interval_s);
    // The ramp goes on accelerating where the model lets the acceleration decay.
    const glm::dvec3 steady(0.5 * interval_s * interval_s, interval_s, 1.0);
    belief.rampError = phi * belief.rampError + (steady - phi[2]);
    logWeight[i] = std::log(belief.probability) + correct(belief, position_m);
  }

  const double largest = *std::max_element(logWeight.begin(), logWeight.end());
  double sum = 0.0;
  for (int i = 0; i < kModels; ++i) sum += beliefs_[i].probability = std::exp(logWeight[i] - largest);
  for (Belief& belief : beliefs_) belief.probability /= sum;
  average();
}

// Mixing: each model goes on from what all models believe, weighted by the probability that they were
// the true one before it. P(i → j) = 1 − exp(−T/dwell_i), shared by all j ≠ i.
CelerityFilter::Beliefs CelerityFilter::mixed(const Beliefs& beliefs, double interval_s) {
  Beliefs result;
  std::array<double, kModels> leaves;
  for (int i = 0; i < kModels; ++i) leaves[i] = -std::expm1(-interval_s / kModelTable[i].dwell_s);
  for (int j = 0; j < kModels; ++j) {
    std::array<double, kModels> weight;
    double sum = 0.0, movingSum = 0.0;
    for (int i = 0; i < kModels; ++i) {
      weight[i] = beliefs[i].probability * (i == j ? 1.0 - leaves[i] : leaves[i] / (kModels - 1));
      sum += weight[i];
      if (!kModelTable[i].isStill()) movingSum += weight[i];
    }
    Belief& to = result[j];
    to.probability = sum;
    for (int i = 0; i < kModels; ++i) {
      const double share = weight[i] / sum;
      to.state.position_m += share * beliefs[i].state.position_m;
      to.state.celerity_m_s += share * beliefs[i].state.celerity_m_s;
      to.state.acceleration_m_s2 += share * beliefs[i].state.acceleration_m_s2;
      if (!kModelTable[i].isStill()) to.rampError += weight[i] / movingSum * beliefs[i].rampError;
    }
    for (int i = 0; i < kModels; ++i) {
      // Covariance within and between the models, the latter averaged over the axes.
      const glm::dvec3 position_m = beliefs[i].state.position_m - to.state.position_m;
      const glm::dvec3 celerity_m_s = beliefs[i].state.celerity_m_s - to.state.celerity_m_s;
      const glm::dvec3 acceleration_m_s2 = beliefs[i].state.acceleration_m_s2 - to.state.acceleration_m_s2;
      const glm::dmat3 spread = glm::transpose(glm::dmat3(position_m, celerity_m_s, acceleration_m_s2));
      to.covariance += weight[i] / sum * (beliefs[i].covariance + spread * glm::transpose(spread) / 3.0);
    }
  }
  return result;
}

// The Kalman step for a measured position, all axes at once. Returns the logarithm of the likelihood,
// −(|ν|²/S + 3 ln S)/2 with innovation ν of variance S, up to a constant.
double CelerityFilter::correct(Belief& belief, const glm::dvec3& position_m) const {
  const double sigma_m = noise_.sigma_m();
  const glm::dvec3 withPosition = belief.covariance[0];
  const double variance_m2 = withPosition[0] + sigma_m * sigma_m;
  const glm::dvec3 gain = withPosition / variance_m2;
  const glm::dvec3 innovation_m = position_m - belief.state.position_m;
  belief.state.position_m += gain[0] * innovation_m;
  belief.state.celerity_m_s += gain[1] * innovation_m;
  belief.state.acceleration_m_s2 += gain[2] * innovation_m;
  belief.covariance -= glm::outerProduct(withPosition, withPosition) / variance_m2;
  belief.rampError -= gain * belief.rampError[0];
  return -0.5 * (glm::dot(innovation_m, innovation_m) / variance_m2 + 3.0 * std::log(variance_m2));
}

void CelerityFilter::average() {
  mean_ = {};
  for (const Belief& belief : beliefs_) {
    mean_.position_m += belief.probability * belief.state.position_m;
    mean_.celerity_m_s += belief.probability * belief.state.celerity_m_s;
    mean_.acceleration_m_s2 += belief.probability * belief.state.acceleration_m_s2;
  }
}

glm::dmat3 CelerityFilter::celerityCovariance_m2_s2() const {
  glm::dmat3 covariance(0.0);
  for (const Belief& belief : beliefs_) {
    const glm::dvec3 apart = belief.state.celerity_m_s - mean_.celerity_m_s;
    covariance +=
        belief.probability * (glm::dmat3(belief.covariance[1][1]) + glm::outerProduct(apart, apart));
  }
  return covariance;
}

double CelerityFilter::lag_s() const {
  double lag_s = 0.0, probability = 0.0;
  for (int i = 0; i < kModels; ++i) {
    if (kModelTable[i].isStill()) continue;
    lag_s += beliefs_[i].probability * beliefs_[i].rampError[1];
    probability += beliefs_[i].probability;
  }
  return lag_s / probability;
}

glm::dvec3 CelerityFilter::predictedPosition_m(double ahead_s) const {
  glm::dvec3 predicted_m(0.0);
  for (int i = 0; i < kModels; ++i) {
    const glm::dmat3 phi = transition(kModelTable[i], ahead_s);
    const State& state = beliefs_[i].state;
    predicted_m += beliefs_[i].probability *
                   (state.position_m + phi[1][0] * state.celerity_m_s + phi[2][0] * state.acceleration_m_s2);
  }
  return predicted_m;
}

// Of the integral of a wandering acceleration: 2σ²τ(t − τd), d = 1 − exp(−t/τ). Of a celerity that dies out:
// no more than twice its variance σ²τT²/(τ + T), which it reaches with T.
double CelerityFilter::celerityChange_m2_s2(double ahead_s) const {
  double change_m2_s2 = 0.0;
  for (int i = 0; i < kModels; ++i) {
    const Model& model = kModelTable[i];
    const double tau_s = model.tau_s, stopTau_s = model.stopTau_s;
    const double perVariance_s2 = model.isStill() ? 2.0 * tau_s * stopTau_s * stopTau_s /
                                                        (tau_s + stopTau_s) * decayed(ahead_s, stopTau_s)
                                                  : 2.0 * tau_s * (ahead_s - tau_s * decayed(ahead_s, tau_s));
    change_m2_s2 += beliefs_[i].probability * model.sigma_m_s2 * model.sigma_m_s2 * perVariance_s2;
  }
  return change_m2_s2;
}

}  // namespace carom
