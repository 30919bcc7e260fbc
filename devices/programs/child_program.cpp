#include "devices/programs/child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "devices/tracker/retry.h"
#include "devices/wire/shown_name.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

constexpr auto kEndsWithin = 150ms;
constexpr std::size_t kMostErrors = 400;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail(const std::string& what, int error) {
  throw std::runtime_error(what + ": " + reason(error));
}

/// What posix_spawn does in the child.
class SpawnPlan {
 public:
  SpawnPlan(int output, int errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// Opens a new pseudo-terminal; returns −1 and sets errno if there is none.
int openTerminal() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0) return terminal;
  if (terminal >= 0) close(terminal);
  return -1;
}

/// Opens the program's end of a pseudo-terminal, which passes on every byte as it is.
int openProgramsEnd(int terminal) {
  std::array<char, 64> name{};
  if (ptsname_r(terminal, name.data(), name.size()) != 0) return -1;
  const int end = open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios mode{};
  if (end >= 0 && tcgetattr(end, &mode) == 0) {
    cfmakeraw(&mode);
    tcsetattr(end, TCSANOW, &mode);
  }
  return end;
}

/// The last line of a text that is not empty.
std::string lastLine(std::string_view text) {
  const std::size_t end = text.find_last_not_of("\r\n ");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  return shownName(text.substr(text.find_last_of('\n') + 1));
}

}  // namespace

ChildProgram::Descriptor::Descriptor(Descriptor&& other) noexcept
    : number_(std::exchange(other.number_, -1)) {}

ChildProgram::Descriptor& ChildProgram::Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

void ChildProgram::Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

ChildProgram::ChildProgram(const std::vector<std::string>& command) : output_(openTerminal()), errors_(-1) {
  if (output_.number() < 0) fail("no pseudo-terminal", errno);
  const Descriptor programsOutput(openProgramsEnd(output_.number()));
  if (programsOutput.number() < 0) fail("no pseudo-terminal", errno);
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) fail("no pipe", errno);
  errors_ = Descriptor(pipe[0]);
  const Descriptor programsErrors(pipe[1]);
  fcntl(pipe[1], F_SETFL, 0);  // the program's end may wait
  start(command, programsOutput.number(), programsErrors.number());
}

void ChildProgram::start(const std::vector<std::string>& command, int output, int errors) {
  const SpawnPlan plan(output, errors);
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error =
      posix_spawnp(&process_, arguments[0], plan.actions(), plan.attributes(), arguments.data(), environ);
  if (error == 0) return;
  process_ = -1;
  if (error == ENOENT)
    throw NeedsHelp("PATH has no program '" + command[0] + "', install it or name it there");
  fail('\'' + command[0] + "' cannot be started", error);
}

ChildProgram::~ChildProgram() {
  if (process_ < 0) return;
  kill(-process_, SIGTERM);
  hasEnded(kEndsWithin);
  kill(-process_, SIGKILL);  // of its group, too
  if (!status_) waitpid(process_, nullptr, 0);
}

bool ChildProgram::waitReadable(std::chrono::milliseconds longest) const {
  std::array<pollfd, 2> waiting{pollfd{output_.number(), POLLIN, 0}, pollfd{errors_.number(), POLLIN, 0}};
  return poll(waiting.data(), waiting.size(), static_cast<int>(longest.count())) > 0;
}

std::optional<std::size_t> ChildProgram::receive(std::span<std::uint8_t> bytes) {
  readErrors();
  const ssize_t count = read(output_.number(), bytes.data(), bytes.size());
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return {};
  return 0;  // EIO: the other end is closed
}

void ChildProgram::readErrors() {
  std::array<char, 4096> bytes;
  while (errors_.number() >= 0) {
    const ssize_t count = read(errors_.number(), bytes.data(), bytes.size());
    if (count < 0) return;
    if (count == 0) return errors_.close();  // poll leaves it out from now on
    lastErrors_.append(bytes.data(), static_cast<std::size_t>(count));
    if (lastErrors_.size() > kMostErrors) lastErrors_.erase(0, lastErrors_.size() - kMostErrors);
  }
}

bool ChildProgram::hasEnded(std::chrono::milliseconds within) {
  for (const auto end = std::chrono::steady_clock::now() + within; !status_;) {
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == process_) status_ = status;
    if (status_ || std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(2ms);
  }
  return status_.has_value();
}

std::string ChildProgram::howItEnded() {
  readErrors();
  std::string words = "closed its output";
  if (hasEnded(kEndsWithin)) {
    words = WIFSIGNALED(*status_) ? "was ended by signal " + std::to_string(WTERMSIG(*status_))
                                  : "ended with status " + std::to_string(WEXITSTATUS(*status_));
  }
  const std::string last = lastLine(lastErrors_);
  return last.empty() ? words : words + ": " + last;
}

}  // namespace carom
