#include "devices/protocol/dtrack_answer.h"

#include <algorithm>
#include <charconv>

namespace carom {
namespace {

constexpr std::size_t kMostText = 200;

std::string printableText(std::string_view text) {
  std::string result(text.substr(0, kMostText));
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return result;
}

/// Removes `front` from the text, if it begins with it.
bool take(std::string_view& text, std::string_view front) {
  if (!text.starts_with(front)) return false;
  text.remove_prefix(front.size());
  return true;
}

}  // namespace

DtrackAnswer readDtrackAnswer(std::string_view answer, std::string_view asked) {
  using Kind = DtrackAnswer::Kind;
  std::string_view rest = answer;
  if (rest == "dtrack2 ok") return {Kind::ok, {}};
  if (take(rest, "dtrack2 err ")) {
    int code = 0;
    const auto [end, failed] = std::from_chars(rest.data(), rest.data() + rest.size(), code);
    if (failed == std::errc()) {
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \""), rest.size()));
      rest = rest.substr(0, rest.find('"'));
      const std::string words = rest.empty() ? "" : ": " + printableText(rest);
      return {Kind::refused, "error " + std::to_string(code) + words};
    }
  }
  rest = answer;
  if (!asked.empty() && take(rest, "dtrack2 set ") && take(rest, asked) && take(rest, " ")) {
    return {Kind::value, printableText(rest)};
  }
  return {Kind::unknown, printableText(answer)};
}

}  // namespace carom
