#pragma once
// Shared by the readers of all formats: a file's text, positions in it, and its faults.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/file_keys/file_key.h"
#include "engine/text/input_error.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {

/// All faults of one file, in the order of its lines. As an InputError, it is the first of them.
class InputErrors : public InputError {
 public:
  /// `faults` must not be empty.
  explicit InputErrors(std::vector<InputError> faults);
  const std::vector<InputError>& faults() const { return faults_; }

 private:
  std::vector<InputError> faults_;
};

/// A position in a file; lines and columns (in bytes) count from 1.
struct FilePlace {
  int line = 1;
  int column = 1;
};

/// Finds the line and column of an offset in a text of at most 4 GiB.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);
  FilePlace at(std::size_t offset) const;

 private:
  std::vector<std::uint32_t> begins_;
};

/// Returns the text as one decimal number, or nothing if it contains anything else.
std::optional<double> wholeNumber(std::string_view text);

/// Returns the file's text, as contentOf (engine/text/outside_file.h). Throws InputErrors.
std::string readText(const std::filesystem::path& file, InputKind kind);

/// Returns the word of `known` nearest to a mistyped one, or nothing if none is near.
std::optional<std::string_view> nearestWord(std::string_view mistyped, std::span<const std::string> known);

}  // namespace carom
