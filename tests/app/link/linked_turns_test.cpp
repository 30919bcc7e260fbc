#include "app/link/linked_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/random_world.h"

namespace carom::test {
namespace {

constexpr double kC_m_s = 1.42;
constexpr std::array<std::uint32_t, 2> kOneEach{1, 1};

LinkStroke strokeOf(const LinkedPlayer& player, std::uint32_t number, const Event& at) {
  LinkStroke made{player.room, {number, player.viewer, {}}};
  made.told.stroke.at_s = at.t_s;
  made.told.stroke.from_m = at.r_m;
  return made;
}

TEST(LinkedTurns, AStrokeFromAfarPassesTheTurnWhenItsLightIsHere) {
  const Event hand{10.0, {1.42, 0.0, 0.9}};
  LinkedTurns there(1), here(0);
  there.struck(strokeOf({1, 0}, 0, hand));
  here.struck(strokeOf({1, 0}, 0, hand));
  EXPECT_EQ(there.turn(kOneEach), (LinkedPlayer{0, 0}));
  here.struck(strokeOf({0, 0}, 0, {9.0, Vec3(0.0)}));
  EXPECT_EQ(here.turn(kOneEach), (LinkedPlayer{1, 0}));
  here.look({10.999, {0.0, 0.0, 0.9}}, kC_m_s);
  EXPECT_EQ(here.turn(kOneEach), (LinkedPlayer{1, 0}));
  EXPECT_EQ(here.strokes({1, 0}), 0U);
  here.look({11.001, {0.0, 0.0, 0.9}}, kC_m_s);
  EXPECT_EQ(here.turn(kOneEach), (LinkedPlayer{0, 0}));
  EXPECT_EQ(here.strokes({1, 0}), 1U);
}

TEST(LinkedTurns, WhoSeesACaromHasTheTurnAgainUnlessALaterStrokeWasMade) {
  LinkedTurns turns(0);
  turns.struck(strokeOf({0, 0}, 0, {1.0, Vec3(0.0)}));
  turns.carom({0, 0}, 0, {2.0, Vec3(0.0)});
  EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{0, 0}));
  turns.struck(strokeOf({0, 0}, 1, {3.0, Vec3(0.0)}));
  EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{1, 0}));
  turns.struck(strokeOf({1, 0}, 0, {3.5, {1.42, 0.0, 0.0}}));
  turns.look({9.0, Vec3(0.0)}, kC_m_s);
  turns.carom({0, 0}, 1, {9.5, Vec3(0.0)});
  EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{0, 0})) << "the other's stroke was later";
  turns.carom({1, 0}, 0, {5.0, {1.42, 0.0, 0.0}});
  turns.look({9.6, Vec3(0.0)}, kC_m_s);
  EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{1, 0}));
}

TEST(LinkedTurns, TheTurnGoesRoundAllPeopleOfBothRooms) {
  constexpr std::array<std::uint32_t, 2> kPeople{2, 1};
  LinkedTurns turns(0);
  LinkedPlayer player = turns.turn(kPeople);
  std::vector<LinkedPlayer> order;
  for (std::uint32_t i = 0; i < 4; ++i) {
    order.push_back(player);
    turns.struck(strokeOf(player, i, {1.0 + i, Vec3(0.0)}));
    turns.look({1.1 + i, Vec3(0.0)}, kC_m_s);
    player = turns.turn(kPeople);
  }
  EXPECT_EQ(order, (std::vector<LinkedPlayer>{{0, 0}, {0, 1}, {1, 0}, {0, 0}}));
  EXPECT_EQ(LinkedTurns(1).turn(kPeople), (LinkedPlayer{0, 0})) << "the room that listens begins";
}

// Two rooms whose people strike and see caroms at any moments, told in any order, say the same once all light
// has arrived: that of the stroke which is latest on the board.
TEST(LinkedTurns, RoomsAgreeOnceTheLightHasArrived) {
  constexpr std::array<std::uint32_t, 2> kPeople{2, 3};
  for (int number = 0; number < 300; ++number) {
    SCOPED_TRACE(number);
    Random random(static_cast<unsigned>(number));
    std::mt19937 order(static_cast<unsigned>(number));
    struct Did {
      LinkStroke stroke;
      bool isCarom;
      Event seenAt;
    };
    std::vector<Did> done;
    std::array<std::uint32_t, 2> numbers{};
    for (int i = 0; i < 12; ++i) {
      const auto room = static_cast<std::uint32_t>(random.in(0.0, 1.999));
      const auto viewer = static_cast<std::uint32_t>(random.in(0.0, kPeople[room] - 0.001));
      const Event at{static_cast<double>(i) + random.in(0.0, 0.9), {room == 0 ? -2.0 : 2.0, 0.0, 1.0}};
      done.push_back({strokeOf({room, viewer}, numbers[room]++, at),
                      random.in(0.0, 1.0) < 0.5,
                      {at.t_s + random.in(0.1, 0.6), at.r_m}});
    }
    std::array<LinkedTurns, 2> rooms{LinkedTurns(0), LinkedTurns(1)};
    for (LinkedTurns& room : rooms) {
      std::ranges::shuffle(done, order);
      for (const Did& did : done) {
        room.struck(did.stroke);
        if (random.in(0.0, 1.0) < 0.3) room.look({random.in(0.0, 20.0), Vec3(0.0)}, kC_m_s);
      }
      std::ranges::sort(done, {}, [](const Did& did) { return did.seenAt.t_s; });
      for (const Did& did : done) {
        if (did.isCarom)
          room.carom({did.stroke.room, did.stroke.told.viewer}, did.stroke.told.number, did.seenAt);
      }
      room.look({100.0, Vec3(0.0)}, kC_m_s);
    }
    const Did& last =
        *std::ranges::max_element(done, {}, [](const Did& did) { return did.stroke.told.stroke.at_s; });
    const LinkedPlayer by{last.stroke.room, last.stroke.told.viewer};
    const LinkedPlayer next = by.viewer + 1 < kPeople[by.room] ? LinkedPlayer{by.room, by.viewer + 1}
                                                               : LinkedPlayer{1 - by.room, 0};
    for (const LinkedTurns& room : rooms) {
      EXPECT_EQ(room.turn(kPeople), last.isCarom ? by : next);
      for (std::uint32_t viewer = 0; viewer < 3; ++viewer) {
        for (std::uint32_t of : {0U, 1U}) {
          const auto made = std::ranges::count_if(done, [&](const Did& did) {
            return did.stroke.room == of && did.stroke.told.viewer == viewer;
          });
          EXPECT_EQ(room.strokes({of, viewer}), made);
        }
      }
    }
  }
}

TEST(LinkedTurns, WhoJoinsBeginsTheirScoreAndKnowsOfNoCaromBefore) {
  for (const std::uint32_t room : {0U, 1U}) {
    LinkedTurns turns(room);
    turns.struck(strokeOf({0, 0}, 0, {1.0, Vec3(0.0)}));
    turns.struck(strokeOf({1, 0}, 0, {2.0, Vec3(0.0)}));
    turns.carom({1, 0}, 0, {2.5, Vec3(0.0)});
    turns.joined(1);
    turns.look({9.0, Vec3(0.0)}, kC_m_s);
    EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{0, 0}));
    EXPECT_EQ(turns.strokes({0, 0}), 1U);
    EXPECT_EQ(turns.strokes({1, 0}), 0U);
    turns.struck(strokeOf({1, 0}, 1, {3.0, Vec3(0.0)}));
    turns.carom({1, 0}, 1, {3.5, Vec3(0.0)});
    turns.look({9.0, Vec3(0.0)}, kC_m_s);
    EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{1, 0}));
    EXPECT_EQ(turns.strokes({1, 0}), 1U);
  }
}

TEST(LinkedTurns, WhatCannotBeChangesNothing) {
  LinkedTurns turns(0);
  turns.struck(strokeOf({3, 0}, 0, {1.0, Vec3(0.0)}));
  turns.struck(strokeOf({1, 9}, 0, {1.0, Vec3(0.0)}));
  turns.carom({2, 0}, 0, {1.0, Vec3(0.0)});
  turns.carom({1, kMostViewers}, 0, {1.0, Vec3(0.0)});
  turns.look({9.0, Vec3(0.0)}, kC_m_s);
  EXPECT_EQ(turns.turn(kOneEach), (LinkedPlayer{0, 0}));
  EXPECT_EQ(turns.strokes({3, 0}) + turns.strokes({1, 9}), 0U);
}

}  // namespace
}  // namespace carom::test
