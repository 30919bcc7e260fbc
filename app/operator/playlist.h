#pragma once
// The shipped games that a visitor reaches with one key, and the lessons in the order in which they build on
// one another.

#include <array>
#include <string>
#include <string_view>

namespace carom {

inline constexpr std::string_view kWelcome = "welcome", kShowMe = "show-me";
inline constexpr std::array<std::string_view, 13> kLessons{
    "comes-and-goes", "seen-at-once",  "seen-length",     "parallel-tracks", "two-cushions",
    "light-clock",    "twins",         "train-in-tunnel", "train-aboard",    "angles",
    "pairs-4",        "rolling-wheel", "spinning-disc"};

/// Returns the scenario file of a shipped game.
std::string fileOfGame(std::string_view name);

/// Returns the file of the lesson after the one in the file `playing`: the first one after the last, or if no
/// lesson is played.
std::string lessonAfter(const std::string& playing);

}  // namespace carom
