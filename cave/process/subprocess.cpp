#include "cave/process/subprocess.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cave/process/work_budget.h"

namespace carom {
namespace {

constexpr unsigned kMost_s = 60;
constexpr rlim_t kMoreMemory_bytes = 4ULL << 30U;
constexpr char kAnswer = 'a', kFailure = 'f', kNoMemory = 'm';

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

/// Ends this process when it has used the share of a budget; some of it stays for the process that waits for
/// it.
void limitTime(double left_s) {
  ::alarm(kMost_s);
  if (!hasBudget()) return;
  constexpr double kShare = 0.8;
  const double most_s = std::max(0.01, kShare * left_s);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(most_s);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (most_s - static_cast<double>(timer.it_value.tv_sec)));
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

[[noreturn]] void runChild(const std::function<std::string()>& job, double left_s, int to) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGPROF, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  // The messages that libraries print when they crash are not meant for the person.
  ::close(STDERR_FILENO);
  ::close(STDOUT_FILENO);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitMemory();
  std::set_terminate(std::abort);
  limitTime(left_s);
  std::string answer;
  try {
    answer = kAnswer + job();
  } catch (const std::bad_alloc&) {
    answer = kNoMemory;
  } catch (const std::exception& error) {
    answer = kFailure + std::string(error.what());
  }
  writeAll(to, answer);
  ::_exit(0);
}

[[noreturn]] void failFor(int status) {
  if (!WIFSIGNALED(status)) throw SubprocessFailed("its reader ended without an answer");
  if (WTERMSIG(status) == SIGALRM)
    throw JobTooLarge("reading it takes over " + std::to_string(kMost_s) + " s");
  if (WTERMSIG(status) == SIGPROF) throw JobTooLarge("reading it takes longer than it may here");
  throw SubprocessFailed("its reader breaks off");
}

}  // namespace

std::string runInSubprocess(const std::function<std::string()>& job) {
  int ends[2];
  if (::pipe(ends) != 0) throw SubprocessFailed(std::string("no pipe to a reader: ") + std::strerror(errno));
  const double left_s = budgetLeft_s();
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    runChild(job, left_s, ends[1]);
  }
  ::close(ends[1]);
  const std::string answer = child > 0 ? readAll(ends[0]) : std::string();
  ::close(ends[0]);
  if (child < 0) throw SubprocessFailed(std::string("no process for a reader: ") + std::strerror(errno));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  budgetLeft_s();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty()) failFor(status);
  if (answer.front() == kNoMemory) throw JobTooLarge("it asks for more memory than it may have");
  if (answer.front() == kFailure) throw std::runtime_error(answer.substr(1));
  return answer.substr(1);
}

}  // namespace carom
