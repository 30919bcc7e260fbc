#pragma once
// Reads the tables that carom writes.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace carom::test {

using Row = std::map<std::string, std::string>;

/// Returns the rows of a CSV by the names of their columns; none of its fields may hold a comma.
inline std::vector<Row> rowsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> fields;
    line += ',';
    for (std::size_t at = 0, comma; at < line.size(); at = comma + 1)
      fields.push_back(line.substr(at, (comma = line.find(',', at)) - at));
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i) row[names[i]] = fields[i];
  }
  return rows;
}

}  // namespace carom::test
