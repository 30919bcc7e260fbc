#pragma once
// A simulated person with a tracker on the head: for rooms without a tracker, and as a head whose true motion
// is known.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

struct SimulatedPerson {
  std::uint64_t seed = 1;
  double rate_hz = 60.0;      ///< of the tracker
  double noise_m = 0.0003;    ///< standard deviation of a position component
  double noise_rad = 0.0005;  ///< standard deviation of a rotation about an axis
  double headHeight_m = 1.7;
  double reach_m = 0.6;  ///< how far from the floor's origin the person goes, along right and forward
  RoomAxes axes{};
  bool still = false;  ///< the person does not move, and the tracker has no noise
  bool walks = false;  ///< the person walks about from the beginning, without standing and shifting first
};

/// The true motion of the person at one time.
struct TrueMotion {
  double time_s = 0.0;
  Pose pose;
  glm::dvec3 velocity_m_s{0.0};
  glm::dvec3 acceleration_m_s2{0.0};
};

/// The person stands for five seconds, then shifts from foot to foot, then walks about, looks around, and
/// rests in between. Acceleration while moving is smooth noise of 0.2 to 0.5 m/s² a component with a
/// correlation time of about 0.15 s, as recorded heads show; while standing, the head sways by some
/// millimetres. If the person is `still`, none of this happens; one who `walks` begins with walking. The same
/// seed gives the same bits.
class SimulatedTracker : public Tracker {
 public:
  explicit SimulatedTracker(const SimulatedPerson& person = {});

  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  /// Always delivering, with the number of samples so far.
  TrackerHealth health(double now_s) const override;

  /// The true motion at the time of the newest sample delivered.
  const TrueMotion& truth() const { return truth_; }

 private:
  /// The person's intention: what they do now, until when, and where they want to be.
  struct Intent {
    enum class Activity { standing, shifting, walking } activity = Activity::standing;
    double until_s = 0.0;
    glm::dvec3 place_m{0.0};     // where to be (right, up, forward)
    glm::dvec3 onTheWay_m{0.0};  // moves there at walking speed, and the body follows it
    double lookUntil_s = 0.0;
    glm::dvec2 look_rad{0.0};  // yaw to the left, pitch up
  };

  void decide();
  void step();
  void moveTruthTo(double time_s);
  TrackerSample measure();
  glm::dvec3 noise(double sigma);

  SimulatedPerson person_;
  std::mt19937_64 motionRandom_;
  std::mt19937_64 noiseRandom_;
  std::int64_t nextSample_ = 0;
  TrueMotion truth_;

  // The motion, advanced in steps of a millisecond whatever the tracker's rate; (right, up, forward) axes.
  std::int64_t steps_ = 0;
  Intent intent_;
  struct Body {
    glm::dvec3 position_m{0.0};
    glm::dvec3 velocity_m_s{0.0};
    glm::dvec3 acceleration_m_s2{0.0};
  };
  Body body_;
  glm::dvec3 drive_{0.0};     // unit white noise after one low-pass
  glm::dvec3 restless_{0.0};  // and after two
  double stride_rad_ = 0.0;
  glm::dvec2 gaze_rad_{0.0};
  glm::dvec2 gazeRate_rad_s_{0.0};
};

}  // namespace carom
