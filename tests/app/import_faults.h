#pragma once
// Rooms of other programs that are wrong in one place, and what is to be said of it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "app/room_checks/room.h"

namespace carom::test {

/// A text with one finding: its place, some of its words, and whether it is an error or a warning.
struct ImportFault {
  const char* what;
  std::string text;
  int line, column;
  std::vector<const char*> words;
  bool error = true;
};

inline std::ostream& operator<<(std::ostream& out, const ImportFault& fault) { return out << fault.what; }

inline std::string placed(const FilePlace& at) { return fmt::format("{}:{}", at.line, at.column); }

/// Expects that `room`, read from the text of `fault`, has the one finding that `fault` names.
inline void expectFound(const ImportFault& fault, const Room& room) {
  ASSERT_EQ(room.findings.size(), 1u) << (room.findings.empty() ? "none" : room.findings.back().text);
  const Finding& finding = room.findings[0];
  EXPECT_EQ(finding.at.line, fault.line) << finding.text;
  EXPECT_EQ(finding.at.column, fault.column) << finding.text;
  EXPECT_EQ(finding.kind == Finding::Kind::error, fault.error) << finding.text;
  for (const char* words : fault.words)
    EXPECT_NE(finding.text.find(words), std::string::npos) << finding.text;
}

}  // namespace carom::test
