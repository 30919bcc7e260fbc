// The viewers of a frame as rows: all that the first one's frame does not have, and whose turn it is.
#include "app/journal_rows/viewer_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/journal_frames.h"
#include "app/journal_rows/frames_in_memory.h"

namespace carom {
namespace {

using test::frameOf;
using test::sameBits;

const std::vector<std::string> kPeople{"anna", "ben", "cleo"};

FrameRecord recordOf(std::uint64_t number, std::size_t viewers) {
  FrameRecord record = frameOf(number).record;
  record.viewerCount = viewers;
  record.room_s = 1.0 / 3.0 + static_cast<double>(number);
  record.drive.thrust_m_s2 = {0.5, -0.25, 1.0 / 7.0};
  for (std::size_t i = 0; i < viewers; ++i) {
    if (i > 0) record.viewers[i] = frameOf(number + 10 * i).record.viewers[0];
    record.viewers[i].placeInRoom_m = {-0.0, static_cast<double>(i), -1.0 / 3.0};
    record.viewers[i].lapse = 0.5 + 0.1 * static_cast<double>(i);
    record.viewers[i].notice = Notice("seen by " + kPeople[i]);
  }
  return record;
}

class ViewerRows : public testing::Test, protected test::FramesInMemory {
 protected:
  void write(const FrameRecord& record) {
    const std::array<HeadWords, 3> heads{
        {{Known::measured, {0.1, 0.2, 0.3}}, {}, {Known::predicted, Vec3(1.0)}}};
    ViewerWriter(database, kPeople).write(record, {heads.data(), record.viewerCount});
  }
  /// Reads a frame's viewers into a record that has been read otherwise.
  FrameRecord read(const FrameRecord& written) {
    FrameRecord record = written;
    record.viewerCount = 1;
    record.room_s = 0.0;
    record.drive.thrust_m_s2 = Vec3(0.0);
    record.viewers[0].placeInRoom_m = Vec3(0.0);
    record.viewers[0].lapse = 1.0;
    record.viewers[0].hasTurn = 0;
    for (std::size_t i = 1; i < kMostViewers; ++i) record.viewers[i] = {};
    ViewerReader(database, 1.42).read(record);
    return record;
  }
};

TEST_F(ViewerRows, AreReadWithTheSameBits) {
  for (std::uint64_t number = 0; number < 20; ++number) {
    SCOPED_TRACE(number);
    FrameRecord written = recordOf(number, 1 + number % 3);
    if (written.viewerCount > 1) written.viewers[number % written.viewerCount].hasTurn = 1;
    write(written);
    const FrameRecord again = read(written);
    ASSERT_EQ(again.viewerCount, written.viewerCount);
    EXPECT_TRUE(sameBits(again, written));
    EXPECT_EQ(again.room_s, written.room_s);
    EXPECT_EQ(again.drive.thrust_m_s2, written.drive.thrust_m_s2);
    EXPECT_EQ(again.viewers[0].hasTurn, written.viewers[0].hasTurn);
    EXPECT_EQ(again.viewers[0].placeInRoom_m, written.viewers[0].placeInRoom_m);
    EXPECT_TRUE(std::signbit(again.viewers[0].placeInRoom_m.x)) << "minus zero";
    EXPECT_EQ(again.viewers[0].lapse, written.viewers[0].lapse);
  }
  const auto valueOf = [&](const char* column) {
    return database.execAndGet(std::string("SELECT ") + column +
                               " FROM viewer WHERE frame = 5 AND name = 'cleo'");
  };
  EXPECT_EQ(valueOf("lapse").getDouble(), 0.5 + 0.1 * 2.0);
  EXPECT_EQ(valueOf("known").getString(), "predicted");
  EXPECT_EQ(valueOf("celerity_y_m_s").getDouble(), 1.0);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM viewer WHERE frame = 5").getInt(), 3);
}

// The turn of the first viewer is no column: it is theirs unless somebody else has it, here or elsewhere.
TEST_F(ViewerRows, TheFirstHasTheTurnThatNoOtherHas) {
  FrameRecord two = recordOf(1, 2), alone = recordOf(2, 1);
  write(two);
  write(alone);
  EXPECT_EQ(read(two).viewers[0].hasTurn, 1);
  EXPECT_EQ(read(alone).viewers[0].hasTurn, 0) << "alone there are no turns";
  database.exec("CREATE TABLE link(frame INTEGER)");
  EXPECT_EQ(read(two).viewers[0].hasTurn, 1);
  database.exec("INSERT INTO link VALUES(1)");
  EXPECT_EQ(read(two).viewers[0].hasTurn, 0) << "it may be somebody's in the other room";
}

TEST_F(ViewerRows, MoreThanThereMayBeAreRefused) {
  const FrameRecord written = recordOf(4, 3);
  write(written);
  for (const char* more : {"3", "4"})
    database.exec(
        "CREATE TEMP TABLE copy AS SELECT * FROM other_viewer WHERE viewer = 1; UPDATE copy SET viewer = " +
        std::string(more) + "; INSERT INTO other_viewer SELECT * FROM copy; DROP TABLE copy");
  try {
    read(written);
    FAIL() << "five viewers are read";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "more than 4 viewers");
  }
}

}  // namespace
}  // namespace carom
