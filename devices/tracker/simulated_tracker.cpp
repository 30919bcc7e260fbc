#include "devices/tracker/simulated_tracker.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace carom {
namespace {

constexpr double kStep_s = 0.001;
constexpr double kSmooth_s = 0.07;  // of each of two low-passes: correlation falls to 1/e in 0.15 s
constexpr double kWalk_m_s = 0.6;
constexpr double kStride_hz = 1.6;   // steps: the head bobs once in each
constexpr double kBob_s = 0.008;     // amplitude of the bob in metres for each m/s of speed
constexpr double kGaze_rad_s = 5.0;  // how fast the eyes' place is turned to
constexpr double kFirstStand_s = 5.0;
constexpr double kFirstShift_s = 5.0;
constexpr double kLeastWalk_m = 0.5;  // of one who walks from the beginning

// How a body keeps its place: a damped spring, driven by acceleration noise of a component.
struct Posture {
  double stiffness_s2;
  double damping_s;
  double restless_m_s2;
};
constexpr Posture kStanding{3.5, 2.6, 0.028};  // sways by 3 to 4 mm at 6 mm/s
constexpr Posture kShifting{10.0, 6.3, 0.15};
constexpr Posture kWalking{10.0, 6.3, 0.33};

// Uniform in [0, 1) and Gauss's distribution by Box and Muller: those of the standard library differ
// between libraries.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

glm::dvec3 gaussian(std::mt19937_64& random) {
  const auto one = [&random] {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(random)));
    return radius * std::cos(2.0 * std::numbers::pi * uniform(random));
  };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * uniform(random);
}

}  // namespace

SimulatedTracker::SimulatedTracker(const SimulatedPerson& person)
    : person_(person), motionRandom_(person.seed), noiseRandom_(person.seed + 0x9e3779b97f4a7c15u) {
  body_.position_m = intent_.place_m = intent_.onTheWay_m = {0.0, person.headHeight_m, 0.0};
  intent_.until_s = person.walks ? 0.0 : kFirstStand_s;
  intent_.lookUntil_s = kFirstStand_s;
}

// What to do next, where, and where to look.
void SimulatedTracker::decide() {
  using Activity = Intent::Activity;
  const double now_s = static_cast<double>(steps_) * kStep_s;
  if (now_s >= intent_.until_s) {
    const bool shifts = !person_.walks && now_s < kFirstStand_s + kFirstShift_s;
    const bool walked = intent_.activity == Activity::walking;
    intent_.activity = shifts ? Activity::shifting : walked ? Activity::standing : Activity::walking;
    if (shifts) {
      intent_.place_m.x = between(motionRandom_, -0.08, 0.08);
      intent_.until_s = now_s + between(motionRandom_, 0.8, 1.5);
    } else if (walked) {
      intent_.until_s = now_s + between(motionRandom_, 1.0, 3.0);
    } else {
      do {
        intent_.place_m.x = between(motionRandom_, -person_.reach_m, person_.reach_m);
        intent_.place_m.z = between(motionRandom_, -person_.reach_m, person_.reach_m);
      } while (person_.walks && glm::distance(intent_.place_m, intent_.onTheWay_m) < kLeastWalk_m);
      const double way_m = glm::distance(intent_.place_m, intent_.onTheWay_m);
      intent_.until_s = now_s + way_m / kWalk_m_s + 1.5;
    }
  }
  if (now_s >= intent_.lookUntil_s) {
    intent_.look_rad = {between(motionRandom_, -0.9, 0.9), between(motionRandom_, -0.4, 0.1)};
    intent_.lookUntil_s = now_s + between(motionRandom_, 1.0, 3.0);
  }
}

void SimulatedTracker::step() {
  decide();
  const Posture& posture = intent_.activity == Intent::Activity::standing   ? kStanding
                           : intent_.activity == Intent::Activity::shifting ? kShifting
                                                                            : kWalking;
  const glm::dvec3 way_m = intent_.place_m - intent_.onTheWay_m;
  const double distance_m = glm::length(way_m);
  if (distance_m > 0.0) intent_.onTheWay_m += way_m * std::min(1.0, kWalk_m_s * kStep_s / distance_m);

  // Two low-passes in a row leave half the variance of the first.
  const double share = kStep_s / kSmooth_s;
  drive_ += -share * drive_ + std::sqrt(2.0 * share) * gaussian(motionRandom_);
  restless_ += share * (drive_ - restless_);
  const glm::dvec3 restless_m_s2 = std::numbers::sqrt2 * posture.restless_m_s2 * restless_;

  const double stride_rad_s = 2.0 * std::numbers::pi * kStride_hz;
  stride_rad_ = std::fmod(stride_rad_ + stride_rad_s * kStep_s, 2.0 * std::numbers::pi);
  const double speed_m_s = std::hypot(body_.velocity_m_s.x, body_.velocity_m_s.z);
  const double bob_m_s2 = kBob_s * speed_m_s * stride_rad_s * stride_rad_s * std::sin(stride_rad_);

  body_.acceleration_m_s2 = restless_m_s2 - posture.damping_s * body_.velocity_m_s -
                            posture.stiffness_s2 * (body_.position_m - intent_.onTheWay_m);
  body_.acceleration_m_s2.y += bob_m_s2;
  body_.position_m += kStep_s * body_.velocity_m_s + 0.5 * kStep_s * kStep_s * body_.acceleration_m_s2;
  body_.velocity_m_s += kStep_s * body_.acceleration_m_s2;

  const glm::dvec2 pull_rad_s2 =
      kGaze_rad_s * (kGaze_rad_s * (intent_.look_rad - gaze_rad_) - 2.0 * gazeRate_rad_s_);
  gaze_rad_ += kStep_s * gazeRate_rad_s_;
  gazeRate_rad_s_ += kStep_s * pull_rad_s2;
  ++steps_;
}

// Whole steps up to the time, and the rest of it at even acceleration.
void SimulatedTracker::moveTruthTo(double time_s) {
  if (person_.still) {
    truth_ = {time_s, {person_.headHeight_m * person_.axes.up, {1.0, 0.0, 0.0, 0.0}}};
    return;
  }
  while (static_cast<double>(steps_ + 1) * kStep_s <= time_s) step();
  const double rest_s = time_s - static_cast<double>(steps_) * kStep_s;
  const auto inTracker = [this](const glm::dvec3& v) {
    return v.x * person_.axes.right + v.y * person_.axes.up + v.z * person_.axes.forward;
  };
  truth_.time_s = time_s;
  truth_.pose.position_m = inTracker(body_.position_m + rest_s * body_.velocity_m_s +
                                     0.5 * rest_s * rest_s * body_.acceleration_m_s2);
  truth_.velocity_m_s = inTracker(body_.velocity_m_s + rest_s * body_.acceleration_m_s2);
  truth_.acceleration_m_s2 = inTracker(body_.acceleration_m_s2);
  const glm::dvec2 gaze_rad = gaze_rad_ + rest_s * gazeRate_rad_s_;
  truth_.pose.orientation =
      glm::angleAxis(gaze_rad.x, person_.axes.up) * glm::angleAxis(gaze_rad.y, person_.axes.right);
}

glm::dvec3 SimulatedTracker::noise(double sigma) { return sigma * gaussian(noiseRandom_); }

TrackerSample SimulatedTracker::measure() {
  TrackerSample sample{truth_.time_s, 0, truth_.pose, true};
  if (person_.still) return sample;
  sample.pose.position_m += noise(person_.noise_m);
  const glm::dvec3 turn_rad = noise(person_.noise_rad);
  sample.pose.orientation = glm::normalize(glm::dquat(1.0, 0.5 * turn_rad) * sample.pose.orientation);
  return sample;
}

void SimulatedTracker::poll(double now_s, std::vector<TrackerSample>& samples) {
  while (static_cast<double>(nextSample_) / person_.rate_hz <= now_s) {
    moveTruthTo(static_cast<double>(nextSample_) / person_.rate_hz);
    samples.push_back(measure());
    ++nextSample_;
  }
}

TrackerHealth SimulatedTracker::health(double now_s) const {
  TrackerHealth health = Tracker::health(now_s);
  health.samples = static_cast<std::uint64_t>(nextSample_);
  return health;
}

}  // namespace carom
