#include "cave/process/termination.h"
#include "engine/text/log.h"

#include <semaphore.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace carom {
namespace {

constexpr std::chrono::milliseconds kPatience{1500};
// Open MPI 4.1's mpirun, asked to end, sends SIGTERM after a second and SIGKILL after another.
constexpr std::chrono::milliseconds kMpirunsPatience{800};

volatile std::sig_atomic_t asked = 0;  // the first signal that was received
std::atomic<bool> allClosed = false;
sem_t wasAsked;

extern "C" void ask(int signal) {
  if (asked && signal == SIGINT) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  const int error = errno;
  if (!asked) asked = signal;
  sem_post(&wasAsked);
  errno = error;
}

std::mutex& mutexOfOpen() {
  static auto* mutex = new std::mutex;  // outlives objects that are destroyed late
  return *mutex;
}
std::vector<const std::function<void()>*>& open() {
  static auto* all = new std::vector<const std::function<void()>*>;
  return *all;
}

/// Waits until the end is requested, and then gives the other threads a little time to end by themselves.
void endIfNobodyDoes() {
  while (sem_wait(&wasAsked) != 0) {
  }
  const bool byMpirun = asked == SIGTERM && std::getenv("OMPI_COMM_WORLD_SIZE");
  std::this_thread::sleep_for(byMpirun ? kMpirunsPatience : kPatience);
  const bool whole = closeAll();
  if (whole && !allClosed)
    log::note("Asked to end: what was begun is not waited for; what was written is whole.");
  std::fflush(nullptr);
  std::_Exit(whole ? 0 : 1);
}

}  // namespace

void noticeTermination() {
  sem_init(&wasAsked, 0, 0);
  std::thread(endIfNobodyDoes).detach();
  std::signal(SIGINT, ask);
  std::signal(SIGTERM, ask);
}

bool terminationAsked() { return asked != 0; }

bool closeAll() {
  mutexOfOpen().lock();  // never unlocked
  bool whole = true;
  for (auto close = open().rbegin(); close != open().rend(); ++close) {
    try {
      (**close)();
    } catch (const std::exception& error) {
      log::error(error.what());
      whole = false;
    }
  }
  return whole;
}

ClosedOnLeaving::ClosedOnLeaving(std::function<void()> close) : close_(std::move(close)) {
  const std::scoped_lock hold(mutexOfOpen());
  open().push_back(&close_);
}

ClosedOnLeaving::~ClosedOnLeaving() {
  const std::scoped_lock hold(mutexOfOpen());
  std::erase(open(), &close_);
}

void leave(const std::function<void()>& last) {
  allClosed = true;
  last();
  std::fflush(nullptr);
  std::_Exit(0);
}

}  // namespace carom
