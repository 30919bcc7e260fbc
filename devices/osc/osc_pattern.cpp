#include "devices/osc/osc_pattern.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kMostDigits = 5;
constexpr std::int32_t kMostNumber = 65535;

/// Whether an address may hold the character. OSC keeps the others for patterns of the sender.
bool isPlain(char c) {
  return c > ' ' && c <= '~' && std::string_view("#*,?[]{}").find(c) == std::string_view::npos;
}

/// Takes a number from the front of `rest`.
std::optional<std::int32_t> takeNumber(std::string_view& rest) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto end = std::find_if_not(rest.begin(), rest.end(), isDigit);
  const auto digits = static_cast<std::size_t>(end - rest.begin());
  if (digits == 0 || digits > kMostDigits) return {};
  std::int32_t number = 0;
  std::from_chars(rest.data(), rest.data() + digits, number);
  rest.remove_prefix(digits);
  if (number > kMostNumber) return {};
  return number;
}

}  // namespace

OscPattern::OscPattern(std::string_view text, bool hasIndex) : text_(text) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument('\'' + text_ + "' " + why + ", expected an address such as '" +
                                (hasIndex ? "/wand/{sensor}/button/{n}'" : "/head/{sensor}'"));
  };
  if (!text.starts_with('/')) refuse("does not begin with '/'");
  std::string before;
  while (!text.empty()) {
    if (text.front() != '{') {
      if (!isPlain(text.front())) refuse("has a character that no address has");
      before += text.front();
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = text.find('}');
    if (end == std::string_view::npos) refuse("has a '{' without a '}'");
    const char last = before.empty() ? '0' : before.back();
    if (last >= '0' && last <= '9') refuse("has nothing that parts the number in braces from one before it");
    add(text.substr(1, end - 1), std::exchange(before, {}), hasIndex);
    text.remove_prefix(end + 1);
    if (!text.empty() && text.front() >= '0' && text.front() <= '9') {
      refuse("has a digit right behind the number in braces");
    }
  }
  if (!before.empty()) pieces_.push_back({std::move(before), Place::none});
}

void OscPattern::add(std::string_view name, std::string&& before, bool hasIndex) {
  const Place place = name == "sensor" ? Place::sensor : name == "n" && hasIndex ? Place::index : Place::none;
  const std::string places = hasIndex ? "{sensor} or {n}" : "{sensor}";
  if (place == Place::none) {
    throw std::invalid_argument('\'' + text_ + "' has {" + std::string(name) + "}, expected " + places);
  }
  const bool isTwice =
      std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return piece.place == place; });
  if (isTwice)
    throw std::invalid_argument('\'' + text_ + "' has {" + std::string(name) + "} twice, expected it once");
  pieces_.push_back({std::move(before), place});
}

std::optional<OscPattern::Numbers> OscPattern::match(std::string_view address) const {
  Numbers numbers;
  for (const Piece& piece : pieces_) {
    if (!address.starts_with(piece.text)) return {};
    address.remove_prefix(piece.text.size());
    if (piece.place == Place::none) continue;
    const auto number = takeNumber(address);
    if (!number) return {};
    (piece.place == Place::sensor ? numbers.sensor : numbers.index) = *number;
  }
  if (!address.empty()) return {};
  return numbers;
}

}  // namespace carom
