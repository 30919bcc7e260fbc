#include "engine/text/log.h"

#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

#include "engine/text/printable.h"

namespace carom::log {
namespace {

void toStandardError(Level level, std::string_view line) {
  std::string text(prefixOf(level));
  text.append(line).push_back('\n');
  std::fwrite(text.data(), 1, text.size(), stderr);
}

struct Log {
  std::mutex mutex;
  Sink sink = toStandardError;
};

Log& theLog() {
  static auto* log = new Log;  // outlives threads that speak late
  return *log;
}

/// Names and texts from outside may have control characters, which would change what the terminal shows.
void say(Level level, std::string_view line) {
  const std::scoped_lock hold(theLog().mutex);
  theLog().sink(level, printable(line, "\n\t"));
}

}  // namespace

Sink replaceSink(Sink sink) {
  const std::scoped_lock hold(theLog().mutex);
  return std::exchange(theLog().sink, std::move(sink));
}

std::string_view prefixOf(Level level) {
  switch (level) {
    case Level::warning:
      return "warning: ";
    case Level::error:
      return "error: ";
    default:
      return "";
  }
}

void note(std::string_view line) { say(Level::note, line); }
void warn(std::string_view line) { say(Level::warning, line); }
void error(std::string_view line) { say(Level::error, line); }

}  // namespace carom::log
