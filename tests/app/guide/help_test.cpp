// `carom help`: explains a message, lists the commands, and gives up where it knows of nothing.
#include <gtest/gtest.h>

#include "app/program.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

TEST(Help, TheCommandExplainsListsAndGivesUp) {
  const TemporaryFolder folder;
  const auto late =
      runCarom(folder, {"help", "node 3 (floor) is late: every wall keeps the last whole frame."});
  EXPECT_EQ(late.status, 0) << late.err;
  EXPECT_EQ(late.out,
            "message  node 2 (left) is late: every wall keeps the last whole frame. … is back after 1.2 s.\n"
            "means    that computer or its network stopped for a moment; if often, look at its load\n");
  EXPECT_EQ(runCarom(folder, {"help", "is", "late:", "every", "wall"}).out, late.out) << "without quotes";
  EXPECT_EQ(runCarom(folder, {"help"}).out, runCarom(folder, {"--help"}).out);
  EXPECT_EQ(runCarom(folder, {"help", "simulate"}).out, runCarom(folder, {"simulate", "--help"}).out);
  const auto none = runCarom(folder, {"help", "xyzzy"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.out.find("carom doctor RIG"), std::string::npos) << none.out;
  EXPECT_EQ(runCarom(folder, {"help", "--frames: 'x' is wrong"}).status, 1)
      << "also what begins like an option";
}

}  // namespace
}  // namespace carom
