#include "engine/polygons/moving_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

const std::vector<Vec2> kBar{{-0.06, -0.01}, {0.06, -0.01}, {0.06, 0.01}, {-0.06, 0.01}};

TEST(MovingShape, TheEqualSpeedFrameSeesEqualSpeeds) {
  test::Random random(81);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const Vec21 one = fourVelocity(random.in(-3.0, 3.0), random.in(-3.0, 3.0));
    const Vec21 two = fourVelocity(random.in(-3.0, 3.0), random.in(-3.0, 3.0));
    const Vec21 U = equalSpeedFrame(one, two);
    EXPECT_NEAR(dot(U, U), 1.0, 1e-12);
    EXPECT_NEAR(dot(U, one), dot(U, two), 1e-12 * dot(one, two));
  }
}

// Without spin a body is contracted along its motion by 1/γ, and follows its centre.
TEST(MovingShape, CornersAreContractedAlongTheMotion) {
  const Outline bar(kBar);
  for (const double beta : {0.0, 0.5, 0.9, 0.99}) {
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    const MovingShape flight{{1.0, 0.2, 0.3}, {gamma, gamma * beta, 0.0}, bar.radius(), &bar, 0.0, 0.0};
    const std::vector<Vec2> corners = cornersOnBoard(flight, 3.0);
    ASSERT_EQ(corners.size(), kBar.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      EXPECT_NEAR(corners[k].x, 0.2 + beta * 2.0 + kBar[k].x / gamma, 1e-14) << beta;
      EXPECT_NEAR(corners[k].y, 0.3 + kBar[k].y, 1e-14) << beta;
    }
  }
}

// The corner of a body at rest that turns is where a circle has it.
TEST(MovingShape, CornersOfABodyThatTurnsGoRoundTheCentre) {
  const Outline bar(kBar);
  const MovingShape flight{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, bar.radius(), &bar, 0.4, 7.0};
  for (const double t : {0.0, 0.1, 0.5, 2.0}) {
    const double angle = 0.4 + 7.0 * t;
    const std::vector<Vec2> corners = cornersOnBoard(flight, t);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      EXPECT_NEAR(corners[k].x, std::cos(angle) * kBar[k].x - std::sin(angle) * kBar[k].y, 1e-13);
      EXPECT_NEAR(corners[k].y, std::sin(angle) * kBar[k].x + std::cos(angle) * kBar[k].y, 1e-13);
    }
  }
}

bool isInside(const Vec2& point, const std::vector<Vec2>& convex) {
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const Vec2 side = convex[(k + 1) % convex.size()] - convex[k], way = point - convex[k];
    if (side.x * way.y - side.y * way.x < 0.0) return false;
  }
  return true;
}

// Beside a grid of points: those of one shape that are in the other.
TEST(MovingShape, OverlapIsThatOfPoints) {
  test::Random random(82);
  const Outline bar(kBar);
  int overlapping = 0, apart = 0;
  for (int i = 0; i < 400; ++i) {
    CASE(random, i);
    const auto shape = [&](bool isDisc) {
      const Vec21 u = fourVelocity(random.in(-1.0, 1.0), random.in(-1.0, 1.0));
      return MovingShape{{0.0, random.in(-0.06, 0.06), random.in(-0.06, 0.06)},
                         u,
                         isDisc ? 0.03 : bar.radius(),
                         isDisc ? nullptr : &bar,
                         random.in(-3.0, 3.0),
                         isDisc ? 0.0 : random.in(-5.0, 5.0)};
    };
    const bool withDisc = random.in(0.0, 1.0) < 0.5;
    const MovingShape one = shape(false), other = shape(withDisc);
    const std::vector<Vec2> corners = cornersOnBoard(one, 0.0);
    int common = 0;
    constexpr int kPoints = 120;
    for (int a = 0; a < kPoints; ++a) {
      for (int b = 0; b < kPoints; ++b) {
        const Vec2 point{-0.13 + 0.26 * a / kPoints, -0.13 + 0.26 * b / kPoints};
        if (!isInside(point, corners)) continue;
        if (withDisc) {
          // The disc is contracted along its motion.
          const Vec2 way = point - Vec2{other.start.x, other.start.y}, u{other.u.x, other.u.y};
          const double along = glm::dot(way, u) / glm::length(u),
                       across2 = glm::dot(way, way) - along * along;
          common += along * along * other.u.t * other.u.t + across2 < other.radius * other.radius;
        } else {
          common += isInside(point, cornersOnBoard(other, 0.0));
        }
      }
    }
    const bool overlap = overlapOnBoard(one, other, 0.0);
    if (common > 0) {
      EXPECT_TRUE(overlap);
    }
    if (!overlap) {
      EXPECT_EQ(common, 0);
    }
    overlapping += common > 0;
    apart += !overlap;
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(apart, 20);
}

}  // namespace
}  // namespace carom
