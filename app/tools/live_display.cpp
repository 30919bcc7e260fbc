#include "app/tools/live_display.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace carom {
namespace {

constexpr double kRefresh_s = 0.25;  // refresh interval on a terminal
constexpr double kReport_s = 1.0;    // interval otherwise

volatile std::sig_atomic_t wantsToEnd = 0;

}  // namespace

EndOnSignals::EndOnSignals() {
  wantsToEnd = 0;
  struct sigaction end {};
  end.sa_handler = [](int) { wantsToEnd = 1; };
  ::sigemptyset(&end.sa_mask);
  ::sigaction(SIGINT, &end, &interruptBefore_);
  ::sigaction(SIGTERM, &end, &terminateBefore_);
}

EndOnSignals::~EndOnSignals() {
  ::sigaction(SIGINT, &interruptBefore_, nullptr);
  ::sigaction(SIGTERM, &terminateBefore_, nullptr);
}

bool EndOnSignals::isAsked() { return wantsToEnd != 0; }

LiveDisplay::LiveDisplay() : isTerminal_(::isatty(STDOUT_FILENO) == 1) {}

double LiveDisplay::period_s() const { return isTerminal_ ? kRefresh_s : kReport_s; }

void LiveDisplay::show(const std::string& table, double now_s) {
  if (isTerminal_) {
    if (lines_ > 0) fmt::print("\033[{}A\033[J", lines_);
    fmt::print("\033[?7l{}\033[?7h", table);  // cuts lines that are too long instead of wrapping them
    lines_ = std::count(table.begin(), table.end(), '\n');
  } else {
    fmt::print("after {:.1f} s\n{}", now_s, table);
  }
  std::fflush(stdout);
}

}  // namespace carom
