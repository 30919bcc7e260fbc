#pragma once
// A room of three walls, and rooms that differ from it by one mistake.

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/room_checks/rig_room.h"
#include "app/temporary_folder.h"

namespace carom::test {

/// A room of three walls, a rank each, nothing odd about it. Line i is kRoom[i - 1].
inline const std::vector<std::string> kRoom{
    "unit = 'm'",
    "axes = 'x-right y-up z-back'",
    "[head]",
    "tracker = 'cap'",
    "eye_separation = 0.064",
    "[[tracker]]",
    "name = 'cap'",
    "kind = 'simulated'",
    "[[wall]]",
    "name = 'front'",
    "lower_left = [-1.5, 0, -1.5]",
    "lower_right = [1.5, 0, -1.5]",
    "upper_left = [-1.5, 3, -1.5]",
    "pixels = [600, 600]",
    "node = 0",
    "window = { size = [600, 600] }",
    "[[wall]]",
    "name = 'left'",
    "lower_left = [-1.5, 0, 1.5]",
    "lower_right = [-1.5, 0, -1.5]",
    "upper_left = [-1.5, 3, 1.5]",
    "pixels = [600, 600]",
    "node = 1",
    "window = { size = [600, 600] }",
    "[[wall]]",
    "name = 'floor'",
    "lower_left = [-1.5, 0, 1.5]",
    "lower_right = [1.5, 0, 1.5]",
    "upper_left = [-1.5, 0, -1.5]",
    "pixels = [600, 600]",
    "node = 2",
    "window = { size = [600, 600] }",
};

using Edits = std::vector<std::pair<std::size_t, std::string>>;

inline Room roomWith(const Edits& edits) {
  std::vector<std::string> lines = kRoom;
  for (const auto& [line, text] : edits) {
    if (line > lines.size()) lines.resize(line);
    lines[line - 1] = text;
  }
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  const TemporaryFolder folder;
  const auto file = folder.file("room.toml", text);
  return roomOf(readPlacedRig(file), file);
}

inline std::string allOf(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += std::to_string(finding.at.line) + ':' + std::to_string(finding.at.column) + ": " + finding.text +
            '\n';
  }
  return text;
}

struct Mistake {
  const char* what;
  Edits edits;
  int line, column;
  std::vector<const char*> words;  // of one finding
  std::size_t findings = 1;        // in all: one mistake may offend several walls
};

inline std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.what; }

/// Rooms with one mistake: each test of a part of the checks gives its own.
class Mistakes : public ::testing::TestWithParam<Mistake> {};

inline Edits secondWall(const std::string& name, const std::string& lowerLeft, const std::string& lowerRight,
                        const std::string& upperLeft,
                        const std::string& window = "window = { size = [600, 600] }") {
  return {{18, "name = '" + name + "'"},
          {19, "lower_left = " + lowerLeft},
          {20, "lower_right = " + lowerRight},
          {21, "upper_left = " + upperLeft},
          {24, window}};
}

inline Edits with(Edits edits, const Edits& more) {
  edits.insert(edits.end(), more.begin(), more.end());
  return edits;
}

inline Edits headAt(const std::string& place) {
  return {{8, "kind = 'simulated'\nroom_from_tracker = { translation = " + place + " }"}};
}

}  // namespace carom::test
