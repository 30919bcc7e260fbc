#include "app/tables/csv_text.h"

#include <fmt/format.h>

namespace carom {

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::string csvNumbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += fmt::format("{:.17g},", value);
  return text;
}

}  // namespace carom
