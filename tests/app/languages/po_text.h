#pragma once
// Pieces of PO files, and a scenario of one's own that has every text.

#include <string>

#include "app/languages/po_file.h"

namespace carom::test {

/// A head that says nothing of plurals.
inline std::string bareHead(const std::string& language) {
  return "msgid \"\"\nmsgstr \"\"\n\"Language: " + language +
         "\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n\n";
}

inline std::string entry(const std::string& name, const std::string& english, const std::string& words) {
  return "msgctxt " + quotedPo(name) + "\nmsgid " + quotedPo(english) + "\nmsgstr " + quotedPo(words) +
         "\n\n";
}

inline const std::string kMine =
    "title = \"My game\"\nlight_speed_m_s = 1.4\n\n[[puck]]\nname = \"left 1\"\n\n[[puck]]\nname = \"left "
    "2\"\n\n"
    "[[puck]]\nname = \"B\"\n\n[[flash]]\nname = \"a lamp\"\n\n[[caption]]\ntext = \"Look\"\nhand_text = "
    "\"Point\"\n\n"
    "[lesson]\nquestion = \"Which?\"\nanswers = [\"This\", \"That\"]\ntodo = \"Do\"\nnotice = "
    "\"See\"\nnumber = \"So\"\n\n"
    "[[lesson.observer]]\nname = \"at rest\"\n\n[[lesson.stopwatch]]\nname = \"Seen\"\n\n"
    "[[task]]\nname = \"First\"\ntext = \"Hit it\"\n";

}  // namespace carom::test
