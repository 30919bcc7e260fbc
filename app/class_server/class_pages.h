#pragma once
// The pages that phones and the teacher load: one page, one style and one script, built into the program,
// with all words from the catalogue (cave/texts/texts.h).

#include <string>

namespace carom {

struct ClassPages {
  std::string page, style, script;
};

/// Returns the pages of the class in the room of this word. `follows`: the game may be followed by phone.
ClassPages classPages(const std::string& word, bool follows = false);

}  // namespace carom
