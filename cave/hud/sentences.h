#pragma once
// The sentences of a text that is read one at a time.

#include <string_view>
#include <vector>

namespace carom {

/// Returns the sentences of a text in UTF-8, without blanks at their ends. A sentence ends with a full stop,
/// a question mark or an exclamation mark and quotes behind it, before a blank that no small letter follows;
/// or with the full stop of Chinese and Japanese, "。". So "0.6 c" and "z. b." are whole.
std::vector<std::string_view> sentencesOf(std::string_view text);

/// Returns how long a sentence stands on the wall, if the next one then takes its place: as long as one needs
/// to read it slowly, and 2 s to look at what it is about.
double standsFor_s(std::string_view sentence);

/// Returns which of these sentences stands so long after the first one began; after the last comes the first.
std::size_t sentenceAt(const std::vector<std::string_view>& sentences, double since_s);

}  // namespace carom
