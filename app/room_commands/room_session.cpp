#include "app/room_commands/room_session.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <ctime>
#include <string_view>

#include "app/journal/session_file.h"
#include "app/journal/session_series.h"
#include "app/nodes/mpirun_line.h"

namespace carom {
namespace {

/// Returns a name for the session file: that of the rig, and the time.
std::string sessionNameOf(const std::filesystem::path& rig) {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", std::localtime(&now));
  return fmt::format("{}-{}.db", rig.stem().string(), text.data());
}

/// Gives a session whose name has a date the name of today, with which it can go on later.
void settleDate(std::vector<std::string>& arguments, bool isToGoOn) {
  const auto dated = [&](const std::string& file) {
    return (isToGoOn ? namedToday(file) : datedFile(file)).string();
  };
  for (std::string& argument : arguments) {
    constexpr std::string_view kWithName = "--session=";
    if (&argument != arguments.data() && *(&argument - 1) == "--session")
      argument = dated(argument);
    else if (argument.starts_with(kWithName))
      argument = std::string(kWithName) + dated(argument.substr(kWithName.size()));
  }
}

}  // namespace

RoomSession::RoomSession(const std::filesystem::path& rig, std::vector<std::string> arguments)
    : rig_(rig), options_(caveOptionsOf(arguments)), arguments_(std::move(arguments)) {
  if (!valueOf(arguments_, "--rig").empty())
    throw CLI::ValidationError("--rig", "the rig is named already, expected it once, before what follows it");
  if (!options_.session) arguments_ = withValue(arguments_, "--session", sessionNameOf(rig));
  if (!options_.resume) settleDate(arguments_, options_.resumeOrNew);
  file_ = valueOf(arguments_, "--session");
  isAnothers_ = !options_.resume && !options_.resumeOrNew && std::filesystem::exists(file_);
  const auto before = progress();
  if (before && before->frame) firstFrame_ = *before->frame + 1;
}

std::optional<Progress> RoomSession::progress() const try {
  if (!std::filesystem::exists(file_)) return {};
  constexpr bool kQuiet = true;
  Progress reached{newestOf(file_)};
  if (const auto frames = SessionFile(reached.file, {}, kQuiet).frames()) reached.frame = frames->second;
  return reached;
} catch (const std::exception&) {
  return {};
}

bool RoomSession::isComplete(const std::optional<Progress>& reached) const {
  return options_.frames && reached && reached->frame &&
         *reached->frame + 1 >= firstFrame_ + *options_.frames;
}

std::vector<std::string> RoomSession::nextArguments(const std::optional<Progress>& reached) const {
  const bool hasMore = reached && (reached->frame ? *reached->frame + 1 : 0) > firstFrame_;
  if (options_.resume && !hasMore) return resumedArguments(arguments_, newestOf(file_).string());
  if (isAnothers_ || (options_.resumeOrNew && !hasMore)) return startArguments(rig_.string(), arguments_);
  std::vector<std::string> arguments = arguments_;
  if (!reached) {
    // A file that was cut off before it could be read is left as it is: the session gets the next name.
    if (std::filesystem::exists(file_)) arguments.emplace_back("--resume-or-new");
    return startArguments(rig_.string(), arguments);
  }
  // Its end and its first game are those with which it began.
  const std::uint64_t next = reached->frame ? *reached->frame + 1 : 0;
  if (const auto frames = options_.frames)
    arguments = withValue(arguments, "--frames", std::to_string(firstFrame_ + *frames - next));
  if (!options_.isUsualGame) arguments = withValue(arguments, "--scenario", options_.scenario.string());
  return resumedArguments(arguments, reached->file.string());
}

}  // namespace carom
