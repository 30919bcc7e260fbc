#pragma once
// What commands share that show devices while they run.

#include <csignal>
#include <string>

namespace carom {

/// While it lives, SIGINT and SIGTERM end the monitoring instead of the program. One at a time.
class EndOnSignals {
 public:
  EndOnSignals();
  EndOnSignals(const EndOnSignals&) = delete;
  EndOnSignals& operator=(const EndOnSignals&) = delete;
  ~EndOnSignals();

  static bool isAsked();

 private:
  struct sigaction interruptBefore_ {};
  struct sigaction terminateBefore_ {};
};

/// Prints a table: on a terminal in place of the previous one, otherwise below it.
class LiveDisplay {
 public:
  LiveDisplay();
  double period_s() const;
  void show(const std::string& table, double now_s);

 private:
  bool isTerminal_;
  long lines_ = 0;
};

}  // namespace carom
