#include "app/commands/room.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <future>
#include <map>
#include <memory>
#include <optional>

#include "app/commands/cave_options.h"
#include "app/commands/mpirun_line.h"
#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/journal/session_file.h"
#include "app/journal/session_series.h"
#include "app/tools/option_values.h"
#include "engine/base/log.h"

namespace carom {
namespace {

constexpr int kAnswers_s = 5;  // how long a host may take to answer

volatile std::sig_atomic_t asked = 0;  // someone asked for the end
volatile pid_t running = 0;            // mpirun

extern "C" void passOn(int) {
  asked = 1;
  if (running > 0) kill(running, SIGTERM);
}

std::string ownProgram() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

std::string ownHost() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

bool isHere(const std::string& host) { return host == "localhost" || host == ownHost(); }

/// Returns what a command prints, of both of its outputs, and its exit status.
std::pair<std::string, int> outputOf(const std::vector<std::string>& words) {
  const std::string line = shellLine(words) + " 2>&1 </dev/null";
  std::FILE* const pipe = popen(line.c_str(), "r");
  if (!pipe) return {std::strerror(errno), -1};
  std::string text;
  std::array<char, 4096> block{};
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe))
    text.append(block.data(), got);
  const int status = pclose(pipe);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return {printable(text), WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

std::string_view lastLineOf(std::string_view text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

/// Returns what is wrong with a host: it does not answer, or its program is missing or another version. Empty
/// if nothing is.
std::string faultOf(const std::string& host, const std::string& program) {
  const auto [said, status] =
      outputOf({"ssh", "-o", "BatchMode=yes", "-o", "LogLevel=ERROR", "-o",
                fmt::format("ConnectTimeout={}", kAnswers_s), host, program, "--version"});
  if (status == 255)  // of ssh itself
    return fmt::format("host {} does not answer: {}, expected to reach it by ssh without a password", host,
                       said);
  if (status != 0)
    return fmt::format("host {} does not run {}: {}, expected {} there", host, program, said, CAROM_VERSION);
  if (lastLineOf(said) == CAROM_VERSION) return {};  // shells may greet or warn before it
  return fmt::format("host {} has another version, {}, expected {} as here", host, said, CAROM_VERSION);
}

/// Asks all other hosts at once. Returns whether every one of them can take part; logs those that cannot.
bool allAnswer(const std::vector<std::string>& hosts, const std::string& program) {
  std::map<std::string, std::future<std::string>> answers;
  for (const std::string& host : hosts) {
    if (isHere(host) || answers.contains(host)) continue;
    answers[host] = std::async(std::launch::async, faultOf, host, program);
  }
  bool all = true;
  for (auto& [host, answer] : answers) {
    const std::string fault = answer.get();
    if (fault.empty()) continue;
    log::error(fault);
    all = false;
  }
  return all;
}

/// Runs mpirun in a process group of its own, so that Ctrl-C in the terminal reaches it through us alone.
/// Returns its exit status.
int run(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  std::vector<std::string> copy = words;
  for (std::string& word : copy) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  sigset_t ours, before;  // no signal may come to the child between fork and exec, where it would be lost
  sigemptyset(&ours);
  sigaddset(&ours, SIGINT);
  sigaddset(&ours, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ours, &before);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  } else {
    running = child;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw std::runtime_error(fmt::format("mpirun cannot be started: {}", std::strerror(errno)));
  if (child == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    execvp(pointers[0], pointers.data());
    std::fprintf(stderr, "error: mpirun cannot be started: %s; expected the package openmpi-bin\n",
                 std::strerror(errno));
    _exit(127);
  }
  if (asked) kill(child, SIGTERM);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  running = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// How far a session has come: its newest file, and the last frame there.
struct Progress {
  std::filesystem::path file;
  std::uint64_t frame = 0;

  bool operator==(const Progress&) const = default;
};

/// Returns how far a session has come, or none if it cannot be read.
std::optional<Progress> progressOf(const std::filesystem::path& session) try {
  if (!std::filesystem::exists(session)) return {};
  constexpr bool kQuiet = true;
  const std::filesystem::path newest = newestOf(session);
  const auto frames = SessionFile(newest, {}, kQuiet).frames();
  return Progress{newest, frames ? frames->second : 0};  // a game may have begun and shown nothing yet
} catch (const std::exception&) {
  return {};
}

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

void noticeSignals() {
  struct sigaction action {};
  action.sa_handler = passOn;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// A session of `carom room`.
struct RoomSession {
  CaveOptions options;                 ///< as the arguments name them
  std::vector<std::string> arguments;  ///< with a name for the session
  std::filesystem::path file;
};

/// Returns the session that the arguments ask for. Throws CLI::ParseError, or what is wrong with its game.
RoomSession sessionOf(const RoomOptions& options, const Rig& rig) {
  RoomSession session{caveOptionsOf(options.arguments), options.arguments, {}};
  if (!valueOf(session.arguments, "--rig").empty())
    throw CLI::ValidationError("--rig", "the rig is named already, expected it once, before what follows it");
  if (!session.options.session)
    session.arguments = withValue(session.arguments, "--session", sessionNameOf(options.rig));
  if (!session.options.resume) settleDate(session.arguments, session.options.resumeOrNew);
  session.file = valueOf(session.arguments, "--session");
  if (isHere(hostsOf(rig).front()) && !session.options.scenario.empty())
    readScenario(session.options.scenario);
  return session;
}

/// Returns the arguments of carom with which the session goes on after a frame: its end and its first game are those
/// with which it began.
std::vector<std::string> argumentsAfter(const RoomSession& session, const Progress& reached,
                                        std::uint64_t firstFrame) {
  std::vector<std::string> arguments = session.arguments;
  if (const auto frames = session.options.frames)
    arguments = withValue(arguments, "--frames", std::to_string(firstFrame + *frames - 1 - reached.frame));
  if (!session.options.isUsualGame)
    arguments = withValue(arguments, "--scenario", session.options.scenario.string());
  return resumedArguments(arguments, reached.file.string());
}

/// Runs the session, and again from where it was cut off as long as it gets further.
int runSession(const Rig& rig, const std::string& program, const RoomSession& session,
               std::vector<std::string> line) {
  auto before = progressOf(session.file);
  const std::uint64_t firstFrame = before ? before->frame + 1 : 0;
  for (;;) {
    const int status = run(line);
    if (asked) return 0;  // mpirun calls the end that was asked for a failure
    if (status == 0) return 0;
    const auto reached = progressOf(before ? before->file : session.file);
    if (!reached || reached == before) return 1;  // it would fail again: it has shown nothing new
    if (session.options.frames && reached->frame + 1 >= firstFrame + *session.options.frames) return status;
    before = reached;
    log::warn(fmt::format("the session was cut off after frame {}: it goes on by itself.", reached->frame));
    line = mpirunLine(rig, program, argumentsAfter(session, *reached, firstFrame));
  }
}

/// Returns the line of mpirun that begins the session, or goes on with it.
std::vector<std::string> firstLine(const Rig& rig, const std::string& program, const RoomOptions& options,
                                   const RoomSession& session) {
  if (session.options.resume)
    return mpirunLine(rig, program, resumedArguments(session.arguments, newestOf(session.file).string()));
  return mpirunLine(rig, program, startArguments(options.rig.string(), session.arguments));
}

}  // namespace

int runRoom(const RoomOptions& options) {
  const Rig rig = readRig(options.rig);
  const std::string program = ownProgram(), leader = hostsOf(rig).front();
  const bool isSession = !options.doctor && !options.pattern;
  const RoomSession session = isSession ? sessionOf(options, rig) : RoomSession{};
  std::vector<std::string> line;
  if (isSession) line = firstLine(rig, program, options, session);
  if (options.doctor) line = mpirunLine(rig, program, {"doctor", options.rig.string()});
  if (options.pattern) line = mpirunLine(rig, program, {"check", options.rig.string(), "--pattern"});
  if (options.lineOnly) {
    fmt::print("{}\n", shellLine(line));
    return 0;
  }
  if (!allAnswer(hostsOf(rig), program)) return 1;
  if (isSession && !isHere(leader)) {
    log::warn(
        fmt::format("node 0 is {}, not this computer: the session file lies there, so a session that loses a "
                    "node does not go on by itself",
                    leader));
  }
  noticeSignals();
  return isSession ? runSession(rig, program, session, line) : run(line);
}

void addRoom(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "room", "Start a session on every host of a rig by mpirun, and again if it loses a node");
  auto options = std::make_shared<RoomOptions>();
  command->add_flag("--line", options->lineOnly, "Print the line of mpirun and start nothing");
  auto* doctor =
      command->add_flag("--doctor", options->doctor, "Say instead what every node has: carom doctor RIG");
  command
      ->add_flag("--pattern", options->pattern, "Show the test patterns instead: carom check RIG --pattern")
      ->excludes(doctor);
  command
      ->add_option("RIG", options->rig,
                   "Rig file; a [[node]] with a host for each rank that is on another computer")
      ->required()
      ->transform(shipped({"rigs"}));
  command->prefix_command();
  command->footer(
      "Examples:\n  carom room my-cave.toml --scenario twins --session monday.db\n"
      "  carom room --doctor my-cave.toml\n"
      "What follows the rig are arguments of carom cave. Without --session, the session is written to a new "
      "file\nhere, RIG-DATE-TIME.db, from which it goes on if a node is lost.");
  command->callback([=, &status] {
    options->arguments = command->remaining();
    status = runRoom(*options);
  });
}

}  // namespace carom
