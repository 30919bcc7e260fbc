// The path of a head: walks have their length, whatever the rate, and the noise of a tracker is no walk.
#include "app/study_data/lesson_behaviour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace carom {
namespace {

struct Path {
  std::vector<double> times_s;
  std::vector<Vec3> places_m;
  double length_m() const { return pathLength_m(times_s, places_m); }
  double rawLength_m() const {
    double sum_m = 0.0;
    for (std::size_t i = 1; i < places_m.size(); ++i) sum_m += glm::distance(places_m[i - 1], places_m[i]);
    return sum_m;
  }
};

template <typename At>
Path walk(double rate_hz, double for_s, const At& at) {
  Path path;
  for (std::size_t i = 0; static_cast<double>(i) <= for_s * rate_hz; ++i) {
    path.times_s.push_back(100.0 + static_cast<double>(i) / rate_hz);
    path.places_m.push_back(at(static_cast<double>(i) / rate_hz));
  }
  return path;
}

TEST(PathLength, OfACircleIsItsCircumferenceAtAnyRate) {
  const auto circle = [](double t_s) {
    const double angle = 2.0 * std::numbers::pi * 0.2 * t_s;
    return Vec3(std::cos(angle), 1.7, std::sin(angle));
  };
  for (const double rate_hz : {30.0, 60.0, 72.0, 90.0}) {
    const double length_m = walk(rate_hz, 60.0, circle).length_m();
    EXPECT_NEAR(length_m, 12.0 * 2.0 * std::numbers::pi, 0.4) << rate_hz;
  }
}

TEST(PathLength, OfAStraightWalkIsTheDistance) {
  EXPECT_NEAR(walk(60.0, 20.0, [](double t_s) { return Vec3(0.8 * t_s, 1.7, -0.3 * t_s); }).length_m(),
              20.0 * std::hypot(0.8, 0.3), 0.05);
  EXPECT_EQ(walk(60.0, 20.0, [](double) { return Vec3(1.0, 2.0, 3.0); }).length_m(), 0.0);
  EXPECT_EQ(pathLength_m({}, {}), 0.0);
}

TEST(PathLength, ANoiseOfThreeTenthsOfAMillimetreIsUnderFiveCentimetresAMinute) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.3e-3 / std::numbers::sqrt3);  // 0.3 mm in all
    const Path path = walk(60.0, 60.0, [&](double) {
      const double x = noise(random), y = noise(random), z = noise(random);
      return Vec3(x, 1.7 + y, z);
    });
    EXPECT_LT(path.length_m(), 0.05) << "seed " << seed;
    EXPECT_GT(path.rawLength_m(), 1.0) << "seed " << seed;
  }
}

// A game of 40 frames with strokes in five of them; the lesson is frames 10 to 29.
TEST(Behaviour, CountsTheStrokesOfItsFramesAlone) {
  SQLite::Database session(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  session.exec(
      "CREATE TABLE session(key, value); INSERT INTO session VALUES('viewer', 'guest');"
      "CREATE TABLE input(frame, what, value); CREATE TABLE stroke(frame, puck);"
      "INSERT INTO stroke VALUES(9, 'white'), (10, 'white'), (20, 'red'), (29, 'white'), (30, 'white');"
      "CREATE TABLE viewer(frame, name, known, room_x_m, room_y_m, room_z_m, celerity_x_m_s, "
      "celerity_y_m_s, celerity_z_m_s, x_m, y_m, z_m);"
      "CREATE TABLE frame(number, display_s, lesson_phase, blank, light_speed_m_s, head_sensor_qw, "
      "head_sensor_qx, head_sensor_qy, head_sensor_qz, board_from_room_xx, board_from_room_xy, "
      "board_from_room_xz, board_from_room_yx, board_from_room_yy, board_from_room_yz, board_from_room_zx, "
      "board_from_room_zy, board_from_room_zz)");
  for (int number = 0; number < 40; ++number) {
    const std::string n = std::to_string(number);
    session.exec("INSERT INTO viewer VALUES(" + n + ", 'guest', 'known', 0, 1.7, 0, 0, 0, 0, 0, 0, 1)");
    session.exec("INSERT INTO frame VALUES(" + n + ", " + n +
                 ", 2, 0, 1.42, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)");
  }
  const LessonBehaviour all = behaviourIn(session, 10, 30, {});
  EXPECT_EQ(all.strokes, 3);
  EXPECT_EQ(all.ask_s + all.show_s + all.explain_s, 19.0);
  EXPECT_EQ(behaviourIn(session, 11, 20, {}).strokes, 0);
}

}  // namespace
}  // namespace carom
