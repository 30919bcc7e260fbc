// The columns of exported data: files and codebook by one list, and texts that tell nothing of who wrote
// them.
#include "app/study_data/study_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace carom {
namespace {

TEST(Masked, HidesAddressesAndLongNumbersAlone) {
  EXPECT_EQ(masked("write anna@example.org now"), "write [masked] now");
  EXPECT_EQ(masked("call +49 (171) 23-45 67 or 123456"), "call [masked] or [masked]");
  EXPECT_EQ(masked("it took 12345 s at 0.96 c, gamma 3.57"), "it took 12345 s at 0.96 c, gamma 3.57");
  EXPECT_EQ(masked(""), "");
}

TEST(StudyCsv, RefusesRowsThatAreNotThoseOfTheCodebook) {
  StudyCsv file("study.csv");
  file.add({{"key", "a"}, {"value", "b, \"c\""}});
  EXPECT_EQ(file.text(), "key,value\na,\"b, \"\"c\"\"\"\n");
  EXPECT_THROW(file.add({{"key", "a"}}), std::logic_error);
  EXPECT_THROW(file.add({{"key", "a"}, {"values", "b"}}), std::out_of_range);
}

TEST(StudyColumns, FilesAndCodebookHaveThoseOfTheList) {
  std::map<std::string, std::string> headers;
  std::set<std::string> names;
  for (const StudyColumn& column : studyColumns()) {
    std::string& header = headers[std::string(column.file)];
    header += (header.empty() ? "" : ",") + std::string(column.name);
    EXPECT_TRUE(names.insert(std::string(column.file) + " " + std::string(column.name)).second)
        << column.name;
    EXPECT_FALSE(column.meaning.empty() || column.allowed.empty() || column.type.empty()) << column.name;
  }
  for (const auto& [file, header] : headers) EXPECT_EQ(StudyCsv(file).text(), header + "\n");
  const std::string book = codebookCsv();
  EXPECT_EQ(book.substr(0, book.find('\n')), "file,name,type,unit,meaning,allowed");
  EXPECT_EQ(std::count(book.begin(), book.end(), '\n'),
            static_cast<std::ptrdiff_t>(studyColumns().size()) + 1);
  EXPECT_NE(book.find("\nbehaviour.csv,path_m,number,m,\"path of the head in the room: 60 Hz positions, "),
            std::string::npos);
}

}  // namespace
}  // namespace carom
