#pragma once
// What the signs of a text are, as far as rules of translations ask: by the blocks of Unicode, not by tables.

#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Returns whether a sign is a letter that makes words with its neighbours: Latin, Greek, Cyrillic.
bool isLetter(char32_t sign);

/// Returns whether a sign is of a script that is read from right to left (Hebrew, Arabic, Syriac and others).
bool isRightToLeft(char32_t sign);

/// Returns whether a sign only changes the direction of reading (Unicode's marks, embeddings, isolates).
bool isDirectionMark(char32_t sign);

/// Returns whether a sign controls something and shows nothing: of C0 and C1, ends of lines and paragraphs,
/// the byte order mark, tags.
bool isControl(char32_t sign);

/// Returns a text with small letters for capitals, and a blank for each kind of space.
std::u32string folded(std::string_view text);

/// Returns the words of a text, in small letters: runs of letters and digits. Between those that belong to no
/// one phrase, since a full stop, a bracket or a value parts them, stands an empty one.
std::vector<std::u32string> wordsOf(std::string_view text);

}  // namespace carom
