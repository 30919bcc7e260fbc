#pragma once
// Item banks as text, and the faults that reading a file throws.

#include <gtest/gtest.h>

#include <string>

#include "app/temporary_folder.h"
#include "app/toml/input_file.h"

#define EXPECT_SAYS(said, words) EXPECT_NE((said).find(words), std::string::npos) << (said)

namespace carom::test {

/// Returns all faults that reading the file throws, one a line, without the folder.
template <typename Read>
std::string faultsOf(const TemporaryFolder& folder, const Read& read) {
  try {
    read();
  } catch (const InputErrors& errors) {
    std::string all;
    for (const InputError& fault : errors.faults()) all += std::string(fault.what()) + "\n";
    const std::string path = (folder / "").string();
    for (std::size_t at = 0; (at = all.find(path)) != std::string::npos;) all.erase(at, path.size());
    return all;
  }
  return {};
}

/// An item with one key.
inline std::string item(const std::string& id, const std::string& asks, const std::string& form,
                        const std::string& answers =
                            "[[item.answer]]\nid = \"a\"\ntext = \"A\"\nright = true\n"
                            "[[item.answer]]\nid = \"b\"\ntext = \"B\"\n"
                            "misconception = \"m\"\n") {
  return "[[item]]\nid = \"" + id + "\"\nconcept = \"" + asks + "\"\nform = \"" + form +
         "\"\nquestion = \"Q\"\n" + answers;
}

inline std::string wholeBank() { return item("i", "k", "A") + item("i", "k", "B") + item("i", "k", "C"); }

}  // namespace carom::test
