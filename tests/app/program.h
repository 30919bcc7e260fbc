#pragma once
// Runs carom as a person does, from the shell.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/temporary_folder.h"
#include "places.h"

namespace carom::test {

inline const std::string kThreePucks = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";

struct ProgramResult {
  int status = -1;
  std::string out;
  std::string err;
};

/// `arguments` reach the program as they are.
inline ProgramResult runCarom(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  std::string command = CAROM_PROGRAM;
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  const auto out = folder / "stdout.txt", err = folder / "stderr.txt";
  const int ended = std::system((command + " >'" + out.string() + "' 2>'" + err.string() + "'").c_str());
  ProgramResult result{WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, contentOf(out), contentOf(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return result;
}

/// A number as files take it: bit for bit.
inline std::string exact(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// Returns what a command that takes a scenario, given as text, answers as JSON; null, with the test failed,
/// where it ends with an error.
inline nlohmann::json answerOf(const TemporaryFolder& folder, const std::string& command,
                               const std::string& scenario, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{command, folder.file("scenario.toml", scenario), "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = runCarom(folder, arguments);
  EXPECT_EQ(result.status, 0) << result.err << scenario;
  return result.status == 0 ? nlohmann::json::parse(result.out) : nlohmann::json();
}

}  // namespace carom::test
