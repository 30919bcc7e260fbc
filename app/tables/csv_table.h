#pragma once
// Tables as CSV files (RFC 4180). A column is declared once, with its name and its value in a row: the first
// line of the file and all others follow from the same list.

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Returns the text as a CSV field, quoted if necessary.
std::string csvField(std::string_view text);

/// A field of a CSV file: a number with 17 digits, which restores every bit; a whole number; 0 or 1; a text;
/// or nothing.
class CsvValue {
 public:
  CsvValue(double number);  // NOLINT(google-explicit-constructor): a column's value is written as it is
  CsvValue(std::integral auto number) : text_(std::to_string(number)) {}
  CsvValue(bool flag) : text_(flag ? "1" : "0") {}
  CsvValue(std::string_view text) : text_(csvField(text)) {}
  CsvValue(const std::string& text) : text_(csvField(text)) {}
  CsvValue(const char* text) : text_(csvField(text)) {}
  CsvValue(std::nullopt_t) {}
  CsvValue(char) = delete;         // a letter is no number
  CsvValue(const void*) = delete;  // nor a place in memory a flag
  template <typename T>
  CsvValue(const std::optional<T>& value) {
    if (value) text_ = CsvValue(*value).text_;
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A column; its name ends with the unit, as in "distance_m".
template <typename Row>
struct CsvColumn {
  std::string name;
  std::function<CsvValue(const Row&)> value;
};

/// Returns the first line, the columns' names.
template <typename Row>
std::string csvHead(std::span<const CsvColumn<Row>> columns) {
  std::string line;
  for (const CsvColumn<Row>& column : columns) {
    if (&column != &columns.front()) line += ',';
    line += csvField(column.name);
  }
  return line + "\n";
}

/// Returns the line of a row.
template <typename Row>
std::string csvLine(std::span<const CsvColumn<Row>> columns, const Row& row) {
  std::string line;
  for (const CsvColumn<Row>& column : columns) {
    if (&column != &columns.front()) line += ',';
    line += column.value(row).text();
  }
  return line + "\n";
}

/// Returns the file of these rows.
template <typename Row>
std::string csvText(const std::vector<CsvColumn<Row>>& columns, const std::vector<Row>& rows) {
  std::string text = csvHead<Row>(columns);
  for (const Row& row : rows) text += csvLine<Row>(columns, row);
  return text;
}

}  // namespace carom
