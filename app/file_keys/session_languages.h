#pragma once
// The languages of a session: which there are, and which of them each viewer reads at first.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/file_keys/language_name.h"
#include "cave/record/frame_state.h"

namespace carom {

struct SessionLanguages {
  /// Codes, or absolute paths of PO files: 1 to kMostLanguages, in the order in which key F9 goes through
  /// them.
  std::vector<std::string> all{kEnglish};
  std::array<std::uint8_t, kMostViewers> atStart{};  ///< of each viewer, an index into `all`
  bool hasTile = false;                              ///< the front wall has a tile that goes through them

  /// Returns the name of the language that a viewer reads at first.
  const std::string& firstOf(std::size_t viewer) const { return all.at(atStart.at(viewer)); }

  bool operator==(const SessionLanguages&) const = default;
};

/// Returns the number of a language in `languages`, where it is added if it is not there. Throws
/// std::runtime_error if there is no room for it.
std::uint8_t numberOf(SessionLanguages& languages, const std::string& language);

/// Returns the languages of a session that goes on: those that it had, in their order, and the others of
/// `now`, in which a viewer begins.
SessionLanguages goingOnWith(const SessionLanguages& before, const SessionLanguages& now);

/// Returns the languages that viewers read, by keys for files: `language`, or `language.NAME` for each where
/// they differ. `numbers` count them in `all`.
std::vector<std::pair<std::string, std::string>> languagesByViewer(std::span<const std::string> all,
                                                                   std::span<const std::uint8_t> numbers,
                                                                   std::span<const std::string> viewers);

/// Returns the same languages for a replay in `option` alone, whatever was recorded: as many, so that the
/// numbers in the records still have a language. Without an option, as they are.
SessionLanguages shownIn(SessionLanguages recorded, const std::string& option);

}  // namespace carom
