// The command line: help that teaches, 2 for wrong arguments, 1 for bad input, and nothing half-written.

#include <gtest/gtest.h>

#include "app/program.h"

namespace carom {
namespace {

using test::kThreePucks;
using test::runCarom;
using test::TemporaryFolder;

TEST(Options, HelpTeaches) {
  const TemporaryFolder folder;
  const auto help = runCarom(folder, {"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"simulate", "observe", "check", "filter", "track"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const auto own = runCarom(folder, {command, "--help"});
    EXPECT_EQ(own.status, 0);
    EXPECT_NE(own.out.find("Example"), std::string::npos) << own.out;
  }
  EXPECT_EQ(runCarom(folder, {"--version"}).out.rfind("carom ", 0), 0u);
}

TEST(Options, MistypedNamesAreToldWhatThereIs) {
  const TemporaryFolder folder;
  const auto said = [&](const std::vector<std::string>& arguments) {
    const auto result = runCarom(folder, arguments);
    EXPECT_EQ(result.status, 2) << result.err;
    return result.err.substr(0, result.err.find('\n'));
  };
  EXPECT_EQ(said({"cave", "--lesson", "banana"}),
            "error: --lesson: 'banana' is wrong, expected one of asks, shows, explains");
  EXPECT_EQ(said({"cave", "--scenario", "tabel"}),
            "error: --scenario: there is no file 'tabel', expected 'table'?");
  EXPECT_EQ(said({"cave", "--rig", "desc"}), "error: --rig: there is no file 'desc', expected 'desk'?");
  EXPECT_NE(said({"cave", "--rig", "xyzzy"}).find("expected a file, or one of cylinder, desk, desk-two, "),
            std::string::npos);
  EXPECT_EQ(said({"cav"}), "error: 'cav' is no command, expected 'cave'?");
  EXPECT_EQ(said({"cave", "--pin", "12"}), "error: --pin: '12' is wrong, expected 3 to 12 digits");
  EXPECT_EQ(said({"cave", "--pin", "12e4"}), "error: --pin: '12e4' is wrong, expected 3 to 12 digits");
}

TEST(Options, WrongArgumentsEndWithTwo) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"dance"},
      {"simulate"},
      {"simulate", kThreePucks},
      {"simulate", kThreePucks, "--until", "soon"},
      {"simulate", kThreePucks, "--until", "1x"},
      {"simulate", kThreePucks, "--until", "nan"},
      {"simulate", kThreePucks, "--until", "-1"},
      {"simulate", kThreePucks, "--until", "1", "--every", "0"},
      {"simulate", kThreePucks, "--until", "1e6", "--every", "1e-3"},
      {"simulate", kThreePucks, "--until", "1", "--sideways"},
      {"simulate", kThreePucks, kThreePucks, "--until", "1"},
      {"observe", kThreePucks},
      {"observe", kThreePucks, "--event", "0", "0", "0"},
      {"observe", kThreePucks, "--event", "0", "0", "0", "inf"},
      {"observe", kThreePucks, "--event", "0", "0", "0", "0", "--beta", "0.8", "0.6", "0"},
      {"observe", kThreePucks, "--event", "0", "0", "0", "0", "--point", "white", "0", "0"},
      {"observe", kThreePucks, "--event", "0", "0", "0", "0", "--point", "white", "0", "0", "nan"},
      {"observe", kThreePucks, "--event", "0", "0", "0", "0", "--point", "whit", "0", "0", "0"},
      {"check"},
      {"cave", "--switch", "colour"},
      {"cave", "--switch", "colour=maybe"},
      {"cave", "--switch", "smell=on"},
  };
  for (const auto& arguments : wrong) {
    std::string line;
    for (const std::string& argument : arguments) line += ' ' + argument;
    const auto result = runCarom(folder, arguments);
    EXPECT_EQ(result.status, 2) << line;
    EXPECT_EQ(result.err.rfind("error: ", 0), 0u) << line << '\n' << result.err;
    EXPECT_EQ(result.out, "") << line;
  }
}

TEST(Options, BadInputEndsWithOneAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string bad =
      folder.file("bad.toml", "light_speed_m_s = 1.42\n[board]\nlength_m = 2.84\nwidth = 1.42\n");
  const std::string out = folder / "out.json";
  const std::vector<std::vector<std::string>> commands{
      {"simulate", bad, "--until", "1", "--json", out},
      {"observe", bad, "--event", "0", "0", "0", "0", "--json", out},
      {"check", bad},
  };
  for (const auto& arguments : commands) {
    const auto result = runCarom(folder, arguments);
    EXPECT_EQ(result.status, 1) << arguments[0];
    EXPECT_EQ(result.err, "error: " + bad + ":4:1: unknown key 'width', expected 'width_m'?\n")
        << arguments[0];
    EXPECT_EQ(result.out, "") << arguments[0];
    EXPECT_EQ(folder.entries(), 1) << arguments[0];
  }
}

TEST(Options, EveryFaultOfAFileIsTold) {
  const TemporaryFolder folder;
  const std::string bad =
      folder.file("bad.toml", "light_speed_m_s = 0\ntitel = 'x'\n[physics]\nfriction_m_s2 = 'a lot'\n");
  const auto result = runCarom(folder, {"check", bad});
  EXPECT_EQ(result.status, 1);
  for (const char* place : {":1:19: ", ":2:1: ", ":4:17: "}) {
    EXPECT_NE(result.err.find("error: " + bad + place), std::string::npos) << place << '\n' << result.err;
  }
}

TEST(Options, AbsentFilesAndUnwritablePlacesAreSaid) {
  const TemporaryFolder folder;
  const auto absent = runCarom(folder, {"simulate", folder / "no.toml", "--until", "1"});
  EXPECT_EQ(absent.status, 1);
  EXPECT_EQ(absent.err.rfind("error: " + (folder / "no.toml").string() + ":1:1: ", 0), 0u) << absent.err;
  const auto unwritable =
      runCarom(folder, {"simulate", kThreePucks, "--until", "1", "--json", folder / "no/out.json"});
  EXPECT_EQ(unwritable.status, 1);
  EXPECT_EQ(unwritable.err.rfind("error: ", 0), 0u) << unwritable.err;
}

}  // namespace
}  // namespace carom
