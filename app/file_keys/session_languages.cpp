#include "app/file_keys/session_languages.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace carom {
std::uint8_t numberOf(SessionLanguages& languages, const std::string& language) {
  std::vector<std::string>& all = languages.all;
  const auto found = std::find(all.begin(), all.end(), language);
  const auto number = static_cast<std::uint8_t>(found - all.begin());
  if (found != all.end()) return number;
  if (all.size() == kMostLanguages)
    throw std::runtime_error(fmt::format("a session has no room for the language {}, expected at most {}",
                                         language, kMostLanguages));
  all.push_back(language);
  return number;
}

SessionLanguages goingOnWith(const SessionLanguages& before, const SessionLanguages& now) {
  SessionLanguages languages{before.all, {}, now.hasTile};
  for (const std::string& language : now.all) numberOf(languages, language);
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
    languages.atStart[viewer] = numberOf(languages, now.firstOf(viewer));
  return languages;
}

std::vector<std::pair<std::string, std::string>> languagesByViewer(std::span<const std::string> all,
                                                                   std::span<const std::uint8_t> numbers,
                                                                   std::span<const std::string> viewers) {
  std::vector<std::pair<std::string, std::string>> named;
  const auto languageOf = [&](std::size_t viewer) { return all[numbers[viewer]]; };
  for (std::size_t viewer = 0; viewer < viewers.size(); ++viewer)
    named.emplace_back(fmt::format("language.{}", viewers[viewer]), languageOf(viewer));
  const bool isOne = std::all_of(named.begin(), named.end(),
                                 [&](const auto& one) { return one.second == named.front().second; });
  if (isOne) return {{"language", languageOf(0)}};
  return named;
}

SessionLanguages shownIn(SessionLanguages recorded, const std::string& option) {
  if (!option.empty()) std::fill(recorded.all.begin(), recorded.all.end(), option);
  return recorded;
}

}  // namespace carom
