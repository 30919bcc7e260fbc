#pragma once
// What the readers of all formats share: a file's text, places in it, and what may be wrong there.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/input_error.h"

namespace carom {

/// All faults of one file, in the order of its lines. As an InputError it is the first of them.
class InputErrors : public InputError {
 public:
  /// `faults` is not empty.
  explicit InputErrors(std::vector<InputError> faults);
  const std::vector<InputError>& faults() const { return faults_; }

 private:
  std::vector<InputError> faults_;
};

/// Where something stands in a file; lines and columns (in bytes) count from 1.
struct FilePlace {
  int line = 1;
  int column = 1;
};

/// Places by offset: where lines begin in a text.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);
  FilePlace at(std::size_t offset) const;

 private:
  std::vector<std::size_t> begins_;
};

/// Lengths (m), times (s) and the like lie within this: a file's numbers then never overflow when squared.
inline constexpr double kFurthest = 1e9;

/// What a number may be.
struct Range {
  double least = -kFurthest;
  double most = kFurthest;
  bool above = false;  ///< `least` itself is excluded
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};

bool within(const Range& range, double value);
/// "a number from 0 to 1".
std::string wordsFor(const Range& range, bool whole);

/// The whole text as one decimal number; none if anything is left over.
std::optional<double> wholeNumber(std::string_view text);

/// Throws InputErrors (at 1:1) where the file cannot be read or is over 1 MiB. `kind`: "a TOML file".
std::string readText(const std::filesystem::path& file, std::string_view kind);

/// Text from a file as it may be shown on a terminal: no control characters.
std::string printable(std::string_view text);

/// The words of `known` nearest to a mistyped one; none if all are far.
std::optional<std::string_view> nearestWord(std::string_view mistyped, std::span<const std::string> known);

}  // namespace carom
