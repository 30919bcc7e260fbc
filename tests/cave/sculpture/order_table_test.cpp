// The table at a picked event: each row by the times that the events have in a frame, which a Lorentz
// transform computes without the table's code.
#include "cave/sculpture/order_table.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "cave/plate_words.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

std::string wordsOf(const OrderTable& table) {
  std::string words;
  for (const OrderRow& row : table.all())
    words += test::plateWords(row.who) + ": " + test::plateWords(row.what) + "; ";
  return words;
}

GameEvent eventAt(std::uint64_t number, double t_s, const Vec3& r_m) {
  GameEvent event;
  event.number = number;
  event.kind = EventKind::stroke;
  event.at = {t_s, r_m};
  return event;
}

FrameRecord recordOf(std::initializer_list<Vec3> betas) {
  FrameRecord record;
  record.viewerCount = 0;
  for (const Vec3& beta : betas)
    record.viewers[record.viewerCount++].observer.headFromBoard =
        Lorentz::boost(uFromBeta(beta), kC_m_s).inverse();
  return record;
}

TEST(OrderTable, SaysWhichIsFirstForWhom) {
  // One metre apart, the light of 0.3 m between them: the one who moves at 0.5 c towards the later has it
  // first.
  std::vector<GameEvent> events{eventAt(4, 1.0, {0.0, 0.0, 0.0}),
                                eventAt(7, 1.0 + 0.3 / kC_m_s, {1.0, 0.0, 0.0}), eventAt(8, 9.0, Vec3(0.0))};
  FrameRecord record = recordOf({Vec3(0.5, 0.0, 0.0), Vec3(-0.5, 0.0, 0.0)});
  EXPECT_EQ(orderTable(record, 0, events, {}).count, 0U) << "nothing is picked";
  record.sculpture.picked = 8;
  EXPECT_EQ(wordsOf(orderTable(record, 0, events, {})), "table: 2 of 3; you: 1 of 3; other: 2 of 3; ");
  EXPECT_EQ(wordsOf(orderTable(record, 1, events, {})), "table: 2 of 3; you: 2 of 3; other: 1 of 3; ");
  record.sculpture.compared = 5;
  EXPECT_EQ(wordsOf(orderTable(record, 0, events, {})),
            "interval: 0.95 m; table: 4 then 7; you: 7 then 4; other: 4 then 7; ");
  // Light connects the first and the last: one order for everybody, and the time of a clock that attends
  // both.
  record.sculpture.picked = 9;
  EXPECT_EQ(wordsOf(orderTable(record, 0, events, {})),
            "interval: 8.00 s; table: 4 then 8; you: 4 then 8; other: 4 then 8; ");
  events[1].at.t_s = 1.0;
  record.sculpture.picked = 8;
  EXPECT_EQ(wordsOf(orderTable(record, 0, events, {})),
            "interval: 1.00 m; table: 4 with 7; you: 7 then 4; other: 4 then 7; ");
  events.erase(events.begin() + 1);
  EXPECT_EQ(orderTable(record, 0, events, {}).count, 0U) << "it has been forgotten";
}

TEST(OrderTable, CallsFlashesByTheirShortNamesAndFourPeopleByTheirNumbers) {
  std::vector<GameEvent> events{eventAt(0, 1.0, Vec3(0.0)), eventAt(1, 2.0, Vec3(0.0))};
  events[1].kind = EventKind::flash;
  events[1].which = 1;
  const std::array<std::string, 2> flashes{"lamp", "B"};
  FrameRecord record = recordOf({Vec3(0.0), Vec3(0.1, 0.0, 0.0), Vec3(0.2, 0.0, 0.0), Vec3(0.3, 0.0, 0.0)});
  record.sculpture.picked = 2;
  record.sculpture.compared = 1;
  EXPECT_EQ(wordsOf(orderTable(record, 1, events, flashes)),
            "interval: 1.00 s; table: 0 then B; you: 0 then B; viewer 1: 0 then B; viewer 3: 0 then B; "
            "viewer 4: 0 then B; ");
  events[1].which = 0;
  EXPECT_EQ(wordsOf(orderTable(recordOf({Vec3(0.0)}), 0, events, flashes)), "");
  record.sculpture.compared = 0;
  EXPECT_EQ(test::plateWords(orderTable(record, 0, events, flashes).rows[0].what), "2 of 2");
}

TEST(OrderTable, PlacesAreThoseOfTheTimesInTheFrame) {
  test::Random random(3651);
  int moved = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    std::vector<GameEvent> events;
    for (std::uint64_t k = 0; k < 9; ++k)
      events.push_back(eventAt(k, random.in(0.0, 1.5), {random.in(-1.4, 1.4), random.in(-0.7, 0.7), 0.02}));
    FrameRecord record = recordOf({betaFromU(random.u(0.9))});
    const Lorentz& frame = record.viewers[0].observer.headFromBoard;
    record.sculpture.picked = 4;
    int earlier = 0, onBoard = 0;
    for (const GameEvent& event : events) {
      earlier += (frame * (event.at - events[3].at)).dt_s < 0.0 ? 1 : 0;
      onBoard += event.at.t_s < events[3].at.t_s ? 1 : 0;
    }
    const OrderTable table = orderTable(record, 0, events, {});
    ASSERT_EQ(test::plateWords(table.rows[0].what), std::to_string(onBoard + 1) + " of 9");
    ASSERT_EQ(test::plateWords(table.rows[1].what), std::to_string(earlier + 1) + " of 9");
    moved += earlier != onBoard ? 1 : 0;
  }
  EXPECT_GT(moved, 50);
}

}  // namespace
}  // namespace carom
