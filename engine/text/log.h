#pragma once
// What the program says to the person who runs it, line by line.

#include <functional>
#include <string_view>

namespace carom::log {

enum class Level { note, warning, error };

/// Receives each line, without its end. May be called from any thread, from one at a time. Must not log.
using Sink = std::function<void(Level, std::string_view)>;

/// Puts another sink in the place of the present one, which it returns. The first one writes to standard
/// error.
Sink replaceSink(Sink sink);

/// A line as it is for people: a warning begins with "warning: ", an error with "error: ".
std::string_view prefixOf(Level level);

void note(std::string_view line);
void warn(std::string_view line);
void error(std::string_view line);

}  // namespace carom::log
