// The rows of a soft body as it is drawn.
#include "engine/soft/soft_history.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(SoftHistory, RefusesLightSpeedAndForgetsFromBothEnds) {
  SoftHistory history;
  const auto row = [](double time, double x) {
    SoftRow at;
    at.time = time, at.centreX = x, at.nodes = 2;
    return at;
  };
  const std::vector<SoftNode> nodes{{0.01F, 0.0F}, {-0.01F, 0.0F}};
  for (int k = 0; k < 200; ++k) history.append(row(0.01 * k, 0.005 * k), nodes);
  EXPECT_THROW(history.append(row(2.0, 1.1), nodes), std::invalid_argument);
  EXPECT_THROW(history.append(row(1.99, 0.995), nodes), std::invalid_argument);
  EXPECT_THROW(history.append(row(2.0, 1.0), std::vector<SoftNode>(1)), std::invalid_argument);
  EXPECT_EQ(history.rowCount(), 200U);
  history.forgetBefore(1.505);
  EXPECT_NEAR(history.row(0).time, 1.50, 1e-12);
  EXPECT_NEAR(history.place(0, 1).x, 0.74, 1e-8);
  history.truncateFrom(1.70);
  EXPECT_EQ(history.rowCount(), 20U);
  history.append(row(1.70, 0.85), nodes);
  EXPECT_NEAR(history.place(20, 0).x, 0.86, 1e-8);
  history.truncateFrom(0.0);
  EXPECT_EQ(history.rowCount(), 0U);
}

// Rows that come, are taken back and forgotten at random, against a plain list.
TEST(SoftHistory, HoldsWhatAPlainListHolds) {
  struct Kept {
    SoftRow row;
    std::vector<SoftNode> nodes;
  };
  test::Random random(43);
  SoftHistory history;
  std::vector<Kept> list;
  double time = 0.0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("seed 43, step " + std::to_string(i));
    const double choice = random.in(0.0, 1.0);
    if (choice < 0.9) {
      time += random.in(0.01, 0.02);
      Kept next;
      next.row.time = time, next.row.centreX = 0.5 * time, next.row.nodes = 3;
      next.row.velocityX = 0.5, next.row.isStill = i % 5 == 0 ? 1 : 0;
      for (int k = 0; k < 3; ++k)
        next.nodes.push_back(
            {static_cast<float>(random.in(-1e-3, 1e-3)), 0.5F, {static_cast<std::int16_t>(k), 0}});
      history.append(next.row, next.nodes);
      list.push_back(next);
    } else if (choice < 0.95) {
      time -= random.in(0.0, 0.3);
      history.truncateFrom(time);
      while (!list.empty() && list.back().row.time >= time) list.pop_back();
    } else {
      const double before = time - random.in(0.0, 2.0);
      history.forgetBefore(before);
      while (list.size() > 1 && list[1].row.time <= before) list.erase(list.begin());
    }
    ASSERT_EQ(history.rowCount(), list.size());
    if (list.empty()) continue;
    for (const std::size_t k : {std::size_t{0}, list.size() / 2, list.size() - 1}) {
      const Kept& kept = list[k];
      ASSERT_EQ(history.row(k).time, kept.row.time);
      for (std::size_t node = 0; node < 3; ++node) {
        ASSERT_EQ(history.place(k, node), kept.row.centre() + glm::dvec2(kept.nodes[node].x, 0.5F));
        ASSERT_EQ(history.velocityAfter(k, node),
                  kept.row.isStill ? glm::dvec2(0.5, 0.0) : kept.nodes[node].v());
      }
    }
  }
}

}  // namespace
}  // namespace carom
