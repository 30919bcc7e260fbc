#pragma once
// A person who calibrates a simulated tracker: the recordings that this makes, with noise and with mistakes.

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <string>
#include <vector>

#include "app/calibration/calibration_data.h"
#include "app/temporary_folder.h"
#include "devices/tracker/trace.h"

namespace carom::test {

/// A room of unequal walls, as a rig with that line in its tracker.
inline std::string calibratedRig(const std::string& trackerLine = "", const std::string& headLines = "",
                                 const std::string& unit = "m") {
  const double unit_m = unit == "mm" ? 1e-3 : 1.0;
  const auto corner = [&](double x, double y, double z) {
    return "[" + std::to_string(x / unit_m) + ", " + std::to_string(y / unit_m) + ", " +
           std::to_string(z / unit_m) + "]\n";
  };
  const auto wall = [](const std::string& name, const std::string& ll, const std::string& lr,
                       const std::string& ul) {
    return "[[wall]]\nname = \"" + name + "\"\npixels = [100, 100]\nlower_left = " + ll +
           "lower_right = " + lr + "upper_left = " + ul;
  };
  return "unit = \"" + unit + "\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"art\"\nsensor = 1\n" +
         headLines + "\n[hand]\ntracker = \"art\"\nsensor = 0\n" +
         "[[tracker]]\nname = \"art\"\nkind = \"simulated\"\n" + trackerLine + "\n" +
         wall("front", corner(-1.5, 0, -1.2), corner(1.5, 0, -1.2), corner(-1.5, 2.4, -1.2)) +
         wall("left", corner(-1.5, 0, 1.0), corner(-1.5, 0, -1.2), corner(-1.5, 2.4, 1.0)) +
         wall("right", corner(1.5, 0, -1.2), corner(1.5, 0, 0.6), corner(1.5, 2.4, -1.2));
}

struct SimulatedRoom {
  std::uint64_t seed = 1;
  Pose roomFromTracker{{0.3, 2.1, -0.4}, glm::normalize(glm::dquat(0.8, -0.5, 0.3, 0.1))};
  glm::dvec3 tip_m{0.01, -0.02, -0.18};  ///< in the hand's sensor
  Pose eyesFromSensor{{0.004, -0.061, 0.083}, glm::normalize(glm::dquat(0.99, 0.05, -0.03, 0.02))};
  double eyeSeparation_m = 0.063;
  double noise_m = 0.001;     ///< of each coordinate of a sample
  double touch_m = 0.0;       ///< of each coordinate of a touched place
  double noise_rad = 0.0005;  ///< of each turn
  double scale = 1.0;         ///< what the tracker makes of a metre
  bool mirrored = false;      ///< the tracker's x is turned round
};

/// Writes the recordings.
class CalibratingPerson {
 public:
  explicit CalibratingPerson(const SimulatedRoom& room) : room_(room), random_(room.seed) {}

  /// Turns the tool about its tip for 15 s.
  void pivot(const std::filesystem::path& folder) {
    const glm::dvec3 hole_m(0.2, 0.8, 0.1);
    samples_.clear();
    for (int i = 0; i < 900; ++i) {
      const double t = i / 60.0;
      const glm::dvec3 turn(0.6 * std::sin(1.3 * t), 0.6 * std::sin(1.7 * t + 1.0), 0.8 * std::sin(0.9 * t));
      const glm::dquat q = turned(turn);
      add({hole_m - q * room_.tip_m, q});
    }
    write(folder / kPivotFile);
  }
  /// Touches places in the room, one after the other.
  void touch(const std::filesystem::path& folder, const std::vector<glm::dvec3>& places_m) {
    samples_.clear();
    glm::dvec3 from_m(0.0, 1.0, 0.0);
    for (const glm::dvec3& place_m : places_m) {
      const glm::dvec3 to_m = place_m + normal3(room_.touch_m);
      // The tool points from the middle of the room to the corner.
      const glm::dquat q = pointing(to_m - glm::dvec3(0.0, 1.0, 0.0));
      move(from_m, to_m, [&](const glm::dvec3& at_m) { return Pose{at_m - q * room_.tip_m, q}; });
      for (int i = 0; i < 75; ++i) add({to_m - q * room_.tip_m, q});
      from_m = to_m;
    }
    write(folder / kCornersFile);
  }
  /// Looks from behind the mark at each target, with each eye, the head turned elsewhere.
  void sight(const std::filesystem::path& folder, const glm::dvec3& mark_m,
             const std::vector<glm::dvec3>& targets_m) {
    for (std::size_t eye = 0; eye < 2; ++eye) {
      samples_.clear();
      const glm::dvec3 side_m((eye == 0 ? -0.5 : 0.5) * room_.eyeSeparation_m, 0.0, 0.0);
      glm::dvec3 from_m(0.0, 1.6, 0.8);
      for (std::size_t i = 0; i < targets_m.size(); ++i) {
        const glm::dvec3 back = glm::normalize(mark_m - targets_m[i]);
        const glm::dvec3 eye_m = mark_m + 0.4 * back;
        const glm::dvec3 elsewhere_m = 0.5 * (targets_m[i] + targets_m[(i + 1) % targets_m.size()]);
        const glm::dquat q = looking(elsewhere_m - eye_m);
        const Pose roomFromEyes{eye_m - q * side_m, q};
        const Pose roomFromSensor = roomFromEyes * room_.eyesFromSensor;
        move(from_m, roomFromSensor.position_m, [&](const glm::dvec3& at_m) {
          return Pose{at_m, roomFromSensor.orientation};
        });
        for (int k = 0; k < 75; ++k) add(roomFromSensor);
        from_m = roomFromSensor.position_m;
      }
      write(folder / kSightFiles[eye]);
    }
  }

 private:
  glm::dvec3 normal3(double sigma) {
    std::normal_distribution<double> one;
    const double x = sigma * one(random_), y = sigma * one(random_), z = sigma * one(random_);
    return {x, y, z};
  }
  static glm::dquat turned(const glm::dvec3& turn_rad) {
    const double angle = glm::length(turn_rad);
    return angle == 0.0 ? glm::dquat(1, 0, 0, 0) : glm::angleAxis(angle, turn_rad / angle);
  }
  /// Turns -z to a direction, x staying level.
  static glm::dquat looking(const glm::dvec3& direction) {
    const glm::dvec3 back = -glm::normalize(direction);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    return glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
  }
  static glm::dquat pointing(const glm::dvec3& direction) { return looking(direction); }

  void move(const glm::dvec3& from_m, const glm::dvec3& to_m,
            const std::function<Pose(const glm::dvec3&)>& poseAt) {
    for (int i = 0; i < 60; ++i) add(poseAt(from_m + (to_m - from_m) * (i / 60.0)));
  }
  /// Adds what the tracker makes of the sensor's pose in the room.
  void add(const Pose& roomFromSensor) {
    Pose seen = inverse(room_.roomFromTracker) * roomFromSensor;
    seen.position_m = seen.position_m * room_.scale + normal3(room_.noise_m);
    seen.orientation = glm::normalize(turned(normal3(room_.noise_rad)) * seen.orientation);
    if (room_.mirrored) {
      seen.position_m.x = -seen.position_m.x;
      seen.orientation = {seen.orientation.w, seen.orientation.x, -seen.orientation.y, -seen.orientation.z};
    }
    TrackerSample sample;
    sample.time_s = time_s_;
    sample.pose = seen;
    sample.hasOrientation = true;
    samples_.push_back(sample);
    time_s_ += 1.0 / 60.0;
  }
  void write(const std::filesystem::path& file) {
    TraceWriter writer(file, true);
    for (const TrackerSample& sample : samples_) writer.add(sample);
    writer.commit();
  }

  SimulatedRoom room_;
  std::mt19937_64 random_;
  double time_s_ = 0.0;
  std::vector<TrackerSample> samples_;
};

inline std::vector<glm::dvec3> placesOf(const std::vector<NamedCorner>& corners) {
  std::vector<glm::dvec3> places_m;
  for (const NamedCorner& corner : corners) places_m.push_back(corner.at_m);
  return places_m;
}

inline double turnBetween_deg(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat d = a * glm::conjugate(b);
  return 360.0 / 3.14159265358979 * std::atan2(glm::length(glm::dvec3(d.x, d.y, d.z)), std::abs(d.w));
}

}  // namespace carom::test
