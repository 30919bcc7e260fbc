#pragma once
// The columns of exported data, declared once: the files are written by this list, and codebook.csv is made
// from it.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

struct StudyColumn {
  std::string_view file, name, type, unit, meaning, allowed;
};

/// Returns all columns, file by file, in the order in which they are written.
std::span<const StudyColumn> studyColumns();

/// Returns codebook.csv.
std::string codebookCsv();

/// A CSV file of an export, row by row.
class StudyCsv {
 public:
  explicit StudyCsv(std::string_view file);
  /// Adds a row: the values of its columns by their names. Throws std::logic_error if one is missing or is no
  /// column.
  void add(const std::map<std::string_view, std::string>& values);
  const std::string& text() const { return text_; }

 private:
  std::vector<std::string_view> columns_;
  std::string text_;
};

/// Returns a text without what could tell who wrote it: e-mail addresses, and numbers of six digits and more,
/// also with blanks or signs of telephone numbers between them.
std::string masked(const std::string& text);

}  // namespace carom
