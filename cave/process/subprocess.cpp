#include "cave/process/subprocess.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace carom {
namespace {

constexpr unsigned kMost_s = 60;
constexpr rlim_t kMoreMemory_bytes = 4ULL << 30U;
constexpr char kAnswer = 'a', kFailure = 'f';

void writeAll(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string readAll(int from) {
  std::string bytes;
  std::string block(1U << 20U, '\0');
  for (;;) {
    const ssize_t got = ::read(from, block.data(), block.size());
    if (got == 0 || (got < 0 && errno != EINTR)) return bytes;
    if (got > 0) bytes.append(block, 0, static_cast<std::size_t>(got));
  }
}

void limitMemory() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + kMoreMemory_bytes;
  if (limit.rlim_max == RLIM_INFINITY || limit.rlim_cur < limit.rlim_max) ::setrlimit(RLIMIT_AS, &limit);
  const rlimit noCore{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCore);
}

[[noreturn]] void runChild(const std::function<std::string()>& job, int to) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  // The messages that libraries print when they crash are not meant for the person.
  ::close(STDERR_FILENO);
  ::close(STDOUT_FILENO);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitMemory();
  ::alarm(kMost_s);
  std::string answer;
  try {
    answer = kAnswer + job();
  } catch (const std::bad_alloc&) {
    answer = std::string(1, kFailure) + "it asks for more memory than it may have";
  } catch (const std::exception& error) {
    answer = kFailure + std::string(error.what());
  }
  writeAll(to, answer);
  ::_exit(0);
}

std::string reasonOf(int status) {
  if (!WIFSIGNALED(status)) return "its reader ended without an answer";
  if (WTERMSIG(status) == SIGALRM) return "reading it takes over " + std::to_string(kMost_s) + " s";
  return "its reader breaks off";
}

}  // namespace

std::string runInSubprocess(const std::function<std::string()>& job) {
  int ends[2];
  if (::pipe(ends) != 0) throw SubprocessFailed(std::string("no pipe to a reader: ") + std::strerror(errno));
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    runChild(job, ends[1]);
  }
  ::close(ends[1]);
  const std::string answer = child > 0 ? readAll(ends[0]) : std::string();
  ::close(ends[0]);
  if (child < 0) throw SubprocessFailed(std::string("no process for a reader: ") + std::strerror(errno));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty())
    throw SubprocessFailed(reasonOf(status));
  if (answer.front() == kFailure) throw std::runtime_error(answer.substr(1));
  return answer.substr(1);
}

}  // namespace carom
