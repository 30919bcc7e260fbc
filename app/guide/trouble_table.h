#pragma once
// The messages of the program and what helps, as the page "Running a room" lists them, found by their words.

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// A row of the page: a message of the program, or something that a person sees.
struct Trouble {
  std::string says;     ///< as the page shows it; "…" stands for what differs from case to case
  std::string meaning;  ///< and what helps
  using Words = std::set<std::string>;
  std::vector<std::string> messages;  ///< each of the messages in `says`
  std::vector<Words> words;           ///< by which each of them is known
};

/// Returns the rows of the page's tables, in their order.
std::vector<Trouble> troublesOf(std::string_view page);
/// Returns those of the page that the program was built with.
const std::vector<Trouble>& troubles();

/// Returns the rows whose message is most like `words`, the best first, at most three; empty if none is.
/// Words are compared, whatever stands between them; numbers, quoted names, paths and places in files are
/// not.
std::vector<const Trouble*> nearestTroubles(const std::vector<Trouble>& rows, std::string_view words);

}  // namespace carom
