#include "app/nodes/room_job.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "app/nodes/status_writer.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenLooks{20};
constexpr int kLooksAQuestion = 10;  // between two calls of isToStop

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The child's part: only what may be called between fork and exec.
[[noreturn]] void become(char* const* words) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  execvp(words[0], words);
  dprintf(STDERR_FILENO, "error: mpirun cannot be started: %s; expected the package openmpi-bin\n",
          std::strerror(errno));
  _exit(127);
}

pid_t start(const std::vector<std::string>& words) {
  std::vector<std::string> copy = words;
  std::vector<char*> pointers;
  for (std::string& word : copy) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  sigset_t ours, before;  // no signal may come to the child between fork and exec, where it would be lost
  sigemptyset(&ours);
  sigaddset(&ours, SIGINT);
  sigaddset(&ours, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ours, &before);
  const pid_t child = fork();
  if (child == 0) become(pointers.data());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw std::runtime_error(fmt::format("mpirun cannot be started: {}", std::strerror(errno)));
  return child;
}

/// Kills a process with all that it has started: mpirun's nodes have groups of their own.
void killWhole(pid_t process) {
  std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", process));
  std::vector<pid_t> children;
  for (pid_t child = 0; list >> child;) children.push_back(child);
  kill(process, SIGKILL);
  for (const pid_t child : children) kill(child, SIGKILL);
}

}  // namespace

JobEnd runJob(const std::vector<std::string>& words, const std::atomic<bool>& asked,
              const std::function<bool()>& isToStop, double ends_s) {
  const pid_t job = start(words);
  JobEnd end;
  std::optional<Clock::time_point> terminated;
  bool isKilled = false;
  int status = 0;
  for (int look = 1; waitpid(job, &status, WNOHANG) == 0; ++look) {
    std::this_thread::sleep_for(kBetweenLooks);
    if (!terminated) {
      end.wasAsked = asked;
      end.wasStopped = !end.wasAsked && look % kLooksAQuestion == 0 && isToStop();
      if (!end.wasAsked && !end.wasStopped) continue;
      kill(job, SIGTERM);
      terminated = Clock::now();
    } else if (!isKilled && since_s(*terminated) > ends_s) {
      killWhole(job);
      isKilled = true;
    }
  }
  end.wasAsked = end.wasAsked || asked;
  end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return end;
}

JobWatch::JobWatch(std::filesystem::path status, double starts_s, double ends_s)
    : status_(std::move(status)), starts_s_(starts_s), ends_s_(ends_s) {}

std::string JobWatch::look(double elapsed_s) {
  const ReadStatus now = readStatus(status_);
  const bool isSession = now.process > 0 && now.process != getpid();
  if (isSession && now.frame) {
    if (firstFrame_s_ < 0.0) firstFrame_s_ = elapsed_s;
    // At least a little: a look may have come late.
    played_s_ = std::max(elapsed_s - firstFrame_s_, std::numeric_limits<double>::min());
  } else if (firstFrame_s_ < 0.0 && elapsed_s > starts_s_) {
    return fmt::format("the nodes have shown no frame {:.0f} s after their start", elapsed_s);
  }
  if (!isSession || kill(now.process, 0) == 0) return {};
  if (ended_s_ < 0.0) ended_s_ = elapsed_s;
  if (elapsed_s - ended_s_ < ends_s_) return {};
  return fmt::format("node 0 has ended and mpirun has not, {:.0f} s later", elapsed_s - ended_s_);
}

}  // namespace carom
