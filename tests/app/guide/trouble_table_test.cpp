// The table of troubles: each row of the page's tables is found by its own message with other numbers, names
// and places, and by messages as the program really prints them.
#include "app/guide/trouble_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "places.h"

namespace carom {
namespace {

std::string replaced(const std::string& text, const char* pattern, const char* by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// The message as another room would get it: other names, numbers and places, and words where the page leaves
/// them out.
std::string elsewhere(const std::string& message) {
  std::string text = replaced(message, "FILE:12:8", "/home/anna/halls/north.toml:3:1");
  text = replaced(text, "NAME", "optical");
  text = replaced(text, R"(\((left|sideways)\))", "(east wall)");
  text = replaced(text, "cave-left", "pc17");
  text = replaced(text, "monday.db", "/data/2031/friday.db");
  text = replaced(text, R"('[A-Za-z]+')", "'Zebra'");
  text = replaced(text, R"("[^"]*")", "\"HDMI-9\"");
  text = replaced(text, "[0-9]", "7");
  return replaced(text, "…", "xyzzy (plugh)");
}

TEST(Help, EveryRowIsFoundByItsOwnMessageWithOtherNumbersAndNames) {
  ASSERT_GT(troubles().size(), 45u);
  for (const Trouble& row : troubles()) {
    EXPECT_FALSE(row.says.empty() || row.meaning.empty()) << row.says;
    for (const std::string& message : row.messages) {
      const auto found = nearestTroubles(troubles(), elsewhere(message));
      ASSERT_FALSE(found.empty()) << elsewhere(message);
      EXPECT_EQ(found.front()->says, row.says) << "for: " << elsewhere(message);
    }
  }
}

/// A line as the program prints it, and the beginning of the row that explains it.
struct Printed {
  const char* line;
  const char* row;
};

TEST(Help, WhatTheProgramPrintsFindsItsRow) {
  for (const Printed& printed : {
           Printed{"error: /root/r.toml:31:1: wall 'left' asks for 3 pixels, expected 16 at least",
                   "error: FILE:12:8"},
           {"error: host gone does not answer: ssh: connect to host gone port 22: No route to host, expected "
            "to "
            "reach it by ssh without a password",
            "host cave-left does not answer"},
           {"error: host old has another version, carom 0.0.1, expected carom 0.1.0 as here",
            "host cave-left has another version"},
           {"error: node 2, 3 of the rig has no host though others have, expected a [[node]] with rank and "
            "host "
            "for each of nodes 0 to 3",
            "node 2 of the rig has no host"},
           {"error: no X display: cannot open \":77\" (X11: Failed to open display :77); start one, e.g. "
            "with: "
            "xvfb-run COMMAND (node 1)",
            "no X display: cannot open"},
           {"error: wall a: there is no monitor \"middle\", expected one of 0 \"left\", 1 \"right\"",
            "wall left: there is no monitor"},
           {"Wall right asks for node 2; node 0 draws it.", "Wall floor asks for node 3"},
           {"warning: node 1 has no wall to draw.", "warning: node 4 has no wall"},
           {"node 3 (floor) is late: every wall keeps the last whole frame.", "node 2 (left) is late"},
           {"node 1 (front, left) is back after 13.7 s.", "node 2 (left) is late"},
           {"error: node 1 (right) is gone: the session ends.", "error: node 2 (left) is gone"},
           {"error: node 3 (floor) has not answered for 10 s: the session ends.",
            "error: node 2 (left) has not answered"},
           {"warning: the session was cut off after frame 10423: it goes on by itself.",
            "warning: the session was cut off"},
           {"Tracker head: the server at 127.0.0.1:41233 has no 'Buttons9', it has: Tracker0; it names "
            "without an "
            "answer: Head; it is waited for",
            "Tracker NAME: the server at … has no"},
           {"Tracker art: silent since second 3.2 of the session; the head is held",
            "Tracker NAME: silent since"},
           {"Tracker art: delivers again, after 12.0 s", "Tracker NAME: silent since"},
           {"Tracker art: sensor 4 never came; this tracker has sent no poses",
            "Tracker NAME: sensor 0 never came"},
           {"Tracker art: a line of its datagrams cannot be read, '6d 1 [0 1,000][12,5 1700,1 3,4][1,0…': "
            "its "
            "numbers have decimal commas, expected points: correct the sender's language settings",
            "Tracker NAME: … its numbers have decimal commas"},
           {"error: session file /tmp/x/y.db: it is there already, expected a new name, or --resume to go on "
            "with it",
            "session file monday.db: it is there already"},
           {"error: /tmp/list.toml:9:3: there is no game 'tipo', expected 'table'?", "…/my-list.toml:4:12"},
           {"warning: There is no room for the window \"outside\" beside the others: it opens over them.",
            "There is no room for the window"},
       }) {
    const auto found = nearestTroubles(troubles(), printed.line);
    ASSERT_FALSE(found.empty()) << printed.line;
    EXPECT_EQ(found.front()->says.rfind(printed.row, 0), 0u) << printed.line << "\n" << found.front()->says;
  }
}

TEST(Help, WordsOfAMessageAreEnough) {
  const auto first = [](const char* words) {
    const auto found = nearestTroubles(troubles(), words);
    return found.empty() ? std::string() : found.front()->says;
  };
  EXPECT_EQ(first("one wall is black"), "one wall is black");
  EXPECT_EQ(first("needs firmware"), "Tracker NAME: … needs firmware: …");
  EXPECT_NE(first("quad-buffer stereo").find("offers no quad-buffer"), std::string::npos);
  EXPECT_EQ(first("/home/anna/r.toml:12:1:"), "error: FILE:12:8: …, expected …") << "a place in a file";
  EXPECT_EQ(first("/r.toml:4:12: there is no game 'the wand is lost: no stroke', expected 'table'?"),
            "…/my-list.toml:4:12: there is no game 'twinz', …")
      << "names in quotes are not compared";
  EXPECT_EQ(first("is the room open today"), "") << "words that many messages have tell nothing";
  EXPECT_EQ(first("who has the key for the door"), "");
  EXPECT_EQ(first("7"), "");
  EXPECT_EQ(first("xyzzy plugh"), "");
  EXPECT_EQ(first("the cat sat upon the mat and purred"), "");
  EXPECT_EQ(first(std::string(1000000, '(').c_str()), "");
}

TEST(Help, OfThePageEveryRowIsThere) {
  std::ifstream page(CAROM_CONFIG_DIR "/../app/doc/operators.md");
  std::string line;
  std::size_t rows = 0;
  for (bool within = false; std::getline(page, line);) {
    if (line.starts_with("## ")) within = line == "## When something goes wrong";
    rows += within && line.starts_with("| ") && !line.starts_with("| ---") ? 1 : 0;
  }
  EXPECT_EQ(troubles().size(), rows - 2) << "two tables, each with the names of its columns";
}

TEST(Help, RowsAreThoseOfTablesWithTwoColumns) {
  const auto rows = troublesOf(
      "# Rooms\n\n| three | columns | here |\n| --- | --- | --- |\n| a | b | c |\n\n"
      "| the program says | meaning |\n| --- | --- |\n"
      "| `node 2 (left) is late.` … `node 2 is back.` | see [lateness](#late), *not* [rigs](rigs.md#x) |\n"
      "| one wall is black | its `display` |\n\nA sentence | of two.\n\n| you see | meaning |\n| red | blue "
      "|");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].says, "node 2 (left) is late. … node 2 is back.");
  EXPECT_EQ(rows[0].meaning, "see lateness, not rigs (rigs.md)");
  EXPECT_EQ(rows[0].messages, (std::vector<std::string>{"node 2 (left) is late.", "node 2 is back."}));
  EXPECT_EQ(rows[0].words,
            (std::vector<Trouble::Words>{{"node", "left", "is", "late"}, {"node", "is", "back"}}));
  EXPECT_EQ(rows[1].messages, std::vector<std::string>{"one wall is black"}) << "of a sight, its whole text";
  EXPECT_EQ(rows[1].meaning, "its display");
  EXPECT_EQ(rows[2].says, "red");
  EXPECT_TRUE(troublesOf("").empty());
}

TEST(Help, AtMostThreeRowsAreFoundTheBestFirst) {
  std::string page = "| the program says | meaning |\n";
  for (const char* words : {"walls lack light", "walls lack a colour", "walls lack a plug", "walls lack heat",
                            "floors lack light entirely"})
    page += "| " + std::string(words) + " | help |\n";
  const auto rows = troublesOf(page);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(nearestTroubles(rows, "walls lack").size(), 3u);
  const auto found = nearestTroubles(rows, "Walls: lack (light)?");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), &rows[0]) << "marks and capitals do not matter";
}

}  // namespace
}  // namespace carom
