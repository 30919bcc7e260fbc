#pragma once
// What special relativity says an eye sees, by other means than the engine: slow, in double, with boosts of
// its own. Two ways, which do not know each other:
//
// * Ray tracing. A pixel's direction in the head frame is a null vector, followed backwards from the eye's
//   event into the rest frame of each leg of a body; there it is a straight line that meets a shape at rest.
//   The hit counts if its event lies on that leg.
// * Bisection. Each point of a fine mesh has a world line, laid by its rules step by step on the board; where
//   it crosses the eye's past cone is found by halving, and the seen places are filled in as triangles.
//   It alone knows what a body looks like in the middle of a bounce.
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

/// d turned about z.
inline Vec turnedBy(double angle, const Vec& d) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * d.x - s * d.y, s * d.x + c * d.y, d.z};
}

/// Motion of a body's centre from its turn on (the first leg: always), and the event whose signal makes the
/// body's points leave the leg before.
struct Leg {
  Event turn;
  Vec v{0.0};  ///< at the turn
  Event signal;
  double brake = 0.0;  ///< constant proper deceleration until rest, 1/m
  // The angle at the turn, the body's rate then (rad/m of own time, anticlockwise), its rim's γβ then, and by
  // how much that falls in a metre of own time.
  double angle = 0.0, rate = 0.0, rim = 0.0, slowing = 0.0;

  bool spins() const { return angle != 0.0 || rate != 0.0; }
  bool glides() const { return brake > 0.0 && v != Vec(0.0); }
  /// Its angle: dφ/ds = (rate Γ₀/h₀) h/Γ, Γ² = 1 + h², with h = h₀ − slowing s until it is 0.
  double angleAt(double s) const {
    if (slowing == 0.0 || s <= 0.0) return angle + rate * s;
    const double h = std::max(std::abs(rim) - slowing * s, 0.0), gamma0 = std::hypot(1.0, rim);
    return angle + rate * gamma0 / std::abs(rim) * (gamma0 - std::hypot(1.0, h)) / slowing;
  }
  /// The body's point d, own time s after the turn, in the leg's rest frame.
  Vec turned(const Vec& d, double s) const { return spins() ? turnedBy(angleAt(s), d) : d; }

  /// The centre of a body that brakes: its celerity w = γβ falls as w₀ − brake t, the way is (γ₀ − γ)/brake,
  /// its own time (asinh w₀ − asinh w)/brake.
  struct State {
    Vec r{0.0};
    double celerity = 0.0, own = 0.0;
  };
  State braked(double since) const {
    const double speed = glm::length(v), gamma0 = 1.0 / std::sqrt(1.0 - speed * speed), w0 = gamma0 * speed;
    if (since <= 0.0) return {turn.r + v * since, w0, since / gamma0};
    const double gliding = std::min(since, w0 / brake), w = std::max(w0 - brake * since, 0.0);
    return {turn.r + v / speed * ((gamma0 - std::sqrt(1.0 + w * w)) / brake), w,
            (std::asinh(w0) - std::asinh(w)) / brake + (since - gliding)};
  }
  /// The body's point d when its leg's time is s. That is the centre's own time since the turn; the point is
  /// simultaneous with the centre in the centre's rest frame. Of a body that brakes it is the centre's board
  /// time since the turn: the point has turned as the centre has; simultaneous with it in its momentary rest
  /// frame, it is later on the board by the centre's celerity times its place ahead, and contracted as the
  /// centre is by then.
  Event event(const Vec& d, double s) const {
    if (!glides()) return turn + boosted(Event{s, turned(d, s)}, -v);
    const Vec n = glm::normalize(v);
    const State centre = braked(s);
    const Vec place = turned(d, centre.own);
    const double ahead = glm::dot(place, n), since = s + centre.celerity * ahead;
    const State then = braked(since);
    const double contracted = ahead / std::sqrt(1.0 + then.celerity * then.celerity);
    return {turn.t + since, then.r + place + n * (contracted - ahead)};
  }
  /// The leg's time of an event near the body.
  double timeNear(const Event& a) const { return glides() ? a.t - turn.t : boosted(a - turn, v).t; }
};

/// In the outgoing body's rest frame, on the way from one leg to the next; faster than the point goes round
/// there and friction leaves it behind.
inline double catchUpSpeed(const Leg& leg, const Vec& d) {
  const double round = std::abs(leg.rate) * std::hypot(d.x, d.y),
               back = leg.glides() ? glm::length(leg.v) : 0.0;
  return std::max(0.9, 0.5 * (1.0 + std::tanh(std::atanh(round) + std::atanh(back))));
}

/// The world line of one body-fixed point, as the rules lay it: it leaves where the signal reaches it,
/// wherever it then is, and goes straight to its place on the next leg.
class PointLine {
 public:
  PointLine(std::span<const Leg> legs, const Vec& d) : legs_(legs), d_(d) {
    pieces_.push_back({0, false, {-std::numeric_limits<double>::infinity(), {}}, {}, 0.0});
    for (std::size_t next = 1; next < legs.size(); ++next) {
      const Event signal = legs[next].signal;
      const Crossing left =
          crossing([&](const Event& a) { return a.t - signal.t - glm::length(a.r - signal.r); });
      const Event a = left.event;
      const double joined = rootOf(
          [&](double s) {
            const Event way = boosted(legs[next].event(d, s) - a, legs[next].v);
            return catchUpSpeed(legs[next], d) * way.t - glm::length(way.r);
          },
          legs[next].timeNear(a));
      outOfTurn_ = outOfTurn_ || (left.piece + 1 < pieces_.size() && !pieces_[left.piece].catchingUp);
      pieces_.resize(left.piece + 1);
      const Event b = legs[next].event(d, joined);
      pieces_.push_back({next, true, a, b, 0.0});
      pieces_.push_back({next, false, b, {}, joined});
    }
  }

  Vec at(double t) const {
    return crossing([&](const Event& a) { return a.t - t; }).event.r;
  }

  /// The event on the past cone of the eye: c (t_o − t) = |r_o − r(t)|.
  Event emission(const Event& eye) const {
    return crossing([&](const Event& a) { return glm::length(eye.r - a.r) - (eye.t - a.t); }).event;
  }

  /// Did the signal that ends a leg overtake the one before, and reach the point while it still followed the
  /// leg before?
  bool newsOutOfTurn() const { return outOfTurn_; }

  std::size_t legAt(double t) const { return pieceAt(t).leg; }
  bool catchingUpAt(double t) const { return pieceAt(t).catchingUp; }

 private:
  struct Piece {
    std::size_t leg;
    bool catchingUp;
    Event from, to;  ///< `to` of a straight way between two legs
    double begins;   ///< the leg's time at `from`
  };
  struct Crossing {
    Event event;
    std::size_t piece;
  };
  /// Where a function of events that rises along the line changes its sign.
  template <typename Function>
  Crossing crossing(const Function& f) const {
    std::size_t i = pieces_.size() - 1;
    while (i > 0 && f(pieces_[i].from) > 0.0) --i;
    const Piece& piece = pieces_[i];
    const auto along = [&](double s) {
      if (!piece.catchingUp) return legs_[piece.leg].event(d_, s);
      return Event{piece.from.t + s * (piece.to.t - piece.from.t),
                   piece.from.r + s * (piece.to.r - piece.from.r)};
    };
    // Of a way without length: its end.
    if (piece.catchingUp && piece.to.t == piece.from.t) return {piece.to, i};
    return {along(rootOf([&](double s) { return f(along(s)); }, piece.begins)), i};
  }
  const Piece& pieceAt(double t) const {
    std::size_t i = pieces_.size() - 1;
    while (i > 0 && t < pieces_[i].from.t) --i;
    return pieces_[i];
  }

  std::span<const Leg> legs_;
  Vec d_;
  std::vector<Piece> pieces_;
  bool outOfTurn_ = false;
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

/// Places (ρ, z) of the built-in puck's surface, from the middle of its bottom to that of its top: each face,
/// bevel and the side in so many cells.
inline std::vector<std::array<double, 2>> puckProfile(double radius, double height,
                                                      const std::array<int, 5>& cells) {
  const double h = 0.5 * height, bevel = puckBevel(radius, height);
  const std::array<std::array<double, 2>, 6> corners{{{0.0, -h},
                                                      {radius - bevel, -h},
                                                      {radius, bevel - h},
                                                      {radius, h - bevel},
                                                      {radius - bevel, h},
                                                      {0.0, h}}};
  std::vector<std::array<double, 2>> profile{corners[0]};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int k = 1; k <= cells[i]; ++k) {
      const double f = static_cast<double>(k) / cells[i];
      profile.push_back({corners[i][0] + f * (corners[i + 1][0] - corners[i][0]),
                         corners[i][1] + f * (corners[i + 1][1] - corners[i][1])});
    }
  }
  return profile;
}

/// A surface of revolution. Each place of the profile has so many points around; of two neighbours one number
/// is a multiple of the other.
inline Mesh turnedMesh(const std::vector<std::array<double, 2>>& profile,
                       const std::vector<std::size_t>& around) {
  Mesh mesh;
  std::vector<std::size_t> first;
  for (std::size_t row = 0; row < profile.size(); ++row) {
    first.push_back(mesh.points.size());
    for (std::size_t i = 0; i < around[row]; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around[row]);
      mesh.points.push_back(
          {profile[row][0] * std::cos(angle), profile[row][0] * std::sin(angle), profile[row][1]});
    }
  }
  for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
    const auto [few, many] = std::minmax(around[row], around[row + 1]);
    const std::size_t coarse = around[row] == few ? row : row + 1, fine = coarse == row ? row + 1 : row;
    const std::size_t times = many / few;
    for (std::size_t i = 0; i < few; ++i) {
      const std::size_t a = first[coarse] + i, b = first[coarse] + (i + 1) % few;
      const auto onFine = [&](std::size_t k) { return first[fine] + (i * times + k) % many; };
      for (std::size_t k = 0; k < times; ++k)
        mesh.triangles.push_back({2 * k < times ? a : b, onFine(k), onFine(k + 1)});
      mesh.triangles.push_back({a, b, onFine((times + 1) / 2)});
    }
  }
  return mesh;
}

/// The built-in puck as triangles, edges at least `times` finer than it is drawn at its coarsest.
inline Mesh puckMesh(double radius, double height, int times) {
  const auto profile = puckProfile(radius, height, {4 * times, times, 2 * times, times, 4 * times});
  return turnedMesh(profile, std::vector(profile.size(), static_cast<std::size_t>(72 * times)));
}

/// Every other one of twelve equal sectors of a body is marked.
inline bool isMarked(const Vec& d) {
  return static_cast<int>(std::floor(6.0 / std::numbers::pi * (std::atan2(d.y, d.x) + std::numbers::pi))) %
             2 ==
         1;
}

/// The marked triangles, or the others.
inline Mesh marksOf(const Mesh& mesh, bool marked) {
  constexpr std::size_t kUnused = static_cast<std::size_t>(-1);
  Mesh marks;
  std::vector<std::size_t> numbers(mesh.points.size(), kUnused);
  for (auto triangle : mesh.triangles) {
    Vec sum(0.0);
    for (const std::size_t i : triangle) sum += mesh.points[i];
    if (isMarked(sum) != marked) continue;
    for (std::size_t& i : triangle) {
      if (numbers[i] == kUnused) {
        numbers[i] = marks.points.size();
        marks.points.push_back(mesh.points[i]);
      }
      i = numbers[i];
    }
    marks.triangles.push_back(triangle);
  }
  return marks;
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

/// What a ray comes from: how far away in the head frame, and which point of the body.
struct Hit {
  double distance = 0.0;
  Vec point{0.0};
};

/// What a straight ray that comes along `direction` was sent by, if by the body. For bodies whose light left
/// on one leg (commonLeg), and legs without brake. Of a body that turns, a round shape, that leg alone is
/// given.
inline std::optional<Hit> trace(std::span<const Leg> legs, const Shape& shape, const Eye& eye,
                                const Vec& direction) {
  const Event back = boosted({-1.0, direction}, -eye.v);  // on the board
  std::optional<Hit> nearest;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const Event eyeInBody = boosted(eye.event - leg.turn, leg.v), backInBody = boosted(back, leg.v);
    const std::optional<double> s = shape(eyeInBody.r, backInBody.r);
    if (!s || (nearest && nearest->distance < *s)) continue;
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
    nearest = Hit{*s, turnedBy(-leg.angleAt(hit.t), hit.r)};
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
