#pragma once
// How values of the engine are printed where a test fails: GoogleTest finds PrintTo by the argument's
// namespace. Numbers are whole, so that a case can be written down again from what is printed.

#include <ostream>

#include <gtest/gtest.h>

#include "engine/base/pose.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

namespace test {

/// A place or direction; of GLM, whose namespace is not ours to add to.
struct Print {
  const glm::dvec3& v;
  friend std::ostream& operator<<(std::ostream& out, const Print& print) {
    return out << '(' << print.v.x << ", " << print.v.y << ", " << print.v.z << ')';
  }
};

/// All digits, for as long as it lives.
class AllDigits {
 public:
  explicit AllDigits(std::ostream& out) : out_(out), before_(out.precision(17)) {}
  ~AllDigits() { out_.precision(before_); }
  AllDigits(const AllDigits&) = delete;

 private:
  std::ostream& out_;
  std::streamsize before_;
};

}  // namespace test

inline void PrintTo(const Event& event, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "event at " << event.t_s << " s, " << test::Print{event.r_m} << " m";
}

inline void PrintTo(const Displacement& d, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "displacement by " << d.dt_s << " s, " << test::Print{d.dr_m} << " m";
}

inline void PrintTo(const Lorentz& aFromB, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "Lorentz transform, c = " << aFromB.lightSpeed_m_s() << " m/s, rows (ct, x, y, z):";
  for (int row = 0; row < 4; ++row) {
    *out << "\n  ";
    for (int column = 0; column < 4; ++column)
      *out << aFromB.matrix()[column][row] << (column < 3 ? ", " : "");
  }
}

inline void PrintTo(const Pose& pose, std::ostream* out) {
  const test::AllDigits digits(*out);
  const glm::dquat& q = pose.orientation;
  *out << "pose at " << test::Print{pose.position_m} << " m, turned by (w " << q.w << ", " << q.x << ", "
       << q.y << ", " << q.z << ')';
}

inline void PrintTo(const Knot& knot, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "knot: turn ";
  PrintTo(knot.turn, out);
  *out << ", u " << test::Print{knot.u} << ", proper time " << knot.properTime_s << " s, signal ";
  PrintTo(knot.signal, out);
  *out << ", deceleration " << knot.deceleration_m_s2 << " m/s²";
}

inline void PrintTo(const WorldLine& line, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "world line, c = " << line.lightSpeed_m_s() << " m/s, radius " << line.radius_m()
       << " m, appears at " << line.appears_s() << " s, of " << line.knots().size() << " knots";
  for (const Knot& knot : line.knots()) {
    *out << "\n  ";
    PrintTo(knot, out);
  }
}

inline void PrintTo(const EyeView& eye, std::ostream* out) {
  const test::AllDigits digits(*out);
  *out << "eye: ";
  PrintTo(eye.observation, out);
  *out << ", in the room at " << test::Print{eye.positionInRoom_m} << " m, seen from "
       << test::Print{eye.seenFromInRoom_m} << " m";
}

}  // namespace carom
