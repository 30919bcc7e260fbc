#include "app/study/study_report.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/toml/config_folder.h"
#include "engine/text/log.h"

extern char** environ;

namespace carom {
namespace {

/// Runs a program of the search path and waits for it. Returns its exit status; none if there is no such
/// program.
std::optional<int> statusOf(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (::posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return {};
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

int writeStudyReport(const std::filesystem::path& folder) {
  const std::filesystem::path responses = folder / "responses.csv";
  if (!std::filesystem::is_regular_file(responses))
    throw std::runtime_error(fmt::format(
        "{} is not there, expected a folder that carom study export has written", responses.string()));
  const auto hasLme4 = statusOf({"Rscript", "--vanilla", "-e",
                                 "quit(status = if (requireNamespace('lme4', quietly = TRUE)) 0 else 3)"});
  if (!hasLme4)
    throw std::runtime_error(
        "R is not installed, expected the packages r-base-core and r-cran-lme4: sudo apt install r-base-core "
        "r-cran-lme4");
  if (*hasLme4 == 3)
    throw std::runtime_error(
        "R has no package lme4, expected the package r-cran-lme4: sudo apt install r-cran-lme4");
  log::note("R computes models and intervals; of hundred people this takes some ten seconds.");
  const std::string script = (configFolder() / "studies" / "analyse.R").string();
  return statusOf({"Rscript", "--vanilla", script, folder.string()}).value_or(1);
}

}  // namespace carom
