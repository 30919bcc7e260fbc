#pragma once
// Shared by the readers of all formats: a file's text, positions in it, and its faults.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/input_error.h"

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

/// An error or an unusual value in a file.
struct Finding {
  enum class Kind { warning, error };
  Kind kind = Kind::warning;
  FilePlace at;
  std::string text;
};

/// Finds the line and column of an offset in a text.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);
  FilePlace at(std::size_t offset) const;

 private:
  std::vector<std::size_t> begins_;
};

/// Bound of all lengths (m), times (s) and the like, so that a file's numbers never overflow when squared.
inline constexpr double kFurthest = 1e9;

/// The allowed range of a number.
struct Range {
  double least = -kFurthest;
  double most = kFurthest;
  bool above = false;  ///< `least` itself is excluded
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};
inline constexpr Range kUnlimited{.least = 0.0, .most = std::numeric_limits<double>::infinity()};

bool within(const Range& range, double value);
/// Returns a description of the range: "a number from 0 to 1".
std::string wordsFor(const Range& range, bool whole);

/// Returns the text as one decimal number, or nothing if it contains anything else.
std::optional<double> wholeNumber(std::string_view text);

/// Returns the file's text. Throws InputErrors (at 1:1) if the file cannot be read or is over 1 MiB. `kind`
/// is for the message: "a TOML file".
std::string readText(const std::filesystem::path& file, std::string_view kind);

/// Returns text from a file without control characters, so that it can be shown on a terminal.
std::string printable(std::string_view text);

/// Returns the word of `known` nearest to a mistyped one, or nothing if none is near.
std::optional<std::string_view> nearestWord(std::string_view mistyped, std::span<const std::string> known);

}  // namespace carom
