// Another room of a linked game as rows: the moments of its people are read with the bits of their telling.
#include "app/journal_rows/link_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace carom {
namespace {

ToldMoment momentOf(std::uint64_t person, double x) {
  ToldMoment moment;
  moment.person = person;
  moment.kind = x == 0.0 ? ToldKind::begins : ToldKind::goesOn;
  moment.head = {x / 3.0, {x, 0.25, 1.6}};
  moment.hand = {x / 7.0, {x, 2.0 / 3.0, 1.2}};
  moment.properTime_s = x / 9.0;
  moment.facing_rad = -x;
  moment.hasHand = person % 2;
  moment.cue_rad = x / 11.0;
  moment.caroms = 3;
  moment.setName("person " + std::to_string(person));
  return moment;
}

class LinkBatches : public testing::Test {
 protected:
  void write(const LinkBatch& batch) { LinkWriter(database_).write(batch); }

  SQLite::Database database_{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

TEST_F(LinkBatches, MomentsAreReadWithTheSameBitsInTheirOrder) {
  LinkBatch batch;
  EXPECT_TRUE(batch.empty());
  for (std::uint64_t frame = 0; frame < 5; ++frame) {
    LinkNews news;
    for (std::uint64_t person = 0; person < frame % 3; ++person)
      news.persons.push_back({1, 100 + frame, momentOf(2 - person, 0.1 * static_cast<double>(frame))});
    batch.add(frame, news);
  }
  EXPECT_FALSE(batch.empty());
  write(batch);
  ToldReader reader(database_);
  std::vector<ToldMoment> told(7);
  for (std::uint64_t frame = 0; frame < 6; ++frame) {
    SCOPED_TRACE(frame);
    reader.read(frame, told);
    ASSERT_EQ(told.size(), frame < 5 ? frame % 3 : 0);
    for (std::uint64_t person = 0; person < told.size(); ++person) {
      const ToldMoment expected = momentOf(2 - person, 0.1 * static_cast<double>(frame));
      EXPECT_EQ(std::memcmp(&told[person], &expected, sizeof expected), 0) << told[person].nameText();
    }
  }
  batch.clear();
  EXPECT_TRUE(batch.empty());
}

TEST_F(LinkBatches, PromisesAndNotesArePlainColumns) {
  LinkNews news;
  news.rows.push_back({1, "playing", 42, 0.25, {12.5, {1.0, 2.0, 3.0}}, "anna", true, 1.5, 7});
  news.notes.push_back({1, "paired", "with lyon"});
  LinkBatch batch;
  batch.add(9, news);
  write(batch);
  write({});  // the tables are there already
  const auto textOf = [&](const char* sql) { return database_.execAndGet(sql).getString(); };
  EXPECT_EQ(textOf("SELECT frame||' '||room||' '||state||' '||heard||' '||viewer||' '||waits||' '||digest_s "
                   "FROM link"),
            "9 1 playing 42 anna 1 7");
  EXPECT_EQ(
      textOf("SELECT round_trip_s + promise_t_s + promise_x_m + promise_y_m + promise_z_m + pace FROM link"),
      "20.25");
  EXPECT_EQ(textOf("SELECT frame||' '||room||' '||what||' '||value FROM link_note"), "9 1 paired with lyon");
}

TEST_F(LinkBatches, AFileWithoutALinkHasNoMoments) {
  EXPECT_FALSE(ToldReader::hasTable(database_));
  ToldReader reader(database_);
  std::vector<ToldMoment> told(3);
  reader.read(0, told);
  EXPECT_TRUE(told.empty());
}

TEST_F(LinkBatches, APersonWhoCannotBeIsRefused) {
  LinkBatch batch;
  LinkNews news;
  news.persons.push_back({1, 100, momentOf(1, 0.1)});
  batch.add(0, news);
  write(batch);
  ToldReader reader(database_);
  std::vector<ToldMoment> told;
  EXPECT_NO_THROW(reader.read(0, told));
  for (const char* change :
       {"has_hand = 2", "kind = 3", "t_s = NULL", "person = 4", "proper_time_s = 'late'"}) {
    SCOPED_TRACE(change);
    database_.exec("CREATE TEMP TABLE kept AS SELECT * FROM link_person; UPDATE link_person SET " +
                   std::string(change));
    EXPECT_THROW(ToldReader(database_).read(0, told), std::exception);
    database_.exec("DELETE FROM link_person; INSERT INTO link_person SELECT * FROM kept; DROP TABLE kept");
  }
  EXPECT_NO_THROW(ToldReader(database_).read(0, told));
}

}  // namespace
}  // namespace carom
