// Rows of soft bodies against the steps from which they are made.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "engine/soft/row_recorder.h"
#include "engine/soft/soft_discs.h"
#include "engine/soft/soft_play.h"

namespace carom {
namespace {

using test::kRadius;

SoftEntry disc(double speed, int cells) {
  const double gamma = 1.0 / std::sqrt(1.0 - speed * speed);
  SoftEntry entry;
  entry.name = "jelly";
  entry.mesh = std::make_shared<const SoftMesh>(softDisc(kRadius, cells));
  entry.mass = 0.2;
  entry.u = {gamma, gamma * speed, 0.0};
  return entry;
}

/// A bounce with its rows, and every step of it.
struct RecordedBounce {
  SoftRows rows;
  SoftHistory history;
  std::map<double, std::vector<glm::dvec2>> steps;

  RecordedBounce(double speed, int cells, double until) {
    SoftPlay play({{{1.0, 0.0}, 0.08}});
    play.add(disc(speed, cells));
    std::vector<glm::dvec2> places;
    play.drawnPlaces(0, 0.0, places);
    RowRecorder recorder(0, 0.0, places, false);
    recorder.take(0.0, places, play.body(0), true, rows);
    play.watch([&](std::size_t body, double time) {
      const bool fades = play.drawnPlaces(body, std::nullopt, places);
      recorder.take(time, places, play.body(body), !play.isAwake(body) && !fades, rows);
      steps[time] = places;
    });
    while (play.time() < until) play.playSlice();
    std::size_t node = 0;
    for (const SoftRow& row : rows.rows) {
      history.append(row, std::span(rows.nodes).subspan(node, row.nodes));
      node += row.nodes;
    }
  }

  glm::dvec2 onRows(double time, std::size_t node) const {
    std::size_t k = 0;
    while (k + 1 < history.rowCount() && history.row(k + 1).time <= time) ++k;
    const double from = history.row(k).time;
    if (k + 1 == history.rowCount())
      return history.place(k, node) + (time - from) * history.velocityAfter(k, node);
    const double share = (time - from) / (history.row(k + 1).time - from);
    return glm::mix(history.place(k, node), history.place(k + 1, node), share);
  }
};

TEST(RowRecorder, RowsMissNoStepByMoreThanATenthOfAMillimetre) {
  for (const double speed : {0.3, 0.6, 0.8}) {
    SCOPED_TRACE(speed);
    const RecordedBounce bounce(speed, 8, 0.6);
    const double last = bounce.history.row(bounce.history.rowCount() - 1).time;
    double farthest = 0.0;
    for (const auto& [time, places] : bounce.steps) {
      if (time > last) break;
      for (std::size_t i = 0; i < places.size(); ++i)
        farthest = std::max(farthest, glm::length(bounce.onRows(time, i) - places[i]));
    }
    EXPECT_LT(farthest, RowRecorder::kOff);
    EXPECT_GT(farthest, 0.2 * RowRecorder::kOff);
    // So few rows that they are worth it: the field's prototype had 99 to 137 in 0.61 m of light.
    EXPECT_LT(bounce.rows.rows.size(), 200U);
    EXPECT_GT(bounce.steps.size(), 3 * bounce.rows.rows.size());
    for (std::size_t k = 2; k < bounce.rows.rows.size(); ++k)
      EXPECT_LT(bounce.rows.rows[k].time - bounce.rows.rows[k - 1].time, 1.2 * RowRecorder::kLongest);
  }
}

TEST(RowRecorder, ASleeperIsOneRowAndWakesOnItsWay) {
  const RecordedBounce bounce(0.3, 6, 0.4);
  ASSERT_GT(bounce.history.rowCount(), 3U);
  EXPECT_EQ(bounce.history.row(0).isStill, 1);
  EXPECT_EQ(bounce.history.row(1).isStill, 0);
  EXPECT_GT(bounce.history.row(1).time, 0.1);  // when it is near the cushion
  for (std::size_t i = 0; i < bounce.history.nodeCount(); ++i) {
    const glm::dvec2 way = bounce.history.place(1, i) - bounce.history.place(0, i);
    EXPECT_NEAR(way.x, 0.3 * bounce.history.row(1).time, 1e-8);
    EXPECT_NEAR(way.y, 0.0, 1e-8);
  }
}

// A node that is elsewhere than where the simulation has it goes there slower than light, and stays.
TEST(RowRecorder, CatchesUpSlowerThanLight) {
  const SoftEntry entry = disc(0.6, 4);
  SoftBody body(entry.mesh, entry.material, entry.mass, entry.centre, entry.u);
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i < body.size(); ++i) places.push_back(body.place(i));
  std::vector<glm::dvec2> drawn = places;
  drawn[3] += glm::dvec2(-0.01, 0.004);
  SoftRows rows;
  RowRecorder recorder(7, 1.0, drawn, true);
  recorder.take(1.0, places, body, true, rows);
  EXPECT_FALSE(recorder.isStill());
  for (int step = 1; step <= 60; ++step) {
    for (glm::dvec2& place : places) place.x += 0.6 * 0.001;
    recorder.take(1.0 + 0.001 * step, places, body, true, rows);
  }
  EXPECT_TRUE(recorder.isStill());
  SoftHistory history;
  std::size_t node = 0;
  for (const SoftRow& row : rows.rows) {
    EXPECT_EQ(row.body, 7U);
    EXPECT_EQ(row.wasRigid, node == 0 ? 1 : 0);
    ASSERT_NO_THROW(history.append(row, std::span(rows.nodes).subspan(node, row.nodes)));
    node += row.nodes;
  }
  EXPECT_NEAR(glm::length(history.place(0, 3) - drawn[3]), 0.0, 1e-8);
  // The gap of 10 mm along the motion closes with 0.35 c.
  EXPECT_NEAR(history.row(history.rowCount() - 1).time, 1.0 + 0.0108 / 0.35, 0.004);
}

}  // namespace
}  // namespace carom
