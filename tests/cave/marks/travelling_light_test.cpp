// The light of strokes and the news of hits: where they are in the picture, by other equations than the
// code's, for an eye at rest and one at 0.6 c, to half a pixel.
#include "cave/marks/travelling_light.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/graphics.h"
#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/room/off_axis.h"
#include "engine/billiard/billiard.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42, kHalfPixel = 0.5;
const glm::ivec2 kPicture_px{960, 960};

ObserverView observerAt(const Event& head, const Vec3& beta) {
  const EyeView eye{head, Vec3(0.0), Vec3(0.0)};
  return {Lorentz::boost(uFromBeta(beta), kC_m_s).inverse(), eye, eye, eye, 0.0};
}

/// A stroke from a hand to a puck that rests, as the game makes it.
GameEvent strokeFrom(const Event& hand, const Vec3& puck_m) {
  GameEvent event;
  event.kind = EventKind::stroke;
  event.at = hand;
  Turn turn;
  turn.event = {hand.t_s + glm::distance(hand.r_m, puck_m) / kC_m_s, puck_m};
  event.turns.push_back(turn);
  return event;
}

/// The direction in which an eye that moves with β sees light that comes from `from` on the board:
/// cos θ' = (cos θ + β)/(1 + β cos θ), with θ between the motion and the way to the light.
Vec3 aberrated(const Vec3& from, const Vec3& beta) {
  const Vec3 way = glm::normalize(from);
  const double speed = glm::length(beta);
  if (speed == 0.0) return way;
  const Vec3 ahead = beta / speed;
  const double cosine = glm::dot(way, ahead), sine = glm::length(way - cosine * ahead);
  const Vec3 across = sine > 0.0 ? (way - cosine * ahead) / sine : Vec3(0.0);
  const double seen = (cosine + speed) / (1.0 + speed * cosine);
  return seen * ahead + std::sqrt(1.0 - seen * seen) * across;
}

glm::dvec2 pixelOf(const Wall& wall, const Vec3& direction) {
  const glm::dvec4 at = *clipFromEye(wall, Vec3(0.0)) * glm::dvec4(direction, 1.0);
  return 0.5 * (glm::dvec2(at) / at.w + 1.0) * glm::dvec2(wall.pixels);
}

/// The middle of what is lit, weighted by light.
glm::dvec2 middleOf(const Image& image) {
  glm::dvec2 sum(0.0);
  double all = 0.0;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(y) * image.size_px.x + static_cast<std::size_t>(x));
      const double light = std::pow(image.rgb[at] / 255.0, 4.0);
      sum += light * glm::dvec2(x + 0.5, y + 0.5);
      all += light;
    }
  }
  return sum / all;
}

class TravellingLight : public testing::Test {
 protected:
  MarkContext sightOf(const ObserverView& observer, std::span<const GameEvent> events) const {
    return {observer, observer.middle, {}, {}, 0, {}, {}, events, {}};
  }
  Image draw(const MarkBuffer& batch, const Wall& wall) {
    graphics_.makeCurrent();
    MarkDrawer drawer;
    drawer.upload(batch);
    RenderTarget picture(wall.pixels);
    picture.clear();
    {
      const GlStateGuard state(picture.framebuffer(), picture.size_px());
      blendOver();
      drawer.draw(glm::mat4(*clipFromEye(wall, Vec3(0.0))));
    }
    return readBack(picture);
  }
  Graphics graphics_;
};

// Of the pulse alone: its glow, without the tail and the ring.
MarkBuffer onlyGlows(const MarkBuffer& batch) {
  MarkBuffer glows;
  const auto corners = batch.corners();
  for (std::size_t i = 0; i + 5 < corners.size(); i += 6) {
    if (corners[i].style > -0.5F) continue;
    const glm::dvec3 middle_m = 0.5 * (glm::dvec3(corners[i].drawn_m) + glm::dvec3(corners[i + 5].drawn_m));
    const double radius_m = 0.5 * glm::distance(corners[i].drawn_m, corners[i + 1].drawn_m);
    glows.addGlow(middle_m, radius_m, corners[i].colour);
  }
  return glows;
}

TEST_F(TravellingLight, ThePulsesStandInThePictureWhereLightIs) {
  test::Random random(351);
  for (const double speed : {0.0, 0.6}) {
    for (int i = 0; i < 12; ++i) {
      CASE(random, i);
      const Vec3 beta = speed * glm::normalize(Vec3(random.in(-1, 1), random.in(-1, 1), 0.0));
      const GameEvent stroke = strokeFrom({1.0, {random.in(-0.3, 0.3), -1.5, 0.4}},
                                          {random.in(-1.0, 1.0), random.in(0.0, 0.6), 0.02});
      const Event& struck = stroke.turns.front().event;
      const Vec3 eye_m(random.in(-0.4, 0.4), -2.2, 0.9);
      const bool isBack = i % 2 == 1;
      const double way_s = struck.t_s - stroke.at.t_s;
      const double now_s =
          isBack ? struck.t_s + random.in(0.05, 0.4) : stroke.at.t_s + random.in(0.2, 0.9) * way_s;
      const ObserverView observer = observerAt({now_s, eye_m}, beta);
      // Out: a share of the way that is the share of the time. Back: towards where the head will be, which is
      // found by steps of the head's own way.
      Vec3 place_m = glm::mix(stroke.at.r_m, struck.r_m, (now_s - stroke.at.t_s) / way_s);
      if (isBack) {
        double meets_s = now_s;
        for (int step = 0; step < 400; ++step)
          meets_s =
              struck.t_s + glm::distance(eye_m + kC_m_s * beta * (meets_s - now_s), struck.r_m) / kC_m_s;
        const Vec3 head_m = eye_m + kC_m_s * beta * (meets_s - now_s);
        place_m = glm::mix(struck.r_m, head_m, (now_s - struck.t_s) / (meets_s - struck.t_s));
      }
      const Vec3 seen = aberrated(place_m - eye_m, beta);
      const Wall wall = test::wallTowards({0, 0, 0}, seen + Vec3(0.1, 0.0, -0.05), kPicture_px);
      MarkBuffer batch;
      addStrokes(sightOf(observer, {&stroke, 1}), batch);
      ASSERT_FALSE(batch.corners().empty());
      const glm::dvec2 expected = pixelOf(wall, seen), drawn = middleOf(draw(onlyGlows(batch), wall));
      EXPECT_LT(glm::distance(drawn, expected), kHalfPixel)
          << (isBack ? "back" : "out") << " at " << speed << " c: " << drawn.x << ' ' << drawn.y
          << ", expected " << expected.x << ' ' << expected.y;
    }
  }
}

// The way back is one ray of light: for whoever moves evenly its direction stays, and it ends at the head in
// the frame in which the struck puck is first seen to move.
TEST_F(TravellingLight, ThePaleOneReachesTheHeadInTheFrameInWhichThePuckIsSeenToMove) {
  test::Random random(352);
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const Vec3 beta = i % 3 == 0 ? Vec3(0.0) : random.direction() * 0.6;
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    Puck puck;
    puck.name = "white";
    puck.radius_m = 0.05, puck.height_m = 0.03, puck.mass_kg = 0.2;
    puck.position_m = {random.in(-1.0, 1.0), random.in(-0.5, 0.5)};
    setup.pucks.push_back(puck);
    Billiard game(setup);
    const Vec3 hand_m(random.in(-1, 1), -1.4, 0.4);
    const double arrives_s = game.strike({0, 0.5, hand_m, {0.2, 0.1}, 0.0});
    const std::vector<GameEvent> events = game.takeChanges().events;
    ASSERT_EQ(events.size(), 1u) << "a stroke is known as soon as it is made";
    ASSERT_EQ(events[0].turns.front().event.t_s, arrives_s);
    Vec3 along(0.0);
    bool wasUnderWay = false, ended = false;
    for (double t_s = 0.51; !ended; t_s += 1.0 / 60.0) {
      ASSERT_LT(t_s, 40.0);
      const Event eye{t_s, Vec3(0.2, -2.0, 0.8) + kC_m_s * beta * (t_s - 1.0)};
      const ObserverView observer = observerAt(eye, beta);
      game.advanceTo(t_s);
      const auto light = strokeLight(events[0], observer);
      const auto seen = emission(game.worldLines()[0], Vec3(0.0), eye, observer.headFromBoard);
      const bool moves = seen->u != Vec3(0.0);
      ASSERT_NE(light.has_value(), moves) << "at " << t_s;
      if (!light) {
        ended = true;
      } else if (light->isBack) {
        if (wasUnderWay) {
          ASSERT_LT(glm::distance(light->along, along), 1e-9) << "it is one ray";
        }
        wasUnderWay = true;
        along = light->along;
      }
    }
    ASSERT_TRUE(wasUnderWay);
  }
}

// The rings: each corner comes from a place on the cloth so far from the hit as light has gone, to the ring's
// half width and half a pixel. The way from the picture back to the board is that of aberration for −β.
TEST_F(TravellingLight, RingsOfNewsLieWhereTheNewsIs) {
  test::Random random(353);
  const std::vector<glm::vec3> colours{{0, 0, 0}, {0.8F, 0.1F, 0.1F}, {0.1F, 0.2F, 0.9F}};
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const Vec3 beta =
        i % 2 == 0 ? Vec3(0.0) : 0.6 * glm::normalize(Vec3(random.in(-1, 1), random.in(-1, 1), 0.0));
    GameEvent hit;
    hit.kind = EventKind::puckPuck;
    hit.at = {1.0, {random.in(-1, 1), random.in(-0.6, 0.6), 0.02}};
    hit.turns.push_back({0, hit.at});
    hit.turns.push_back({1, hit.at});
    const double gone_s = random.in(0.1, 1.8);
    const Event eye{1.0 + gone_s, {random.in(-0.5, 0.5), -2.0, 0.9}};
    const ObserverView observer = observerAt(eye, beta);
    MarkBuffer batch;
    addNews(sightOf(observer, {&hit, 1}), colours, batch);
    ASSERT_EQ(batch.corners().size(), 2u * kAround * 6u);
    const double radius_m = std::sqrt(std::pow(kC_m_s * gone_s, 2) - std::pow(0.02 - kOnCloth_m, 2));
    std::size_t inside = 0, outside = 0;
    for (const MarkCorner& corner : batch.corners()) {
      const Vec3 way = aberrated(Vec3(corner.drawn_m), -beta);
      const Vec3 place_m = eye.r_m + way * ((kOnCloth_m - eye.r_m.z) / way.z);
      const double off_m = glm::distance(glm::dvec2(place_m), glm::dvec2(hit.at.r_m)) - radius_m;
      const bool isFirst = corner.colour.r > corner.colour.b;
      ASSERT_LT(std::abs(off_m - (isFirst ? -0.5 : 0.5) * kNewsHalfWidth_m), 0.5 * kNewsHalfWidth_m + 2e-5)
          << "as thick as it is, with single precision";
      (isFirst ? inside : outside) += 1;
    }
    EXPECT_EQ(inside, outside);
  }
}

TEST_F(TravellingLight, NewsOfAHitWithoutDelayBeginsAtTheTurnsAndNothingBeforeIt) {
  const std::vector<glm::vec3> colours(3, glm::vec3(0.5F));
  GameEvent hit;
  hit.kind = EventKind::puckCushion;
  hit.withoutDelay = true;
  hit.at = {5.0, {0.0, 0.0, 0.02}};
  Turn turn;
  turn.event = {1.0, {0.4, 0.0, 0.02}};
  hit.turns.push_back(turn);
  const auto cornersAt = [&](double t_s) {
    const ObserverView observer = observerAt({t_s, {0.0, -2.0, 0.9}}, Vec3(0.0));
    MarkBuffer batch;
    addNews(sightOf(observer, {&hit, 1}), colours, batch);
    return batch.corners().size();
  };
  EXPECT_EQ(cornersAt(0.9), 0u);
  EXPECT_GT(cornersAt(1.1), 0u);
  EXPECT_GT(cornersAt(1.0 + kNews_m / kC_m_s - 0.1), 0u);
  EXPECT_EQ(cornersAt(1.0 + kNews_m / kC_m_s + 0.1), 0u);
}

TEST_F(TravellingLight, AStrokeFromNoPlaceHasOnlyTheWayBack) {
  GameEvent stroke = strokeFrom({1.0, {0.3, 0.2, 0.02}}, {0.3, 0.2, 0.02});
  EXPECT_FALSE(strokeLight(stroke, observerAt({0.9, {0.0, -2.0, 1.0}}, Vec3(0.0))));
  const auto light = strokeLight(stroke, observerAt({1.5, {0.0, -2.0, 1.0}}, Vec3(0.0)));
  ASSERT_TRUE(light);
  EXPECT_TRUE(light->isBack);
  EXPECT_FALSE(isStrokeUnderWay({&stroke, 1}, observerAt({9.0, {0.0, -2.0, 1.0}}, Vec3(0.0))));
}

}  // namespace
}  // namespace carom
