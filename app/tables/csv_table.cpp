#include "app/tables/csv_table.h"

#include <fmt/format.h>

namespace carom {

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

CsvValue::CsvValue(double number) : text_(fmt::format("{:.17g}", number)) {}

}  // namespace carom
