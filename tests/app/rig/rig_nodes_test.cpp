// The nodes of a rig file and how they are started.
#include "app/rig/rig_nodes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::changed;
using test::Fault;
using test::kGood;
using test::read;
using test::RigFaults;

/// kGood with these lines before its head.
std::string withLines(const std::string& lines) { return changed("[head]", lines + "[head]"); }

TEST(Rig, EachNodeHasItsRanksHostAndDisplay) {
  const Rig rig =
      read(withLines("[[node]]\nrank = 0\ndisplay = ':0'\n"
                     "[[node]]\nrank = 1\nslots = 3\nhost = 'wall-1.local'\ndisplay = ':1'\n"
                     "[[node]]\nrank = 4\nhost = '10.0.0.7'\n"));
  ASSERT_EQ(rig.nodes.size(), 3u);
  EXPECT_EQ(rig.nodes[0].slots, 1);
  EXPECT_EQ(rig.nodes[0].host, "");
  EXPECT_EQ(rig.nodes[1].host, "wall-1.local");
  EXPECT_EQ(nodesOf(rig), 5);
  const std::vector<std::string> displays{":0", ":1", ":1", ":1", "", ""};
  for (int rank = 0; rank < 6; ++rank)
    EXPECT_EQ(displayOf(rig, rank), displays[static_cast<std::size_t>(rank)]) << rank;
}

TEST(Rig, SaysHowItsNodesAreStarted) {
  const StartSetup start = read(withLines("[start]\nnetwork = '10.0.0.0/24,eth0'\nports = '47000-47015'\n"
                                          "environment = ['LIBGL=1', '_X=a=b', 'HOME']\n"))
                               .start;
  EXPECT_EQ(start.network, "10.0.0.0/24,eth0");
  ASSERT_TRUE(start.ports);
  EXPECT_EQ(start.ports->first, 47000);
  EXPECT_EQ(start.ports->last, 47015);
  EXPECT_EQ(start.environment, (std::vector<std::string>{"LIBGL=1", "_X=a=b", "HOME"}));
  EXPECT_FALSE(read(kGood).start.ports) << "any port will do";
}

INSTANTIATE_TEST_SUITE_P(
    Nodes, RigFaults,
    ::testing::Values(
        Fault{"same rank",
              changed("[head]",
                      "[[node]]\nrank = 0\ndisplay = ':0'\n[[node]]\nrank = 0\ndisplay = ':1'\n[head]"),
              7, 8, "taken in line 4"},
        Fault{"no port for each", withLines("[start]\nports = '47000-47014'\n"), 4, 9,
              "a range of 16 TCP ports at least"},
        Fault{"ports with signs", withLines("[start]\nports = '+47000- 47099'\n"), 4, 9, "'+47000- 47099'"},
        Fault{"ports of the system", withLines("[start]\nports = '1023-2000'\n"), 4, 9, "from 1024 to 65535"},
        Fault{"ports beyond the last", withLines("[start]\nports = '65000-65536'\n"), 4, 9,
              "from 1024 to 65535"},
        Fault{"more than ports", withLines("[start]\nports = '47000-47099x'\n"), 4, 9,
              "ports is '47000-47099x'"},
        Fault{"host that is an option", withLines("[[node]]\nrank = 0\nhost = '-x'\n"), 5, 8,
              "a computer's name or IPv4 address"},
        Fault{"network of a shell", withLines("[start]\nnetwork = 'eth0;ls'\n"), 4, 11,
              "networks such as '10.0.0.0/24' or 'eth0'"},
        Fault{"variable without a name", withLines("[start]\nenvironment = ['A=1', '=1']\n"), 4, 23,
              "environment has '=1'"},
        Fault{"variable that begins with a digit", withLines("[start]\nenvironment = ['1A=1']\n"), 4, 16,
              "expected 'NAME=VALUE' or 'NAME'"},
        Fault{"node without anything", withLines("[[node]]\nrank = 0\n"), 3, 1,
              "neither a display nor a host"},
        Fault{"rank among the slots of another",
              withLines(
                  "[[node]]\nrank = 2\nslots = 3\nhost = 'a'\n[[node]]\nrank = 0\nslots = 3\nhost = 'b'\n"),
              8, 8, "the rank '2' is taken in line 4"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
