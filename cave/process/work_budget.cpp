#include "cave/process/work_budget.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <fstream>
#include <limits>

namespace carom {
namespace {

std::string& lastWords() {
  static auto* words = new std::string;  // outlives everything
  return *words;
}

double budget_s = std::numeric_limits<double>::infinity();

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double used_s(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  return secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
}

/// Ends the process; may be called by a signal.
[[noreturn]] void giveUp() {
  const std::string& words = lastWords();
  for (std::size_t at = 0; at < words.size();) {
    const ssize_t written = ::write(STDERR_FILENO, words.data() + at, words.size() - at);
    if (written <= 0) break;
    at += static_cast<std::size_t>(written);
  }
  ::_exit(1);
}

extern "C" void giveUpOnSignal(int) { giveUp(); }

void limitMemory(std::size_t more_bytes) {
  rlim_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;  // in pages
  std::ifstream("/proc/self/statm") >> total >> resident >> shared >> text >> library >> data;
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, data * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + more_bytes);
  if (data > 0) ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace

void begin(const WorkBudget& budget, const std::string& message) {
  lastWords() = "error: " + message + "\n";
  budget_s = budget.processor_s;
  std::signal(SIGPROF, giveUpOnSignal);
  std::set_terminate(giveUp);  // a library that cannot have memory and may not throw
  limitMemory(budget.memory_bytes);
  budgetLeft_s();
}

double budgetLeft_s() {
  if (!hasBudget()) return budget_s;
  const double left_s = std::max(1e-3, budget_s - used_s(RUSAGE_SELF) - used_s(RUSAGE_CHILDREN));
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(left_s);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (left_s - static_cast<double>(timer.it_value.tv_sec)));
  ::setitimer(ITIMER_PROF, &timer, nullptr);
  return left_s;
}

bool hasBudget() { return budget_s < std::numeric_limits<double>::infinity(); }

}  // namespace carom
