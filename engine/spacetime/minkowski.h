#pragma once
// Spacetime of the board's plane in 2+1 dimensions, for the collision physics alone: (c t, x, y), all in
// metres, metric (+,−,−). A four-velocity is (γ, γβx, γβy).
// Theory: app/doc/physics.md, Notation and sources.

#include <cmath>

#include <glm/vec2.hpp>

namespace carom {

/// An event or a four-vector of the board's plane; c = 1, everything in metres.
struct Vec21 {
  double t = 0.0;
  double x = 0.0;
  double y = 0.0;
};

inline Vec21 operator+(const Vec21& a, const Vec21& b) { return {a.t + b.t, a.x + b.x, a.y + b.y}; }
inline Vec21 operator-(const Vec21& a, const Vec21& b) { return {a.t - b.t, a.x - b.x, a.y - b.y}; }
inline Vec21 operator*(const Vec21& a, double s) { return {a.t * s, a.x * s, a.y * s}; }
inline Vec21 operator*(double s, const Vec21& a) { return a * s; }

/// a·b = at bt − ax bx − ay by.
inline double dot(const Vec21& a, const Vec21& b) { return a.t * b.t - a.x * b.x - a.y * b.y; }

/// The vector orthogonal to a and b; dot(cross(a, b), d) is the determinant of (d, a, b).
inline Vec21 cross(const Vec21& a, const Vec21& b) {
  return {a.x * b.y - a.y * b.x, a.t * b.y - a.y * b.t, a.x * b.t - a.t * b.x};
}

/// (γ, u) of u = γβ.
inline Vec21 fourVelocity(double ux, double uy) { return {std::sqrt(1.0 + ux * ux + uy * uy), ux, uy}; }

}  // namespace carom
