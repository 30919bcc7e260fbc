// The bright line on the tubes of spacetime, found in the picture itself, against the seen top rim of the
// puck: events of whole histories on the eye's past cone, boosted and put into the room without the drawing's
// code.

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cave/frame/bodies.h"
#include "cave/gl/graphics.h"
#include "cave/pictures/image.h"
#include "cave/room/off_axis.h"
#include "cave/sculpted_game.h"
#include "cave/sculpture/room_sculpture.h"
#include "engine/billiard/billiard.h"
#include "engine/light/vertex_history.h"
#include "engine/random_game.h"
#include "engine/random_world.h"
#include "engine/sculpture/world_tube.h"

namespace carom {
namespace {

constexpr int kPicture_px = 800;
constexpr double kHalfField = 0.20;  // tangent of half the field of view: a pixel is half a milliradian
constexpr double kNearest_m = 0.25;  // an eye cannot see sharply what is nearer
constexpr double kAlong_px = 7.0;    // how far beside the expected place the line is looked for

/// A picture taken from `from_m` towards `to_m`.
struct Camera {
  Vec3 from_m{0.0};
  Wall wall;
  glm::dmat4 clipFromEye{1.0};

  Camera(const Vec3& from, const Vec3& to) : from_m(from) {
    const Vec3 ahead = glm::normalize(to - from);
    const Vec3 right = glm::normalize(glm::cross(ahead, Vec3(0.0, 0.0, 1.0))), up = glm::cross(right, ahead);
    wall.lowerLeft_m = ahead - kHalfField * (right + up);
    wall.lowerRight_m = ahead + kHalfField * (right - up);
    wall.upperLeft_m = ahead - kHalfField * (right - up);
    wall.pixels = {kPicture_px, kPicture_px};
    clipFromEye = carom::clipFromEye(wall, Vec3(0.0)).value();
  }
  /// Returns the pixel, from the lower left corner.
  glm::dvec2 operator()(const Vec3& room_m) const {
    const glm::dvec4 clip = clipFromEye * glm::dvec4(room_m - from_m, 1.0);
    return 0.5 * kPicture_px * (glm::dvec2(clip) / clip.w + 1.0);
  }
};

/// How white the picture is at a place, 0 to 1, interpolated between the middles of pixels.
double whiteAt(const Image& image, const glm::dvec2& at) {
  const auto white = [&](int x, int y) {
    const std::size_t pixel = 3 * static_cast<std::size_t>(y * image.size_px.x + x);
    return std::min({image.rgb[pixel], image.rgb[pixel + 1], image.rgb[pixel + 2]}) / 255.0;
  };
  const glm::dvec2 from = glm::floor(at - 0.5), share = at - 0.5 - from;
  const int x = static_cast<int>(from.x), y = static_cast<int>(from.y);
  return (white(x, y) * (1.0 - share.x) + white(x + 1, y) * share.x) * (1.0 - share.y) +
         (white(x, y + 1) * (1.0 - share.x) + white(x + 1, y + 1) * share.x) * share.y;
}

/// Returns how far beside a place a bright line runs along `way`, pixels; none where no white one is alone
/// there.
std::optional<double> lineBeside_px(const Image& image, const glm::dvec2& at, const glm::dvec2& way) {
  const glm::dvec2 aside = glm::normalize(glm::dvec2(-way.y, way.x));
  double first = std::numeric_limits<double>::infinity(), last = -first;
  constexpr double kStep_px = 0.05, kWhite = 0.93;
  for (double off = -kAlong_px; off <= kAlong_px; off += kStep_px) {
    if (whiteAt(image, at + aside * off) < kWhite) continue;
    first = std::min(first, off), last = off;
  }
  // A line is as wide as it is drawn, half an angle of 0.0018.
  const double width_px = 2.0 * 0.0018 * 0.5 * kPicture_px / kHalfField;
  if (!(last - first > 0.3 * width_px && last - first < 1.6 * width_px)) return {};
  return 0.5 * (first + last);
}

struct Found {
  int expected = 0, found = 0;
  double most_px = 0.0;
};

class SculpturePicture : public testing::Test {
 protected:
  void SetUp() override { graphics_.makeCurrent(); }

  /// Compares the bright line of one puck with its seen rim.
  void compare(const BilliardSetup& setup, const World& world, const FrameRecord& record, std::size_t puck,
               Found& found) {
    const ObserverView& observer = record.viewers[0].observer;
    const Event& eye = observer.middle.observation;
    const SculpturePlace& place = record.sculpture.place;
    const double c_m_s = setup.lightSpeed_m_s, present_m = c_m_s * place.past_s;
    const Lorentz shownFromBoard = Lorentz::boost(uFromBeta(place.beta), c_m_s).inverse();
    std::vector<Vec3> rim_m;  // in the room
    for (const Vec2& point_m : rimOf(setup.pucks[puck])) {
      const auto history =
          vertexHistory(world.histories[kFirstPuck + puck], Vec3(point_m, 0.5 * setup.pucks[puck].height_m));
      const Displacement since = shownFromBoard * (eventOnPastCone(history, eye, c_m_s) - eye);
      const Vec3 model_m(eye.r_m.x + since.dr_m.x, eye.r_m.y + since.dr_m.y, present_m + c_m_s * since.dt_s);
      if (model_m.z < 0.02 * present_m) return;  // it is cut off at the foot
      rim_m.push_back(place.roomFromFoot * (place.scale * model_m));
    }
    Vec3 middle_m(0.0);
    for (const Vec3& point_m : rim_m) middle_m += point_m / static_cast<double>(rim_m.size());
    double size_m = 0.0;
    for (const Vec3& point_m : rim_m) size_m = std::max(size_m, glm::distance(point_m, middle_m));
    const double away_m = std::max(kNearest_m, size_m / (0.45 * kHalfField));
    // Looking down on the line, not quite at a right angle to it.
    Vec3 normal(0.0);
    for (std::size_t i = 0; i < rim_m.size(); ++i)
      normal += glm::cross(rim_m[i] - middle_m, rim_m[(i + 1) % rim_m.size()] - middle_m);
    const Vec3 down = glm::normalize(glm::normalize(normal) + Vec3(0.25, -0.35, 0.0));
    const Camera camera(middle_m + away_m * down, middle_m);
    // This puck alone, so that no other's line is near.
    SculptedGame alone = game_;
    alone.bodies = {game_.bodies[puck]};
    const Image image = draw(alone, world, record, camera, 0.0F);
    for (std::size_t i = 0; i < rim_m.size(); ++i) {
      const glm::dvec2 at = camera(rim_m[i]);
      const glm::dvec2 before = camera(rim_m[(i + rim_m.size() - 1) % rim_m.size()]),
                       after = camera(rim_m[(i + 1) % rim_m.size()]);
      // At a corner the line has no one direction, and seen along itself it is no line.
      const glm::dvec2 in = at - before, out = after - at;
      if (glm::length(in) < 3.0 || glm::length(out) < 3.0) continue;
      if (glm::dot(glm::normalize(in), glm::normalize(out)) < 0.97) continue;
      // Another part of the line that is so near looks like one with it.
      const auto isNear = [&](std::size_t k) {
        const std::size_t apart =
            std::min((i + rim_m.size() - k) % rim_m.size(), (k + rim_m.size() - i) % rim_m.size());
        return glm::distance(camera(rim_m[k]), at) < (apart > 3 ? 2.0 * kAlong_px : 0.0);
      };
      bool isAlone = true;
      for (std::size_t k = 0; k < rim_m.size(); ++k) isAlone = isAlone && !isNear(k);
      if (!isAlone) continue;
      ++found.expected;
      // The mean of several places around the point, as borders of lines are rough to a pixel.
      double sum_px = 0.0;
      int places = 0;
      for (int step = -4; step <= 4; ++step) {
        const glm::dvec2 near = at + (step < 0 ? in : out) * (0.2 * step);
        const std::optional<double> off_px = lineBeside_px(image, near,
                                                           step < 0   ? in
                                                           : step > 0 ? out
                                                                      : after - before);
        if (off_px) sum_px += *off_px, ++places;
      }
      if (places < 6) continue;
      const double off_px = sum_px / places;
      ++found.found;
      found.most_px = std::max(found.most_px, std::abs(off_px));
      ASSERT_LT(std::abs(off_px), 0.5) << "puck " << puck << ", point " << i << " at " << at.x << ' ' << at.y;
    }
  }

  static Image draw(const SculptedGame& game, const World& world, const FrameRecord& record,
                    const Camera& camera, float background) {
    RoomSculpture sculpture(game);
    sculpture.look(record, world, {}, camera.from_m, 0, {});
    RenderTarget picture(camera.wall.pixels);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
    glClearColor(background, background, background, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    sculpture.draw(glm::mat4(camera.clipFromEye), picture.framebuffer(), picture.size_px());
    return readBack(picture);
  }

  Graphics graphics_;
  SculptedGame game_;
};

TEST_F(SculpturePicture, TheBrightLineIsWhereTheSeenRimIs) {
  Found found;
  int games = 0, fast = 0;
  for (std::uint64_t seed = 1; games < 10; ++seed) {
    const test::RandomGame game = test::randomGame(seed, {.events = 60, .packed = 8});
    const BilliardSetup& setup = game.setup;
    if (setup.pucks.size() > 12 || game.until_s > 60.0) continue;
    ++games;
    SCOPED_TRACE(testing::Message() << "game " << seed << ", " << game.kind);
    const double now_s = std::min(game.until_s, 6.0);
    Billiard billiard(setup);
    billiard.advanceTo(now_s);
    World world;
    world.histories.push_back(restingWorldLine(setup.lightSpeed_m_s));
    for (const WorldLine& line : billiard.worldLines()) world.histories.push_back(line);
    game_ = test::sculptedOf(setup, glm::vec3(0.0F));
    test::Random random(seed);
    FrameRecord record;
    record.pucks = setup.pucks.size();
    record.views.spacetime = 1;
    ObserverView& observer = record.viewers[0].observer;
    observer.headFromBoard = Lorentz::boost(random.u(0.9), setup.lightSpeed_m_s);
    observer.middle.observation = {now_s, {random.in(-1.0, 1.0), random.in(-1.0, 1.0), 0.8}};
    const double beta = games % 2 == 0 ? random.in(0.0, 0.8) : 0.0, angle = random.in(0.0, 6.3);
    record.sculpture.place = {{{1.0, 2.0, 0.0}, glm::angleAxis(0.4, Vec3(0.0, 0.0, 1.0))},
                              2.2,
                              0.25,
                              5.0,
                              {beta * std::cos(angle), beta * std::sin(angle), 0.0}};
    record.sculpture.place.past_s = 0.8 * 2.2 / (0.25 * setup.lightSpeed_m_s);
    for (std::size_t puck = 0; puck < std::min<std::size_t>(setup.pucks.size(), 4); ++puck) {
      const int before = found.expected;
      ASSERT_NO_FATAL_FAILURE(compare(setup, world, record, puck, found));
      const Knots knots = world.histories[kFirstPuck + puck].knots();
      fast += found.expected > before && glm::length(betaFromU(knots[0].u)) > 0.3 ? 1 : 0;
    }
  }
  RecordProperty("points", found.found);
  EXPECT_GT(found.expected, 200);
  EXPECT_GT(found.found, 0.9 * found.expected) << "of " << found.expected;
  EXPECT_GT(fast, 2);
  std::printf("%d points of %d found, %.2f px at most\n", found.found, found.expected, found.most_px);
}

// A resting red puck's shadow runs from its foot over the floor, along the same way of the room however the
// sculpture is turned: red light passes, the other colours are taken.
TEST_F(SculpturePicture, ItsShadowLiesOnTheFloor) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.pucks.push_back({"red", 0.06, 0.03, 0.2, Vec2(0.0), Vec2(0.0)});
  Billiard billiard(setup);
  World world;
  world.histories = {restingWorldLine(setup.lightSpeed_m_s), billiard.worldLines()[0]};
  FrameRecord record;
  record.pucks = 1;
  record.views.spacetime = 1;
  ObserverView& observer = record.viewers[0].observer;
  observer.headFromBoard = Lorentz(setup.lightSpeed_m_s);
  observer.middle.observation = {0.0, {0.0, -1.6, 0.8}};
  const SculptedGame game = test::sculptedOf(setup, glm::vec3(1.0F, 0.0F, 0.0F));
  for (const double turn : {0.0, 1.2, 3.0}) {
    SCOPED_TRACE(turn);
    const Vec3 foot(1.0, 2.0, 0.0);
    record.sculpture.place = {{foot, glm::angleAxis(turn, Vec3(0.0, 0.0, 1.0))}, 2.2, 0.25, 5.0, Vec3(0.0)};
    // What is half a metre high has its shadow 0.11 m to the left and 0.025 m behind.
    const Vec3 shadow = foot - 0.5 * Vec3(0.22, 0.05, 0.0), lit = foot + 0.5 * Vec3(0.22, 0.05, 0.0);
    const Camera camera(foot + Vec3(-0.5, -1.5, 1.2), foot);
    const Image image = draw(game, world, record, camera, 0.8F);
    const auto at = [&](const Vec3& room_m, int colour) {
      const glm::ivec2 pixel(camera(room_m));
      return int{image.rgb[3 * static_cast<std::size_t>(pixel.y * image.size_px.x + pixel.x) +
                           static_cast<std::size_t>(colour)]};
    };
    EXPECT_LT(at(shadow, 1), 0.75 * 204) << "green is taken";
    EXPECT_GT(at(shadow, 0), at(shadow, 1) + 10) << "red passes rather";
    EXPECT_NEAR(at(lit, 1), 204, 3) << "no shadow on the other side";
  }
}

}  // namespace
}  // namespace carom
