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

/// Returns the value of a column that is empty where `part(row)` is, an optional part of the row; else
/// `value` of what it has.
template <typename Part, typename Value>
auto ifThere(const Part& part, const Value& value) {
  return [part, value](const auto& row) -> CsvValue {
    const auto& found = part(row);
    if (!found) return std::nullopt;
    return value(*found);
  };
}

/// Returns a line with a field of each column.
template <typename Row, typename Field>
std::string csvFields(std::span<const CsvColumn<Row>> columns, const Field& fieldOf) {
  std::string line;
  for (const CsvColumn<Row>& column : columns) {
    if (&column != &columns.front()) line += ',';
    line += fieldOf(column);
  }
  return line + "\n";
}

/// Returns the first line, the columns' names.
template <typename Row>
std::string csvHead(std::span<const CsvColumn<Row>> columns) {
  return csvFields(columns, [](const CsvColumn<Row>& column) { return csvField(column.name); });
}

/// Returns the line of a row.
template <typename Row>
std::string csvLine(std::span<const CsvColumn<Row>> columns, const Row& row) {
  return csvFields(columns, [&](const CsvColumn<Row>& column) { return column.value(row).text(); });
}

/// Returns the file of these rows.
template <typename Row>
std::string csvText(const std::vector<CsvColumn<Row>>& columns, const std::vector<Row>& rows) {
  std::string text = csvHead<Row>(columns);
  for (const Row& row : rows) text += csvLine<Row>(columns, row);
  return text;
}

}  // namespace carom
