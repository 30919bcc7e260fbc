#pragma once
// Events and the displacements between them: points and arrows of spacetime, kept apart by type.
// Event − Event = Displacement; Event + Displacement = Event; Event + Event does not compile.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace carom {

using Vec3 = glm::dvec3;

/// A difference of two events in one frame: seconds and metres.
struct Displacement {
  double dt_s = 0.0;
  Vec3 dr_m{0.0};
};

/// A point of spacetime in one frame (the board's unless the name says otherwise): seconds and metres.
struct Event {
  double t_s = 0.0;
  Vec3 r_m{0.0};
};

inline Displacement operator-(const Event& a, const Event& b) { return {a.t_s - b.t_s, a.r_m - b.r_m}; }
inline Event operator+(const Event& e, const Displacement& d) { return {e.t_s + d.dt_s, e.r_m + d.dr_m}; }
inline Event operator-(const Event& e, const Displacement& d) { return {e.t_s - d.dt_s, e.r_m - d.dr_m}; }
inline Displacement operator+(const Displacement& a, const Displacement& b) {
  return {a.dt_s + b.dt_s, a.dr_m + b.dr_m};
}
inline Displacement operator-(const Displacement& d) { return {-d.dt_s, -d.dr_m}; }

/// Returns Δs² = c²Δt² − Δr² in m²: positive between events that one clock can attend, 0 along light.
inline double interval_m2(const Displacement& d, double c_m_s) {
  const double ct_m = c_m_s * d.dt_s;
  return ct_m * ct_m - glm::dot(d.dr_m, d.dr_m);
}

}  // namespace carom
