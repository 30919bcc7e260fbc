#include "app/nodes/timed_command.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstring>

namespace carom {
namespace {

constexpr std::size_t kMostText = 64 * 1024;
constexpr int kPoll_ms = 50;

/// A pipe whose ends close with it and are not inherited.
struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) ends = {-1, -1};
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeWriting() {
    close(ends[1]);
    ends[1] = -1;
  }

  std::array<int, 2> ends{-1, -1};
};

/// Starts the command in a process group of its own. Returns its process, or −1 with the reason in `text`.
pid_t start(const std::vector<std::string>& words, int output, std::string& text) {
  std::vector<std::string> copy = words;
  std::vector<char*> pointers;
  for (std::string& word : copy) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t usual;
  sigemptyset(&usual);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&usual, signal);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  pid_t process = -1;
  const int error = posix_spawnp(&process, pointers[0], &actions, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error == 0) return process;
  text = std::strerror(error);
  return -1;
}

/// Adds everything that waits in the pipe. Returns whether more may come.
bool drain(int end, std::string& text) {
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t got = read(end, block.data(), block.size());
    if (got <= 0) return got < 0;
    const std::size_t room = kMostText - std::min(kMostText, text.size());
    text.append(block.data(), std::min(room, static_cast<std::size_t>(got)));
  }
}

}  // namespace

CommandResult runTimed(const std::vector<std::string>& words, double limit_s,
                       const std::atomic<bool>& cancelled) {
  using Clock = std::chrono::steady_clock;
  CommandResult result;
  Pipe pipe;
  const pid_t process = start(words, pipe.ends[1], result.text);
  if (process < 0) return result;
  pipe.closeWriting();
  const auto until = Clock::now() + std::chrono::duration<double>(limit_s);
  int status = 0;
  bool hasOutput = true;
  // Its end counts, not that of its output: a process that it leaves behind may keep the pipe open.
  while (waitpid(process, &status, WNOHANG) == 0) {
    result.isCancelled = cancelled;
    result.isTooLate = !result.isCancelled && Clock::now() > until;
    if (result.isCancelled || result.isTooLate) {
      kill(-process, SIGKILL);
      waitpid(process, &status, 0);
      break;
    }
    pollfd waited{hasOutput ? pipe.ends[0] : -1, POLLIN, 0};
    poll(&waited, 1, kPoll_ms);
    if (hasOutput) hasOutput = drain(pipe.ends[0], result.text);
  }
  drain(pipe.ends[0], result.text);
  while (!result.text.empty() && (result.text.back() == '\n' || result.text.back() == '\r'))
    result.text.pop_back();
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

}  // namespace carom
