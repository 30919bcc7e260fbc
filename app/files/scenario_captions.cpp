#include "app/files/scenario_captions.h"

#include <fmt/format.h>

#include "app/files/scenario_lesson.h"
#include "app/files/toml_values.h"

namespace carom {

std::vector<Caption> readCaptions(const TomlTable& root) {
  std::vector<Caption> captions;
  double free_s = 0.0;  // end of the previous caption
  for (const TomlTable& table : root.tables("caption")) {
    Caption caption{.from_s = table.numberOr("from_s", free_s),
                    .for_s = table.number("for_s"),
                    .text = readWords(table, "text"),
                    .handText = {},
                    .views = readViews(table)};
    caption.handText = table.has("hand_text") ? readWords(table, "hand_text") : caption.text;
    if (caption.from_s < free_s) {
      table.fault("from_s",
                  fmt::format("from_s is {}, expected a time after the caption before it, {} or above",
                              caption.from_s, free_s));
    }
    free_s = caption.from_s + (table.has("for_s") ? caption.for_s : 0.0);
    captions.push_back(caption);
  }
  return captions;
}

}  // namespace carom
