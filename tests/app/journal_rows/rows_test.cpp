// Values in rows of a session file: read with the bits with which they were written, or refused in words.
#include "app/journal_rows/rows.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstring>
#include <set>

#include "cave/record/frame_state.h"

namespace carom {
namespace {

enum class Weather : std::uint8_t { sun, rain };

class Rows : public testing::Test {
 protected:
  Rows() { database_.exec("CREATE TABLE t(value, word TEXT)"); }

  template <typename Value>
  void write(const Value& value) {
    SQLite::Statement row(database_, insertInto("t", "value"));
    RowWriter{row}("value", value);
    row.exec();
  }
  /// Reads the newest value.
  template <typename Value>
  Value read(const char* column = "value") {
    SQLite::Statement row(database_, "SELECT " + std::string(column) + " FROM t ORDER BY rowid DESC LIMIT 1");
    EXPECT_TRUE(row.executeStep());
    Value value{};
    RowReader{row}(column, value);
    return value;
  }
  template <typename Value>
  std::string refusal(const char* column = "value") {
    try {
      read<Value>(column);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }
  std::string storedType() {
    return database_.execAndGet("SELECT typeof(value) FROM t ORDER BY rowid DESC LIMIT 1").getString();
  }

  SQLite::Database database_{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

TEST_F(Rows, NumbersKeepEveryBit) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, 1.0 / 3.0, -2.0, 1e300, Limits::denorm_min(), Limits::max(),
                             Limits::infinity(), -Limits::infinity()}) {
    SCOPED_TRACE(value);
    write(value);
    const double again = read<double>();
    EXPECT_EQ(std::memcmp(&again, &value, sizeof value), 0) << again;
  }
  write(Limits::quiet_NaN());
  EXPECT_EQ(storedType(), "null");
  EXPECT_TRUE(std::isnan(read<double>()));
  database_.exec("INSERT INTO t VALUES('many', 'many')");
  EXPECT_TRUE(std::isnan(read<double>())) << "what is no number is not taken for one";
}

TEST_F(Rows, WholeNumbersAreThoseOfTheirKind) {
  for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{1} << 53U | 1U, ~std::uint64_t{0}}) {
    SCOPED_TRACE(value);
    SQLite::Statement row(database_, "SELECT ?");
    RowWriter{row}("", value);
    ASSERT_TRUE(row.executeStep());
    std::uint64_t again = 7;
    RowReader{row}("", again);
    EXPECT_EQ(again, value);
  }
  const auto refused = [&](const std::string& stored) -> std::string {
    SQLite::Statement row(database_, "SELECT " + stored);
    EXPECT_TRUE(row.executeStep());
    std::uint8_t value = 0;
    try {
      RowReader{row}(ColumnName("left_", "count", "_1"), value);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return std::to_string(value);
  };
  EXPECT_EQ(refused("255"), "255");
  const std::string expected = ", expected a whole number up to 255";
  EXPECT_EQ(refused("256"), "left_count_1 is 256" + expected);
  EXPECT_EQ(refused("-1"), "left_count_1 is -1" + expected);
  EXPECT_EQ(refused("1.5"), "left_count_1 is 1.5" + expected);
  EXPECT_EQ(refused("'some'"), "left_count_1 is some" + expected);
}

TEST_F(Rows, ChoicesAndShortTextsAreRead) {
  SQLite::Statement row(database_, "SELECT ?, ?");
  RowWriter writer(row);
  writer("weather", Weather::rain);
  writer("words", ShortText<8>("\xC3\xA9t\xC3\xA9"));
  ASSERT_TRUE(row.executeStep());
  RowReader reader(row);
  Weather weather = Weather::sun;
  ShortText<8> words;
  reader("weather", weather);
  reader("words", words);
  EXPECT_EQ(weather, Weather::rain);
  EXPECT_EQ(words.words(), "\xC3\xA9t\xC3\xA9");
  database_.exec("INSERT INTO t VALUES(0, 'one two three')");
  EXPECT_EQ(refusal<ShortText<8>>("word"), "word is of 13 bytes, expected at most 7 and none zero");
}

/// Counts the values that a part gives to a row.
struct Counted {
  template <typename Value>
  void operator()(const ColumnName&, const Value&) {
    ++count;
  }
  std::size_t count = 0;
};

template <typename Part>
void expectPlainNames() {
  const Names names = namesOf<Part>();
  Counted row;
  const Part any{};
  putColumns(row, any);
  EXPECT_EQ(names.all.size(), row.count);
  EXPECT_EQ(std::set<std::string>(names.all.begin(), names.all.end()).size(), names.all.size())
      << names.text();
  std::string text;
  for (const std::string& name : names.all) {
    EXPECT_FALSE(name.empty());
    for (const char letter : name)
      EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_') << name;
    text += ", " + name;
  }
  EXPECT_EQ(names.text(), text);
}

TEST_F(Rows, EveryColumnHasANameOfItsOwn) {
  expectPlainNames<ViewerState>();
  expectPlainNames<HeadsetState>();
  expectPlainNames<Knot>();
  expectPlainNames<GameEvent>();
  expectPlainNames<ForceView>();
  expectPlainNames<ToldMoment>();
  EXPECT_EQ(insertInto("t", "a, b, c"), "INSERT OR REPLACE INTO t(a, b, c) VALUES(?,?,?)");
}

}  // namespace
}  // namespace carom
