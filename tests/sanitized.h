#pragma once
// How much a test does in the builds with sanitizers. They look for faults of memory, arithmetic and threads,
// which a few hundred cases show as well as many thousand; the statistics are the optimised build's.

#include <initializer_list>
#include <vector>

namespace carom::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Returns how many of these cases to try: all, or a tenth of them with sanitizers, at least one.
template <typename Number>
constexpr Number casesOf(Number all) {
  return kSanitized && all > 10 ? all / 10 : kSanitized ? Number(1) : all;
}

/// Returns these cases; with sanitizers, the first alone.
template <typename Case>
std::vector<Case> someOf(std::initializer_list<Case> all) {
  return kSanitized ? std::vector<Case>{*all.begin()} : std::vector<Case>(all);
}

}  // namespace carom::test
