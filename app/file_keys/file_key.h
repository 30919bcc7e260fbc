#pragma once
// The keys of a kind of file, declared once. Its reader takes from the declaration which keys there are,
// their types, ranges and defaults; the build makes of it the JSON Schema for editors and the list of keys
// for people.

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Bound of all lengths (m), times (s) and the like, so that a file's numbers never overflow when squared.
inline constexpr double kFurthest = 1e9;

/// Bound of all numbers that must be above zero, so that their fourth powers never vanish.
inline constexpr double kSmallest = 1e-30;

/// The allowed range of a number.
struct Range {
  double least = -kFurthest;
  double most = kFurthest;
  bool above = false;  ///< `least` itself is excluded
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};
inline constexpr Range kUnlimited{.least = 0.0, .most = std::numeric_limits<double>::infinity()};
inline constexpr Range kShare{.least = 0.0, .most = 1.0};

bool within(const Range& range, double value);
/// Returns a description of the range: "a number from 0 to 1".
std::string wordsFor(const Range& range, bool whole);

inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// One key of a file. A table is a key, too, and so is the whole file.
struct FileKey {
  enum class Type {
    number,
    whole,
    flag,
    text,
    date,      ///< a day, such as 2031-12-31, without quotes
    choice,    ///< one of several texts
    numbers,   ///< an array of a fixed count of numbers
    wholes,    ///< the same of whole numbers
    texts,     ///< an array of texts
    points,    ///< an array of points
    monitors,  ///< a whole number, a text or several texts
    table,
    tables,  ///< an array of tables
  };
  /// Some keys of a table are there and others are not.
  struct Combination {
    std::vector<std::string_view> with, without;
  };

  std::string name;
  Type type = Type::table;
  std::string sentence;  ///< the meaning of the key
  std::string unit{};    ///< of its numbers; empty if they have none
  bool isRequired = false;
  Range range{};                            ///< of each number
  std::size_t count = 0;                    ///< number of coordinates: of `numbers`, or of each of the points
  std::size_t fewest = 0;                   ///< number of texts, points or tables, at least
  std::size_t most = kAnyNumber;            ///< and at most
  std::size_t letters = kAnyNumber;         ///< of each text, at most
  std::string pattern{};                    ///< that each text fits, as a regular expression; empty: any text
  std::vector<std::string_view> choices{};  ///< the texts that there are, if not all; of a number, instead
  /// The value where the key is left out: its numbers, 0 or 1 for a flag, the index of a choice. Empty: none,
  /// and the reader decides what to do.
  std::vector<double> fallback{};
  std::vector<FileKey> keys{};  ///< of a table
  /// Of each of these, one combination holds at least.
  std::vector<std::vector<Combination>> rules{};
  std::string notInFirst{};  ///< a required key that the first of the tables does not have
};

/// Returns the key of a table, or null if none has this name.
const FileKey* findKey(const FileKey& table, std::string_view name);

/// Builds declarations.
namespace declare {

FileKey number(std::string_view name, const Range& range, std::string_view sentence,
               std::optional<double> fallback = {});
FileKey whole(std::string_view name, int least, int most, std::string_view sentence,
              std::optional<int> fallback = {});
FileKey flag(std::string_view name, std::string_view sentence, std::optional<bool> fallback = false);
FileKey text(std::string_view name, std::string_view sentence);
FileKey date(std::string_view name, std::string_view sentence);
FileKey choice(std::string_view name, std::span<const std::string_view> choices, std::string_view sentence,
               std::optional<std::size_t> fallback = {});
FileKey choice(std::string_view name, std::initializer_list<std::string_view> choices,
               std::string_view sentence, std::optional<std::size_t> fallback = {});
FileKey numbers(std::string_view name, std::size_t count, const Range& range, std::string_view sentence,
                std::initializer_list<double> fallback = {});
FileKey wholes(std::string_view name, std::size_t count, const Range& range, std::string_view sentence,
               std::initializer_list<double> fallback = {});
FileKey texts(std::string_view name, std::string_view sentence);
FileKey points(std::string_view name, std::size_t count, std::string_view sentence);
FileKey table(std::string_view name, std::string_view sentence, std::vector<FileKey> keys);
FileKey tables(std::string_view name, std::string_view sentence, std::vector<FileKey> keys);

/// Return the key with more properties.
FileKey required(FileKey key);
FileKey inUnit(std::string_view unit, FileKey key);
FileKey fitting(std::string_view pattern, FileKey key);
FileKey ofLetters(std::size_t most, FileKey key);
FileKey orOneOf(std::initializer_list<std::string_view> texts, FileKey number);
FileKey ofSize(std::size_t fewest, std::size_t most, FileKey key);

}  // namespace declare

}  // namespace carom
