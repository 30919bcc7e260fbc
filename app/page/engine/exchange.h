#pragma once
// How a page in a browser and the engine that was compiled for it exchange values: one array of numbers in
// the engine's memory, which the page fills before a call and reads after it. Displacements are columns (c t,
// x, y, z) in metres; events are t (s), x, y, z (m); matrices stand column by column.
//
// There are no exceptions in a page: what the engine would throw at ends it. The page checks before.

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/spacetime/event.h"
#include "engine/spacetime/knot.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

/// Makes a function of the engine one that the page can call by its own name.
#ifdef __wasm__
#define CAROM_EXPORTED(name) __attribute__((export_name(#name)))
#else
#define CAROM_EXPORTED(name)
#endif

namespace carom::page {

/// The numbers that go to and fro.
std::vector<double>& exchange();

/// Reads what the page has left, one value after the other.
class Given {
 public:
  double number() { return exchange()[at_++]; }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Event event() {
    const double t_s = number();
    return {t_s, vector()};
  }
  Lorentz transform(double c_m_s) {
    glm::dmat4 matrix(1.0);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) matrix[column][row] = number();
    return Lorentz(c_m_s, matrix);
  }
  /// A knot has seventeen numbers: its turn, γβ, own time, signal, deceleration and spin.
  Knot knot() {
    Knot knot;
    knot.turn = event();
    knot.u = vector();
    knot.properTime_s = number();
    knot.signal = event();
    knot.deceleration_m_s2 = number();
    knot.spin.angle_rad = number();
    knot.spin.omega_rad_s = number();
    knot.spin.rim_u = number();
    knot.spin.slowing_1_s = number();
    return knot;
  }

 private:
  std::size_t at_ = 0;
};

/// Leaves an answer for the page, in the place of what it gave.
class Answer {
 public:
  Answer() { exchange().clear(); }
  void number(double value) { exchange().push_back(value); }
  void vector(const Vec3& v) {
    for (int i = 0; i < 3; ++i) number(v[i]);
  }
  void event(const Event& event) {
    number(event.t_s);
    vector(event.r_m);
  }
  void matrix(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) number(matrix[column][row]);
  }
  void knot(const Knot& knot) {
    event(knot.turn);
    vector(knot.u);
    number(knot.properTime_s);
    event(knot.signal);
    for (const double value : {knot.deceleration_m_s2, knot.spin.angle_rad, knot.spin.omega_rad_s,
                               knot.spin.rim_u, knot.spin.slowing_1_s})
      number(value);
  }
};

/// The bodies of the visit, as they are known at the moment that is shown: numbered as in the scene.
struct Bodies {
  double lightSpeed_m_s = 1.0;
  std::vector<WorldLine> lines;
};
Bodies& bodies();

}  // namespace carom::page
