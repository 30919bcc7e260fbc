#include "cave/texts/saying.h"

#include <fmt/args.h>
#include <nlohmann/json.hpp>

#include "cave/texts/language.h"

namespace carom::texts {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 4;  // of sayings within sayings

std::string jsonOf(std::string_view words) {
  return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string wordsOf(const Json& parts, int depth);

/// Returns a text of the catalogue with its values. `part` is a list that begins with a name.
std::string wordsOfText(const Json& part, int depth) {
  const Text text = textNamed(part.at(0).get_ref<const std::string&>());
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (auto value = part.begin() + 1; value != part.end(); ++value) {
    if (value->is_number_integer()) {
      values.push_back(Number<std::int64_t>{value->get<std::int64_t>()});
    } else if (value->is_number()) {
      values.push_back(Number<double>{value->get<double>()});
    } else if (value->is_string()) {
      values.push_back(other(value->get_ref<const std::string&>()));
    } else {
      values.push_back(wordsOf(*value, depth + 1));
    }
  }
  const bool counts = text.englishOfMany() && part.size() > 1 && part[1].is_number();
  try {
    return fmt::vformat(counts ? formFor(text, part[1].get<double>()) : text.words(), values);
  } catch (const fmt::format_error&) {  // values that it has no place for, from outside
    return text.words();
  }
}

std::string wordsOf(const Json& parts, int depth) {
  std::string words;
  if (!parts.is_array() || depth > kDeepest) return words;
  for (const Json& part : parts) {
    if (part.is_string()) words += other(part.get_ref<const std::string&>());
    if (part.is_array() && !part.empty() && part[0].is_string()) words += wordsOfText(part, depth);
  }
  return words;
}

}  // namespace

Saying::Saying(std::string_view words) {
  if (!words.empty()) parts_ = jsonOf(words);
}

Saying::Saying(const Text& text) {
  if (!text) return;
  begin(text);
  end();
}

Saying Saying::read(std::string_view line) {
  Saying saying;
  const Json parts = Json::parse(line, nullptr, false);
  if (!parts.is_array() || parts.empty()) return saying;
  saying.parts_ = parts.dump(-1, ' ', false, Json::error_handler_t::replace);
  saying.parts_ = saying.parts_.substr(1, saying.parts_.size() - 2);
  return saying;
}

std::string Saying::line() const { return empty() ? std::string() : fmt::format("[{}]", parts_); }

std::string Saying::words() const { return wordsOf(Json::parse(line(), nullptr, false), 0); }

std::string Saying::english() const {
  const InLanguage english(nullptr);
  return words();
}

Saying& Saying::operator+=(const Saying& more) {
  if (!parts_.empty() && !more.parts_.empty()) parts_ += ',';
  parts_ += more.parts_;
  return *this;
}

void Saying::begin(const Text& text) { parts_.assign(1, '[').append(jsonOf(catalogue()[text.index()].name)); }

/// Seven digits are more than any text shows.
void Saying::value(double number) {
  const std::string digits = fmt::format("{:.7g}", number);
  if (!std::isfinite(number)) return value(std::string_view(digits));
  const bool isWhole = digits.find_first_of(".e") == std::string::npos;  // it stays a number with decimals
  parts_.append(1, ',').append(digits).append(isWhole ? ".0" : "");
}

void Saying::value(std::string_view name) { parts_.append(1, ',').append(jsonOf(name)); }

void Saying::value(const Saying& saying) { parts_.append(",[").append(saying.parts_).append(1, ']'); }

}  // namespace carom::texts
