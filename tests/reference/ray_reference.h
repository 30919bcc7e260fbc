#pragma once
// What special relativity says an eye sees, by other means than the engine: slow, in double, with boosts of
// its own. Two ways, which do not know each other:
//
// * Ray tracing. A pixel's direction in the head frame is a null vector, followed backwards from the eye's
//   event into the rest frame of each leg of a body; there it is a straight line that meets a shape at rest.
//   The hit counts if its event lies on that leg.
// * Bisection. Each point of a fine mesh has a world line, laid by its rules step by step on the board; where
//   it crosses the eye's past cone is found by halving, and the seen places are filled in as triangles.
//   It alone knows what a body looks like while it is turning.
//
// c = 1: times are metres of light. Board frame unless a name says otherwise.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace carom::reference {

using Vec = glm::dvec3;

struct Event {
  double t = 0.0;
  Vec r{0.0};
};
inline Event operator-(const Event& a, const Event& b) { return {a.t - b.t, a.r - b.r}; }
inline Event operator+(const Event& a, const Event& b) { return {a.t + b.t, a.r + b.r}; }

/// A displacement in the frame that moves with velocity v, by the textbook (Jackson 11.19):
/// t' = γ (t − v·r),  r' = r + ((γ − 1)/v² (v·r) − γ t) v, with (γ − 1)/v² = γ²/(γ + 1).
inline Event boosted(const Event& d, const Vec& v) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(v, v));
  const double vr = glm::dot(v, d.r);
  return {gamma * (d.t - vr), d.r + v * (gamma * gamma / (gamma + 1.0) * vr - gamma * d.t)};
}

/// Where an increasing function changes its sign: outwards from `guess`, then halving to the last bit.
template <typename Function>
double rootOf(const Function& f, double guess) {
  double low = guess - 0.01, high = guess + 0.01;
  for (double step = 0.01; f(low) > 0.0; step *= 2.0) low -= step;
  for (double step = 0.01; f(high) <= 0.0; step *= 2.0) high += step;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    (f(middle) > 0.0 ? high : low) = middle;
  }
}

/// Motion of a body's centre from its turn on (the first leg: always), and the event whose signal makes the
/// body's points leave the leg before.
struct Leg {
  Event turn;
  Vec v{0.0};  ///< at the turn
  Event signal;
  double brake = 0.0;  ///< constant proper deceleration until rest, 1/m
  // Of an unbraked leg: the angle at the turn, the body's rate then (rad/m of own time, anticlockwise), its rim's γβ
  // then, and by how much that falls in a metre of own time.
  double angle = 0.0, rate = 0.0, rim = 0.0, slowing = 0.0;

  bool spins() const { return angle != 0.0 || rate != 0.0; }
  /// Its angle: dφ/ds = (rate Γ₀/h₀) h/Γ, Γ² = 1 + h², with h = h₀ − slowing s until it is 0.
  double angleAt(double s) const {
    if (slowing == 0.0 || s <= 0.0) return angle + rate * s;
    const double h = std::max(std::abs(rim) - slowing * s, 0.0), gamma0 = std::hypot(1.0, rim);
    return angle + rate * gamma0 / std::abs(rim) * (gamma0 - std::hypot(1.0, h)) / slowing;
  }
  /// The body's point d, own time s after the turn, in the leg's rest frame.
  Vec turned(const Vec& d, double s) const {
    const double a = angleAt(s);
    return {std::cos(a) * d.x - std::sin(a) * d.y, std::sin(a) * d.x + std::cos(a) * d.y, d.z};
  }

  struct State {
    Vec r{0.0}, v{0.0};
  };
  /// The centre. Braked, the celerity w = γv falls as w − brake t, the way is (γ − γ')/brake.
  State centre(double t) const {
    const double dt = t - turn.t, speed = glm::length(v);
    if (brake == 0.0 || speed == 0.0 || dt <= 0.0) return {turn.r + v * dt, v};
    const double gamma = 1.0 / std::sqrt(1.0 - speed * speed);
    const double celerity = std::max(gamma * speed - brake * dt, 0.0);
    const double gammaNow = std::sqrt(1.0 + celerity * celerity);
    return {turn.r + v / speed * ((gamma - gammaNow) / brake), v / speed * (celerity / gammaNow)};
  }
  /// The body's point d: contracted by 1/γ along the motion; where it turns, on its helix.
  Vec place(const Vec& d, double t) const {
    if (spins()) {
      const auto onBoard = [&](double s) { return boosted(Event{s, turned(d, s)}, -v); };
      const double s = rootOf([&](double at) { return onBoard(at).t - (t - turn.t); }, t - turn.t);
      return turn.r + onBoard(s).r;
    }
    const State now = centre(t);
    const double v2 = glm::dot(now.v, now.v);
    if (v2 == 0.0) return now.r + d;
    return now.r + d + now.v * ((std::sqrt(1.0 - v2) - 1.0) * glm::dot(d, now.v) / v2);
  }
};

/// In the outgoing body's rest frame, on the way from one leg to the next; faster than the point goes round there.
inline double catchUpSpeed(const Leg& leg, const Vec& d) {
  return std::max(0.9, 0.5 * (1.0 + std::abs(leg.rate) * std::hypot(d.x, d.y)));
}

/// The world line of one body-fixed point, as the rules lay it: it leaves where the signal reaches it, wherever
/// it then is, and goes straight to its place on the next leg.
class PointLine {
 public:
  PointLine(std::span<const Leg> legs, const Vec& d) : legs_(legs), d_(d) {
    pieces_.push_back({-std::numeric_limits<double>::infinity(), 0, false, {}, {}});
    for (std::size_t next = 1; next < legs.size(); ++next) {
      const Event signal = legs[next].signal;
      const double left =
          rootOf([&](double t) { return t - signal.t - glm::length(at(t) - signal.r); }, signal.t);
      const Event a{left, at(left)};
      const double joined = rootOf(
          [&](double t) {
            const Event way = boosted(Event{t, legs[next].place(d, t)} - a, legs[next].v);
            return catchUpSpeed(legs[next], d) * way.t - glm::length(way.r);
          },
          left);
      while (pieces_.back().from > left) pieces_.pop_back();
      const Event b{joined, legs[next].place(d, joined)};
      pieces_.push_back({left, next, true, a, b});
      pieces_.push_back({joined, next, false, {}, {}});
    }
  }

  Vec at(double t) const {
    const Piece& piece = pieceAt(t);
    if (!piece.catchingUp) return legs_[piece.leg].place(d_, t);
    const double way = piece.b.t - piece.a.t;
    return way > 0.0 ? piece.a.r + (piece.b.r - piece.a.r) * ((t - piece.a.t) / way) : piece.b.r;
  }

  /// The event on the past cone of the eye: c (t_o − t) = |r_o − r(t)|.
  Event emission(const Event& eye) const {
    const double t = rootOf([&](double s) { return glm::length(eye.r - at(s)) - (eye.t - s); }, eye.t);
    return {t, at(t)};
  }

  std::size_t legAt(double t) const { return pieceAt(t).leg; }
  bool catchingUpAt(double t) const { return pieceAt(t).catchingUp; }

 private:
  struct Piece {
    double from;
    std::size_t leg;
    bool catchingUp;
    Event a, b;
  };
  const Piece& pieceAt(double t) const {
    std::size_t i = pieces_.size() - 1;
    while (i > 0 && t < pieces_[i].from) --i;
    return pieces_[i];
  }

  std::span<const Leg> legs_;
  Vec d_;
  std::vector<Piece> pieces_;
};

/// An eye at an event, moving with v; its head frame's axes are the board's by a rotation-free boost.
struct Eye {
  Event event;
  Vec v{0.0};
  Vec seen(const Event& emission) const { return boosted(emission - event, v).r; }
};

// ---- shapes at rest -------------------------------------------------------------------------------------

/// How far along a ray (origin + s direction, s > 0) a shape at rest is first met.
using Shape = std::function<std::optional<double>(const Vec& origin, const Vec& direction)>;

/// The interval of s on which b s² + 2 h s + g ≥ 0 holds within [low, high], where it is known to be one
/// interval; `descending`: of two, the one at small s. False if it is empty.
inline bool clipQuadratic(double b, double h, double g, bool descending, double& low, double& high) {
  if (b == 0.0) {
    if (h == 0.0) return g >= 0.0;
    (h > 0.0 ? low : high) = h > 0.0 ? std::max(low, -0.5 * g / h) : std::min(high, -0.5 * g / h);
    return low < high;
  }
  const double inside = h * h - b * g;
  if (inside <= 0.0) return b > 0.0;
  const double root = std::sqrt(inside);
  const double first = (b > 0.0 ? -h - root : -h + root) / b, second = (b > 0.0 ? -h + root : -h - root) / b;
  if (b < 0.0) {
    low = std::max(low, first);
    high = std::min(high, second);
  } else if (descending) {
    high = std::min(high, first);
  } else {
    low = std::max(low, second);
  }
  return low < high;
}

/// The bevel of the built-in puck (cave/scene/puck_model.cpp), cut at 45°.
inline double puckBevel(double radius, double height) { return std::min(0.08 * radius, 0.15 * height); }

/// The built-in puck without any mesh: |z| ≤ h, ρ ≤ R, and the bevels' two cones ρ ≤ R + h − bevel ∓ z.
inline Shape puckShape(double radius, double height) {
  const double h = 0.5 * height, apex = radius + h - puckBevel(radius, height);
  return [=](const Vec& o, const Vec& k) -> std::optional<double> {
    double low = 0.0, high = std::numeric_limits<double>::infinity();
    if (k.z == 0.0) {
      if (std::abs(o.z) > h) return std::nullopt;
    } else {
      low = std::max(low, ((k.z > 0.0 ? -h : h) - o.z) / k.z);
      high = ((k.z > 0.0 ? h : -h) - o.z) / k.z;
    }
    const double kk = k.x * k.x + k.y * k.y, ok = o.x * k.x + o.y * k.y, oo = o.x * o.x + o.y * o.y;
    if (!(low < high) || !clipQuadratic(-kk, -ok, radius * radius - oo, false, low, high)) return {};
    for (const double up : {1.0, -1.0}) {  // (apex − up z)² ≥ ρ²
      const double z = apex - up * o.z;
      if (!clipQuadratic(k.z * k.z - kk, -up * k.z * z - ok, z * z - oo, up * k.z > 0.0, low, high))
        return {};
    }
    return low;
  };
}

struct Mesh {
  std::vector<Vec> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// A mesh by brute force: every triangle (Möller and Trumbore 1997) of what lies within a bounding ball.
inline Shape meshShape(Mesh mesh) {
  double reach2 = 0.0;
  for (const Vec& p : mesh.points) reach2 = std::max(reach2, glm::dot(p, p));
  return [mesh = std::move(mesh), reach2](const Vec& o, const Vec& k) -> std::optional<double> {
    const double ok = glm::dot(o, k), kk = glm::dot(k, k);
    if (glm::dot(o, o) - ok * ok / kk > reach2) return std::nullopt;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& triangle : mesh.triangles) {
      const Vec corner = mesh.points[triangle[0]];
      const Vec a = mesh.points[triangle[1]] - corner, b = mesh.points[triangle[2]] - corner;
      const Vec p = glm::cross(k, b);
      const double determinant = glm::dot(a, p);
      if (determinant == 0.0) continue;
      const Vec from = o - corner, q = glm::cross(from, a);
      const double u = glm::dot(from, p) / determinant, w = glm::dot(k, q) / determinant;
      const double s = glm::dot(b, q) / determinant;
      if (u >= 0.0 && w >= 0.0 && u + w <= 1.0 && s > 0.0) nearest = std::min(nearest, s);
    }
    return nearest < std::numeric_limits<double>::infinity() ? std::optional(nearest) : std::nullopt;
  };
}

/// The built-in puck as triangles, edges at least `times` finer than it is drawn at its coarsest.
inline Mesh puckMesh(double radius, double height, int times) {
  const double h = 0.5 * height, bevel = puckBevel(radius, height);
  const std::array<std::array<double, 2>, 6> corners{{{0.0, -h},
                                                      {radius - bevel, -h},
                                                      {radius, bevel - h},
                                                      {radius, h - bevel},
                                                      {radius - bevel, h},
                                                      {0.0, h}}};
  const std::array<int, 5> cells{4, 1, 2, 1, 4};
  const int sectors = 72 * times;
  Mesh mesh;
  std::vector<std::array<double, 2>> profile{corners[0]};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int k = 1; k <= cells[i] * times; ++k) {
      const double f = static_cast<double>(k) / (cells[i] * times);
      profile.push_back({corners[i][0] + f * (corners[i + 1][0] - corners[i][0]),
                         corners[i][1] + f * (corners[i + 1][1] - corners[i][1])});
    }
  }
  const auto n = static_cast<std::size_t>(sectors);
  for (const auto& [rho, z] : profile) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / sectors;
      mesh.points.push_back({rho * std::cos(angle), rho * std::sin(angle), z});
    }
  }
  for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = row * n + i, b = row * n + (i + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  }
  return mesh;
}

/// Every triangle as sixteen: edges four times finer.
inline Mesh fourTimesFiner(const Mesh& coarse) {
  Mesh fine;
  for (const auto& triangle : coarse.triangles) {
    const Vec a = coarse.points[triangle[0]], u = (coarse.points[triangle[1]] - a) / 4.0,
              w = (coarse.points[triangle[2]] - a) / 4.0;
    const auto add = [&](int i, int j) {
      fine.points.push_back(a + u * static_cast<double>(i) + w * static_cast<double>(j));
      return fine.points.size() - 1;
    };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; i + j < 4; ++j) {
        fine.triangles.push_back({add(i, j), add(i + 1, j), add(i, j + 1)});
        if (i + j < 3) fine.triangles.push_back({add(i + 1, j), add(i + 1, j + 1), add(i, j + 1)});
      }
    }
  }
  return fine;
}

// ---- the wall -------------------------------------------------------------------------------------------

/// A wall from the eye, head axes: pixel (x, y), y upwards, lies at lowerLeft + x/width right + y/height up.
struct Screen {
  Vec lowerLeft{0.0}, right{0.0}, up{0.0};
  double width = 0.0, height = 0.0;

  Vec direction(double x, double y) const {
    return glm::normalize(lowerLeft + right * (x / width) + up * (y / height));
  }
  struct Pixel {
    double x = 0.0, y = 0.0;
    double depth = 0.0;  ///< along the wall's normal, in distances of the wall; behind the eye ≤ 0
  };
  Pixel pixelOf(const Vec& seen) const {
    const Vec normal = glm::cross(right, up);
    const double depth = glm::dot(normal, seen) / glm::dot(normal, lowerLeft);
    const Vec onWall = seen / depth - lowerLeft;
    return {glm::dot(onWall, right) / glm::dot(right, right) * width,
            glm::dot(onWall, up) / glm::dot(up, up) * height, depth};
  }
  /// The same depth of a point at `distance` in a direction.
  double depthAlong(const Vec& direction, double distance) const {
    const Vec normal = glm::cross(right, up);
    return glm::dot(normal, direction) * distance / glm::dot(normal, lowerLeft);
  }
};

// ---- the two ways ---------------------------------------------------------------------------------------

/// On which leg the light of all `points` left, if of all the same and none on its way to it.
inline std::optional<std::size_t> commonLeg(std::span<const Leg> legs, std::span<const Vec> points,
                                            const Eye& eye) {
  std::optional<std::size_t> common;
  for (const Vec& d : points) {
    const PointLine line(legs, d);
    const double t = line.emission(eye.event).t;
    if (line.catchingUpAt(t) || (common && *common != line.legAt(t))) return std::nullopt;
    common = line.legAt(t);
  }
  return common;
}

/// How far away in the head frame a straight ray that comes along `direction` was sent by the body, if it
/// was. For bodies whose light left on one leg (commonLeg), and legs without brake.
inline std::optional<double> trace(std::span<const Leg> legs, const Shape& shape, const Eye& eye,
                                   const Vec& direction) {
  const Event back = boosted({-1.0, direction}, -eye.v);  // on the board
  std::optional<double> nearest;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const Event eyeInBody = boosted(eye.event - leg.turn, leg.v), backInBody = boosted(back, leg.v);
    const std::optional<double> s = shape(eyeInBody.r, backInBody.r);
    if (!s || (nearest && *nearest < *s)) continue;
    const Event hit{eyeInBody.t + *s * backInBody.t, eyeInBody.r + *s * backInBody.r};
    if (i + 1 < legs.size()) {  // had the signal that ends the leg arrived?
      const Event signal = boosted(legs[i + 1].signal - leg.turn, leg.v);
      if (hit.t - signal.t >= glm::length(hit.r - signal.r)) continue;
    }
    if (i > 0) {  // had the point of the body that was hit joined the leg?
      const Leg& before = legs[i - 1];
      const Event signal = boosted(leg.signal - before.turn, before.v);
      const Event left{signal.t + glm::length(hit.r - signal.r), hit.r};  // in the frame of the leg before
      const Event leftHere = boosted(boosted(left, -before.v) + before.turn - leg.turn, leg.v);
      if (hit.t < leftHere.t + glm::length(leftHere.r - hit.r) / catchUpSpeed(leg, hit.r)) continue;
    }
    nearest = s;
  }
  return nearest;
}

/// A mesh whose points' emissions were found by halving, on a screen.
class SeenMesh {
 public:
  SeenMesh(std::span<const Leg> legs, const Mesh& mesh, const Eye& eye, const Screen& screen)
      : triangles_(mesh.triangles),
        tilesAcross_(static_cast<int>(screen.width) / kTile + 1),
        tilesUp_(static_cast<int>(screen.height) / kTile + 1),
        tiles_(static_cast<std::size_t>(tilesAcross_) * static_cast<std::size_t>(tilesUp_)) {
    for (const Vec& d : mesh.points) {
      corners_.push_back(screen.pixelOf(eye.seen(PointLine(legs, d).emission(eye.event))));
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) sortIntoTiles(i);
  }

  /// Depth (Screen::Pixel) of what is nearest at a place of the screen.
  std::optional<double> depthAt(double x, double y) const {
    const int column = static_cast<int>(x) / kTile, row = static_cast<int>(y) / kTile;
    if (x < 0.0 || y < 0.0 || column >= tilesAcross_ || row >= tilesUp_) return std::nullopt;
    double inverse = 0.0;
    for (const std::size_t i : tiles_[static_cast<std::size_t>(row * tilesAcross_ + column)]) {
      const Screen::Pixel &a = corners_[triangles_[i][0]], &b = corners_[triangles_[i][1]],
                          &c = corners_[triangles_[i][2]];
      const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      const double u = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
      const double w = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
      if (!(u >= 0.0 && w >= 0.0 && u + w <= 1.0)) continue;
      // 1/depth is linear on the screen.
      inverse = std::max(inverse, (1.0 - u - w) / a.depth + u / b.depth + w / c.depth);
    }
    return inverse > 0.0 ? std::optional(1.0 / inverse) : std::nullopt;
  }

  const std::vector<Screen::Pixel>& corners() const { return corners_; }

 private:
  static constexpr int kTile = 8;

  void sortIntoTiles(std::size_t triangle) {
    double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
    for (const std::size_t i : triangles_[triangle]) {
      const Screen::Pixel& p = corners_[i];
      if (!(p.depth > 0.0)) return;
      left = std::min(left, p.x), right = std::max(right, p.x);
      bottom = std::min(bottom, p.y), top = std::max(top, p.y);
    }
    const auto tile = [](double at, int tiles) {
      return static_cast<int>(std::clamp(std::floor(at / kTile), -1.0, static_cast<double>(tiles)));
    };
    for (int row = std::max(tile(bottom, tilesUp_), 0); row <= std::min(tile(top, tilesUp_), tilesUp_ - 1);
         ++row) {
      for (int column = std::max(tile(left, tilesAcross_), 0);
           column <= std::min(tile(right, tilesAcross_), tilesAcross_ - 1); ++column) {
        tiles_[static_cast<std::size_t>(row * tilesAcross_ + column)].push_back(triangle);
      }
    }
  }

  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<Screen::Pixel> corners_;
  int tilesAcross_, tilesUp_;
  std::vector<std::vector<std::size_t>> tiles_;
};

}  // namespace carom::reference
