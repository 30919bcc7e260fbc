// Frames as rows: read with the bits with which they were written, from any frame on, or only those that
// change the game.
#include "app/journal_rows/frame_rows.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/journal_frames.h"
#include "app/journal_rows/frames_in_memory.h"

namespace carom {
namespace {

using test::frameOf;
using test::sameBits;

constexpr std::uint64_t kFrames = 40;

class FrameRows : public testing::Test, protected test::FramesInMemory {
 protected:
  FrameRows() {
    FrameWriter frames(database);
    ViewerWriter viewers(database, {"anna"});
    const HeadWords head{Known::predicted, {0.1, 0.2, 0.3}};
    for (std::uint64_t number = 0; number < kFrames; ++number) {
      const FrameState frame = frameOf(number);
      frames.write(frame.record, "predicted", head.celerity_m_s);
      for (const BodyKnot& knot : frame.knots) frames.write(number, knot);
      for (const GameEvent& event : frame.events) frames.write(number, event);
      viewers.write(frame.record, {&head, 1});
    }
  }
  /// Reads all frames that come, and returns their numbers.
  static std::vector<std::uint64_t> numbersOf(FrameReader& reader) {
    std::vector<std::uint64_t> numbers;
    FrameState state;
    while (const auto number = reader.step()) {
      reader.read(state);
      EXPECT_EQ(state.record.number, *number);
      EXPECT_TRUE(sameBits(state, frameOf(*number))) << "frame " << *number;
      numbers.push_back(*number);
    }
    return numbers;
  }
  static std::vector<std::uint64_t> expected(std::uint64_t from, bool changesOnly) {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t number = from; number < kFrames; ++number) {
      const FrameState frame = frameOf(number);
      if (!changesOnly || !frame.knots.empty() || !frame.events.empty()) numbers.push_back(number);
    }
    return numbers;
  }
  std::string refusalOf(const std::string& change) {
    database.exec(change);
    FrameReader reader(database, 1.42);
    FrameState state;
    try {
      while (reader.step()) reader.read(state);
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(FrameRows, AreReadWithTheSameBitsFromAnyFrameOn) {
  FrameReader reader(database, 1.42);
  EXPECT_EQ(numbersOf(reader), expected(0, false)) << "at first from the first frame on";
  EXPECT_FALSE(reader.step()) << "there is still none after the last";
  for (const std::uint64_t from : {0U, 7U, 39U, 40U}) {
    SCOPED_TRACE(from);
    reader.goTo(from);
    EXPECT_EQ(numbersOf(reader), expected(from, false));
    reader.goTo(from, true);
    EXPECT_EQ(numbersOf(reader), expected(from, true));
  }
  database.exec("DELETE FROM frame WHERE number = 8");
  reader.goTo(8);
  EXPECT_EQ(reader.step(), 9U) << "the first that is there";
}

TEST_F(FrameRows, WhatCannotBeIsRefused) {
  EXPECT_EQ(refusalOf("UPDATE frame SET pucks = 'many' WHERE number = 5"),
            "pucks is many, expected a whole number up to 18446744073709551615");
  EXPECT_EQ(refusalOf("UPDATE frame SET pucks = 2"), "");
  EXPECT_EQ(refusalOf("UPDATE frame SET pucks = 1 WHERE number = 12"),
            "an event turns puck 1, expected one of 1 from 0")
      << "frame 12 brings an event of the puck 1";
  EXPECT_NE(refusalOf("UPDATE frame SET pucks = 2; UPDATE frame SET comfort = 256 WHERE number = 3")
                .find("comfort is 256, expected a whole number up to 255"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
