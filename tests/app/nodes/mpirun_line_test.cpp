// The line of mpirun for a rig: a slot for each node, in the order of the nodes, and words that a shell reads
// back as they were.
#include "app/nodes/mpirun_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/nodes/timed.h"
#include "app/nodes/timed_command.h"

namespace carom {
namespace {

using Words = std::vector<std::string>;

/// A rig with a wall for each node, and nothing else.
Rig rigOf(int nodes, std::vector<NodeSetup> setups) {
  Rig rig;
  rig.walls.resize(static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node) rig.walls[static_cast<std::size_t>(node)].node = node;
  rig.nodes = std::move(setups);
  return rig;
}

std::string refusalOf(const Rig& rig) {
  try {
    hostsOf(rig);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(MpirunLine, EveryNodeHasItsHost) {
  EXPECT_EQ(hostsOf(rigOf(3, {})), Words(3, "localhost"));
  const Rig rig = rigOf(4, {{.rank = 3, .display = "", .host = "floor"},
                            {.rank = 0, .display = "", .host = "front"},
                            {.rank = 1, .display = "", .host = "sides", .slots = 2}});
  EXPECT_EQ(hostsOf(rig), (Words{"front", "sides", "sides", "floor"})) << "whatever the order in the file";
}

TEST(MpirunLine, HostsThatCannotBeStartedAreNamed) {
  EXPECT_EQ(refusalOf(rigOf(4, {{.rank = 0, .display = "", .host = "front"},
                                {.rank = 2, .display = "", .host = "floor"}})),
            "node 1, 3 of the rig has no host though others have, expected a [[node]] with rank and host for "
            "each of nodes 0 to 3");
  EXPECT_EQ(refusalOf(rigOf(3, {{.rank = 0, .display = "", .host = "front"},
                                {.rank = 1, .display = "", .host = "sides"},
                                {.rank = 2, .display = "", .host = "front"}})),
            "node 2 of the rig is on host front again, expected the nodes of one host to follow each other");
}

TEST(MpirunLine, HasTheSlotsOfEachHostThenTheProgramAndItsArguments) {
  Rig rig = rigOf(3, {{.rank = 0, .display = "", .host = "front"},
                      {.rank = 1, .display = "", .host = "sides", .slots = 2}});
  EXPECT_EQ(mpirunLine(rig, "/bin/carom", {"cave", "--rig", "r.toml"}),
            (Words{"mpirun", "-n", "3", "--host", "front:1,sides:2", "--map-by", "slot", "--bind-to", "none",
                   "/bin/carom", "cave", "--rig", "r.toml"}));
  rig.start.network = "10.0.0.0/24";
  rig.start.environment = {"DISPLAY", "LANG=fr"};
  EXPECT_EQ(mpirunLine(rig, "carom", {}), (Words{"mpirun",
                                                 "-n",
                                                 "3",
                                                 "--host",
                                                 "front:1,sides:2",
                                                 "--map-by",
                                                 "slot",
                                                 "--bind-to",
                                                 "none",
                                                 "--mca",
                                                 "btl_tcp_if_include",
                                                 "10.0.0.0/24",
                                                 "--mca",
                                                 "oob_tcp_if_include",
                                                 "10.0.0.0/24",
                                                 "-x",
                                                 "DISPLAY",
                                                 "-x",
                                                 "LANG=fr",
                                                 "carom"}));
}

// The ports of the daemons and those of the nodes do not overlap, and together are those of the rig.
TEST(MpirunLine, SharesThePortsOfTheRigBetweenDaemonsAndNodes) {
  for (const int count : {8, 40, 41, 1000}) {
    SCOPED_TRACE(count);
    Rig rig = rigOf(1, {});
    rig.start.ports = StartSetup::Ports{20000, 20000 + count - 1};
    const Words words = mpirunLine(rig, "carom", {});
    const auto valueOfParameter = [&](const char* name) {
      const auto found = std::find(words.begin(), words.end(), name);
      return found == words.end() || found + 1 == words.end() ? std::string() : *(found + 1);
    };
    const std::string daemons = valueOfParameter("oob_tcp_dynamic_ipv4_ports");
    ASSERT_EQ(daemons.rfind("20000-", 0), 0u) << daemons;
    const int last = std::stoi(daemons.substr(6));
    EXPECT_GE(last - 20000 + 1, 4) << "daemons have four ports at least";
    for (const std::string version : {"v4", "v6"}) {
      const int first = std::stoi(valueOfParameter(("btl_tcp_port_min_" + version).c_str()));
      EXPECT_EQ(first, last + 1);
      EXPECT_EQ(first + std::stoi(valueOfParameter(("btl_tcp_port_range_" + version).c_str())),
                20000 + count);
    }
  }
}

// A shell prints each of its words with a mark behind it.
TEST(MpirunLine, AShellReadsTheWordsBack) {
  const std::string letters = "aZ09 '\"\\$`*?[]{}()<>|&;#!~=%,\t\n-_./:@+ü";
  std::mt19937 random(5);
  for (int number = 0; number < 40; ++number) {
    Words words{"", "plain/word-1.0"};
    for (int i = 0; i < 6; ++i) {
      std::string& word = words.emplace_back();
      for (auto k = random() % 9; k > 0; --k) word += letters[random() % letters.size()];
    }
    const std::string line = shellLine(words);
    SCOPED_TRACE(line);
    std::string printed;
    for (const std::string& word : words) printed += word + "|end";
    EXPECT_EQ(runTimed({"sh", "-c", "printf '%s|end' " + line}, 60.0, test::kGoOn).text, printed);
  }
  EXPECT_EQ(shellLine({"mpirun", "-n", "2", "a b"}), "mpirun -n 2 'a b'") << "plain words are not quoted";
}

TEST(MpirunLine, OptionsAreReadAndReplacedInBothForms) {
  const Words arguments{"--frames=3", "--session", "a.db", "--resume", "--sessions", "b.db"};
  EXPECT_EQ(valueOf(arguments, "--session"), "a.db");
  EXPECT_EQ(valueOf(arguments, "--frames"), "3");
  EXPECT_EQ(valueOf(arguments, "--rig"), "");
  EXPECT_EQ(valueOf({"--session"}, "--session"), "");
  for (const char* option : {"--session", "--frames", "--rig"}) {
    SCOPED_TRACE(option);
    const Words changed = withValue(arguments, option, "new");
    EXPECT_EQ(valueOf(changed, option), "new");
    EXPECT_EQ(valueOf(changed, "--sessions"), "b.db");
    EXPECT_EQ(changed.size(), arguments.size() + (std::string(option) == "--rig" ? 2 : 0));
  }
  EXPECT_EQ(startArguments("r.toml", {"--frames=3"}), (Words{"cave", "--rig", "r.toml", "--frames=3"}));
  EXPECT_EQ(resumedArguments(arguments, "c.db"),
            (Words{"cave", "--frames=3", "--session", "c.db", "--sessions", "b.db", "--resume"}));
}

}  // namespace
}  // namespace carom
