#pragma once
// Silhouettes as they are drawn against those of the reference (reference/ray_reference.h), to a pixel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "cave/reference_views.h"
#include "cave/scene/puck_model.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "reference/ray_reference.h"

namespace carom::test {

inline constexpr int kWall_px = 1920;
inline constexpr double kWall_m = 3.0, kWallDistance_m = 1.5;  // a wall of a CAVE from its middle
inline constexpr double kSilhouette_px = 1.0;
// In the middle of a bounce the front of the signal runs across the facets of a puck, and what is bent within
// a facet is drawn straight: off by less than half its largest edge, an eighth of the puck's width.
inline constexpr double kFacetShare = 0.0625;

/// A body of a picture, for the reference.
struct ReferenceBody {
  int number = 0;
  std::vector<reference::Leg> legs;
  std::optional<reference::Shape> shape;  // for ray tracing
  reference::Mesh fine;                   // for halving
  std::vector<Vec3> rim;                  // its outermost points
  bool round = false;                     // the shape stays the same while it turns about z
  std::optional<bool> marked{};           // these of its sectors alone
};

inline ReferenceBody puckBody(int number, const WorldLine& line, double radius_m, double height_m) {
  ReferenceBody body{number,
                     test::referenceLegs(line),
                     reference::puckShape(radius_m, height_m),
                     reference::puckMesh(radius_m, height_m, 4),
                     {},
                     true};
  const reference::Mesh coarse = reference::puckMesh(radius_m, height_m, 1);
  for (std::size_t i = 0; i < coarse.points.size(); i += 2) body.rim.push_back(coarse.points[i]);
  return body;
}

inline ReferenceBody meshBody(int number, const WorldLine& line, vtkPolyData& mesh) {
  constexpr std::size_t kBruteForce = 6000;  // triangles
  ReferenceBody body{number, test::referenceLegs(line), {}, test::referenceMesh(mesh), {}};
  for (std::size_t i = 0; i < body.fine.points.size(); i += 1 + body.fine.points.size() / 300) {
    body.rim.push_back(body.fine.points[i]);
  }
  if (body.fine.triangles.size() > kBruteForce) return body;
  body.shape = reference::meshShape(body.fine);
  body.fine = reference::fourTimesFiner(body.fine);
  return body;
}

/// One body as one eye sees it on one screen.
class ReferenceView {
 public:
  ReferenceView(const ReferenceBody& body, const reference::Eye& eye, const reference::Screen& screen)
      : body_(body), legs_(test::knownTo(eye, body.legs)), eye_(eye), screen_(screen) {
    bool straight = true, turns = false;
    for (const reference::Leg& leg : legs_) {
      straight = straight && leg.brake == 0.0;
      turns = turns || leg.spins();
    }
    const auto common = reference::commonLeg(legs_, body.rim, eye);
    settled_ = common.has_value();
    traced_ = body.shape && settled_ && straight && (body.round || !turns);
    if (settled_ && turns) traceable_ = {legs_[*common]};
    if (!traced_) mesh_.emplace(legs_, body.fine, eye, screen);
    for (const Vec3& d : body.rim) {
      const auto p = screen.pixelOf(eye.seen(reference::PointLine(legs_, d).emission(eye.event)));
      if (!(p.depth > 0.02)) {
        behind_ = true;
        continue;
      }
      left_ = std::min(left_, p.x), right_ = std::max(right_, p.x);
      bottom_ = std::min(bottom_, p.y), top_ = std::max(top_, p.y);
    }
    const double margin_px = 8.0 + 0.05 * std::max(right_ - left_, top_ - bottom_);
    left_ -= margin_px, right_ += margin_px, bottom_ -= margin_px, top_ += margin_px;
  }

  int number() const { return body_.number; }
  bool traced() const { return traced_; }
  bool settled() const { return settled_; }  ///< no point of it is on its way between two legs
  bool behind() const { return behind_; }    ///< some of it is beside or behind the eye
  bool onScreen() const {
    return right_ > 0 && top_ > 0 && left_ < screen_.width && bottom_ < screen_.height;
  }
  bool mayCover(double x, double y) const { return x >= left_ && x <= right_ && y >= bottom_ && y <= top_; }
  std::array<int, 4> box() const {
    const auto within = [](double at, double most) { return static_cast<int>(std::clamp(at, 0.0, most)); };
    return {within(left_, screen_.width), within(right_, screen_.width), within(bottom_, screen_.height),
            within(top_, screen_.height)};
  }

  std::optional<double> depthAt(double x, double y) const {
    if (!mayCover(x, y)) return std::nullopt;
    return traced_ ? tracedDepth(x, y) : mesh_->depthAt(x, y);
  }
  std::optional<double> tracedDepth(double x, double y) const {
    const Vec3 direction = screen_.direction(x, y);
    const auto hit = reference::trace(traceable_.empty() ? legs_ : traceable_, *body_.shape, eye_, direction);
    if (!hit || (body_.marked && reference::isMarked(hit->point) != *body_.marked)) return std::nullopt;
    return screen_.depthAlong(direction, hit->distance);
  }

 private:
  const ReferenceBody& body_;
  std::vector<reference::Leg> legs_;
  std::vector<reference::Leg> traceable_;  // the only leg on which a body that turns is to be traced
  reference::Eye eye_;
  reference::Screen screen_;
  bool traced_ = false, settled_ = false, behind_ = false;
  std::optional<reference::SeenMesh> mesh_;
  double left_ = 1e9, right_ = -1e9, bottom_ = 1e9, top_ = -1e9;
};

/// Would a picture that shows body `number` (0: none) at a place of the screen be right? Pucks in contact lie
/// within each other by fractions of a millimetre until the signal has arrived; which of two is nearer by
/// less than a hundredth of the distance is left to the facets of their rims.
inline bool isRight(const std::vector<ReferenceView>& views, int number, double x, double y) {
  constexpr double kTouching = 1.01;
  double nearest = std::numeric_limits<double>::infinity(), shown = nearest;
  for (const ReferenceView& view : views) {
    const auto depth = view.depthAt(x, y);
    if (!depth) continue;
    nearest = std::min(nearest, *depth);
    if (view.number() == number) shown = *depth;
  }
  return number == 0 ? std::isinf(nearest) : std::isfinite(shown) && shown <= nearest * kTouching;
}

/// How far from (x, y) something first is right, to a twentieth of itself; infinite beyond a hundred pixels.
template <typename IsRight>
inline double distanceTo_px(const IsRight& right, double x, double y) {
  for (double radius = 0.05; radius < 100.0; radius *= 1.05) {
    for (int i = 0; i < 24; ++i) {
      const double angle = i * std::numbers::pi / 12.0;
      if (right(x + radius * std::cos(angle), y + radius * std::sin(angle))) return radius;
    }
  }
  return std::numeric_limits<double>::infinity();
}

struct Comparison {
  double worst_px = 0.0;         ///< farthest that a drawn silhouette lies from the reference's
  double worstTurning_px = 0.0;  ///< the same near bodies in the middle of a bounce
  double turningShare = 0.0;     ///< the same as a share of the body's width
  long lit = 0, checked = 0, differing = 0;
  int bodies = 0, tracedBodies = 0, turningBodies = 0;

  void add(const Comparison& other) {
    worst_px = std::max(worst_px, other.worst_px);
    worstTurning_px = std::max(worstTurning_px, other.worstTurning_px);
    turningShare = std::max(turningShare, other.turningShare);
    lit += other.lit, checked += other.checked, differing += other.differing;
    bodies += other.bodies, tracedBodies += other.tracedBodies, turningBodies += other.turningBodies;
  }
  void print(const char* what) const {
    std::printf(
        "%s: %d silhouettes (%d by rays), %ld pixels lit, %ld checked, %ld differ, the worst by %.2f px; "
        "%d in the middle of a bounce, by %.2f px, %.4f of the width\n",
        what, bodies, tracedBodies, lit, checked, differing, worst_px, turningBodies, worstTurning_px,
        turningShare);
  }
};

/// Is the pixel within two of a silhouette, or one of a grid of 8 by 8?
inline bool worthChecking(const Image& image, int x, int y) {
  if (x % 8 == 0 && y % 8 == 0) return true;
  const int number = test::numberAt(image, x, y);
  for (int dy = -2; dy <= 2; dy += 2) {
    for (int dx = -2; dx <= 2; dx += 2) {
      const int nx = x + dx, ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= image.size_px.x || ny >= image.size_px.y) continue;
      if (test::numberAt(image, nx, ny) != number) return true;
    }
  }
  return false;
}

/// Whether every lit pixel of the picture lies where the reference expects a body at all.
inline long litOutside(const Image& image, const std::vector<ReferenceView>& views, Comparison& comparison) {
  long outside = 0;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      if (test::numberAt(image, x, y) == 0) continue;
      ++comparison.lit;
      const bool expected = std::any_of(views.begin(), views.end(), [&](const ReferenceView& view) {
        return view.mayCover(x + 0.5, y + 0.5);
      });
      outside += expected ? 0 : 1;
    }
  }
  return outside;
}

inline Comparison compare(const Image& image, const std::vector<ReferenceView>& views) {
  Comparison comparison;
  EXPECT_EQ(litOutside(image, views, comparison), 0);
  const auto nearTurning = [&](int x, int y) {
    return std::any_of(views.begin(), views.end(), [&](const ReferenceView& view) {
      return !view.settled() && view.mayCover(x + 0.5, y + 0.5);
    });
  };
  for (const ReferenceView& view : views) {
    if (!view.onScreen()) continue;
    ++comparison.bodies;
    comparison.tracedBodies += view.traced() ? 1 : 0;
    comparison.turningBodies += view.settled() ? 0 : 1;
    const auto [left, end, bottom, top] = view.box();
    for (int y = bottom; y < top; ++y) {
      for (int x = left; x < end; ++x) {
        if (!worthChecking(image, x, y)) continue;
        ++comparison.checked;
        const int number = test::numberAt(image, x, y);
        const auto right = [&](double px, double py) { return isRight(views, number, px, py); };
        if (right(x + 0.5, y + 0.5)) continue;
        ++comparison.differing;
        const double off_px = distanceTo_px(right, x + 0.5, y + 0.5);
        const bool turning = nearTurning(x, y);
        double& worst = turning ? comparison.worstTurning_px : comparison.worst_px;
        worst = std::max(worst, off_px);
        const double share = off_px / std::max(end - left, top - bottom);
        if (turning && off_px > kSilhouette_px)
          comparison.turningShare = std::max(comparison.turningShare, share);
      }
    }
  }
  return comparison;
}

/// The bodies on a wall; none if one of them reaches beside or behind the eye.
inline std::vector<ReferenceView> viewsOn(const Wall& wall, const std::vector<ReferenceBody>& bodies,
                                          const test::Look& look, double c_m_s) {
  const reference::Screen screen = test::screenOf(wall, look.inRoom_m);
  std::vector<ReferenceView> views;
  for (const ReferenceBody& body : bodies) views.emplace_back(body, look.eye(c_m_s), screen);
  const bool behind = std::any_of(views.begin(), views.end(),
                                  [](const ReferenceView& view) { return view.behind() && view.onScreen(); });
  if (behind) views.clear();
  return views;
}

/// The wall of a CAVE that the eye sees a place of a body on.
inline Wall wallTowards(const test::Look& look, const ReferenceBody& body, double c_m_s) {
  const reference::Eye eye = look.eye(c_m_s);
  const auto legs = test::knownTo(eye, body.legs);
  const Vec3 seen = eye.seen(reference::PointLine(legs, Vec3(0.0)).emission(eye.event));
  return test::squareWall(look.inRoom_m, seen, kWallDistance_m, kWall_m, kWall_px);
}

/// An eye near the place where the target is at time `t` (c t) that sees its centre as it is then.
inline test::Look lookAt(const ReferenceBody& target, double t, const Vec3& fromTarget_m, const Vec3& beta,
                         double c_m_s) {
  const Vec3 place_m = reference::PointLine(target.legs, Vec3(0.0)).at(t);
  const Vec3 turn_m = target.legs.size() > 1 ? target.legs[1].turn.r : place_m;
  const Vec3 eye_m = turn_m + fromTarget_m;
  return {{(t + glm::length(eye_m - place_m)) / c_m_s, eye_m}, beta};
}

/// What is looked at, for the reference and as it is drawn.
struct Flyer {
  std::vector<ReferenceBody> bodies;
  Scene scene;
};

/// The mesh that is drawn: the product's, or the reference's own, four times finer.
enum class Drawn { builtIn, fine };

/// Are the outlines of a size that tells something?
inline bool tellingSize(const ReferenceBody& body, const reference::Eye& eye, const reference::Screen& screen,
                        int widest_px) {
  const ReferenceBody outline{body.number, body.legs, {}, {}, body.rim};
  const auto [left, right, bottom, top] = ReferenceView(outline, eye, screen).box();
  const int least = std::min(right - left, top - bottom), most = std::max(right - left, top - bottom);
  return least > 40 && most < widest_px;
}

struct PuckBody {
  ReferenceBody operator()(const WorldLine& line, double radius_m, double height_m) const {
    return puckBody(1, line, radius_m, height_m);
  }
};

/// Looks at random flights until `pictures` of them are large enough to tell something.
template <typename MakeLine, typename MakeFlyer, typename Accept, typename MakeBody = PuckBody>
Comparison compareRandom(Graphics& graphics, std::uint64_t seed, int pictures, MakeLine makeLine,
                         const MakeFlyer& makeFlyer, const Accept& accept, int widest_px = 900,
                         const MakeBody& makeBody = {}) {
  test::Random random(seed);
  Comparison all;
  const std::array<double, 3> observers{0.0, 0.7, 0.95};
  for (int tries = 0, made = 0; made < pictures && tries < 100 * pictures; ++tries) {
    const double radius_m = random.in(0.03, 0.08), height_m = random.in(0.3, 1.0) * radius_m;
    const WorldLine line = makeLine(random, radius_m);
    const ReferenceBody outline = makeBody(line, radius_m, height_m);
    const double beta = observers[static_cast<std::size_t>(made % 3)];
    const double t = kC_m_s * (line.knots().back().turn.t_s + random.in(-0.2, 0.4));
    test::Look look =
        lookAt(outline, t, random.direction() * random.in(0.3, 1.0), random.direction() * beta, kC_m_s);
    const reference::Eye eye = look.eye(kC_m_s);
    if (!accept(outline, eye)) continue;
    const Wall wall = wallTowards(look, outline, kC_m_s);
    if (!tellingSize(outline, eye, test::screenOf(wall, look.inRoom_m), widest_px)) continue;
    const Flyer flyer = makeFlyer(line, radius_m, height_m);
    WallRenderer renderer(graphics, flyer.scene, kC_m_s, 1);
    SCOPED_TRACE(testing::Message() << "try " << tries << " of seed " << seed << ": radius " << radius_m
                                    << " m, speed " << glm::length(outline.legs.back().v)
                                    << " c, observer at " << beta << " c");
    const auto views = viewsOn(wall, flyer.bodies, look, kC_m_s);
    if (views.empty()) continue;
    const Comparison picture = compare(test::drawn(graphics, renderer, {&line, 1}, look, wall), views);
    EXPECT_GT(picture.lit, 0);
    EXPECT_LT(std::max(picture.worst_px, picture.worstTurning_px), kSilhouette_px);
    all.add(picture);
    ++made;
  }
  return all;
}

inline bool inABounce(const ReferenceBody& body, const reference::Eye& eye) {
  const auto legs = test::knownTo(eye, body.legs);
  return legs.size() > 1 && !reference::commonLeg(legs, body.rim, eye);
}

}  // namespace carom::test
