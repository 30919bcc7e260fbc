#include "cave/termination.h"

#include <csignal>

namespace carom {
namespace {

volatile std::sig_atomic_t asked = 0;

extern "C" void ask(int signal) {
  if (asked && signal == SIGINT) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  asked = 1;
}

}  // namespace

void noticeTermination() {
  std::signal(SIGINT, ask);
  std::signal(SIGTERM, ask);
}

bool terminationAsked() { return asked != 0; }

}  // namespace carom
