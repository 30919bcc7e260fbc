#pragma once
// The lines that the program logs while this lives, instead of printing them. They may come from any thread.

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/text/log.h"

namespace carom::test {

class LogLines {
 public:
  LogLines()
      : before_(log::replaceSink([this](log::Level level, std::string_view line) {
          const std::scoped_lock hold(mutex_);
          said_.push_back(std::string(log::prefixOf(level)) + std::string(line));
        })) {}
  ~LogLines() { log::replaceSink(std::move(before_)); }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  std::vector<std::string> said() const {
    const std::scoped_lock hold(mutex_);
    return said_;
  }
  void waitFor(std::size_t lines) const {
    using namespace std::chrono_literals;
    for (int wait = 0; wait < 2000 && said().size() < lines; ++wait) std::this_thread::sleep_for(10ms);
    ASSERT_EQ(said().size(), lines);
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> said_;
  log::Sink before_;
};

/// Fails the test for each line that is logged while it lives.
class NothingIsLogged {
 public:
  ~NothingIsLogged() { EXPECT_EQ(lines_.said(), std::vector<std::string>()); }

 private:
  LogLines lines_;
};

}  // namespace carom::test
