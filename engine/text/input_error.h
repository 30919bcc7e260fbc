#pragma once
// The exception that every file reader throws: the fault of an input file, and its place.

#include <stdexcept>
#include <string>
#include <utility>

namespace carom {

/// A fault in an input file. `what()` is "FILE:LINE:COLUMN: MESSAGE"; programs print it behind "error: ".
/// Lines and columns count from 1, columns in bytes; a fault of the file as a whole (missing, unreadable)
/// is at 1:1. The message says the fault and the expectation.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, int line, int column, std::string message)
      : std::runtime_error(file + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + message),
        file_(std::move(file)),
        line_(line),
        column_(column),
        message_(std::move(message)) {}

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  int column() const { return column_; }
  const std::string& message() const { return message_; }

 private:
  std::string file_;
  int line_;
  int column_;
  std::string message_;
};

}  // namespace carom
