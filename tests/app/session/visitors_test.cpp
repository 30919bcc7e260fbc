// Three visitors, one after the other: each finds the room as the first one did.
#include <gtest/gtest.h>

#include "app/journal/session_file.h"
#include "app/simulated_visitors.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

TEST(Visitors, ThreeComePlayAndLeaveAndNobodyFindsAnothersState) {
  const test::LogLines log;
  const test::TemporaryFolder folder;
  test::SimulatedVisitors room(7, folder / "");
  const std::vector<test::Found> found = room.run(3, 4000.0);
  ASSERT_EQ(found.size(), 4U) << "after " << room.now_s() << " s and " << room.games() << " games";
  for (const test::Found& each : found) {
    SCOPED_TRACE(each.at_s);
    test::expectNothingOfOthers(each, found.front());
  }
  EXPECT_GT(room.games(), 3U);
  EXPECT_GT(room.strokes(), 0U);
  EXPECT_EQ(room.ends(), 0U) << "Escape is locked";
  EXPECT_EQ(room.thrownOut(), 0U) << "of " << room.discussions() << " discussions";
  EXPECT_LE(found[3].handles, found[1].handles);
  // The last game is under way: its first frames may still wait to be written.
  const std::size_t written = SessionFile(room.file()).games().size();
  const std::size_t played = room.games() + 1 - room.attractions();
  EXPECT_TRUE(written == played || written + 1 == played) << written << " of " << played;
}

}  // namespace
}  // namespace carom
