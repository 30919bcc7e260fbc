// Skewed screens: the homography against projectors of our own, which stand askew before a wall, and against
// a solution of its eight equations.

#include "cave/room/skewed_screen.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "cave/room/off_axis.h"
#include "cave/screen/wall_pointer.h"

namespace carom {
namespace {

using Random = std::mt19937_64;
using Corners = std::array<glm::dvec3, 4>;

double uniform(Random& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// A projector: light goes straight from its lens to a plane, so that a straight line of its picture is one
/// on the wall.
struct Lens {
  glm::dvec3 at_m;
  glm::dvec3 right, up, ahead;  ///< of its picture, ahead at the distance at which it is one unit high
  glm::dvec3 onPlane(const glm::dvec2& inWindow, const glm::dvec3& planeAt_m,
                     const glm::dvec3& normal) const {
    const glm::dvec3 ray = ahead + (inWindow.x - 0.5) * right + (inWindow.y - 0.5) * up;
    return at_m + glm::dot(planeAt_m - at_m, normal) / glm::dot(ray, normal) * ray;
  }
};

/// A wall anywhere in the room, with a lens before it that is turned by some degrees.
struct Scene {
  glm::dvec3 normal, planeAt_m;
  Lens lens;
  Corners corners_m;

  explicit Scene(Random& random) {
    const auto turn = [&](double most) {
      return glm::angleAxis(uniform(random, -most, most), glm::dvec3(1, 0, 0)) *
             glm::angleAxis(uniform(random, -most, most), glm::dvec3(0, 1, 0)) *
             glm::angleAxis(uniform(random, -most, most), glm::dvec3(0, 0, 1));
    };
    const glm::dquat room = turn(3.0);
    normal = room * glm::dvec3(0, 0, 1);
    planeAt_m = room * glm::dvec3(0, 1, -1.5);
    const glm::dquat askew = room * turn(0.2);
    lens = {planeAt_m + room * glm::dvec3(0.2, 0.3, 3.0), askew * glm::dvec3(0.8, 0, 0),
            askew * glm::dvec3(0, 0.6, 0), askew * glm::dvec3(0, 0, -1)};
    corners_m = {at({0, 0}), at({1, 0}), at({0, 1}), at({1, 1})};
  }
  glm::dvec3 at(const glm::dvec2& inWindow) const { return lens.onPlane(inWindow, planeAt_m, normal); }
};

glm::dvec2 mapped(const glm::dmat3& homography, const glm::dvec2& place) {
  const glm::dvec3 h = homography * glm::dvec3(place, 1.0);
  return glm::dvec2(h) / h.z;
}

Wall wallOf(const AroundScreen& around) {
  Wall wall;
  wall.lowerLeft_m = around.lowerLeft_m;
  wall.lowerRight_m = around.lowerRight_m;
  wall.upperLeft_m = around.upperLeft_m;
  return wall;
}

// Where the eye should see a point of the room, there the lens throws it: on the eye's line to the point.
TEST(SkewedScreen, ThrowsEveryPointOfTheRoomOntoTheLineOfSight) {
  Random random(1);
  int thrown = 0;
  for (int i = 0; i < 300; ++i) {
    const Scene scene(random);
    const AroundScreen found = around(scene.corners_m);
    ASSERT_EQ(found.fault, "") << "case " << i;
    EXPECT_LT(found.screen.offPlane_m, 1e-12);
    const Wall wall = wallOf(found);
    const glm::dmat3 pictureOf = pictureFromWindow(found.screen);
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 middle_m = scene.at({0.5, 0.5});
      const glm::dvec3 side(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5),
                            uniform(random, -0.5, 0.5));
      const glm::dvec3 eye_m = middle_m + uniform(random, 0.8, 2.0) * scene.normal + side;
      // A point before or behind the wall, on a line of sight through the screen.
      const glm::dvec3 onScreen_m = scene.at({uniform(random, 0, 1), uniform(random, 0, 1)});
      const glm::dvec3 point_m = eye_m + uniform(random, 0.5, 4.0) * (onScreen_m - eye_m);
      const auto clip = clipFromRoom(wall, eye_m);
      ASSERT_TRUE(clip) << "case " << i;
      const glm::dvec4 c = *clip * glm::dvec4(point_m, 1.0);
      const glm::dvec2 inPicture = 0.5 * glm::dvec2(c) / c.w + 0.5;
      const glm::dvec2 inWindow = mapped(glm::inverse(pictureOf), inPicture);
      EXPECT_LT(glm::distance(scene.at(inWindow), onScreen_m), 1e-9) << "case " << i << ", point " << k;
      ++thrown;
    }
  }
  EXPECT_EQ(thrown, 6000);
}

// What the mouse points to in the window is the place on the wall to which the lens throws that pixel.
TEST(SkewedScreen, ThePointerPointsToWhereTheLensThrowsItsPixel) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Scene scene(random);
    const AroundScreen found = around(scene.corners_m);
    Wall wall = wallOf(found);
    wall.skewed = found.screen;
    wall.flip = i % 2 == 0 ? Flip::none : Flip::both;
    const Viewport pane{{40, 20}, {800, 600}};
    const glm::dvec2 pointer_px(uniform(random, 40, 839), uniform(random, 20, 619));
    const auto pointed = pointedIn(wall, pane, pointer_px);
    ASSERT_TRUE(pointed) << "case " << i;
    glm::dvec2 inWindow((pointer_px.x - 40) / 800, 1.0 - (pointer_px.y - 20) / 600);
    if (wall.flip == Flip::both) inWindow = 1.0 - inWindow;
    EXPECT_LT(glm::distance(pointed->onWall_m, scene.at(inWindow)), 1e-9) << "case " << i;
  }
}

/// The homography from its eight linear equations: x (g u + h v + 1) = a u + b v + c, and so for y.
glm::dmat3 solved(const SkewedScreen& screen) {
  const std::array<glm::dvec2, 4> window{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  Eigen::Matrix<double, 8, 8> m;
  Eigen::Matrix<double, 8, 1> right;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 p = window[static_cast<std::size_t>(i)],
                     q = screen.inPicture[static_cast<std::size_t>(i)];
    m.row(2 * i) << p.x, p.y, 1, 0, 0, 0, -q.x * p.x, -q.x * p.y;
    m.row(2 * i + 1) << 0, 0, 0, p.x, p.y, 1, -q.y * p.x, -q.y * p.y;
    right(2 * i) = q.x;
    right(2 * i + 1) = q.y;
  }
  const Eigen::Matrix<double, 8, 1> s = m.fullPivLu().solve(right);
  return {glm::dvec3(s(0), s(3), s(6)), glm::dvec3(s(1), s(4), s(7)), glm::dvec3(s(2), s(5), 1.0)};
}

TEST(SkewedScreen, ItsHomographySolvesTheEquations) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const SkewedScreen screen = around(Scene(random).corners_m).screen;
    const glm::dmat3 found = pictureFromWindow(screen), expected = solved(screen);
    for (int column = 0; column < 3; ++column) {
      EXPECT_LT(glm::distance(found[column], expected[column]), 1e-11) << "case " << i;
    }
  }
}

// What it costs, against counted pixels.
TEST(SkewedScreen, ItsCostIsThatOfItsPixels) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const AroundScreen found = around(Scene(random).corners_m);
    const Wall wall = wallOf(found);
    const glm::ivec2 pixels(400, 300);
    const SkewCost cost = costOf(found.screen, sizeOf_m(wall), pixels);
    const glm::dmat3 windowOf = glm::inverse(pictureFromWindow(found.screen));
    int beside = 0;
    double least = 1e9, most = 0.0;
    for (int y = 0; y < pixels.y; ++y) {
      for (int x = 0; x < pixels.x; ++x) {
        const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) / glm::dvec2(pixels);
        const glm::dvec2 inWindow = mapped(windowOf, place);
        const bool inside = glm::all(glm::greaterThan(inWindow, glm::dvec2(0.0))) &&
                            glm::all(glm::lessThan(inWindow, glm::dvec2(1.0)));
        beside += inside ? 0 : 1;
        if (!inside) continue;
        const double step = 1e-5;
        const glm::dvec2 dx = (mapped(windowOf, place + glm::dvec2(step, 0)) - inWindow) / step;
        const glm::dvec2 dy = (mapped(windowOf, place + glm::dvec2(0, step)) - inWindow) / step;
        const double shown = 1.0 / std::sqrt(dx.x * dy.y - dx.y * dy.x);
        least = std::min(least, shown);
        most = std::max(most, shown);
      }
    }
    EXPECT_NEAR(cost.lost, beside / double(pixels.x * pixels.y), 0.005) << "case " << i;
    EXPECT_NEAR(cost.least, least, 0.01) << "case " << i;
    EXPECT_NEAR(cost.most, most, 0.01) << "case " << i;
    double inset_m = 0.0;
    const std::array<glm::dvec3, 4> rectangle{wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m,
                                              wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m};
    for (std::size_t k = 0; k < 4; ++k) {
      inset_m = std::max(inset_m, glm::distance(rectangle[k], found.screen.corners_m[k]));
    }
    EXPECT_NEAR(cost.inset_m, inset_m, 1e-9) << "case " << i;
  }
}

TEST(SkewedScreen, ARectangleIsItself) {
  const Corners corners_m{{{-1.5, 0, -1}, {1.5, 0, -1}, {-1.5, 2, -1}, {1.5, 2, -1}}};
  const AroundScreen found = around(corners_m);
  EXPECT_EQ(found.fault, "");
  EXPECT_LT(glm::distance(found.lowerLeft_m, corners_m[0]), 1e-12);
  EXPECT_LT(glm::distance(found.upperLeft_m, corners_m[2]), 1e-12);
  const SkewCost cost = costOf(found.screen, {3, 2}, {300, 200});
  EXPECT_NEAR(cost.inset_m, 0.0, 1e-12);
  EXPECT_NEAR(cost.lost, 0.0, 1e-12);
  EXPECT_NEAR(cost.least, 1.0, 1e-12);
  EXPECT_NEAR(cost.most, 1.0, 1e-12);
}

// The plane lies as near to the farthest corner as a plane can: turning or moving it makes that worse.
TEST(SkewedScreen, ItsPlaneIsTheNearestToFourCorners) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Corners corners_m{{{-1.5, 0, 0}, {1.4, 0.1, 0}, {-1.4, 2, 0}, {1.5, 2.1, 0}}};
    for (glm::dvec3& corner : corners_m) corner.z = uniform(random, -0.01, 0.01);
    const AroundScreen found = around(corners_m);
    ASSERT_EQ(found.fault, "");
    const glm::dvec3 normal = normalOf(wallOf(found));
    for (int k = 0; k < 50; ++k) {
      const glm::dvec3 other = glm::normalize(
          normal + 0.01 * glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)));
      double low = 1e9, high = -1e9;  // the best plane of that normal is midway
      for (const glm::dvec3& corner : corners_m) {
        low = std::min(low, glm::dot(corner, other));
        high = std::max(high, glm::dot(corner, other));
      }
      EXPECT_GE(0.5 * (high - low), found.screen.offPlane_m - 1e-12) << "case " << i;
    }
  }
}

TEST(SkewedScreen, CornersThatAreNoScreenAreNamed) {
  const Corners good{{{-1.5, 0, -1}, {1.5, 0, -1}, {-1.5, 2, -1}, {1.5, 2, -1}}};
  const auto fault = [&](std::size_t corner, const glm::dvec3& at_m) {
    Corners corners_m = good;
    corners_m[corner] = at_m;
    return around(corners_m).fault;
  };
  EXPECT_NE(fault(3, {1.5, 2, -0.9}).find("25.0 mm off one plane"), std::string::npos)
      << fault(3, {1.5, 2, -0.9});
  EXPECT_NE(fault(3, good[2]).find("one place"), std::string::npos) << fault(3, good[2]);
  EXPECT_NE(fault(3, {0, 0.5, -1}).find("degrees"), std::string::npos) << fault(3, {0, 0.5, -1});
  Corners crossed = good;
  std::swap(crossed[2], crossed[3]);
  EXPECT_NE(around(crossed).fault, "");
  EXPECT_NE(around(Corners{}).fault.find("span no screen"), std::string::npos);
  const double nan = std::nan("");
  EXPECT_NE(fault(1, {nan, 0, 0}), "");
}

}  // namespace
}  // namespace carom
