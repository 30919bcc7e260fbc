#pragma once
// Input that is wrong in one place, and what is to be said of it.

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "app/toml/toml_file.h"

namespace carom::test {

/// A text that is refused, with the place and some of the words of the reason.
struct Fault {
  const char* what;
  std::string text;
  int line, column;
  const char* words;
};

inline std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.what; }

/// Expects that `read(text)` throws one fault, at the place and with the words that `fault` names.
template <typename Read>
void expectExplained(const Fault& fault, const Read& read) {
  try {
    read(fault.text);
    FAIL() << "was taken: " << fault.what;
  } catch (const InputErrors& error) {
    EXPECT_EQ(error.line(), fault.line) << error.what();
    EXPECT_EQ(error.column(), fault.column) << error.what();
    EXPECT_NE(error.message().find(fault.words), std::string::npos) << error.what();
    EXPECT_EQ(error.faults().size(), 1u) << error.faults().back().what();
  }
}

}  // namespace carom::test
