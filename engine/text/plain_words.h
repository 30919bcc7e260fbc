#pragma once
// Words that somebody outside has typed, as they may stand on a wall, in a page or in a table.

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// Returns the first signs of a text in UTF-8, at most `most`, on one line: line feeds and tabulators become
/// blanks, and signs that show nothing or change the direction of reading are left out (Unicode's controls,
/// marks of direction, separators of lines, signs without width, the mark of byte order, invisible tags).
/// Each byte that is no UTF-8 becomes '?'.
std::string plainWords(std::string_view text, std::size_t most);

}  // namespace carom
