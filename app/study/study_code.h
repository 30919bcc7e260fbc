#pragma once
// The codes of participants: six letters of Crockford's base 32. The last one notices a slip. A code does not
// tell whose it is.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// The digits and letters of codes, without I, L, O and U (D. Crockford's base 32).
inline constexpr std::string_view kCodeLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
inline constexpr std::size_t kCodeLength = 6;

/// Returns the letter that follows the first five of a code: Luhn's sum modulo 32 is 0 with it, and is not
/// after a slip of one letter.
char checkLetterOf(std::string_view five);

/// Returns the code that somebody typed: small letters are large ones, O is 0, I and L are 1, blanks and
/// hyphens count for nothing. None if it is no code.
std::optional<std::string> codeOf(std::string_view typed);

/// Returns `count` different codes from the operating system's randomness. Throws std::runtime_error if there
/// is none.
std::vector<std::string> newCodes(std::size_t count);

/// Returns the slips as CSV: number,code.
std::string slipsCsv(const std::vector<std::string>& codes);

/// Returns a page to print and cut, a slip for each code, under the title of the study.
std::string slipsHtml(const std::string& title, const std::vector<std::string>& codes);

/// Returns a few digits that tell a withdrawn code with little doubt, and that many codes share.
std::string withdrawnMark(const std::string& code);

}  // namespace carom
