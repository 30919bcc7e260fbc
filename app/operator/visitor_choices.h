#pragma once
// The shipped games that a visitor reaches with one key, and the lessons in the order in which they build on
// one another.

#include <array>
#include <string>
#include <string_view>

#include "app/operator/command.h"
#include "cave/record/choice.h"

namespace carom {

inline constexpr std::string_view kWelcome = "welcome", kShowMe = "show-me", kTasks = "tasks";
inline constexpr std::string_view kTwoCities = "two-cities";
inline constexpr std::array<std::string_view, 23> kLessons{
    "comes-and-goes", "seen-at-once",      "seen-length",     "parallel-tracks", "same-laws",
    "two-cushions",   "bar-meets-bar",     "cause",           "one-spacetime",   "light-clock",
    "twins",          "twins-in-one-room", "train-in-tunnel", "train-aboard",    "pairs-4",
    "angles",         "mass-energy",       "heavier",         "rolling-wheel",   "spinning-disc",
    "solid",          "bell-string",       "soft-and-rigid"};

/// Returns the scenario file of a shipped game.
std::string fileOfGame(std::string_view name);

/// Returns the number of the shipped lesson in this file, from 0, or how many there are if it is none.
std::size_t numberOfLesson(const std::string& file);

/// Returns the file of the lesson after the one in this file: the first one after the last, or if the file is
/// no lesson. `canWalk`: somebody can walk about, which one of the lessons is about; otherwise it is left
/// out.
std::string lessonAfter(const std::string& file, bool canWalk = true);
inline constexpr std::string_view kLessonOfWalkers = "twins-in-one-room";

/// Returns the command that carries out a visitor's choice. The lessons go on after the one seen last. With a
/// playlist, only its games are played: its first one, and its lessons in their order; what it does not have
/// is told to the person.
Command commandOf(Choice choice, const OperatorSettings& settings);

/// Returns the command that begins the shipped tasks, or tells the person that a playlist has none.
Command beginTasks(const OperatorSettings& settings);

/// Returns the command that lets a viewer read the next of the session's languages, or tells the person that
/// there is one only.
Command nextLanguage(const OperatorSettings& settings, std::size_t viewer);

/// Returns the command that goes on to the next task of the game, after the last one to the first.
Command nextTask(const OperatorSettings& settings);

}  // namespace carom
