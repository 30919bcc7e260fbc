// CSV files: what a field may hold, and that names and values come from one list.
#include "app/tables/csv_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace carom {
namespace {

struct Row {
  double length_m = 0.0;
  std::string name;
  std::optional<bool> isRight;
};

const std::vector<CsvColumn<Row>> kColumns{{"length_m", [](const Row& row) { return row.length_m; }},
                                           {"name, of a puck", [](const Row& row) { return row.name; }},
                                           {"right", [](const Row& row) { return row.isRight; }}};

TEST(CsvTable, NamesAndValuesFollowOneList) {
  EXPECT_EQ(csvText(kColumns, {{0.5, "red", true}, {-1.0, "a \"b\", c", {}}, {0.0, "", false}}),
            "length_m,\"name, of a puck\",right\n0.5,red,1\n-1,\"a \"\"b\"\", c\",\n0,,0\n");
  EXPECT_EQ(csvText(kColumns, {}), csvHead<Row>(kColumns));
}

TEST(CsvTable, AnEmptyFirstValueKeepsItsComma) {
  const std::vector<CsvColumn<Row>> columns{{"right", [](const Row& row) { return row.isRight; }},
                                            {"name", [](const Row& row) { return row.name; }}};
  EXPECT_EQ(csvLine<Row>(columns, {0.0, "red", {}}), ",red\n");
}

TEST(CsvTable, ValuesOfEachKind) {
  EXPECT_EQ(CsvValue(std::uint64_t{18446744073709551615U}).text(), "18446744073709551615");
  EXPECT_EQ(CsvValue(-3).text(), "-3");
  EXPECT_EQ(CsvValue(true).text(), "1");
  EXPECT_EQ(CsvValue(std::nullopt).text(), "");
  EXPECT_EQ(CsvValue(std::optional<double>(0.25)).text(), "0.25");
  EXPECT_EQ(CsvValue("two\nlines").text(), "\"two\nlines\"");
}

TEST(CsvTable, NumbersKeepEveryBit) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 1000; ++i) {
    const double number = std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                                     std::uniform_int_distribution(-900, 900)(random));
    SCOPED_TRACE(number);
    EXPECT_EQ(std::strtod(CsvValue(number).text().c_str(), nullptr), number);
  }
}

}  // namespace
}  // namespace carom
