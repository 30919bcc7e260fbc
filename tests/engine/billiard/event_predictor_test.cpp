#include "engine/billiard/event_predictor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/billiard/collision_scheduler.h"
#include "engine/gas.h"

namespace carom {
namespace {

/// The first event of a puck on the leg that it follows, found by comparing it with everything.
PredictedEvent firstOf(const GameState& game, int i) {
  PredictedEvent first;
  for (int other = 0; other < game.count(); ++other) {
    if (other == i || game.handled(i, other) != nullptr) continue;
    if (game.predictions[i].lastPartner == other && game.predictions[other].lastPartner == i) continue;
    const PuckPair who{std::min(i, other), std::max(i, other)};
    const auto meeting = findMeeting(game.discs[who[0]], game.discs[who[1]], game.rules.convention);
    if (!meeting || !(meeting->ownTime[i == who[0] ? 0 : 1] < first.ownTime)) continue;
    first.kind = PredictedKind::pair;
    first.with = other;
    first.ownTime = meeting->ownTime[i == who[0] ? 0 : 1];
    first.otherTime = meeting->ownTime[i == who[0] ? 1 : 0];
  }
  for (int cushion = 0; cushion < 4; ++cushion) {
    const auto contact =
        findContact(game.legOf(i), game.discs[i].radius, game.rules.cushions[cushion], game.rules.convention);
    if (!contact || !(contact->ownTime < first.ownTime) ||
        (game.predictions[i].metCushions >> cushion & 1) != 0)
      continue;
    first = {};
    first.kind = PredictedKind::cushion;
    first.with = cushion;
    first.ownTime = contact->ownTime;
  }
  return first;
}

// Cells tell of what comes before either of a pair leaves its own.
void expectFirst(const GameState& game) {
  int known = 0;
  for (int i = 0; i < game.count(); ++i) {
    const PredictedEvent first = firstOf(game, i);
    const Prediction& own = game.predictions[i];
    const bool isNear =
        first.kind != PredictedKind::pair || first.otherTime < game.predictions[first.with].leavesCell;
    if (isNear && first.ownTime < own.leavesCell) {
      ++known;
      EXPECT_EQ(own.next.kind, first.kind) << i;
      EXPECT_EQ(own.next.with, first.with) << i;
      EXPECT_EQ(own.next.ownTime, first.ownTime) << i;
      if (first.kind == PredictedKind::pair) {
        EXPECT_EQ(own.next.otherTime, first.otherTime) << i;
      }
    } else {
      EXPECT_GE(own.next.ownTime, first.ownTime) << i;
    }
  }
  EXPECT_GT(known, game.count() / 10);
}

TEST(EventPredictor, FindsTheFirstOfAllAtTheStart) {
  for (const int count : {20, 300}) {
    for (const CollisionEvent event : {CollisionEvent::centre, CollisionEvent::contact}) {
      SCOPED_TRACE(testing::Message() << count << " pucks");
      BilliardSetup setup = test::gasSetup(count, 0.3, 1.4, 11);
      setup.rules.collisionEvent = event;
      const CollisionScheduler game(setup);
      expectFirst(game.state());
    }
  }
}

// Where turns do not wait for light, no leg is decided that has not begun.
TEST(EventPredictor, FindsTheFirstOfAllInTheCourseOfAGame) {
  for (const int count : {20, 300}) {
    SCOPED_TRACE(testing::Message() << count << " pucks");
    const BilliardSetup setup = test::gasSetup(count, 0.3, 1.4, 12);
    CollisionScheduler game(setup);
    GameHistory history(setup);
    for (std::size_t events = 50; events <= 500; events += 50) {
      game.playUntil(1e3, events, history);
      expectFirst(game.state());
    }
  }
}

// Of two pucks that one would meet at the same time to the last bit it meets the one whose name comes first,
// wherever that lies.
TEST(EventPredictor, OfEqualTimesTheFirstNameCounts) {
  for (const CollisionEvent event : {CollisionEvent::centre, CollisionEvent::contact}) {
    for (const double side : {1.0, -1.0}) {
      BilliardSetup setup;
      setup.lightSpeed_m_s = 1.0;
      setup.rules.collisionEvent = event;
      const auto add = [&](const char* name, const Vec2& at_m, const Vec2& beta) {
        setup.pucks.push_back({name, 0.03, 0.02, 1.0, at_m, beta});
      };
      add("a", {-0.5, 0.0}, {0.8, 0.0});
      add("b", {0.5, side * 0.04}, {0.0, 0.0});
      add("c", {0.5, -side * 0.04}, {0.0, 0.0});
      const CollisionScheduler game(setup);
      const LargeArray<Prediction>& predictions = game.state().predictions;
      EXPECT_EQ(predictions[1].next.otherTime, predictions[2].next.otherTime);
      EXPECT_EQ(predictions[0].next.kind, PredictedKind::pair);
      EXPECT_EQ(predictions[0].next.with, 1) << side;
    }
  }
}

// The lists of those that count on meeting a puck hold exactly these.
TEST(EventPredictor, PucksKnowWhoCountsOnThem) {
  const BilliardSetup setup = test::gasSetup(300, 0.3, 1.4, 13);
  CollisionScheduler game(setup);
  GameHistory history(setup);
  game.playUntil(1e3, 400, history);
  const LargeArray<Prediction>& predictions = game.state().predictions;
  int listed = 0, counting = 0;
  for (int i = 0; i < game.state().count(); ++i) {
    counting += predictions[i].next.kind == PredictedKind::pair ? 1 : 0;
    for (int k = predictions[i].firstDependent; k >= 0; k = predictions[k].nextDependent) {
      ++listed;
      EXPECT_EQ(predictions[k].next.kind, PredictedKind::pair);
      EXPECT_EQ(predictions[k].next.with, i);
    }
  }
  EXPECT_EQ(listed, counting);
  EXPECT_GT(listed, 100);
}

}  // namespace
}  // namespace carom
