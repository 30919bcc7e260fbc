// The order in which corners were touched, found again from random ones.
#include "app/calibration/corner_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>
#include <vector>

#include "engine/base/pose.h"

namespace carom {
namespace {

const Pose kRoomFromTracker{{0.3, 2.1, -0.4}, {0.6, 0.0, 0.8, 0.0}};

/// The touches of a tracker elsewhere, of which touch i was of corner `order[i]`.
std::vector<PointPair> touched(const std::vector<glm::dvec3>& corners_m,
                               const std::vector<std::size_t>& order) {
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < corners_m.size(); ++i)
    pairs.push_back({corners_m[i], inverse(kRoomFromTracker) * corners_m[order[i]]});
  return pairs;
}

std::vector<std::size_t> asAsked(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

TEST(CornerOrder, FindsAnyOrderOfCornersThatAreNowhereAlike) {
  constexpr std::size_t kCorners = 8;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto in = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    std::vector<glm::dvec3> corners_m;
    while (corners_m.size() < kCorners) {
      const double x = in(-3, 3), y = in(0, 3), z = in(-3, 3);
      const glm::dvec3 at_m(x, y, z);
      const bool isNear = std::any_of(corners_m.begin(), corners_m.end(), [&](const glm::dvec3& other_m) {
        return glm::distance(other_m, at_m) < 0.8;
      });
      if (!isNear) corners_m.push_back(at_m);
    }
    std::vector<std::size_t> order = asAsked(kCorners);
    for (std::size_t i = kCorners - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
    std::vector<PointPair> pairs = touched(corners_m, order);
    for (PointPair& pair : pairs) {
      const double x = in(-1, 1), y = in(-1, 1), z = in(-1, 1);
      pair.inB_m += 0.003 * glm::dvec3(x, y, z);
    }
    const CornerOrder found = likeliestOrder(pairs);
    EXPECT_EQ(found.corner, order);
    EXPECT_LT(found.largest_m, 0.01);
  }
}

// A box looks the same when it is turned half round: the order that was asked for fits, and so do others.
TEST(CornerOrder, OfEqualWallsTheFewestTouchesAreMoved) {
  std::vector<glm::dvec3> box_m;
  for (int i = 0; i < 8; ++i) box_m.push_back({i & 1 ? 1.5 : -1.5, i & 2 ? 2.4 : 0.0, i & 4 ? 1.0 : -1.0});
  EXPECT_EQ(likeliestOrder(touched(box_m, asAsked(8))).corner, asAsked(8));
  std::vector<std::size_t> swapped = asAsked(8);
  std::swap(swapped[1], swapped[6]);
  EXPECT_EQ(likeliestOrder(touched(box_m, swapped)).corner, swapped);
}

TEST(CornerOrder, FindsNoneWhereNoneFits) {
  std::vector<glm::dvec3> corners_m{
      {-1.5, 0, -1}, {1.5, 0, -1}, {-1.5, 2.4, -1}, {-1.5, 0, 0.7}, {1.5, 2.4, 0}};
  std::vector<PointPair> pairs = touched(corners_m, asAsked(5));
  EXPECT_FALSE(likeliestOrder(pairs).corner.empty());
  pairs[4].inB_m += glm::dvec3(0.0, 0.3, 0.0);
  EXPECT_TRUE(likeliestOrder(pairs).corner.empty());
  EXPECT_FALSE(likeliestOrder(pairs, 0.5).corner.empty()) << "it may miss by as much";
  EXPECT_TRUE(likeliestOrder(std::vector<PointPair>(pairs.begin(), pairs.begin() + 2)).corner.empty())
      << "two touches have no order";
}

}  // namespace
}  // namespace carom
