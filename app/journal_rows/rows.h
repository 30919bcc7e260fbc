#pragma once
// Rows of a session file whose columns are listed by a visit (app/journal_rows/frame_columns.h): their names,
// and values written to and read from them.

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "app/journal_rows/frame_columns.h"
#include "cave/record/notice.h"

namespace carom {

/// Collects the column names.
struct Names {
  std::vector<std::string> all;

  template <typename Value>
  void operator()(const ColumnName& name, const Value&) {
    all.push_back(name.text());
  }
  /// Returns the names, each after a comma.
  std::string text() const {
    std::string text;
    for (const std::string& name : all) text += ", " + name;
    return text;
  }
};

/// Returns the names of the columns of a viewer after the first, of a headset, a knot or an event.
template <typename Part>
Names namesOf() {
  Names names;
  const Part any{};
  putColumns(names, any);
  return names;
}

/// Binds values to a row's parameters in order.
class RowWriter {
 public:
  explicit RowWriter(SQLite::Statement& row) : row_(row) { row_.tryReset(); }

  /// Writes zero as an integer, which needs no byte, but keeps minus zero. NaN becomes NULL.
  void operator()(const ColumnName&, double value) {
    if (value == 0.0 && !std::signbit(value)) {
      row_.bind(parameter_++, 0);
    } else {
      row_.bind(parameter_++, value);
    }
  }
  template <std::unsigned_integral Whole>
  void operator()(const ColumnName&, Whole value) {
    row_.bind(parameter_++, static_cast<std::int64_t>(value));
  }
  template <typename Choice>
  requires std::is_enum_v<Choice>
  void operator()(const ColumnName&, Choice value) { row_.bind(parameter_++, static_cast<int>(value)); }
  template <std::size_t bytes>
  void operator()(const ColumnName&, const ShortText<bytes>& text) {
    (*this)("", std::string(text.words()));
  }
  void operator()(const ColumnName&, const std::string& text) { row_.bind(parameter_++, text); }

 private:
  SQLite::Statement& row_;
  int parameter_ = 1;
};

/// Reads values from a row's columns in order. Anything that is not a number becomes NaN, which later checks
/// refuse.
class RowReader {
 public:
  explicit RowReader(SQLite::Statement& row, int firstColumn = 0) : row_(row), column_(firstColumn) {}

  void operator()(const ColumnName&, double& value) {
    const SQLite::Column column = row_.getColumn(column_++);
    value = column.isFloat() || column.isInteger() ? column.getDouble()
                                                   : std::numeric_limits<double>::quiet_NaN();
  }
  template <std::unsigned_integral Whole>
  void operator()(const ColumnName& name, Whole& value) {
    const SQLite::Column column = row_.getColumn(column_++);
    const std::int64_t stored = column.getInt64();
    value = static_cast<Whole>(stored);
    if (!column.isInteger() || static_cast<std::int64_t>(value) != stored) {
      throw std::runtime_error(fmt::format("{} is {}, expected a whole number up to {}", name.text(),
                                           column.getString(), std::numeric_limits<Whole>::max()));
    }
  }
  template <typename Choice>
  requires std::is_enum_v<Choice>
  void operator()(const ColumnName& name, Choice& value) {
    std::underlying_type_t<Choice> number{};
    (*this)(name, number);
    value = static_cast<Choice>(number);
  }
  template <std::size_t bytes>
  void operator()(const ColumnName& name, ShortText<bytes>& text) {
    const std::string words = row_.getColumn(column_++).getString();
    text = ShortText<bytes>(words);
    if (text.words() != words)
      throw std::runtime_error(fmt::format("{} is of {} bytes, expected at most {} and none zero",
                                           name.text(), words.size(), bytes - 1));
  }

 private:
  SQLite::Statement& row_;
  int column_;
};

/// Returns the statement that writes a row, of `columns` separated by commas.
inline std::string insertInto(const char* table, const std::string& columns) {
  std::string text = fmt::format("INSERT OR REPLACE INTO {}({}) VALUES(?", table, columns);
  for (const char letter : columns) text += letter == ',' ? ",?" : "";
  return text + ")";
}

}  // namespace carom
